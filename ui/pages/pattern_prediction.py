"""Predicted performance of a plan's patterns and exposures, and their cost in time and disk space."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING

from ui.look.language.words import tr
from ui.look.wording import counted, duration, quantity, sentence, several, storage
from ui.widgets.properties_panel import Group

if TYPE_CHECKING:
    from measureapp.data.fringe import PatternSet
    from measureapp.data.plan import ScanPlan
    from measureapp.data.rig import RigDescription

NEGLIGIBLE = 1e-12


@lru_cache(maxsize=16)
def predict(patterns: PatternSet, width_px: int, height_px: int) -> tuple[Group, ...]:
    """Predict the performance of a set on this projector at a typical contrast, one group per direction of its fringes."""
    from measureapp.errors import DecodeError
    from measureapp.fringe.patterns.check import DEFAULT_MODULATION, check_patterns

    try:
        checks = check_patterns(patterns, width_px, height_px)
    except DecodeError as error:
        return (Group("Predicted performance", (("Cannot be used", sentence(str(error))),)),)
    groups = []
    for check in checks:
        heading = "Predicted performance" + (tr(", {direction} fringes", direction=check.direction) if len(checks) > 1 else "")
        rows = (
            ("Method", sentence(check.method).rstrip(".")),
            ("Range", quantity(check.range_px, "px", 0)),
            ("Guard band", quantity(check.guard_px, "px", 0)),
            ("Assumed modulation", quantity(DEFAULT_MODULATION, "grey levels", 0)),
            ("σ of the column" if check.direction == "vertical" else "σ of the row", quantity(check.column_sigma_px, "px")),
            ("Wrong fringe orders", odds(check.order_error_probability)),
        )
        groups.append(Group(heading, rows))
    return tuple(groups)


def odds(probability: float) -> str:
    """Format a small probability as a frequency: ``1 of 2 000 pixels``."""
    if probability < NEGLIGIBLE:
        return "None expected"
    one_of = 1 / probability
    if one_of > 1e6:
        return tr("< 1 of {counted} pixels", counted=counted(1_000_000))
    digits = max(0, len(str(int(one_of))) - 2)
    return tr("1 of {counted} pixels", counted=counted(int(round(one_of, -digits))))


def cost(plan: ScanPlan, rig: RigDescription) -> Group:
    """Return number of images, time and disk space per viewpoint, without the motion of the axes."""
    from measureapp.data.scan_cost import image_time_s

    exposures, cameras = plan.bracket.exposures_us, rig.cameras
    images = plan.patterns.count * len(exposures)
    seconds = plan.patterns.count * sum(image_time_s(exposure_us) for exposure_us in exposures)
    size = sum(camera.width_px * camera.height_px * (1 if camera.bit_depth == 8 else 2) for camera in cameras) * images
    return Group(
        "Per viewpoint",
        (
            ("Images", f"{images} × {several(len(cameras), 'camera')}"),
            ("Acquisition time", tr("At least {seconds}", seconds=quantity(seconds, "s", 1))),
            ("Disk space", storage(size)),
            ("All viewpoints", f"{duration(seconds * len(plan))}, {storage(size * len(plan))}"),
        ),
    )
