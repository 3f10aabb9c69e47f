"""How a process that does heavy work of ours ended, in words."""

from __future__ import annotations

from pathlib import Path

TOLD_CHARACTERS = 200


def how_it_ended(code: int, told: Path) -> str:
    """Say how a process ended without a result.

    Parameters
    ----------
    code : its return code, below 0 the signal that ended it
    told : file of what it wrote as errors; the last line is said too
    """
    if code < 0:
        return f"its process was ended by signal {-code}; the memory may not have sufficed"
    lines = told.read_text(encoding="utf-8", errors="replace").strip().splitlines()
    return f"its process ended with code {code}" + (f" ({lines[-1][:TOLD_CHARACTERS].strip()})" if lines else "")
