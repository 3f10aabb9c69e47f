"""The guards of tests/conftest.py catch what they are for."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
LEFT_BEHIND = {
    "threads running": "def test_it():\n    import threading\n    threading.Thread(target=threading.Event().wait, args=(30,), daemon=True).start()\n",
    "QWidget": "def test_it(qapp):\n    from PySide6.QtWidgets import QWidget\n    test_it.kept = QWidget()\n",
    "QTimer": "def test_it(qapp):\n    from PySide6.QtCore import QTimer\n    test_it.kept = QTimer()\n    test_it.kept.start(5)\n",
    "QThread": "def test_it(qapp):\n    from PySide6.QtCore import QThread\n    test_it.kept = QThread()\n    test_it.kept.start()\n"
    "def test_end(qapp):\n    test_it.kept.quit()\n    test_it.kept.wait()\n",
    "Exceptions caught in Qt event loop": "def test_it(qtbot):\n    from PySide6.QtCore import QTimer\n"
    "    QTimer.singleShot(0, lambda: 1 / 0)\n    qtbot.wait(20)\n",
}
TIDY = """
def test_it(qtbot):
    import os
    from PySide6.QtWidgets import QComboBox, QWidget
    window = QWidget()
    QComboBox(window).addItem("x")
    qtbot.addWidget(window)
    window.show()
    assert "DISPLAY" not in os.environ
"""


@pytest.fixture(scope="module")
def output(tmp_path_factory: pytest.TempPathFactory) -> str:
    """Return what pytest says about one file per thing left behind, and a tidy one."""
    folder = tmp_path_factory.mktemp("guarded")
    (folder / "conftest.py").write_bytes((ROOT / "tests" / "conftest.py").read_bytes())
    for number, body in enumerate([*LEFT_BEHIND.values(), TIDY]):
        (folder / f"test_{number}.py").write_text(body)
    command = [sys.executable, "-m", "pytest", "-v", "-p", "no:cacheprovider", "-p", "no:dash", "--rootdir", str(folder), str(folder)]
    found = {**os.environ, "PYTHONPATH": os.pathsep.join((str(ROOT), str(ROOT / "tests")))}  # its plugins
    return subprocess.run(command, cwd=folder, env=found, capture_output=True, text=True, check=False, timeout=120).stdout


@pytest.mark.parametrize(("number", "left"), list(enumerate(LEFT_BEHIND)))
def test_a_test_that_leaves_something_behind_fails(output: str, number: int, left: str) -> None:
    assert f"test_{number}.py::test_it ERROR" in output or f"test_{number}.py::test_it FAILED" in output, output
    assert left in output


def test_a_tidy_window_passes(output: str) -> None:
    tidy = f"test_{len(LEFT_BEHIND)}.py::test_it"
    assert f"{tidy} PASSED" in output, output
    assert f"{tidy} ERROR" not in output
