"""The steps of one call of `calibrate collect`, in their order: undo, redo, images, remove, solve, compare, accept, guidance."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from measureapp.calibrate.draft.draft import Limits
from measureapp.calibrate.draft.verdict import Verdict, compare, cross_validate, evaluate
from measureapp.calibrate.guidance.advise import advise
from measureapp.calibration_session.accepting import accept
from measureapp.calibration_session.session import CalibrationSession
from measureapp.cli.calibrate.collect_answer import collect_answer
from measureapp.cli.calibrate.collect_session import Sources, add_sources, previous_result
from measureapp.progress import PartOf, Progress

if TYPE_CHECKING:
    from measureapp.cli.calibrate.collect_options import Steps


@dataclass(frozen=True, slots=True)
class StepsResult:
    """The results of the steps."""

    document: Mapping[str, Any]
    within: bool  # no verdict is bad, no comparison out of its bounds


def run_steps(steps: Steps, limits: Limits | None, session: CalibrationSession, sources: Sources, progress: Progress) -> StepsResult:
    """Carry out the requested steps. Raises InputError, CalibrationError, StorageError."""
    changes = _edit(steps, session, sources, PartOf(progress, 0.0, 0.6))
    verdict = _solve(steps, session, limits, PartOf(progress, 0.6, 1.0))
    comparison = None if steps.compare is None else compare(previous_result(steps.compare), session.draft)
    progress.report(1, 1)
    advice = advise(session.draft) if steps.advise else None
    document = collect_answer(session.snapshot(), changes, advice, verdict, comparison) | {"accepted": steps.accept}
    within = (verdict is None or verdict.level != "bad") and (comparison is None or comparison.within)
    return StepsResult(document, within)


def _edit(steps: Steps, session: CalibrationSession, sources: Sources, progress: Progress) -> dict[str, Sequence[str]]:
    """Undo, redo, add and remove; return the ids of the observations by action."""
    changes: dict[str, Sequence[str]] = {
        "undone": [session.undo().observation] if steps.undo else [],
        "redone": [session.redo().observation] if steps.redo else [],
        "added": add_sources(session, sources, progress),
        "removed": list(steps.remove or ()),
    }
    for name in changes["removed"]:
        session.remove(name)
    session.identify_parts()
    return changes


def _solve(steps: Steps, session: CalibrationSession, limits: Limits | None, progress: Progress) -> Verdict | None:
    """Solve, or accept, and evaluate the solution; None where there is none."""
    if steps.accept is not None:
        part = PartOf(progress, 0.0, 0.5)
        accept(session, steps.accept, part, valid_days=steps.valid_days, temperature_c=steps.temperature_c)
    elif steps.solve or steps.validate or steps.compare is not None:
        session.solve_with_parts(PartOf(progress, 0.0, 0.5))
    if session.solved is None:
        return None
    held_back = cross_validate(session.draft, PartOf(progress, 0.5, 1.0)) if steps.validate else None
    return evaluate(session.draft, limits, held_back=held_back)
