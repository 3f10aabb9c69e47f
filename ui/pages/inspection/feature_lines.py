"""Features and dimensions as lines and labels of the 3-D view."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import TYPE_CHECKING

import numpy as np

from ui.look.theme import Theme
from ui.pages.inspection.outlines import outline
from ui.pages.inspection.section_lines import Whiskers, blade_layers
from ui.viewport.layers import LineLayer

if TYPE_CHECKING:
    from measureapp.data.dimension import Dimension
    from measureapp.data.feature import Feature
    from measureapp.inspection.section_curves import SectionCurves

OUTLINE = (70, 82, 90)  # visible on the part in both themes
Colour = tuple[int, int, int]


def verdict_rgb(theme: Theme, dimension: Dimension) -> Colour:
    """Return the colour of a dimension's verdict as three numbers."""
    colour = theme.verdict(dimension.verdict)
    return colour.red(), colour.green(), colour.blue()


def feature_lines(
    features: Sequence[Feature], mine: Collection[Feature], dimension: Dimension | None, sections: SectionCurves | None, colour: Colour
) -> list[LineLayer]:
    """Return all features in grey and ``mine`` in colour; for a dimension also the measured lines."""
    blades = {} if sections is None else sections.blades
    quiet = [line for feature in features if feature not in mine for line in _lines(feature, sections)]
    strong = [line for feature in mine if feature.name not in blades for line in _lines(feature, sections)]
    centres = np.array([feature.point_mm for feature in mine])
    if dimension is not None and len(mine) > 1 and not any(feature.name in blades for feature in mine):
        strong.append(centres)
    layers = [LineLayer(tuple(quiet), OUTLINE, 1.5), LineLayer(tuple(strong), colour, 3.5)]
    if sections is not None:
        names = [feature.name for feature in mine if feature.name in blades]
        nominal = [curve for name in names for curve in sections.nominal_blades[name]]
        layers += blade_layers(dimension.kind if dimension is not None else "", [blades[name] for name in names], nominal, colour, OUTLINE)
        if dimension is not None and dimension.name in sections.profiles:
            found = sections.profiles[dimension.name]
            layers += [LineLayer(found.nominal, OUTLINE, 1.5), *Whiskers.of(found).layers()]
    return [layer for layer in layers if layer.lines]


def _lines(feature: Feature, sections: SectionCurves | None) -> list[np.ndarray]:
    if sections is not None and feature.name in sections.blades:
        return list(sections.blades[feature.name].outline)
    line = outline(feature)
    return [line] if len(line) else []
