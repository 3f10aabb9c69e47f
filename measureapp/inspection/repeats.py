"""Mean and spread of dimensions measured several times (JCGM 100, 4.2), and the spread against the stated uncertainty."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from measureapp.data.dimension import Dimension
from measureapp.data.measurement import Inspection
from measureapp.data.repeats import RepeatedDimension, RepeatedMeasurement, RepeatStudy, SpreadTest
from measureapp.errors import InspectionError
from measureapp.inspection.uncertainty import COVERAGE_FACTOR

CONFIDENCE = 0.95  # of the intervals
LEAST_P = 0.001  # smaller probabilities are not told apart
LEVEL = 0.05  # significance level of all tests of a study together
LEAST_MEASUREMENTS = 2
MOVED_MM = 0.5  # displacement of the part on the table beyond which it was clamped anew
ARM_MM = 100.0  # typical distance of the part's points from its origin


@dataclass(frozen=True, slots=True)
class InspectedPart:
    """One measurement of the part with its inspection."""

    measurement: RepeatedMeasurement
    inspection: Inspection


def evaluate_repeats(part: str, inspected: Sequence[InspectedPart]) -> RepeatStudy:
    """Evaluate repeated measurements: mean, standard deviation and their confidence intervals for every dimension.

    A dimension without a value in some measurements is evaluated from the others, and this is stated. The level of the tests of the spread
    is divided by their number (C. E. Bonferroni), so that it holds for the study as a whole.

    Raises
    ------
    InspectionError
        There are fewer than two measurements; their programs, dimensions or nominal values differ; or two of them have identical values.
    """
    if len(inspected) < LEAST_MEASUREMENTS:
        raise InspectionError("A spread needs at least two measurements.", "Name two or more projects of the same part.")
    _require_same_dimensions(inspected)
    _require_independent(inspected)
    names = [one.name for one in inspected[0].inspection.dimensions]
    tested = sum(_is_testable([_named(one.inspection, name) for one in inspected]) for name in names)
    dimensions = tuple(_repeated(name, inspected, LEVEL / max(tested, 1)) for name in names)
    displacement = _displacement_mm([one.inspection for one in inspected])
    return RepeatStudy(
        part=part,
        program=inspected[0].inspection.program,
        measurements=tuple(one.measurement for one in inspected),
        dimensions=dimensions,
        confidence=CONFIDENCE,
        level=LEVEL,
        displacement_mm=displacement,
        sentences=(_clamping(displacement), *_incomplete(dimensions), *_spread(dimensions)),
    )


def _require_same_dimensions(inspected: Sequence[InspectedPart]) -> None:
    first = inspected[0]
    expected = {one.name: one for one in first.inspection.dimensions}
    if not expected:
        raise InspectionError(f"{first.measurement.name} has no dimensions.", "Inspect it with a program that has dimensions.")
    for other in inspected[1:]:
        hint = "Inspect all projects with the same program: measureapp process PROJECT, or the Inspect page."
        where = f"{first.measurement.name} and {other.measurement.name}"
        if other.inspection.program != first.inspection.program:
            programs = f"{first.inspection.program!r} and {other.inspection.program!r}"
            raise InspectionError(f"{where} were inspected with different programs: {programs}.", hint)
        found = {one.name: one for one in other.inspection.dimensions}
        if different := sorted(set(expected) ^ set(found)):
            raise InspectionError(f"{where} do not have the same dimensions: only one has {', '.join(different)}.", hint)
        for name, one in found.items():
            if (one.nominal, one.unit, one.kind) != (expected[name].nominal, expected[name].unit, expected[name].kind):
                values = f"{expected[name].nominal:g} {expected[name].unit} and {one.nominal:g} {one.unit}"
                raise InspectionError(f"The nominal of {name} differs between {where}: {values}.", hint)


def _require_independent(inspected: Sequence[InspectedPart]) -> None:
    """Refuse copies of one measurement: independent images never give the same values to the last digit."""
    for one, other in combinations(inspected, 2):
        values = [[dimension.measured for dimension in part.inspection.dimensions] for part in (one, other)]
        if values[0] == values[1] and any(value is not None for value in values[0]):
            raise InspectionError(
                f"{one.measurement.name} and {other.measurement.name} are the same measurement: all values agree to the last digit.",
                "Name each measurement once; a spread needs independent scans.",
            )


def _named(inspection: Inspection, name: str) -> Dimension:
    return next(one for one in inspection.dimensions if one.name == name)


def _stated_sigma(measured: Sequence[Dimension]) -> float | None:
    """Return half the root mean square of the stated U; None unless all are stated."""
    stated = [one.uncertainty for one in measured if one.measured is not None]
    if not stated or any(not one for one in stated):
        return None
    return float(np.sqrt(np.mean(np.square(np.asarray(stated, float))))) / COVERAGE_FACTOR


def _is_testable(measured: Sequence[Dimension]) -> bool:
    return sum(one.measured is not None for one in measured) >= LEAST_MEASUREMENTS and _stated_sigma(measured) is not None


def _repeated(name: str, inspected: Sequence[InspectedPart], level: float) -> RepeatedDimension:
    from scipy.stats import chi2, t

    lines = {one.measurement.name: _named(one.inspection, name) for one in inspected}
    first = next(iter(lines.values()))
    values = np.array([line.measured for line in lines.values() if line.measured is not None], float)
    degrees, tail = len(values) - 1, (1 - CONFIDENCE) / 2
    std = float(np.std(values, ddof=1)) if degrees > 0 else None
    test = None
    if std is not None and (sigma := _stated_sigma(list(lines.values()))) is not None:
        test = SpreadTest(float(chi2.sf(degrees * (std / sigma) ** 2, degrees)), level, sigma)
    return RepeatedDimension(
        name=name,
        nominal=first.nominal,
        unit=first.unit,
        values={where: line.measured for where, line in lines.items()},
        reasons={where: line.reason for where, line in lines.items() if line.measured is None},
        mean=float(values.mean()) if len(values) else None,
        std=std,
        mean_half_width=None if std is None else float(t.ppf(1 - tail, degrees)) * std / len(values) ** 0.5,
        std_interval=None
        if std is None
        else (std * float(degrees / chi2.ppf(1 - tail, degrees)) ** 0.5, std * float(degrees / chi2.ppf(tail, degrees)) ** 0.5),
        test=test,
    )


def _displacement_mm(inspections: Sequence[Inspection]) -> float | None:
    """Return the largest displacement of the part on the table between two measurements; None where an alignment does not say.

    A best fit of a symmetric part is ambiguous about its axis, so that only the displacement of the origin and of the axes' inclination
    counts, each rotation at a typical distance.
    """
    placed = [inspection.alignment.nominal_from_part for inspection in inspections]
    if all(np.allclose(one.matrix, np.eye(4)) for one in placed):
        return None
    largest = 0.0
    for one, other in combinations(placed, 2):
        moved = np.linalg.norm(one.inverse().translation_mm - other.inverse().translation_mm)
        tilted = np.linalg.norm(one.inverse().rotation[:, 2] - other.inverse().rotation[:, 2]) * ARM_MM
        largest = max(largest, float(moved), float(tilted))
    return largest


def _clamping(displacement_mm: float | None) -> str:
    if displacement_mm is None:
        return "The alignment of the program does not show whether the part was clamped anew between the measurements."
    if displacement_mm > MOVED_MM:
        return (
            f"The part was displaced by up to {displacement_mm:.1f} mm between the measurements: "
            "the spread includes clamping (reproducibility)."
        )
    return (
        f"The part was neither displaced nor tilted between the measurements ({displacement_mm:.2f} mm; a rotation about z is not "
        "considered): the spread does not include clamping."
    )


def _incomplete(dimensions: Sequence[RepeatedDimension]) -> tuple[str, ...]:
    return tuple(
        f"{one.name}: not measured in {', '.join(one.reasons)}; evaluated from {one.n} of {len(one.values)} measurements."
        for one in dimensions
        if one.reasons
    )


def _p_words(p_value: float) -> str:
    return "p < 0.001" if p_value < LEAST_P else f"p = {p_value:.2g}"


def _spread(dimensions: Sequence[RepeatedDimension]) -> tuple[str, ...]:
    tests: Mapping[str, SpreadTest] = {one.name: one.test for one in dimensions if one.test is not None}
    if not tests:
        return ("No dimension has both a spread and a stated uncertainty to compare it with.",)
    wrong = [
        f"{one.name}: the standard deviation {one.std:.4f} {one.unit} contradicts the stated uncertainty U = "
        f"{COVERAGE_FACTOR * one.test.stated_sigma:.4f} {one.unit} (chi-square test, {_p_words(one.test.p_value)}): "
        "something varies that the uncertainty budget does not contain, for example clamping, temperature or the part itself."
        for one in dimensions
        if one.test is not None and one.test.contradicts
    ]
    many = f"{len(tests)} dimensions, chi-square test at a level of {LEVEL:.0%} in all"
    tested = many if len(tests) > 1 else f"1 dimension, chi-square test at a level of {LEVEL:.0%}"
    return tuple(wrong) or (f"No spread contradicts the stated uncertainty ({tested}). Systematic errors cause no spread.",)
