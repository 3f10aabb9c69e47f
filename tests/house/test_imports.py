"""Imports go one way."""

from __future__ import annotations

import ast
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
WINDOW = ("PySide6", "shiboken6", "qtpy", "qtawesome", "pyqtgraph", "vtk", "vtkmodules", "pyvista")
VENDORS = ("pymodbus", "serial", "pypylon", "hid", "requests")
WITHOUT_THEM = f"""
import sys
for name in {(*WINDOW, *VENDORS, "ui")!r}:
    sys.modules[name] = None
from measureapp.cli.main import build, main
build()
sys.exit(main(["--help"]))
"""


def test_the_command_line_works_where_qt_vtk_and_vendor_libraries_are_absent() -> None:
    done = subprocess.run([sys.executable, "-c", WITHOUT_THEM], cwd=ROOT, capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == 0, done.stderr
    assert "demo" in done.stdout


def test_help_imports_no_heavy_library() -> None:
    code = f"import sys; from measureapp.cli.main import main; main(['--help']); print([n for n in {HEAVY!r} if n in sys.modules], file=sys.stderr)"
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=False, timeout=60)
    assert done.stderr.strip() == "[]"


HEAVY = ("open3d", "numba", "trimesh", "small_gicp", "typst", "PySide6", "vtkmodules", "pyvista")


def test_the_import_contracts_are_kept() -> None:
    linter = (
        f"import sys; from importlinter.cli import lint_imports; sys.exit(lint_imports({str(ROOT / 'pyproject.toml')!r}, no_cache=True))"
    )
    done = subprocess.run([sys.executable, "-c", linter], cwd=ROOT, capture_output=True, text=True, check=False)  # it silences all loggers
    assert done.returncode == 0, done.stdout


def imports(path: Path) -> set[str]:
    """Return the top-level names of what a file imports absolutely."""
    names: set[str] = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names |= {alias.name.partition(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.level == 0 and node.module:
            names.add(node.module.partition(".")[0])
    return names


def test_plugins_import_no_window_and_not_each_other_by_name() -> None:
    files = sorted((ROOT / "plugins").rglob("*.py"))
    if not files:
        pytest.skip("there is no plugin")
    guilty = {str(path.relative_to(ROOT)): imports(path) & {*WINDOW, "ui", "plugins"} for path in files}
    assert not {path: names for path, names in guilty.items() if names}
