"""Bonus tolerance at maximum or least material condition (ISO 2692), from the actual size of a hole or shaft.

The size used is the one with the smaller bonus: for a hole at maximum material the largest cylinder about the associated axis inside all
cell means, for a shaft the smallest outside; at least material the opposite. Noise can only reduce the bonus.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from measureapp.data.cut import Range
from measureapp.data.feature import Feature
from measureapp.data.material import MaterialCondition
from measureapp.errors import InspectionError
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.tolerances.form import extract_cells
from measureapp.inspection.value import require_feature

WORDS = {"maximum": "maximum material", "least": "least material"}


def compute_bonus(
    condition: MaterialCondition, limits_mm: Range, found: FoundFeature, settings: InspectionSettings
) -> tuple[Callable[[Feature], float], float]:
    """Return the function from the feature to the bonus (mm), and its standard uncertainty by noise.

    Raises
    ------
    InspectionError
        The feature is not a measured cylinder, or too little of it was measured.
    """
    if require_feature(found).shape != "cylinder":
        raise InspectionError(f"{found.name} is a {require_feature(found).shape}: a material condition requires a measured cylinder")
    least, most = limits_mm
    cells = extract_cells(found, settings)
    inner = found.hole == (condition == "maximum")  # the size inside all means
    extreme = float(cells.deviations_mm.min() if inner else cells.deviations_mm.max())

    def bonus(feature: Feature) -> float:
        size = 2 * ((feature.radius_mm or 0.0) + extreme)
        return float(np.clip(size - least if inner else most - size, 0.0, most - least))

    return bonus, cells.form_sigma_mm  # the error of the diameter is at most twice the greatest noise, an expanded uncertainty
