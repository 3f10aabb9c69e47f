"""Maximum and least material condition: by how much the actual size of a hole or shaft widens the zone of its position (ISO 2692).

The size taken is the one that leaves the smaller bonus: of a hole at maximum material the largest cylinder about the associated
axis that fits inside all its means, of a shaft the smallest outside; at least material the other way round. Noise of the means
can only lessen it.
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
    """Return what gives the bonus in mm from the feature, and its standard uncertainty by the noise of the means alone.

    Raises
    ------
    InspectionError
        The feature is no measured cylinder, or too little of it was measured.
    """
    if require_feature(found).shape != "cylinder":
        raise InspectionError(f"{found.name} is a {require_feature(found).shape}: a material condition is taken of a measured cylinder")
    least, most = limits_mm
    cells = extract_cells(found, settings)
    inner = found.hole == (condition == "maximum")  # the size that lies inside all means
    extreme = float(cells.deviations_mm.min() if inner else cells.deviations_mm.max())

    def bonus(feature: Feature) -> float:
        size = 2 * ((feature.radius_mm or 0.0) + extreme)
        return float(np.clip(size - least if inner else most - size, 0.0, most - least))

    return bonus, cells.form_sigma_mm  # the diameter is off by no more than twice the greatest noise, an expanded uncertainty
