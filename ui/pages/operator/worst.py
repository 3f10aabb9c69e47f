"""The worst dimensions of a part: in words, drawn on the part, and where to look from."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from measureapp.data.verdicts import worst_first
from ui.look.language.words import tr, translated
from ui.look.theme import Theme
from ui.look.wording import NOTHING, dimension_words, quantity
from ui.pages.inspection.dimension_rows import features_of, unit_of
from ui.pages.inspection.feature_lines import feature_lines, verdict_rgb
from ui.pages.inspection.part_picture import GREYS
from ui.pages.layers import mesh_layer, points_layer, rgb
from ui.pages.viewport_page import Composer, Picture
from ui.viewport.layers import Label, LineLayer
from ui.widgets.data_table import VERDICT_WORDS
from ui.workers.job import Job

if TYPE_CHECKING:
    from measureapp.data.dimension import Dimension
    from measureapp.data.feature import Feature
    from measureapp.data.measurement import Inspection, Measurement

MOST = 3
LETTERS_PX = 20.0  # of labels: read from two metres
OBLIQUE = np.array([-0.45, -0.5, 0.55])  # added to the direction of a feature, so that its edges show
UPRIGHT = 0.3  # cosine between an axis and the vertical of the table, above which it has an upper end


@dataclass(frozen=True)
class DimensionWords:
    """One dimension as an operator reads it."""

    name: str
    value: str
    limit: str
    verdict: str


def shown_dimensions(dimensions: Sequence[Dimension]) -> tuple[Dimension, ...]:
    """Return the worst dimensions, at most three: those that do not pass, or of a part that passes those nearest to a limit."""
    ordered = worst_first(dimensions)
    open_ = [one for one in ordered if one.verdict not in ("pass", "no tolerance")]
    return tuple(open_[:MOST] or ordered[:MOST])


def words_of(dimension: Dimension) -> DimensionWords:
    """Return name, value, the limit that counts, and verdict."""
    unit = unit_of(dimension)
    value = quantity(dimension.measured, unit) if dimension.measured is not None else NOTHING
    return DimensionWords(dimension_words(dimension.name), value, _limit(dimension, unit), str(dimension.verdict))


def _limit(dimension: Dimension, unit: str) -> str:
    deviation, lower, upper = dimension.deviation, dimension.lower_tolerance, dimension.upper_tolerance
    if deviation is None:
        return dimension.reason or "It could not be measured."
    if lower is None or upper is None:
        return "The program states no tolerance."
    above = deviation > (lower + upper) / 2
    bound = upper if above else lower
    words = {
        "limit": quantity(dimension.nominal + bound, unit),
        "u": f"±\u00a0{quantity(dimension.round_uncertainty(), unit)}",
        "past": quantity(abs(deviation - bound), unit),
    }
    if dimension.verdict == "not proven":
        return tr("at most {limit}, measured to {u}" if above else "at least {limit}, measured to {u}", **words)
    if dimension.verdict == "fail":
        return tr("at most {limit}: {past} too large" if above else "at least {limit}: {past} too small", **words)
    return tr("at most {limit}" if above else "at least {limit}", **words)


def drawn(inspection: Inspection, theme: Theme) -> tuple[list[LineLayer], list[Label]]:
    """Return outlines and labels of the worst dimensions, each in the colour of its verdict; the worst one is drawn last."""
    shown = shown_dimensions(inspection.dimensions)
    lines: list[LineLayer] = []
    for dimension in reversed(shown):
        lines += feature_lines((), _features(inspection, dimension), dimension, None, verdict_rgb(theme, dimension))
    return lines, _labels(inspection, theme)


def _labels(inspection: Inspection, theme: Theme) -> list[Label]:
    """Return name and verdict of the worst dimensions that have a place on the part; their values stand beside the picture."""
    labels = []
    for dimension in shown_dimensions(inspection.dimensions):
        places = [feature.point_mm for feature in _features(inspection, dimension)]
        if places:
            verdict = translated(VERDICT_WORDS.get(dimension.verdict, dimension.verdict))
            words = f"{dimension_words(dimension.name)}  {verdict}"
            middle = np.mean(places[:1] if len(places) > 2 else places, axis=0)
            labels.append(Label(words, middle, rgb(theme, "text"), rgb(theme, "surface"), LETTERS_PX))
    return labels


def part_composer(measurement: Measurement, shade: str) -> Composer | None:
    """Return the composer of the measured surface, or of the points where there is none; None without an inspection."""
    inspection, mesh, stitched = measurement.inspection, measurement.mesh, measurement.stitched
    if inspection is None:
        return None
    nominal_from_part, grey = inspection.alignment.nominal_from_part, GREYS[shade]

    def compose(_job: Job) -> Picture:
        if mesh is not None:
            return Picture(surface=mesh_layer(mesh, nominal_from_part, grey))
        return Picture((points_layer(stitched, nominal_from_part, grey),))

    return compose


def seen_from(inspection: Inspection) -> tuple[float, float, float] | None:
    """Return the direction from which the worst dimension is seen, in the nominal's frame; None where it has no place on the part."""
    shown = shown_dimensions(inspection.dimensions)
    features = _features(inspection, shown[0]) if shown else []
    if not features:
        return None
    middle = np.mean([feature.point_mm for feature in inspection.features], axis=0)
    up = inspection.alignment.nominal_from_part.rotate(np.array([[0.0, 0.0, 1.0]]))[0]
    outward = [_outward(feature, middle, up) for feature in features]
    together = np.sum(outward, axis=0)
    direction = together if np.linalg.norm(together) > 0.5 else outward[0]
    seen = direction / max(float(np.linalg.norm(direction)), 1e-9) + OBLIQUE
    return float(seen[0]), float(seen[1]), float(seen[2])


def _features(inspection: Inspection, dimension: Dimension) -> list[Feature]:
    known = {feature.name: feature for feature in inspection.features}
    return [feature for _, feature in features_of(dimension, known) if feature is not None]


def _outward(feature: Feature, middle: np.ndarray, up: np.ndarray) -> np.ndarray:
    """Return the direction of a feature, away from the middle of the part; of an upright axis upwards: nothing is measured from below."""
    away = np.asarray(feature.point_mm) - middle
    direction = away if feature.direction is None else np.asarray(feature.direction)
    size = float(np.linalg.norm(direction))
    if size < 1e-9:
        return np.array([0.0, 0.0, 1.0])
    lean = float(direction @ up) / size
    side = lean if feature.shape != "plane" and abs(lean) > UPRIGHT else float(direction @ away)
    return direction / size * (-1.0 if feature.direction is not None and side < 0 else 1.0)
