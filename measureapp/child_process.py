"""Description of how a child process ended."""

from __future__ import annotations

from pathlib import Path

LOG_CHARACTERS = 200


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
