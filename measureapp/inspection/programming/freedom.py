"""Degrees of freedom that an alignment fixes, known from the nominal features before anything is measured."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.alignment_program import (
    AlignmentProgram,
    BestFit,
    DatumAlignment,
    ReferencePoint,
    ReferencePoints,
    ThreeTwoOne,
)
from measureapp.data.inspection_program import InspectionProgram, MeasuredFeature, copy_names
from measureapp.errors import InspectionError
from measureapp.inspection.alignment.by_features import require_role, solve_motion
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.programming.nominals import nominals_of
from measureapp.inspection.tolerances.datums import describe_free_motions

ALL = 6


@dataclass(frozen=True, slots=True)
class FreedomStep:
    """One element of an alignment in its order."""

    element: str
    fixed: int  # degrees of freedom that it fixes in addition
    problem: str = ""  # why it fixes nothing
    refused: bool = False  # the alignment fails with it


@dataclass(frozen=True, slots=True, eq=False)
class Freedom:
    """Degrees of freedom of the part under an alignment."""

    fixed: int  # of 6
    steps: tuple[FreedomStep, ...]
    free: tuple[str, ...]  # the free motions in words
    motions: FloatArray  # (6, F): the free motions: translations in mm, rotations in rad times `ARM_MM`, about the nominal's origin


def alignment_freedom(program: InspectionProgram, alignment: AlignmentProgram) -> Freedom:
    """Return what an alignment by features of ``program`` fixes, element by element.

    An alignment that is not complete yet is given with the elements it has, as datums A or A, B, or as its first reference points.
    """
    if isinstance(alignment, ReferencePoints):
        return points_freedom(program, alignment.points)
    if isinstance(alignment, ThreeTwoOne):
        return three_two_one_freedom(program, (alignment.plane, alignment.line, alignment.point))
    if isinstance(alignment, DatumAlignment):
        return datums_freedom(program, alignment.datums)
    words = "all points" if isinstance(alignment, BestFit) else "the part's coordinates"
    return Freedom(ALL, (FreedomStep(words, ALL),), (), np.zeros((ALL, 0)))


def datums_freedom(program: InspectionProgram, names: Sequence[str]) -> Freedom:
    """Return what datums fix, in this order; fewer than three may be given."""
    perfect = _perfect_features(program)
    return _freedom_in_order(names, lambda chosen: {name: _known(perfect, name) for name in chosen})


def three_two_one_freedom(program: InspectionProgram, names: Sequence[str]) -> Freedom:
    """Return what the plane, line and point of a 3-2-1 alignment fix, in this order; fewer than three may be given."""
    perfect = _perfect_features(program)

    def as_datums(chosen: Sequence[str]) -> Mapping[str, FoundFeature]:
        require_role([_known(perfect, name) for name in names[: names.index(chosen[-1]) + 1]])
        return {name: _as_datum(perfect, name) for name in chosen}

    return _freedom_in_order(names, as_datums)


def _freedom_in_order(names: Sequence[str], as_datums: Callable[[Sequence[str]], Mapping[str, FoundFeature]]) -> Freedom:
    steps: list[FreedomStep] = []
    kept: list[str] = []
    motions: FloatArray = np.eye(ALL)
    for name in names:
        try:
            _, left = solve_motion(DatumAlignment(datums=(*kept, name)), as_datums((*kept, name)))
        except InspectionError as error:
            steps.append(FreedomStep(name, 0, error.message, True))
            continue
        steps.append(FreedomStep(name, motions.shape[1] - left.shape[1]))
        kept.append(name)
        motions = left
    return Freedom(ALL - motions.shape[1], tuple(steps), describe_free_motions(motions), motions)


def points_freedom(program: InspectionProgram, points: Sequence[ReferencePoint]) -> Freedom:
    """Return what reference points fix, one after the other; fewer than three may be given."""
    steps: list[FreedomStep] = []
    kept: list[ReferencePoint] = []
    motions: FloatArray = np.eye(ALL)
    perfect = _perfect_features(program)
    for point in points:
        found = {one.feature: _known(perfect, one.feature) for one in (*kept, point)}
        try:
            _, left = solve_motion(ReferencePoints.model_construct(points=(*kept, point)), found)
        except InspectionError as error:
            steps.append(FreedomStep(point.feature, 0, error.message, True))
            continue
        gained = motions.shape[1] - left.shape[1]
        steps.append(FreedomStep(point.feature, gained, "" if gained else "fixes nothing new; it takes part in the least squares"))
        kept.append(point)
        motions = left
    return Freedom(ALL - motions.shape[1], tuple(steps), describe_free_motions(motions), motions)


def _perfect_features(program: InspectionProgram) -> Mapping[str, FoundFeature]:
    """Return all features found exactly at their nominals; a surface point has its point, as the measured one has."""
    patches = {
        name
        for one in program.features
        if isinstance(one, MeasuredFeature) and one.shape == "surface_point"
        for name in copy_names(one.name, one.repeat)
    }
    return {
        name: FoundFeature(name, nominal, nominal=nominal, points_mm=nominal.point_mm[None] if name in patches else np.empty((0, 3)))
        for name, nominal in nominals_of(program).items()
    }


def _known(perfect: Mapping[str, FoundFeature], name: str) -> FoundFeature:
    return perfect.get(name) or FoundFeature(name, None, f"{name} has no nominal position")


def _as_datum(perfect: Mapping[str, FoundFeature], name: str) -> FoundFeature:
    """Return a feature as a datum; a surface point, the last element of a 3-2-1 alignment, constrains the same as a plane through it."""
    found = _known(perfect, name)
    if found.nominal is None or len(found.points_mm) == 0:
        return found
    plane = replace(found.nominal, shape="plane")
    return FoundFeature(name, plane, nominal=plane)
