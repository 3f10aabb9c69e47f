"""Nominal features of a program, and the nominals of dimensions that follow from them."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace

from measureapp.data.feature import Feature
from measureapp.data.inspection_program import ConstructedFeature, InspectionProgram, MeasuredFeature
from measureapp.errors import InspectionError
from measureapp.inspection.evaluate import evaluate_nominal
from measureapp.inspection.features.construct import construct
from measureapp.inspection.features.cut import nominal_features
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.settings import InspectionSettings

DIGITS = 9  # of a nominal from features: what rounding leaves of a number such as 30


def nominals_of(program: InspectionProgram) -> Mapping[str, Feature]:
    """Return the nominal of every feature that has one, by name (copies of patterns by theirs), in the nominal's frame."""
    known: dict[str, FoundFeature] = {}
    for described in program.features:
        if isinstance(described, MeasuredFeature) and described.placed:
            known |= {one.feature.name: FoundFeature(one.feature.name, one.feature) for one in nominal_features(described)}
        elif isinstance(described, ConstructedFeature):
            made = construct(described, _Unplaced(known))
            known |= {name: one for name, one in made.items() if one.feature is not None}
    return {name: replace(one.feature, name=name) for name, one in known.items() if one.feature is not None}


def with_designed_standards(program: InspectionProgram) -> InspectionProgram:
    """Return a program for points on the nominal itself: its certified lengths are as designed, where they follow from nominal features."""
    dimensions = []
    for one in program.dimensions:
        if one.certificate is not None:
            with suppress(InspectionError):
                certificate = one.certificate.model_copy(update={"material": ""})
                one = one.model_copy(update={"nominal": linked_nominal(program, one.name), "certificate": certificate})  # noqa: PLW2901
        dimensions.append(one)
    return program.model_copy(update={"dimensions": tuple(dimensions)})


def linked_nominal(program: InspectionProgram, name: str) -> float:
    """Return the nominal of a dimension that follows from its nominal features.

    Raises
    ------
    InspectionError
        It does not follow from features, or one of them has no nominal position.
    """
    described = next(one for one in program.dimensions if one.name == name)
    return round(evaluate_nominal(described, nominals_of(program), InspectionSettings()), DIGITS) + 0.0


class _Unplaced(dict[str, FoundFeature]):
    """Known features; any other one has no nominal position."""

    def __missing__(self, name: str) -> FoundFeature:
        return FoundFeature(name, None, f"{name} has no nominal position")
