"""Dimensions in two steps: the value with its uncertainty budget, then limits and verdict."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from measureapp import __version__
from measureapp.data.control_frame import control_frame
from measureapp.data.datum_letters import common_datums
from measureapp.data.dimension import CONTRADICTED, Dimension, Verdict
from measureapp.data.inspection_program import ZONES, DimensionProgram, InspectionProgram
from measureapp.errors import InspectionError
from measureapp.inspection.certified_lengths import CertifiedLength, CertifiedLengths
from measureapp.inspection.evaluate import evaluate_dimension, evaluate_pattern_mean, measure_of
from measureapp.inspection.features.feature_errors import CALIBRATION, NOISE, SCALE, TEMPERATURE
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.uncertainty import COVERAGE_FACTOR, assumed_calibration
from measureapp.inspection.value import Budget, Value
from measureapp.inspection.verdict import decide_verdict

NARROW = 5  # tolerance over U below which a verdict is hardly ever possible
UNEXPLAINED = "unexplained"  # of the `CONTRIBUTIONS`
MISJUDGED = 3.0  # how much larger the unexplained may be: upper limit (95 %) of a standard deviation of three degrees of freedom
CONTRADICTION = "Most of U is what the error model does not explain: a contradicted model proves nothing; see the checks of the error model"
STATISTICS = {"mean": "mean of {count}", "min": "min of {count}", "max": "max of {count}"}  # of the copies of a pattern
MOST_LISTED = 4  # features listed individually in the traceability of a value


@dataclass(frozen=True, slots=True)
class Evaluated:
    """The value of a dimension, which does not depend on its name, nominal and tolerance; or the reason why there is none."""

    value: Value | None
    reason: str = ""


def evaluate(
    described: DimensionProgram, found: Mapping[str, FoundFeature], settings: InspectionSettings, certified: CertifiedLengths
) -> Evaluated:
    """Evaluate a dimension on the features found; a certified length itself stays as measured."""
    try:
        return Evaluated(_evaluate(described, found, settings, CertifiedLengths() if described.certificate else certified))
    except InspectionError as error:
        return Evaluated(None, error.message)


def certified_lengths(program: InspectionProgram, found: Mapping[str, FoundFeature], settings: InspectionSettings) -> CertifiedLengths:
    """Return the certified lengths of a program, as far as their features were found."""
    lengths = []
    for described in program.dimensions:
        if described.certificate is None:
            continue
        features = tuple(found[name] for name in described.features)
        try:
            measure = measure_of(described.kind, features, settings)
        except InspectionError:  # its own row says why
            continue
        known = described.certificate.known_length(described.nominal, settings.temperature)
        value = CertifiedLengths().value(measure, features)
        whole = float(np.linalg.norm(list(_complete_budget(value, described.unit, features, settings)[0].values())))
        assumed_mm = max(whole**2 - value.sigma**2, 0.0) ** 0.5
        lengths.append(CertifiedLength(described.name, measure, features, known, assumed_mm))
    return CertifiedLengths.of(lengths)


def certified_statements(program: InspectionProgram, dimensions: Sequence[Dimension], contradiction: str) -> Iterator[str]:
    """Return what was done with each certified length, for reports."""
    measured = {one.name: one for one in dimensions}
    for described in program.dimensions:
        if described.certificate is None:
            continue
        known = f"{described.name} is a {_certified_words(described)}"
        own = measured[described.name]
        if own.measured is None or own.uncertainty is None:
            yield f"{known}; not measured, so that it corrects nothing."
        elif contradiction:
            yield f"{known}; nothing is corrected. {contradiction}."
        else:
            yield f"{known}; measured {own.measured:.4f} ± {own.uncertainty:.4f} mm. Other lengths are corrected by what it is off."


def _certified_words(described: DimensionProgram) -> str:
    """Return what its certificate states of a length; empty where there is none."""
    if described.certificate is None:
        return ""
    number = f", certificate {described.certificate.number}" if described.certificate.number else ""
    return f"certified length of {described.nominal:.4f} ± {described.certificate.uncertainty_mm:.4f} mm (k = 2){number}"


def decide(
    described: DimensionProgram,
    evaluated: Evaluated,
    found: Mapping[str, FoundFeature],
    settings: InspectionSettings,
    letters: Mapping[str, str],
) -> Dimension:
    """Return the dimension with uncertainty, limits and verdict: all that follows from its value, nominal and tolerance.

    Parameters
    ----------
    letters : letter of each datum of the program by its feature
    """
    made = _decide(described, evaluated, found, settings)
    return replace(
        made,
        datum_letters=tuple(letters[name] for name in common_datums(described)),
        frame=control_frame(described, {name: _shape_of(found[name]) for name in (*made.features, *made.datums)}, letters),
    )


def _decide(
    described: DimensionProgram, evaluated: Evaluated, found: Mapping[str, FoundFeature], settings: InspectionSettings
) -> Dimension:
    value = evaluated.value
    if value is None:
        return _make_dimension(described, found, None, None, Verdict.NOT_MEASURED, evaluated.reason)
    budget, assumptions = _complete_budget(
        value, described.unit, [found[name] for names in described.feature_sets for name in names], settings
    )
    uncertainty = COVERAGE_FACTOR * float(np.linalg.norm(list(budget.values())))
    if not (np.isfinite(value.value) and np.isfinite(uncertainty)):
        return _make_dimension(described, found, None, None, Verdict.NOT_MEASURED, "the points do not determine this value")
    how = "; ".join(filter(None, (value.how, _certified_words(described), *assumptions)))
    verdict = _verdict(described, value, uncertainty, settings)
    contradicted = verdict in (Verdict.PASS, Verdict.FAIL) and (bool(value.doubt) or _is_contradicted(described, value, budget, settings))
    verdict = Verdict.NOT_PROVEN if contradicted else verdict
    made = _make_dimension(described, found, value.value, uncertainty, verdict, "", how, value.bonus)
    warning = value.doubt or (CONTRADICTION if contradicted else "") or _warn_of_narrow_tolerance(described, uncertainty) or value.warning
    return replace(made, warning=warning, budget={contribution: COVERAGE_FACTOR * sigma for contribution, sigma in budget.items()})


def _verdict(described: DimensionProgram, value: Value, uncertainty: float, settings: InspectionSettings) -> Verdict:
    if not described.is_toleranced:
        return Verdict.NO_TOLERANCE
    lower, upper = (-np.inf if described.kind in ZONES else described.lower_tolerance), described.upper_tolerance + value.bonus
    # a zone has no lower limit
    return decide_verdict(value.value - described.nominal, uncertainty, lower, upper, settings.verdict_rule)


def _is_contradicted(described: DimensionProgram, value: Value, budget: Budget, settings: InspectionSettings) -> bool:
    """Whether most of U is unexplained, and so much that the verdict would be another one if the unexplained were `MISJUDGED`."""
    unexplained = COVERAGE_FACTOR * budget.get(UNEXPLAINED, 0.0)
    uncertainty = COVERAGE_FACTOR * float(np.linalg.norm(list(budget.values())))
    if unexplained <= CONTRADICTED * uncertainty:
        return False
    widened = float(np.hypot(uncertainty, (MISJUDGED**2 - 1) ** 0.5 * unexplained))
    return _verdict(described, value, widened, settings) is not _verdict(described, value, uncertainty, settings)


def _warn_of_narrow_tolerance(described: DimensionProgram, uncertainty: float) -> str:
    """Return a warning where the tolerance is too narrow for the uncertainty of this measurement."""
    lower, upper = described.limits
    if not described.is_toleranced or upper - lower >= NARROW * uncertainty:
        return ""
    return (
        f"The tolerance of {upper - lower:.3g} {described.unit} is smaller than {NARROW} U ({NARROW * uncertainty:.3g} {described.unit}): "
        "this measurement can hardly prove it"
    )


def _evaluate(
    described: DimensionProgram, found: Mapping[str, FoundFeature], settings: InspectionSettings, certified: CertifiedLengths
) -> Value:
    """Return the value, or the mean, minimum or maximum over a pattern; noise averages out in a mean only."""
    values = [
        evaluate_dimension(described, tuple(found[name] for name in names), tuple(found[name] for name in datums), settings, certified)
        for names, datums in zip(described.feature_sets, described.datum_sets, strict=True)
    ]
    if len(values) == 1:
        return values[0]
    numbers = np.array([v.value for v in values])
    if described.statistic == "mean":
        sets = [tuple(found[name] for name in names) for names in described.feature_sets]
        together = evaluate_pattern_mean(described, sets, settings, certified)
        return together or Value(
            float(numbers.mean()), _average_budgets([v.budget for v in values], _are_disjoint(described)), values[0].how
        )
    left = numbers - np.array([v.bonus for v in values])
    return values[int(left.argmin() if described.statistic == "min" else left.argmax())]


def _complete_budget(
    value: Value, unit: str, found: Sequence[FoundFeature], settings: InspectionSettings
) -> tuple[Budget, tuple[str, ...]]:
    """Add assumed contributions to a value's uncertainty budget where the cloud has no error model; return them in words, too."""
    budget, assumptions = dict(value.budget), []
    chosen = settings.uncertainty
    if any(one.view_errors is None for one in found) and chosen.placement_mm > 0:
        assumptions.append(f"assumed: position of each view ± {chosen.placement_mm:g} mm (k = 1), as the cloud has no error model")
    if CALIBRATION not in budget and unit == "mm" and (chosen.systematic_mm or chosen.systematic_relative):
        budget[CALIBRATION] = assumed_calibration(value.value, chosen)
        assumptions.append(
            f"assumed: calibration ± {chosen.systematic_mm:g} mm and {chosen.systematic_relative * 1e6:.0f} ppm of the length (k = 1)"
        )
    if chosen.scale_ppm > 0 and unit == "mm":
        budget.setdefault(SCALE, chosen.scale_ppm * 1e-6 * abs(value.value))  # without views a value scales like a length
        assumptions.append(f"length scale ± {chosen.scale_ppm:.3g} ppm (k = 1), from {chosen.scale_source}")
    if settings.temperature is not None and unit == "mm":
        if settings.temperature.sigma > 0:
            budget.setdefault(TEMPERATURE, settings.temperature.sigma * abs(value.value))
        assumptions.append(settings.temperature.words)
    return budget, tuple(assumptions)


def _average_budgets(budgets: list[Budget], apart: bool) -> Budget:
    """Return the budget of a mean: noise of disjoint copies averages out; all other contributions are taken as fully correlated."""
    means = {
        contribution: float(np.mean([budget.get(contribution, 0.0) for budget in budgets]))
        for contribution in sorted({NOISE}.union(*budgets))
    }
    return means | {NOISE: float(np.linalg.norm([budget.get(NOISE, 0.0) for budget in budgets])) / len(budgets)} if apart else means


def _are_disjoint(described: DimensionProgram) -> bool:
    """Return whether no feature or datum belongs to two copies, whose noise would be correlated."""
    names = [name for i in range(len(described.feature_sets)) for name in {*described.feature_sets[i], *described.datum_sets[i]}]
    return len(names) == len(set(names))


def _make_dimension(
    described: DimensionProgram,
    found: Mapping[str, FoundFeature],
    value: float | None,
    uncertainty: float | None,
    verdict: Verdict,
    reason: str,
    how: str = "",
    bonus: float = 0.0,
) -> Dimension:
    lower, upper = described.limits if described.is_toleranced else (None, None)
    features = _distinct(described.feature_sets)
    datums = _distinct(described.datum_sets)
    return Dimension(
        name=described.name,
        nominal=described.nominal,
        measured=value,
        uncertainty=uncertainty,
        lower_tolerance=lower,
        upper_tolerance=None if upper is None else upper + bonus,
        verdict=verdict,
        unit=described.unit,
        reason=reason,
        features=features,
        kind=described.kind,
        datums=datums,
        tolerance_source=described.tolerance or "",
        alignment=described.alignment or "",
        group=described.group,
        traceability=_describe_traceability(described, [found[name] for name in (*features, *datums)], how),
        version=__version__,
    )


def _shape_of(found: FoundFeature) -> str:
    """Return the shape of a feature as designed where it was not found; empty if neither is known."""
    known = found.feature or found.nominal
    return "" if known is None else str(known.shape)


def _distinct(sets: tuple[tuple[str, ...], ...]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(name for names in sets for name in names))


def _describe_traceability(described: DimensionProgram, found: list[FoundFeature], how: str) -> str:
    """Describe the source of a value: points used and rejected, filter and criterion, datums in order, copies."""
    words = [_describe_points(found)]
    if how:
        words.append(how)
    if described.datums:
        words.append(f"datums {'|'.join(described.datums)}")
    if described.count:
        words.append(STATISTICS[described.statistic].format(count=described.count))
    return "; ".join(words)


def _describe_points(found: list[FoundFeature]) -> str:
    """Describe the points of each feature; for long patterns the total, and which of them have no points of their own."""
    fitted = [one for one in found if one.feature is None or len(one.points_mm)]
    constructed = [one for one in found if one.feature is not None and len(one.points_mm) == 0]
    if len(found) <= MOST_LISTED:
        return ", ".join(_describe_feature(one) for one in found)
    words = [_describe_feature(one) for few in (fitted, constructed) if len(few) <= MOST_LISTED for one in few]
    if len(fitted) > MOST_LISTED:
        known = [one for one in fitted if one.feature is not None]
        left_out = sum(one.feature.left_out for one in known if one.feature is not None)
        words.append(f"{len(known)} features: {sum(len(one.points_mm) for one in known)} points, {left_out} rejected")
    if len(constructed) > MOST_LISTED:
        words.append(f"{len(constructed)} constructed features: {constructed[0].name} … {constructed[-1].name}")
    return ", ".join(words)


def _describe_feature(found: FoundFeature) -> str:
    if found.feature is None:
        return f"{found.name}: not found"
    if len(found.points_mm) == 0:
        return f"{found.name}: constructed"
    words = f"{found.name}: {len(found.points_mm)} points, {found.feature.left_out} rejected"
    if found.draws:
        words += f", small segment: Monte Carlo, {found.draws} draws"
    return f"{words} ({found.feature.how})" if found.feature.how else words
