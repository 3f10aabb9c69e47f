"""Views that are used or refused by hand, and stitching again after such a choice."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from measureapp.acquire.events import Event
from measureapp.data.cloud import StitchedCloud, ViewPlacement
from measureapp.data.measurement import ViewResult
from measureapp.data.view_choices import ViewChoices
from measureapp.errors import InputError
from measureapp.progress import PartOf, Progress
from measureapp.project.folder import ProjectFolder

if TYPE_CHECKING:
    from measureapp.pipeline.run import Outcome

REFUSED = "refused by hand: left out"


def chosen(views: Sequence[ViewResult], choices: ViewChoices) -> list[ViewResult]:
    """Return the views to be stitched: those whose cloud is good enough or that are used by hand, without those refused by hand."""
    return [
        view for view in views if view.viewpoint_id not in choices.refused and (view.quality.accepted or view.viewpoint_id in choices.used)
    ]


def with_refused(stitched: StitchedCloud, views: Sequence[ViewResult], choices: ViewChoices) -> StitchedCloud:
    """Return the stitched cloud with a line for each view refused by hand, after those that its points refer to."""
    refused = [view for view in views if view.viewpoint_id in choices.refused]
    lines = (
        ViewPlacement(view.viewpoint_id, view.part_from_camera, view.part_from_camera, 0.0, 0.0, 0.0, 0.0, REFUSED, False)
        for view in refused
    )
    return replace(stitched, placements=(*stitched.placements, *lines))


def check_choices(choices: ViewChoices, known: Sequence[str]) -> None:
    """Refuse choices about views that are not there. Raises InputError."""
    unknown = sorted({*choices.used, *choices.refused}.difference(known))
    if unknown:
        raise InputError(f"There is no view {unknown[0]!r}.", "The views are called: " + ", ".join(known) + ".")


def restitch(project: ProjectFolder, choices: ViewChoices, on_event: Callable[[Event], None], progress: Progress) -> Outcome:
    """Stitch the clouds that were computed already with other choices, measure again, and keep results and choices.

    The images are not decoded again. Where this fails, results and choices stay as they were.

    Raises
    ------
    InputError
        Nothing was measured yet, or there is no such view.
    RegistrationError
        No view is left to be stitched, or they do not fit.
    """
    from measureapp.pipeline.assemble import assemble
    from measureapp.pipeline.run import finished
    from measureapp.pipeline.watch import Stopwatch

    progress.report(0, 1, "reading clouds")
    measurement = project.measurement()
    if measurement is None:
        raise InputError(f"{project.path} has no clouds yet.", "Scan the part, or compute it from its images: measureapp process PROJECT.")
    check_choices(choices, [view.viewpoint_id for view in measurement.views])
    watch, rest = Stopwatch(), PartOf(progress, 0.1, 1.0)
    with project.claimed():
        made = assemble(
            project, measurement.calibration, measurement.views, on_event, rest, watch, choices=choices, validity=measurement.validity
        )
        project.save_view_choices(choices)
        return finished(project, made, watch)
