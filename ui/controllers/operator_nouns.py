"""What operator mode shows: cards of part programs, runs, faults, and the numbers of a shift."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:
    from measureapp.data.part_program import PartProgram
    from measureapp.data.series import SeriesRun

Step = Literal["home", "identify", "load", "run", "verdict"]
UNREASONED = "no reason stated"
LAST_DOTS = 10


@dataclass(frozen=True, eq=False)
class ProgramCard:
    """A part program in the folder, or the reason why its file cannot be used."""

    path: Path
    program: PartProgram | None = None
    problem: str = ""
    last: SeriesRun | None = None
    seconds: float | None = None  # usual duration

    is_released: bool = False

    @property
    def name(self) -> str:
        """Name of the program, or of its file."""
        return self.path.name if self.program is None else self.program.facts.name


@dataclass(frozen=True)
class Entered:
    """What the operator states about a part."""

    serial: str = ""
    order: str = ""
    remarks: str = ""
    operator: str = ""


@dataclass(frozen=True, eq=False)
class ToMeasure:
    """A part that is to be measured."""

    card: ProgramCard
    program: PartProgram
    entered: Entered
    reason: str = ""  # why it is measured again


@dataclass(frozen=True)
class Fault:
    """Why a measurement ended early: what is kept, and what to press."""

    cause: str
    remedy: str
    stored: int
    planned: int
    following: str = ""  # viewpoint that is taken next
    is_lost: bool = False  # the folder is gone, with what was stored

    @property
    def may_resume(self) -> bool:
        """Whether some viewpoints are still to be taken."""
        return bool(self.following) or self.stored < self.planned


@dataclass(frozen=True, eq=False)
class Filed:
    """Where a finished run was filed, or why it could not be."""

    run: SeriesRun | None = None
    report: Path | None = None
    problem: str = ""


@dataclass(frozen=True)
class ShiftCount:
    """Parts since the start of a shift."""

    parts: int = 0
    passed: int = 0
    failed: int = 0
    open: int = 0  # not proven or not measured
    first_passed: int = 0  # parts whose first run passed
    last: tuple[str, ...] = ()  # verdicts of the last runs, oldest first

    @property
    def first_pass_yield(self) -> float | None:
        """Share of parts whose first run passed; None before the first part."""
        return self.first_passed / self.parts if self.parts else None


def verdict_of(run: SeriesRun) -> str:
    """Return the verdict on a run."""
    from measureapp.data.verdicts import part_verdict

    return str(part_verdict(value.verdict for value in run.values))


def counted_run(runs: Sequence[SeriesRun]) -> SeriesRun:
    """Return the run of a part that counts, of its runs in order: the last one measured for a stated reason, else the first one."""
    reasoned = [run for run in runs[1:] if run.repeat_reason not in ("", UNREASONED)]
    return reasoned[-1] if reasoned else runs[0]


def count_shift(runs: Sequence[SeriesRun], since: datetime) -> ShiftCount:
    """Return the numbers of a shift from all runs, in order of measurement; a part belongs to it if it was measured since then."""
    recent = [run for run in runs if datetime.fromisoformat(run.measured_at).astimezone() >= since]
    parts: dict[tuple[str, str], list[SeriesRun]] = {}
    for number, run in enumerate(runs):
        serial = run.identification.serial_number or f"\0{number}"  # without a serial number each run is a part of its own
        parts.setdefault((run.program, serial), []).append(run)
    mine = [part for part in parts.values() if any(run in recent for run in part)]
    counted = [verdict_of(counted_run(part)) for part in mine]
    passed, failed = counted.count("pass"), counted.count("fail")
    first = sum(verdict_of(part[0]) == "pass" for part in mine)
    last = tuple(verdict_of(run) for run in recent[-LAST_DOTS:])
    return ShiftCount(len(mine), passed, failed, len(mine) - passed - failed, first, last)
