"""Properties of one viewpoint of a plan."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ui.look.language.words import tr
from ui.look.wording import exposure, millimetres, percent, quantity, sentence_case
from ui.pages.pattern_prediction import cost, predict
from ui.widgets.properties_panel import Group, Properties

if TYPE_CHECKING:
    from measureapp.data.plan import ScanPlan, Viewpoint
    from measureapp.data.rig import RigDescription
    from ui.controllers.plan_prediction import Prediction


def viewpoint_properties(plan: ScanPlan, viewpoint: Viewpoint, rig: RigDescription, found: Prediction | None) -> Properties:
    """Return the properties of one viewpoint: what prevents it, what it measures, its axes, patterns and exposures."""
    x, y, z = viewpoint.flange.position_mm
    settle_s = plan.settle_of(viewpoint)
    current = found if found is not None and found.plan is plan else None
    return Properties(
        viewpoint.id,
        (
            *(() if current is None else _found(current, viewpoint)),
            Group(
                "Axes",
                (
                    ("Flange", f"{', '.join(quantity(value, '', 1) for value in (x, y, z))} mm"),
                    ("Guide", millimetres(viewpoint.guide_mm, 1)),
                    ("Table", quantity(viewpoint.table_deg, "°", 1)),
                    ("Wait", quantity(rig.motion.settle_s if settle_s is None else settle_s, "s", 1)),
                ),
            ),
            Group(
                "Exposures",
                tuple((tr("No. {place}", place=place + 1), exposure(value)) for place, value in enumerate(plan.exposures_of(viewpoint))),
            ),
            Group(
                "Patterns",
                (
                    ("Set", sentence_case(plan.patterns.name)),
                    ("Images", str(plan.patterns.count)),
                    ("Fringe pitches", ", ".join(f"{pitch:.4g} px" for pitch in plan.patterns.pitches_px)),
                ),
            ),
            *predict(plan.patterns, rig.projector.width_px, rig.projector.height_px),
            cost(plan, rig),
        ),
    )


def _found(found: Prediction, viewpoint: Viewpoint) -> tuple[Group, ...]:
    groups = []
    sentences = found.check.sentences().get(viewpoint.id, [])
    if sentences:
        groups.append(Group("Prevents the scan", tuple(("", sentence) for sentence in sentences)))
    row = found.row(viewpoint.id)
    if found.coverage is not None and row >= 0:
        alone = found.coverage.seen[row] & (found.coverage.counts == 1)
        groups.append(
            Group(
                "Predicted",
                (
                    ("Measures of the part", percent(found.coverage.share(found.coverage.seen[row]))),
                    ("Which no other measures", percent(found.coverage.share(alone))),
                ),
            )
        )
    return tuple(groups)
