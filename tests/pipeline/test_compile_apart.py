"""Kernels are compiled in another process where the cache on disk has none, and only there."""

from __future__ import annotations

import logging
import time
from pathlib import Path

import pytest

from measureapp.pipeline import compile_apart as room
from measureapp.pipeline.compile_apart import compile_apart
from measureapp.progress import CallbackProgress, Cancelled, NoProgress


@pytest.fixture
def kernels(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(room, "KERNELS", (tmp_path,))
    monkeypatch.setattr(room, "COMMAND", f"open({str(tmp_path / 'compiled')!r}, 'w')")
    return tmp_path


def test_what_was_never_compiled_is_compiled_by_another_process(kernels: Path) -> None:
    compile_apart(NoProgress())
    assert (kernels / "compiled").exists()


def test_what_is_compiled_is_left_as_it_is(kernels: Path) -> None:
    (kernels / "__pycache__").mkdir()
    (kernels / "__pycache__" / "blur.correct_blur-114.py311.nbi").touch()
    compile_apart(NoProgress())
    assert not (kernels / "compiled").exists()


@pytest.mark.usefixtures("kernels")
def test_a_process_that_fails_is_written_to_the_log(monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture) -> None:
    monkeypatch.setattr(room, "COMMAND", "raise SystemExit('no compiler here')")
    with caplog.at_level(logging.WARNING):
        compile_apart(NoProgress())
    assert "no compiler here" in caplog.text


@pytest.mark.usefixtures("kernels")
def test_it_ends_with_the_job_that_waits_for_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(room, "COMMAND", "import time; time.sleep(600)")
    start = time.monotonic()

    class Cancelling(CallbackProgress):
        def check(self) -> None:
            if time.monotonic() > start + 0.5:
                raise Cancelled

    with pytest.raises(Cancelled):
        compile_apart(Cancelling(lambda *_: None))
    assert time.monotonic() - start < 60


def test_the_command_compiles_what_the_warm_up_compiles() -> None:
    """The packages named are those in which compiled kernels are looked for, and the command is a program that Python accepts."""
    compile(room.COMMAND, "command", "exec")
    assert all((folder / "__init__.py").exists() for folder in room.KERNELS)
