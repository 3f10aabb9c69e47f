"""The entry of a feature from clicks, and a trial on the measured points that proves it before it becomes part of the program."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal

from measureapp.arrays import FloatArray
from measureapp.data.feature import Feature
from measureapp.data.feature_program import MeasuredFeature
from measureapp.data.inspection_program import InspectionProgram
from measureapp.errors import InputError, InspectionError
from measureapp.inspection.features.cut import nominal_features
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.find_features import find_features
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.programming.clicking.on_nominal import circle_on_nominal, edge_on_nominal, line_on_nominal, slot_on_nominal
from measureapp.inspection.programming.clicking.on_points import circle_on_points, edge_on_points, line_on_points, slot_on_points
from measureapp.inspection.programming.clicking.patterns import pattern_on_nominal
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.progress import NoProgress, Progress

Clickable = Literal["circle", "slot", "line", "edge", "pattern"]
CLICKS: dict[Clickable, int] = {"circle": 1, "slot": 1, "line": 2, "edge": 1, "pattern": 1}  # on a nominal
CLICKS_ON_POINTS: dict[Clickable, int] = {"circle": 3, "slot": 4, "line": 2, "edge": 2}  # without one


def describe_on_nominal(kind: Clickable, surface: NominalSurface, places_mm: Sequence[FloatArray], name: str) -> dict[str, Any]:
    """Return the entry of a feature from its `CLICKS` on the nominal. Raises InspectionError where they give none."""
    if kind == "line":
        return line_on_nominal(surface, places_mm[0], places_mm[1], name)
    on_nominal = {"circle": circle_on_nominal, "slot": slot_on_nominal, "edge": edge_on_nominal, "pattern": pattern_on_nominal}
    return on_nominal[kind](surface, places_mm[0], name)


def describe_on_points(kind: Clickable, points: MeasuredPoints, places_mm: Sequence[FloatArray], name: str) -> dict[str, Any]:
    """Return the entry of a feature from its `CLICKS_ON_POINTS`. Raises InspectionError where they give none."""
    on_points = {"circle": circle_on_points, "slot": slot_on_points, "line": line_on_points, "edge": edge_on_points}
    if kind not in on_points:
        raise InspectionError(
            "A hole pattern is found on the CAD model only, and there is none.",
            "Create the holes as circles, select them, then choose Hole pattern.",
        )
    return on_points[kind](points, places_mm, name)


def nominals_described(entry: dict[str, Any]) -> tuple[Feature, ...]:
    """Return the nominal of an entry, or those of its copies. Raises InputError where the entry is not valid."""
    return tuple(one.feature for one in nominal_features(_described(entry)))


def try_feature(
    entry: dict[str, Any],
    points: MeasuredPoints,
    surface: NominalSurface | None,
    progress: Progress = NoProgress(),  # noqa: B008 - stateless
) -> tuple[FoundFeature, ...]:
    """Measure an entry, or its copies, on points in the nominal's frame, as the program would."""
    program = InspectionProgram.model_validate({"name": "clicked", "alignment": "none", "features": [_described(entry)]})
    return tuple(find_features(points, program, surface, InspectionSettings(), progress).values())


def _described(entry: dict[str, Any]) -> MeasuredFeature:
    from pydantic import ValidationError

    try:
        return MeasuredFeature.model_validate(entry)
    except ValidationError as error:
        words = str(error.errors()[0]["msg"]).removeprefix("Value error, ")
        raise InputError(f"The feature cannot be used: {words}.", "Change its values.") from None
