"""Repeated stitching after views were accepted or refused by hand."""

from __future__ import annotations

from collections.abc import Callable

from measureapp.data.view_choices import ViewChoices
from measureapp.errors import InputError
from measureapp.language.languages import ENGLISH
from measureapp.pipeline.assemble import Revision, assemble
from measureapp.pipeline.chosen_views import check_choices
from measureapp.pipeline.events import Event
from measureapp.pipeline.run import Outcome, finish
from measureapp.pipeline.watch import Stopwatch
from measureapp.progress import PartOf, Progress
from measureapp.project.folder import ProjectFolder


def restitch(
    project: ProjectFolder, choices: ViewChoices, on_event: Callable[[Event], None], progress: Progress, language: str = ENGLISH
) -> Outcome:
    """Stitch the existing clouds with other choices of views, inspect again, and store results and choices.

    The images are not decoded again. On failure results and choices are unchanged.

    Raises
    ------
    InputError
        There is no measurement yet, or no such view.
    RegistrationError
        No view is left, or the clouds cannot be registered.
    """
    progress.report(0, 1, "reading clouds")
    measurement = project.measurement()
    if measurement is None:
        raise InputError(
            f"{project.path} has no clouds yet.", "Scan the part, or compute them from stored images: measureapp process PROJECT."
        )
    if measurement.setups:
        raise InputError(
            f"{project.path} is joined from several set-ups.",
            "Choose the views in the project of their set-up, then compute this one again: measureapp process PROJECT.",
        )
    check_choices(choices, [view.viewpoint_id for view in measurement.views])
    watch, rest = Stopwatch(), PartOf(progress, 0.1, 1.0)
    with project.lock():
        made = assemble(project, measurement.calibration, measurement.views, on_event, rest, watch, revision=Revision(measurement, choices))
        project.save_view_choices(choices)
        return finish(project, made, watch, language)  # to its end: what is stored now is what the window will show
