"""Alignments by features: 3-2-1, datum systems and reference points."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.alignment_program import DatumAlignment, ReferencePoint, ReferencePoints, ThreeTwoOne, alignment_features
from measureapp.data.feature import Feature
from measureapp.data.inspection_program import InspectionProgram
from measureapp.data.measurement import Alignment
from measureapp.errors import InspectionError
from measureapp.geometry.transform import RigidTransform, orthonormalise
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.find_features import find_features
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.inspection.tolerances.datums import (
    ARM_MM,
    datum_system,
    describe_free_motions,
    location_directions,
    pseudo_inverse,
    require_nominals,
    twist_matrix,
)
from measureapp.inspection.value import AXES, CENTRES, require_feature, require_nominal

ROUNDS = 6  # features are searched again at the positions of the previous round
CONVERGED = 1e-4  # mm, and rad times `ARM_MM`
STEPS = 20

Step = Callable[[Mapping[str, FoundFeature]], tuple[FloatArray, FloatArray]]  # found features -> motion (4, 4), free motions (6, F)


def datum_alignment(
    points: MeasuredPoints,
    program: InspectionProgram,
    requested: DatumAlignment,
    start: Alignment,
    surface: NominalSurface | None,
    settings: InspectionSettings,
) -> Alignment:
    """Align by a datum system A, B, C (ISO 5459). Raises InspectionError for a datum that is not found or constrains nothing."""

    def step(found: Mapping[str, FoundFeature]) -> tuple[FloatArray, FloatArray]:
        datums = [found[name] for name in requested.datums]
        system = datum_system(require_nominals(datums), [require_feature(one) for one in datums])
        return system.nominal_from_measured, system.free

    name = f"datum system {'|'.join(requested.datums)}"
    return _iterate(name, points, program, start, surface, settings, step)


def three_two_one(
    points: MeasuredPoints,
    program: InspectionProgram,
    requested: ThreeTwoOne,
    start: Alignment,
    surface: NominalSurface | None,
    settings: InspectionSettings,
) -> Alignment:
    """3-2-1 alignment: a plane to its nominal, then a line or axis, then a point, each within the freedom left by the previous ones.

    Raises
    ------
    InspectionError
        A feature is not found or of the wrong shape, constrains nothing new, or a surface point would have to fix a rotation.
    """

    def step(found: Mapping[str, FoundFeature]) -> tuple[FloatArray, FloatArray]:
        trio = [found[name] for name in (requested.plane, requested.line, requested.point)]
        measured = [require_feature(one) for one in trio]
        nominals = [require_nominal(one) for one in trio]
        _require_shapes(measured)
        if _on_surface(trio[2]):
            _require_fixed_rotations(nominals, measured)
            # with all rotations fixed, it constrains the same as a plane through it
            nominals[2], measured[2] = (replace(one, shape="plane") for one in (nominals[2], measured[2]))
        system = datum_system(nominals, measured)
        return system.nominal_from_measured, system.free

    name = f"3-2-1 (plane {requested.plane}, line {requested.line}, point {requested.point})"
    return _iterate(name, points, program, start, surface, settings, step)


def _require_shapes(trio: Sequence[Feature]) -> None:
    wanted = (("plane",), ("plane", *AXES), ("plane", *CENTRES))
    words = ("a plane", "a line, an axis or a second plane", "a point, a centre or a third plane")
    for feature, shapes, word in zip(trio, wanted, words, strict=True):
        if feature.shape not in shapes:
            raise InspectionError(f"{feature.name} is a {feature.shape}: 3-2-1 needs {word} there")


def _on_surface(found: FoundFeature) -> bool:
    return require_feature(found).shape == "point" and len(found.points_mm) > 0


def _require_fixed_rotations(nominals: Sequence[Feature], measured: Sequence[Feature]) -> None:
    free = datum_system(nominals[:2], measured[:2]).free
    if np.abs(free[3:]).max(initial=0.0) > 1e-6:
        raise InspectionError(
            f"{nominals[0].name} and {nominals[1].name} do not fix {', '.join(describe_free_motions(free))}, "
            f"and the surface point {nominals[2].name} fixes a translation only. Use an axis or plane as the line, or reference points"
        )


def reference_points(
    points: MeasuredPoints,
    program: InspectionProgram,
    requested: ReferencePoints,
    start: Alignment,
    surface: NominalSurface | None,
    settings: InspectionSettings,
) -> Alignment:
    """Reference point system (RPS): least-squares alignment of reference points to their nominals along given directions.

    Motions that no point constrains stay as in ``start`` and are listed.

    Raises
    ------
    InspectionError
        A point is not found, or is an axis without directions.
    """

    def step(found: Mapping[str, FoundFeature]) -> tuple[FloatArray, FloatArray]:
        held = [_reference_rows(found[one.feature], one) for one in requested.points]
        return _least_squares(held)

    name = f"RPS ({len(requested.points)} points: {', '.join(one.feature for one in requested.points)})"
    sides = {one.feature: np.asarray(one.along, float) for one in requested.points if one.along}
    return _iterate(name, points, program, start, surface, settings, step, sides)


def _reference_rows(found: FoundFeature, requested: ReferencePoint) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return measured position, nominal position, and the constrained directions (K, 3)."""
    measured, nominal = require_feature(found), require_nominal(found)
    if requested.along:
        sides = np.asarray(requested.along, float)
        return measured.point_mm, nominal.point_mm, sides / np.linalg.norm(sides, axis=1, keepdims=True)
    if measured.shape in AXES:
        raise InspectionError(f"{found.name} is a {measured.shape}: as a reference point it needs `along`, its constrained directions")
    return measured.point_mm, nominal.point_mm, _location_directions(found)


def _location_directions(found: FoundFeature) -> FloatArray:
    """Return the directions (K, 3) in which a feature has a defined position: a surface point has its normal only."""
    nominal = require_nominal(found)
    if _on_surface(found) and nominal.direction is not None:
        return np.asarray(nominal.direction)[None]
    return location_directions(nominal)


def _least_squares(held: Sequence[tuple[FloatArray, FloatArray, FloatArray]]) -> tuple[FloatArray, FloatArray]:
    """Gauss-Newton over translation and rotation; undetermined motions stay zero."""
    placed: FloatArray = np.eye(4)
    free: FloatArray = np.zeros((6, 0))
    for _ in range(STEPS):
        rows, off = [], []
        for point, nominal, sides in held:
            at = placed[:3, :3] @ point + placed[:3, 3]
            rows.append(np.hstack([sides, np.cross(at, sides) / ARM_MM]))
            off.append(sides @ (at - nominal))
        inverse, free = pseudo_inverse(np.vstack(rows))
        motion = -inverse @ np.concatenate(off)
        placed = twist_matrix(motion) @ placed
        if np.abs(motion).max() < 1e-12:
            break
    return placed, free


def _iterate(
    name: str,
    points: MeasuredPoints,
    program: InspectionProgram,
    start: Alignment,
    surface: NominalSurface | None,
    settings: InspectionSettings,
    step: Step,
    sides: Mapping[str, FloatArray] | None = None,
) -> Alignment:
    """Find the features and align, repeatedly until convergence."""
    matrix, frame = start.nominal_from_part.matrix, start.nominal_from_part.from_frame
    needed = alignment_features(program.alignment)
    free: FloatArray = np.zeros((6, 0))
    for _ in range(ROUNDS):
        found = _find_required(name, points, program, RigidTransform(orthonormalise(matrix), "nominal", frame), surface, settings)
        try:
            moved, free = step(found)
        except InspectionError as error:
            raise InspectionError(
                f"The alignment {name} failed: {error.message}.", "Choose other features, or another alignment."
            ) from error
        matrix = moved @ matrix
        if np.abs(moved - np.eye(4))[:3].max(axis=0) @ [ARM_MM, ARM_MM, ARM_MM, 1.0] < CONVERGED:
            break
    transform = RigidTransform(orthonormalise(matrix), "nominal", frame)
    found = _find_required(name, points, program, transform, surface, settings)
    residuals = {one: _residual(found[one], (sides or {}).get(one)) for one in needed}
    rms = float(np.sqrt(np.mean(np.square(list(residuals.values())))))
    notes = (f"Motions not fixed by the features: from {start.name}",) if free.shape[1] else ()
    return Alignment(name, transform, rms, 1.0, describe_free_motions(free), residuals, notes)


def _find_required(
    name: str,
    points: MeasuredPoints,
    program: InspectionProgram,
    transform: RigidTransform,
    surface: NominalSurface | None,
    settings: InspectionSettings,
) -> Mapping[str, FoundFeature]:
    needed = alignment_features(program.alignment)
    found = find_features(points.seen_from(transform), program, surface, settings, only=needed)
    for one in needed:
        if found[one].feature is None:
            raise InspectionError(
                f"The alignment {name} failed: {found[one].reason}.", "Scan this feature, or align by features that were measured."
            )
    return found


def _residual(found: FoundFeature, sides: FloatArray | None) -> float:
    """Return the remaining deviation of a feature from its nominal position, in its constrained directions."""
    unit = _location_directions(found) if sides is None else sides / np.linalg.norm(sides, axis=1, keepdims=True)
    return float(np.linalg.norm(unit @ (require_feature(found).point_mm - require_nominal(found).point_mm)))
