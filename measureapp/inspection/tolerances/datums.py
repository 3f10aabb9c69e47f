"""Datum systems (ISO 5459): up to three features that fix a part in its nominal frame, in order."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.feature import Feature
from measureapp.errors import InspectionError
from measureapp.geometry.shapes import tangents
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.value import AXES, CENTRES, require_direction, require_feature, require_nominal

ARM_MM = 100.0  # lever arm that converts rotations to lengths
OPEN = 1e-3  # relative effect below which a motion does not move a feature
ROUNDS = 20
SMALL_ANGLE = 1e-4
NO_SHIFTS: Mapping[int, FloatArray] = MappingProxyType({})
MOTIONS = ("translation along x", "translation along y", "translation along z", "rotation about x", "rotation about y", "rotation about z")


@dataclass(frozen=True, slots=True, eq=False)
class DatumSystem:
    """Motion from measured to nominal datums, and the remaining free motions."""

    names: tuple[str, ...]
    nominal_from_measured: FloatArray  # 4×4
    free: FloatArray  # (6, F): translations in mm, rotations in rad times `ARM_MM`
    fixed: tuple[FloatArray, ...] = ()  # (6, H) of each datum: the motions that it fixes in addition to earlier datums

    def apply(self, points_mm: FloatArray) -> FloatArray:
        """Transform points (..., 3) to the nominal frame."""
        return points_mm @ self.nominal_from_measured[:3, :3].T + self.nominal_from_measured[:3, 3]

    def rotate(self, direction: FloatArray) -> FloatArray:
        """Rotate a direction to the nominal frame."""
        return np.asarray(self.nominal_from_measured[:3, :3] @ direction)

    def require_location(self, nominal: Feature, name: str) -> None:
        """Raise InspectionError unless the datums fix the location of this nominal feature."""
        self._require(np.vstack([_locations(location_directions(nominal), nominal.point_mm), _orientations(nominal)]), "location", name)

    def require_direction(self, nominal: Feature, name: str) -> None:
        """Raise InspectionError unless the datums fix the orientation of this nominal feature."""
        self._require(_orientations(nominal), "orientation", name)

    def require_all_fixed(self, name: str) -> None:
        """Raise InspectionError unless the datums fix all motions, as a free-form surface requires."""
        self._require(np.eye(6), "location", name)

    def _require(self, rows: FloatArray, what: str, name: str) -> None:
        if len(rows) and self.free.shape[1] and np.abs(rows @ self.free).max() > OPEN:
            raise InspectionError(
                f"The datums {'|'.join(self.names)} do not fix the {what} of {name}: free are {', '.join(describe_free_motions(self.free))}"
            )


def describe_free_motions(free: FloatArray) -> tuple[str, ...]:
    """Describe the free motions (6, F) in words."""
    if free.shape[1] == 0:
        return ()
    axes = [name for name, axis in zip(MOTIONS, np.eye(6), strict=True) if np.linalg.norm(free @ (free.T @ axis) - axis) < OPEN]
    return tuple(axes) if axes else ("a combined rotation and translation",)


def require_nominals(datums: Sequence[FoundFeature]) -> list[Feature]:
    """Return the nominals of datums. Raises InspectionError for features that cannot be a datum."""
    for one in datums:
        shape, patch = require_feature(one).shape, len(one.points_mm) > 0
        if (shape == "point" and patch) or shape not in ("plane", *AXES, *CENTRES):
            raise InspectionError(f"{one.name} is a surface point: a datum must be a plane, an axis or a centre")
    return [require_nominal(one) for one in datums]


def datum_system(nominals: Sequence[Feature], measured: Sequence[Feature], shifts: Mapping[int, FloatArray] = NO_SHIFTS) -> DatumSystem:
    """Align measured datums to their nominals: A completely, B within the freedom left by A, C within that left by both.

    The motions that leave A invariant form a group, so that B does not move A. A later datum is first rotated, then translated, about its
    measured position; to first order in the angular errors this is the fit constrained by the earlier datums.

    Parameters
    ----------
    shifts : motion (H,) in the columns of `fixed` by which datums (by index) are displaced from their nominals; later datums follow

    Raises
    ------
    InspectionError
        A datum constrains nothing beyond the earlier ones.
    """
    placed: FloatArray = np.eye(4)
    free: FloatArray = np.eye(6)
    fixed_motions: list[FloatArray] = []
    names = tuple(one.name for one in nominals)
    for number, (nominal, feature) in enumerate(zip(nominals, measured, strict=True)):
        fixed = np.vstack([_orientations(nominal), _locations(location_directions(nominal), nominal.point_mm)]) @ free
        if np.abs(fixed).max(initial=0.0) < OPEN:
            raise InspectionError(f"Datum {nominal.name} constrains nothing beyond {'|'.join(names[: names.index(nominal.name)])}")
        placed = _align_datum(placed, free, nominal, feature)
        _, rest = pseudo_inverse(fixed)
        fixed_motions.append(free @ np.linalg.svd(fixed)[2][: free.shape[1] - rest.shape[1]].T)
        if number in shifts:
            placed = twist_matrix(fixed_motions[-1] @ shifts[number]) @ placed
        free = free @ rest
    return DatumSystem(names, placed, free, tuple(fixed_motions))


def _align_datum(placed: FloatArray, free: FloatArray, nominal: Feature, feature: Feature) -> FloatArray:
    orientations, sides = _orientations(nominal), location_directions(nominal)
    turn, turning = np.zeros(6), free
    if len(orientations):
        expected, measured = require_direction(nominal), require_direction(feature)
        across = tangents(expected)
        inverse, rest = pseudo_inverse(orientations @ free)
        following, turning = free @ inverse, free @ rest
    for _ in range(ROUNDS):
        if len(orientations):
            direction = placed[:3, :3] @ measured
            direction = direction * (np.sign(direction @ expected) or 1.0)  # an axis has no sign
            turn = -following @ (ARM_MM * (across @ (direction - expected)))
            placed = twist_matrix(turn) @ placed
        point = placed[:3, :3] @ feature.point_mm + placed[:3, 3]
        inverse, _ = pseudo_inverse(_locations(sides, point) @ turning)
        shift = -turning @ inverse @ (sides @ (point - nominal.point_mm))
        placed = twist_matrix(shift) @ placed
        if np.abs(turn).max() + np.abs(shift).max() < 1e-12:
            break
    return placed


def pseudo_inverse(rows: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the pseudo-inverse of ``rows``, and their null space (columns): the free motions."""
    u, sizes, vt = np.linalg.svd(rows)
    rank = int(np.count_nonzero(sizes > OPEN))
    return vt[:rank].T @ (u[:, :rank] / sizes[:rank]).T, vt[rank:].T


def twist_matrix(motion: FloatArray) -> FloatArray:
    """Exponential map of a twist (translation, rotation times `ARM_MM`) to a 4×4 matrix; it stays within a group of motions."""
    x, y, z = motion[3:] / ARM_MM
    angle = float(np.sqrt(x * x + y * y + z * z))
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    near = angle < SMALL_ANGLE  # first terms of the series, where the quotients lose precision
    one = 1.0 if near else np.sin(angle) / angle
    two = 0.5 if near else (1 - np.cos(angle)) / angle**2
    three = 1 / 6 if near else (angle - np.sin(angle)) / angle**3
    made = np.eye(4)
    made[:3, :3] += one * cross + two * cross @ cross
    made[:3, 3] = (np.eye(3) + two * cross + three * cross @ cross) @ motion[:3]
    return made


def location_directions(nominal: Feature) -> FloatArray:
    """Return the directions (K, 3) in which a nominal feature has a defined location."""
    if nominal.shape == "plane":
        return require_direction(nominal)[None]
    if nominal.shape == "slot" and nominal.normal is not None:
        return tangents(nominal.normal)
    return tangents(require_direction(nominal)) if nominal.shape in (*AXES, "circle") else np.eye(3)  # a cone counts as its axis


def _locations(sides: FloatArray, point_mm: FloatArray) -> FloatArray:
    """Return the Jacobian (K, 6) of a point of the feature, along its location directions (K, 3), for a motion."""
    return np.hstack([sides, _crossed(point_mm, sides) / ARM_MM])


def _orientations(nominal: Feature) -> FloatArray:
    """Return the Jacobian (2, 6) of the feature's direction times `ARM_MM` for a motion; empty for a centre."""
    if nominal.shape in ("sphere", "point", "circle", "slot") or nominal.direction is None:
        return np.empty((0, 6))
    return np.hstack([np.zeros((2, 3)), _crossed(nominal.direction, tangents(nominal.direction))])


def _crossed(vector: FloatArray, rows: FloatArray) -> FloatArray:
    """Return the vector product with each row (K, 3): for a few rows NumPy's own takes ten times as long."""
    x, y, z = map(float, vector)
    return rows @ np.array([[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]])
