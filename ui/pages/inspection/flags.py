"""Flags in the picture: dimensions, probes, and the extremes of the deviation."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from ui.look.language.words import tr
from ui.look.wording import dimension_words, millimetres, quantity
from ui.pages.inspection.dimension_rows import features_of, tolerance, unit_of
from ui.pages.inspection.outlines import outline
from ui.pages.inspection.section_lines import Whiskers
from ui.viewport.overlay.flag import Flag

if TYPE_CHECKING:
    from measureapp.data.control_frame import ControlFrame
    from measureapp.data.dimension import Dimension
    from measureapp.data.feature import Feature
    from measureapp.inspection.section_curves import SectionCurves
    from measureapp.inspection.surface.probe import ProbeValue
    from measureapp.inspection.surface.statistics import DeviationStatistics

Pins = Mapping[str, tuple[float, float]]
DIMENSION = "dimension:"


def dimension_flags(
    dimensions: Sequence[Dimension],
    features: Sequence[Feature],
    sections: SectionCurves | None,
    pins: Pins,
    frames: Mapping[str, ControlFrame | None] | None = None,
) -> list[Flag]:
    """Return a flag for each dimension that has features in the picture; ``frames``: of the edited program, by name."""
    known = {feature.name: feature for feature in features}
    flags = []
    for dimension in dimensions:
        mine = [feature for name, feature in features_of(dimension, known) if feature is not None and name in dimension.features]
        if not mine:
            continue
        unit, key = unit_of(dimension), f"{DIMENSION}{dimension.name}"
        more = []
        if sections is not None and dimension.name in sections.profiles:
            more.append(tr("Whiskers × {gain}", gain=Whiskers.of(sections.profiles[dimension.name]).gain))
        limits = (dimension.lower_tolerance, dimension.upper_tolerance)
        frame = (frames or {}).get(dimension.name, dimension.frame)
        is_stated = limits[1] is None or (frame is not None and dimension.upper_tolerance == frame.width_mm)
        flags.append(
            Flag(
                key,
                anchor_of(mine[0]),
                dimension_words(dimension.name),
                quantity(dimension.measured, unit),
                "" if is_stated else tr("Tolerance {tolerance}", tolerance=tolerance(*limits, unit)),
                "" if dimension.uncertainty is None else f"U {quantity(dimension.round_uncertainty(), unit)}",
                str(dimension.verdict),
                tuple(more),
                pins.get(key),
                frame,
            )
        )
    return flags


def anchor_of(feature: Feature) -> np.ndarray:
    """Return a point (3,) of a feature's outline, which lies on the surface; its centre or axis may not."""
    line = outline(feature)
    return np.asarray(line[len(line) // 8] if len(line) else feature.point_mm, float)


def extreme_flags(statistics: DeviationStatistics | None, pins: Pins) -> list[Flag]:
    """Return flags at the smallest and the greatest deviation that neighbours confirm."""
    if statistics is None:
        return []
    found = (("minimum", "Minimum", statistics.minimum), ("maximum", "Maximum", statistics.maximum))
    return [
        Flag(key, np.asarray(one.point_mm, float), words, millimetres(one.value_mm, signed=True), pinned=pins.get(key))
        for key, words, one in found
        if one is not None
    ]


def probe_flag(key: str, probe: ProbeValue, pins: Pins) -> Flag:
    """Return the flag of a clicked deviation: value, number of points and uncertainty."""
    return Flag(
        key,
        np.asarray(probe.point_mm, float),
        "",
        millimetres(probe.value_mm, signed=True),
        "",
        f"U {millimetres(probe.uncertainty_mm)}, n {probe.points}",
        pinned=pins.get(key),
    )
