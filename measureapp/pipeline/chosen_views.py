"""Views that are used or refused by hand."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from measureapp.data.cloud import StitchedCloud, ViewPlacement
from measureapp.data.measurement import ViewResult
from measureapp.data.view_choices import ViewChoices
from measureapp.errors import InputError

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
