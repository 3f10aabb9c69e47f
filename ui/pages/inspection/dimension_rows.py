"""Texts about dimensions and features: rows of the tree, and properties."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from measureapp.data.dimension import CONTRIBUTION_DIGITS
from ui.look.wording import counted, millimetres, percent, quantity, sentence, sentence_case, several
from ui.widgets.data_table import Cell, number, verdict_cell
from ui.widgets.data_tree import Branch
from ui.widgets.properties_panel import Group, Properties

if TYPE_CHECKING:
    from measureapp.data.dimension import Dimension
    from measureapp.data.feature import Feature
    from measureapp.data.measurement import Alignment, Inspection

DIGITS = {"mm": 3, "deg": 3, "°": 3}
OTHERS = "Other features"
DATUM_LETTERS = "ABC"


def unit_of(dimension: Dimension) -> str:
    """Return the unit as it is printed."""
    return "°" if dimension.unit == "deg" else dimension.unit


def dimension_words(name: str) -> str:
    """Return the name of a dimension as words; single letters are unchanged."""
    return name if len(name) == 1 else sentence_case(name)


def dimension_cells(dimension: Dimension) -> list[Cell]:
    """Return one row of the table."""
    unit = "" if dimension.unit == "mm" else unit_of(dimension)
    digits = DIGITS.get(dimension.unit, 3)
    return [
        Cell(dimension_words(dimension.name)),
        number(quantity(dimension.nominal, unit, digits)),
        number(quantity(dimension.measured, unit, digits)),
        number(quantity(dimension.deviation, unit, digits, signed=True)),
        number(quantity(dimension.round_uncertainty(digits), unit, digits)),
        verdict_cell(str(dimension.verdict), tip=dimension.reason),
    ]


def is_blade(feature: Feature) -> bool:
    """Return whether a feature is a blade section: a measured point feature without a direction."""
    return feature.shape == "point" and feature.points > 0 and feature.direction is None


def feature_words(feature: Feature, role: str = "") -> str:
    """Return one line about a feature: name, shape, number of points and form deviation."""
    form = "" if is_blade(feature) else f", form {millimetres(feature.form_error_mm)}"
    found = f"{several(feature.points, 'point')}{form}" if feature.points else "constructed"
    return f"{role}{sentence_case(feature.name)}: {shape_words(feature)}, {found}"


def shape_words(feature: Feature) -> str:
    """Return the shape of a feature in words."""
    return "blade section" if is_blade(feature) else feature.shape


def datum_words(datums: Sequence[str]) -> str:
    """Return datums with their letters: ``A Gear face, B Bore``; of a pattern, without."""
    if len(datums) > len(DATUM_LETTERS):
        return ", ".join(sentence_case(name) for name in datums)
    return ", ".join(f"{letter} {sentence_case(name)}" for letter, name in zip(DATUM_LETTERS, datums, strict=False))


def features_of(dimension: Dimension, known: dict[str, Feature]) -> list[tuple[str, Feature | None]]:
    """Return features and datums of a dimension, in the order of its leaves: names, and features if found."""
    return [(name, known.get(name)) for name in dict.fromkeys((*dimension.features, *dimension.datums))]


def branches_of(dimensions: Sequence[Dimension], features: Sequence[Feature]) -> list[Branch]:
    """Return a row for each dimension with its features and datums below it; then the features that no dimension uses."""
    known = {feature.name: feature for feature in features}
    rows = []
    for dimension in dimensions:
        leaves = []
        for name, feature in features_of(dimension, known):
            role = "" if name in dimension.features else "Datum: " if len(dimension.datums) > 3 else _letter(dimension, name)
            leaves.append(f"{role}{sentence_case(name)}: not found" if feature is None else feature_words(feature, role))
        rows.append(Branch(tuple(dimension_cells(dimension)), tuple(leaves)))
    others = other_features(dimensions, features)
    if others:
        blank = [Cell("")] * 5
        rows.append(Branch((Cell(OTHERS), *blank), tuple(feature_words(feature) for feature in others)))
    return rows


def other_features(dimensions: Sequence[Dimension], features: Sequence[Feature]) -> list[Feature]:
    """Return the features that no dimension uses."""
    used = {name for dimension in dimensions for name in (*dimension.features, *dimension.datums)}
    return [feature for feature in features if feature.name not in used]


@dataclass(frozen=True)
class Selection:
    """The dimension and features of a selected row or leaf."""

    dimension: Dimension | None = None  # None for the row of other features
    features: tuple[Feature, ...] = ()  # of the dimension, or of the leaf
    is_leaf: bool = False


def find_selection(inspection: Inspection | None, place: int, leaf: int) -> Selection:
    """Return dimension and features of a row of the tree; empty if none is selected (-1)."""
    if inspection is None or place < 0:
        return Selection()
    dimensions = inspection.dimensions
    if place >= len(dimensions):
        dimension, features = None, list(other_features(dimensions, inspection.features))
    else:
        known = {feature.name: feature for feature in inspection.features}
        dimension, features = dimensions[place], [feature for _, feature in features_of(dimensions[place], known)]
    shown = features if leaf < 0 else features[leaf : leaf + 1]
    return Selection(dimension, tuple(feature for feature in shown if feature is not None), leaf >= 0)


def _letter(dimension: Dimension, name: str) -> str:
    return f"Datum {DATUM_LETTERS[dimension.datums.index(name)]}: "


def tolerance(lower: float | None, upper: float | None, unit: str) -> str:
    """Return a tolerance: ``± 0.100 mm``, both limits where they differ, ``0 / +0.200 mm`` for the width of a zone."""
    if lower is None or upper is None:
        return "none: no verdict"
    if -lower == upper:
        return f"±\u00a0{quantity(upper, unit)}"
    low, high = ("0" if limit == 0 else quantity(limit, "", signed=True) for limit in (lower, upper))
    return quantity_with_unit(f"{low}\u00a0/\u00a0{high}", unit)


def quantity_with_unit(words: str, unit: str) -> str:
    """Return words with a unit behind them."""
    return f"{words}{unit}" if unit in {"", "°"} else f"{words}\u00a0{unit}"


def alignment_group(alignment: Alignment) -> Group:
    """Return the alignment to the nominal, and the motions it does not determine."""
    rows = [
        ("Method", sentence_case(alignment.name)),
        ("Residual (rms)", millimetres(alignment.rms_mm)),
        ("Overlap", percent(alignment.overlap, 0)),
    ]
    rows += [(f"Residual at {name}", millimetres(off)) for name, off in alignment.residuals_mm.items()]
    rows += [("", sentence(f"not determined: {motion}")) for motion in alignment.undetermined]
    return Group("Alignment", (*rows, *(("", note) for note in alignment.notes)))


def dimension_properties(dimension: Dimension, features: Sequence[Feature], alignment: Alignment, rule: str) -> Properties:
    """Return the properties of one dimension, with its alignment and decision ``rule``."""
    unit = unit_of(dimension)
    kind = sentence_case(dimension.kind)
    values = Group(
        "Result",
        (
            *((("Kind", kind),) if kind else ()),
            *((("Datums", datum_words(dimension.datums)),) if dimension.datums else ()),
            ("Nominal", quantity(dimension.nominal, unit)),
            ("Tolerance", tolerance(dimension.lower_tolerance, dimension.upper_tolerance, unit)),
            ("Measured", quantity(dimension.measured, unit)),
            ("Deviation", quantity(dimension.deviation, unit, signed=True)),
            ("Relative deviation", percent(dimension.relative_deviation, 3, signed=True)),
            ("Uncertainty (k = 2)", quantity(dimension.round_uncertainty(), unit)),
        ),
    )
    taken = tuple(("", sentence(part)) for part in dimension.traceability.split("; ") if part and not part.startswith("datums "))
    groups = [values]
    if contributions := dimension.rank_contributions():
        rows = tuple((sentence_case(name), quantity(size, unit, CONTRIBUTION_DIGITS)) for name, size in contributions)
        groups.append(Group("Uncertainty budget (k = 2)", rows))
    if taken:
        groups.append(Group("Traceability", taken))
    groups += [feature_group(feature) for feature in features]
    groups.append(alignment_group(alignment))
    if rule:
        groups.append(Group("Decision rule", (("", rule),)))
    return Properties(dimension_words(dimension.name), tuple(groups), dimension.reason)


def feature_group(feature: Feature) -> Group:
    """Return the figures of a fit."""
    return Group(
        f"{sentence_case(feature.name)} ({shape_words(feature)})",
        (
            ("Points", counted(feature.points)),
            ("Rejected", counted(feature.left_out)),
            *([] if is_blade(feature) else [("Form deviation", millimetres(feature.form_error_mm))]),
            ("Residual (rms)", millimetres(feature.rms_mm)),
            *([("Radius", millimetres(feature.radius_mm))] if feature.radius_mm is not None else []),
        ),
    )


def rule_name() -> str:
    """Return the standard of the rule alone."""
    return decision_rule().partition(": ")[0]


def decision_rule() -> str:
    """Return the decision rule of the verdicts, in words."""
    from measureapp.inspection.settings import InspectionSettings
    from measureapp.inspection.verdict import RULES

    return RULES[InspectionSettings().verdict_rule]
