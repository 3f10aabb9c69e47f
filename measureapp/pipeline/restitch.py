"""Stitching again after views were chosen by hand."""

from __future__ import annotations

from collections.abc import Callable

from measureapp.acquire.events import Event
from measureapp.data.view_choices import ViewChoices
from measureapp.errors import InputError
from measureapp.pipeline.assemble import assemble
from measureapp.pipeline.chosen_views import check_choices
from measureapp.pipeline.run import Outcome, finished
from measureapp.pipeline.watch import Stopwatch
from measureapp.progress import PartOf, Progress
from measureapp.project.folder import ProjectFolder


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
    progress.report(0, 1, "reading clouds")
    measurement = project.measurement()
    if measurement is None:
        raise InputError(f"{project.path} has no clouds yet.", "Scan the part, or compute it from its images: measureapp process PROJECT.")
    check_choices(choices, [view.viewpoint_id for view in measurement.views])
    watch, rest = Stopwatch(), PartOf(progress, 0.1, 1.0)
    with project.lock():
        made = assemble(project, measurement.calibration, measurement.views, on_event, rest, watch, choices=choices, former=measurement)
        project.save_view_choices(choices)
        return finished(project, made, watch)
