"""The steps of one call of `calibrate collect`, in their order: undo, redo, images, remove, solve, compare, accept, coach."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from measureapp.cli.calibrate.collect_answer import collect_answer
from measureapp.cli.calibrate.collect_session import Sources, add_sources, previous_result
from measureapp.pipeline import collecting
from measureapp.progress import PartOf, Progress

if TYPE_CHECKING:
    from measureapp.cli.calibrate.collect_options import Steps


@dataclass(frozen=True, slots=True)
class Done:
    """What the steps gave."""

    document: Mapping[str, Any]
    within: bool  # no verdict is bad, no comparison out of its bounds


def carry_out(
    steps: Steps, limits: collecting.Limits | None, collection: collecting.Collection, sources: Sources, progress: Progress
) -> Done:
    """Do what was asked for. Raises InputError, CalibrationError, StorageError."""
    changes = _edited(steps, collection, sources, PartOf(progress, 0.0, 0.6))
    verdict = _solved(steps, collection, limits, PartOf(progress, 0.6, 1.0))
    comparison = None if steps.compare is None else collecting.compare(previous_result(steps.compare), collection)
    progress.report(1, 1)
    advice = collecting.coach(collection) if steps.advise else None
    document = collect_answer(collection, changes, advice, verdict, comparison) | {"accepted": steps.accept}
    within = (verdict is None or verdict.level != "bad") and (comparison is None or comparison.within)
    return Done(document, within)


def _edited(steps: Steps, collection: collecting.Collection, sources: Sources, progress: Progress) -> dict[str, Sequence[str]]:
    """Undo, redo, add and remove; return the ids of the observations by what was done with them."""
    changes: dict[str, Sequence[str]] = {
        "undone": [collection.undo().observation] if steps.undo else [],
        "redone": [collection.redo().observation] if steps.redo else [],
        "added": add_sources(collection, sources, progress),
        "removed": list(steps.remove or ()),
    }
    for name in changes["removed"]:
        collection.remove(name)
    collection.look_again()
    return changes


def _solved(
    steps: Steps, collection: collecting.Collection, limits: collecting.Limits | None, progress: Progress
) -> collecting.Verdict | None:
    """Solve, or accept, and judge what is solved; None where nothing is."""
    if steps.accept is not None:
        part = PartOf(progress, 0.0, 0.5)
        collecting.accept(collection, steps.accept, part, valid_days=steps.valid_days, temperature_c=steps.temperature_c)
    elif steps.solve or steps.validate or steps.compare is not None:
        collection.solve_with_parts(PartOf(progress, 0.0, 0.5))
    if collection.solved is None:
        return None
    held_back = collecting.check_held_back(collection, PartOf(progress, 0.5, 1.0)) if steps.validate else None
    return collecting.judge(collection, limits, held_back=held_back)
