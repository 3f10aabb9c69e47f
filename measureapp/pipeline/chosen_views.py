"""Views accepted or refused by hand."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from measureapp.data.cloud import StitchedCloud, ViewPlacement
from measureapp.data.measurement import ViewResult
from measureapp.data.view_choices import ViewChoices
from measureapp.errors import InputError

REFUSED = "refused by hand: not used"


def select_views(views: Sequence[ViewResult], choices: ViewChoices) -> list[ViewResult]:
    """Select the views to be stitched: those of sufficient quality or accepted by the user, except those refused by hand."""
    return [
        view for view in views if view.viewpoint_id not in choices.refused and (view.quality.accepted or view.viewpoint_id in choices.used)
    ]


def add_refused(stitched: StitchedCloud, views: Sequence[ViewResult], choices: ViewChoices) -> StitchedCloud:
    """Append a placement for each view refused by hand, after those of the stitched views."""
    refused = [view for view in views if view.viewpoint_id in choices.refused]
    lines = (
        ViewPlacement(view.viewpoint_id, view.part_from_camera, view.part_from_camera, 0.0, 0.0, 0.0, 0.0, REFUSED, False)
        for view in refused
    )
    return replace(stitched, placements=(*stitched.placements, *lines))


def check_choices(choices: ViewChoices, known: Sequence[str]) -> None:
    """Refuse choices of unknown views. Raises InputError."""
    unknown = sorted({*choices.used, *choices.refused}.difference(known))
    if unknown:
        raise InputError(f"There is no view {unknown[0]!r}.", "Name one of: " + ", ".join(known) + ".")
