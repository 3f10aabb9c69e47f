"""Features whose points are selected by region growing from a seed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.cut import Grow
from measureapp.data.feature import Feature
from measureapp.data.inspection_program import MeasuredFeature, copy_names
from measureapp.errors import FitError, InspectionError
from measureapp.geometry.transform import rotation_about
from measureapp.inspection.features.cut import NominalFeature, nominal_features, within_box
from measureapp.inspection.features.found_feature import FoundFeature, fit_feature
from measureapp.inspection.features.regions.grow import Region, grow_region
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.settings import InspectionSettings


def grow_features(described: MeasuredFeature, points: MeasuredPoints, settings: InspectionSettings) -> Mapping[str, FoundFeature]:
    """Grow a feature, or all copies of its pattern, from its seed; ``points`` are in the nominal's frame."""
    assert described.grow is not None
    nominals = {one.feature.name: one for one in nominal_features(described)} if described.placed else {}
    angle = 0.0 if described.repeat is None else np.radians(described.repeat.angle_deg)
    found = {}
    for number, name in enumerate(copy_names(described.name, described.repeat)):
        turn = rotation_about([0, 0, 1], number * angle)
        found[name] = _grow_copy(described, described.grow, name, turn, nominals.get(name), points, settings)
    return found


def _grow_copy(
    described: MeasuredFeature,
    requested: Grow,
    name: str,
    turn: FloatArray,
    nominal: NominalFeature | None,
    points: MeasuredPoints,
    settings: InspectionSettings,
) -> FoundFeature:
    nominal_feature = None if nominal is None else nominal.feature
    allowed = within_box(points.points_mm, described.cut, turn)
    shape = described.shape
    assert shape == "plane" or shape == "cylinder" or shape == "sphere" or shape == "cone"  # noqa: PLR1714 - the program refuses others
    try:
        region = grow_region(points, allowed, shape, turn @ np.asarray(requested.seed_mm, float), requested)
    except (InspectionError, FitError) as error:
        return FoundFeature(
            name, None, " ".join(filter(None, [f"{name}: {error.message.rstrip('.')}.", error.hint])).rstrip("."), nominal=nominal_feature
        )
    expected = nominal or NominalFeature(_orient_outwards(region, name, points), described.cut, described.hole, False, 0.0)
    made = fit_feature(expected, points, region.indices, settings, nominal_feature)
    if made.feature is None:
        return made
    words = f"grown from seed to {len(region.indices)} points within {region.limit_mm:.3f} mm (noise {region.noise_mm:.3f} mm)"
    return replace(made, feature=replace(made.feature, how=f"{words}; border: {region.stop_reason}"))


def _orient_outwards(region: Region, name: str, points: MeasuredPoints) -> Feature:
    """Return the region's shape under the feature's name, with a plane's normal pointing towards the sensor."""
    feature = replace(region.feature, name=name)
    if feature.shape != "plane" or feature.direction is None or points.normals is None:
        return feature
    seen = np.asarray(points.normals, float)[region.indices].mean(axis=0)
    return feature if seen @ feature.direction >= 0 else replace(feature, direction=-feature.direction)
