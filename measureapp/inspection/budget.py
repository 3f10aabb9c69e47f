"""The shares of a dimension's uncertainty, with what has to be assumed where the cloud does not tell."""

from __future__ import annotations

from collections.abc import Sequence

from measureapp.inspection.features.errors import CALIBRATION, SCALE
from measureapp.inspection.features.found import Found
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.uncertainty import assumed_calibration
from measureapp.inspection.value import Budget, Value


def completed(value: Value, unit: str, found: Sequence[Found], settings: InspectionSettings) -> tuple[Budget, tuple[str, ...]]:
    """Return the shares of a value's standard uncertainty with those that had to be assumed, and these assumptions in words."""
    budget, told = dict(value.budget), []
    chosen = settings.uncertainty
    if any(one.view_errors is None for one in found) and chosen.placement_mm > 0:
        told.append(f"assumed: a view lies within ± {chosen.placement_mm:g} mm (k = 1), as the cloud does not say how its views lie")
    if CALIBRATION not in budget and unit == "mm" and (chosen.systematic_mm or chosen.systematic_relative):
        budget[CALIBRATION] = assumed_calibration(value.value, chosen)
        told.append(
            f"assumed of the calibration: ± {chosen.systematic_mm:g} mm and {chosen.systematic_relative * 1e6:.0f} ppm of the length (k = 1)"
        )
    if chosen.scale_ppm > 0 and unit == "mm":
        budget.setdefault(SCALE, chosen.scale_ppm * 1e-6 * abs(value.value))  # without views a value follows the scale as a length does
        told.append(f"lengths ± {chosen.scale_ppm:g} ppm (k = 1), by the calibration board and the part's temperature")
    return budget, tuple(told)
