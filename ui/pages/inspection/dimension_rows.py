"""Texts about dimensions and features: rows of the tree, and properties."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import TYPE_CHECKING

from measureapp.data.dimension import CONTRIBUTION_DIGITS
from ui.look.language.words import later, tr, translated
from ui.look.wording import counted, dimension_words, millimetres, percent, quantity, sentence, sentence_case, several
from ui.widgets.properties_panel import Group, Properties

if TYPE_CHECKING:
    from measureapp.data.dimension import Dimension
    from measureapp.data.feature import Feature
    from measureapp.data.measurement import Alignment
    from ui.controllers.program_rows import Construction, ProgramEntries


ALIGNMENTS = (later("best fit"), later("datums"), later("reference points"), later("coordinates"))  # names that results state
KIND = later("angle")  # of a dimension, as refusals state it
SHAPES = {
    "plane": later("plane"),
    "circle": later("circle"),
    "cylinder": later("cylinder"),
    "cone": later("cone"),
    "sphere": later("sphere"),
    "line": later("line"),
    "point": later("point"),
    "slot": later("slot"),
    "edge": later("edge"),
    "torus": later("torus"),
}
MOST_SOURCES = 3  # named of a constructed feature
NONE_MADE: Mapping[str, Construction] = MappingProxyType({})


def unit_of(dimension: Dimension) -> str:
    """Return the unit as it is printed."""
    return "°" if dimension.unit == "deg" else dimension.unit


def removal_words(entries: ProgramEntries) -> str:
    """Name the button that removes entries of the program: which, as a dimension and a feature may have the same name."""
    if len(entries.names) != 1:
        return tr("Remove {entries}", entries=several(len(entries.names), entries.kind))
    name = dimension_words(entries.names[0])
    if entries.kind == "dimension":
        return tr("Remove dimension {name}", name=name)
    return tr("Remove pattern {name}", name=name) if entries.is_pattern else tr("Remove feature {name}", name=name)


def is_blade(feature: Feature) -> bool:
    """Return whether a feature is a blade section: a measured point feature without a direction."""
    return feature.shape == "point" and feature.points > 0 and feature.direction is None


def feature_words(feature: Feature, role: str = "") -> str:
    """Return one line about a feature: name, shape, number of points and form deviation."""
    form = "" if is_blade(feature) else tr(", form {form_error_mm}", form_error_mm=millimetres(feature.form_error_mm))
    found = f"{several(feature.points, 'point')}{form}" if feature.points else "constructed"
    name = f"{role}{sentence_case(feature.name)}"
    return tr("{name}: {shape}, {found}", name=name, shape=shape_words(feature), found=found)


def shape_words(feature: Feature, made: Construction | None = None) -> str:
    """Return the shape of a feature in words; ``made``: what it is constructed from, with the points of which it is stated."""
    is_section = made is None and is_blade(feature)
    return translated("blade section" if is_section else SHAPES.get(str(feature.shape), str(feature.shape)))


def source_words(made: Construction) -> str:
    """Return the names of the features that one is constructed from, the first few of many."""
    names = [sentence_case(name) for name in made.of[:MOST_SOURCES]]
    more = len(made.of) - len(names)
    return ", ".join(names) if not more else tr("{names} and {count} more", names=", ".join(names), count=more)


def datum_words(datums: Sequence[str], letters: Sequence[str]) -> str:
    """Return datums with their letters: ``A Gear face, D Bore``; without letters, which a pattern has not, their names alone."""
    names = [sentence_case(name) for name in datums]
    return ", ".join(f"{letter} {name}" for letter, name in zip(letters, names, strict=True)) if letters else ", ".join(names)


def features_of(dimension: Dimension, known: dict[str, Feature]) -> list[tuple[str, Feature | None]]:
    """Return features and datums of a dimension, in the order of its leaves: names, and features if found."""
    return [(name, known.get(name)) for name in dict.fromkeys((*dimension.features, *dimension.datums))]


@dataclass(frozen=True)
class Selection:
    """The selected dimension with its features, or the selected features."""

    dimension: Dimension | None = None  # None: features are selected
    features: tuple[Feature, ...] = ()  # of the dimension, or those selected


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


def alignment_words(program: str, alignment: Alignment) -> str:
    """Return the state of an inspection: program and alignment; without one there is no residual to state."""
    if alignment.name.startswith("none"):
        return tr("{program}. Not aligned: the part frame is taken as that of the nominal.", program=sentence_case(program))
    return tr(
        "{program}. Aligned by {name}, {rms_mm} rms.",
        program=sentence_case(program),
        name=alignment.name,
        rms_mm=millimetres(alignment.rms_mm),
    )


def alignment_group(alignment: Alignment) -> Group:
    """Return the alignment to the nominal, and the motions it does not determine."""
    rows = [
        ("Method", sentence_case(alignment.name)),
        ("Residual (rms)", millimetres(alignment.rms_mm)),
        ("Overlap", percent(alignment.overlap, 0)),
    ]
    rows += [(tr("Residual at {name}", name=name), millimetres(off)) for name, off in alignment.residuals_mm.items()]
    rows += [("", sentence(tr("not determined: {motion}", motion=motion))) for motion in alignment.undetermined]
    return Group("Alignment", (*rows, *(("", note) for note in alignment.notes)))


def dimension_properties(
    dimension: Dimension, features: Sequence[Feature], alignment: Alignment, rule: str, made: Mapping[str, Construction] = NONE_MADE
) -> Properties:
    """Return the properties of one dimension, with its alignment and decision ``rule``; ``made`` has the constructed features."""
    unit = unit_of(dimension)
    kind = sentence_case(dimension.kind)
    values = Group(
        "Result",
        (
            *((("Kind", kind),) if kind else ()),
            *((("Datums", datum_words(dimension.datums, dimension.datum_letters)),) if dimension.datums else ()),
            ("Aligned by", sentence_case(dimension.alignment or alignment.name)),
            ("Nominal", quantity(dimension.nominal, unit)),
            ("Tolerance", tolerance(dimension.lower_tolerance, dimension.upper_tolerance, unit)),
            ("Measured", quantity(dimension.measured, unit)),
            ("Deviation", quantity(dimension.deviation, unit, signed=True)),
            ("Relative deviation", percent(dimension.relative_deviation, 3, signed=True)),
            ("Uncertainty (k = 2)", quantity(dimension.round_uncertainty(), unit)),
        ),
    )
    evaluated = tr("evaluated by version {version} of MeasureApp", version=dimension.version) if dimension.version else ""
    taken = tuple(
        ("", sentence(part)) for part in (*dimension.traceability.split("; "), evaluated) if part and not part.startswith("datums ")
    )
    groups = [values]
    if contributions := dimension.rank_contributions():
        rows = tuple((sentence_case(name), quantity(size, unit, CONTRIBUTION_DIGITS)) for name, size in contributions)
        groups.append(Group("Uncertainty budget (k = 2)", rows))
    if taken:
        groups.append(Group("Traceability", taken))
    groups += [feature_group(feature, made.get(feature.name)) for feature in features]
    groups.append(alignment_group(alignment))
    if rule:
        groups.append(Group("Decision rule", (("", rule),)))
    return Properties(dimension_words(dimension.name), tuple(groups), dimension.reason)


def feature_group(feature: Feature, made: Construction | None = None) -> Group:
    """Return the figures of a fit; of a constructed feature what it is made from, since it has no points of its own."""
    title = tr("{name} ({shape})", name=sentence_case(feature.name), shape=shape_words(feature, made))
    if made is not None:
        return Group(
            title,
            (
                ("Constructed from", source_words(made)),
                *([("Distance", millimetres(made.distance_mm))] if made.distance_mm is not None else []),
                *([("Radius", millimetres(feature.radius_mm))] if feature.radius_mm is not None else []),
            ),
        )
    return Group(
        title,
        (
            ("Points", counted(feature.points)),
            ("Rejected", counted(feature.left_out)),
            *([] if is_blade(feature) else [("Form deviation", millimetres(feature.form_error_mm))]),
            ("Residual (rms)", millimetres(feature.rms_mm)),
            *_sizes(feature),
        ),
    )


def _sizes(feature: Feature) -> list[tuple[str, str]]:
    """Return the sizes of a feature; a slot is toleranced by its width and length."""
    if feature.radius_mm is None:
        return []
    if feature.shape == "slot" and feature.length_mm is not None:
        return [("Width", millimetres(2 * feature.radius_mm)), ("Length", millimetres(feature.length_mm))]
    return [("Radius", millimetres(feature.radius_mm))]


def rule_name() -> str:
    """Return the standard of the rule alone."""
    return decision_rule().partition(": ")[0]


def decision_rule() -> str:
    """Return the decision rule of the verdicts, in words."""
    from measureapp.inspection.settings import InspectionSettings
    from measureapp.inspection.verdict import RULES

    return RULES[InspectionSettings().verdict_rule]
