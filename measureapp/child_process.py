"""Child processes: run to their end unless the task is cancelled, and a description of how one ended."""

from __future__ import annotations

import subprocess
from collections.abc import Callable, Sequence
from pathlib import Path

LOG_CHARACTERS = 200
POLL_INTERVAL_S = 0.1


def run_child(command: Sequence[str], log: Path, meanwhile: Callable[[], None]) -> int:
    """Run a program and return its exit code; its output goes to the file ``log``.

    Parameters
    ----------
    meanwhile : called ten times a second; when it raises, the process is killed

    Raises
    ------
    OSError
        The program cannot be started, or the file not be written.
    """
    with log.open("wb") as output:
        process = subprocess.Popen(
            command,
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=subprocess.STDOUT,
            creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
        )
        try:
            while True:
                meanwhile()
                try:
                    return process.wait(POLL_INTERVAL_S)
                except subprocess.TimeoutExpired:
                    continue
        finally:
            process.kill()
            process.wait()


def describe_exit(code: int, log: Path) -> str:
    """Describe how a child process ended without a result.

    Parameters
    ----------
    code : return code; negative: the signal that ended it
    log : file of its standard error, whose last line is quoted
    """
    if code < 0:
        return f"its process was ended by signal {-code}, possibly for lack of memory"
    lines = log.read_text(encoding="utf-8", errors="replace").strip().splitlines()
    return f"its process ended with code {code}" + (f" ({lines[-1][:LOG_CHARACTERS].strip()})" if lines else "")
