"""Alignments by features: 3-2-1, datum systems and reference points."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.alignment_program import (
    AlignmentProgram,
    DatumAlignment,
    ReferencePoint,
    ReferencePoints,
    ThreeTwoOne,
    alignment_features,
)
from measureapp.data.feature import Feature
from measureapp.data.inspection_program import InspectionProgram
from measureapp.data.measurement import Alignment
from measureapp.errors import InspectionError
from measureapp.geometry.transform import RigidTransform, orthonormalise
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.find_features import find_features
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.propagation import displaced_features
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
from measureapp.inspection.uncertainty import COVERAGE_FACTOR
from measureapp.inspection.value import AXES, CENTRES, require_feature, require_nominal

ROUNDS = 6  # features are searched again at the positions of the previous round
CONVERGED = 1e-4  # mm, and rad times `ARM_MM`
STEPS = 20

Step = Callable[[Mapping[str, FoundFeature]], tuple[FloatArray, FloatArray]]  # found features -> motion (4, 4), free motions (6, F)


def align_by_features(
    points: MeasuredPoints,
    program: InspectionProgram,
    start: Alignment,
    surface: NominalSurface | None,
    settings: InspectionSettings,
) -> Alignment:
    """Align by the features of the program's alignment: datum system A, B, C (ISO 5459), 3-2-1, or reference points (RPS).

    - datums: each is aligned within the freedom left by the earlier ones;
    - 3-2-1: a plane to its nominal, then a line or axis, then a point, each within the freedom left by the previous ones;
    - RPS: least squares of all reference points to their nominals along given directions.

    Motions that no feature constrains stay as in ``start`` and are listed.

    Raises
    ------
    InspectionError
        A feature is not found or of the wrong shape, constrains nothing new, or a surface point would have to fix a rotation.
    """
    requested = program.alignment
    sides: dict[str, FloatArray] = {}
    if isinstance(requested, DatumAlignment):
        name = f"datum system {'|'.join(requested.datums)}"
    elif isinstance(requested, ThreeTwoOne):
        name = f"3-2-1 (plane {requested.plane}, line {requested.line}, point {requested.point})"
    else:
        assert isinstance(requested, ReferencePoints)
        name = f"RPS ({len(requested.points)} points: {', '.join(one.feature for one in requested.points)})"
        sides = {one.feature: np.asarray(one.directions, float) for one in requested.points if one.directions}
    return _iterate(name, points, program, start, surface, settings, lambda found: solve_motion(requested, found), sides)


def solve_motion(requested: AlignmentProgram, found: Mapping[str, FoundFeature]) -> tuple[FloatArray, FloatArray]:
    """Return the motion (4, 4) that aligns found features to their nominals, and the motions (6, F) that they do not fix."""
    if isinstance(requested, ReferencePoints):
        return _least_squares([_reference_rows(found[one.feature], one) for one in requested.points])
    if isinstance(requested, ThreeTwoOne):
        return _three_two_one([found[name] for name in (requested.plane, requested.line, requested.point)])
    assert isinstance(requested, DatumAlignment)
    datums = [found[name] for name in requested.datums]
    system = datum_system(require_nominals(datums), [require_feature(one) for one in datums])
    return system.nominal_from_measured, system.free


def _three_two_one(trio: Sequence[FoundFeature]) -> tuple[FloatArray, FloatArray]:
    measured = [require_feature(one) for one in trio]
    nominals = [require_nominal(one) for one in trio]
    for place in range(len(trio)):
        require_role(trio[: place + 1])
    if _on_surface(trio[2]):
        # with all rotations fixed, it constrains the same as a plane through it
        nominals[2], measured[2] = (replace(one, shape="plane") for one in (nominals[2], measured[2]))
    system = datum_system(nominals, measured)
    return system.nominal_from_measured, system.free


def require_role(elements: Sequence[FoundFeature]) -> None:
    """Require that the last of one to three elements can be the plane, the line or the point of a 3-2-1 alignment; raises InspectionError."""
    wanted = (("plane",), ("plane", *AXES), ("plane", *CENTRES))[len(elements) - 1]
    word = ("a plane", "a line, an axis or a second plane", "a point, a centre or a third plane")[len(elements) - 1]
    measured = [require_feature(one) for one in elements]
    if measured[-1].shape not in wanted:
        raise InspectionError(f"{measured[-1].name} is a {measured[-1].shape}: 3-2-1 needs {word} there")
    if len(elements) == 3 and _on_surface(elements[-1]):
        _require_fixed_rotations([require_nominal(one) for one in elements], measured)


def _on_surface(found: FoundFeature) -> bool:
    return require_feature(found).shape == "point" and len(found.points_mm) > 0


def _require_fixed_rotations(nominals: Sequence[Feature], measured: Sequence[Feature]) -> None:
    free = datum_system(nominals[:2], measured[:2]).free
    if np.abs(free[3:]).max(initial=0.0) > 1e-6:
        raise InspectionError(
            f"{nominals[0].name} and {nominals[1].name} do not fix {', '.join(describe_free_motions(free))}, "
            f"and the surface point {nominals[2].name} fixes a translation only. Use an axis or plane as the line, or reference points"
        )


def _reference_rows(found: FoundFeature, requested: ReferencePoint) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return measured position, nominal position, and the constrained directions (K, 3)."""
    measured, nominal = require_feature(found), require_nominal(found)
    if requested.directions:
        sides = np.asarray(requested.directions, float)
        return measured.point_mm, nominal.point_mm, sides / np.linalg.norm(sides, axis=1, keepdims=True)
    if measured.shape in AXES:
        raise InspectionError(
            f"{found.name} is a {measured.shape}: as a reference point it needs `along` or `lock`, its constrained directions"
        )
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
    weakest, direction = weakest_direction(program.alignment, [found[one] for one in needed], points.points_mm, transform)
    return Alignment(
        name,
        transform,
        rms,
        1.0,
        describe_free_motions(free),
        residuals,
        notes,
        fixed=6 - free.shape[1],
        weakest_mm=weakest,
        weakest_direction=direction,
    )


def weakest_direction(
    requested: AlignmentProgram, found: Sequence[FoundFeature], points_mm: FloatArray, transform: RigidTransform
) -> tuple[float, tuple[float, ...]]:
    """Return the largest expanded uncertainty (k = 2) of a corner of the part's box by the errors of the features, and its direction."""
    names = [one.name for one in found]
    low, high = points_mm.min(axis=0), points_mm.max(axis=0)
    corners = transform.apply(np.array([[x, y, z] for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]))
    base, _ = solve_motion(requested, dict(zip(names, found, strict=True)))
    covariance = np.zeros((len(corners), 3, 3))
    for features in displaced_features(found):
        displaced = {name: replace(one, feature=feature) for name, one, feature in zip(names, found, features, strict=True)}
        try:
            moved, _ = solve_motion(requested, displaced)
        except InspectionError:  # at the limit of what fixes the part
            continue
        change = (moved - base)[:3]
        shift = corners @ change[:, :3].T + change[:, 3]
        covariance += shift[:, :, None] * shift[:, None, :]
    values, vectors = np.linalg.eigh(covariance)
    worst = int(values[:, -1].argmax())
    direction = vectors[worst, :, -1]
    return COVERAGE_FACTOR * float(np.sqrt(max(values[worst, -1], 0.0))), tuple(float(value) for value in direction)


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
