"""Datum systems: up to three features that fix a part in the frame of its drawing, one after the other (ISO 5459)."""

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

ARM_MM = 100.0  # a turn counts as what it moves a point this far away
OPEN = 1e-3  # a motion that moves a feature by less than this share of itself does not move it
ROUNDS = 20
SMALL_ANGLE = 1e-4
NO_SHIFTS: Mapping[int, FloatArray] = MappingProxyType({})
MOTIONS = ("shift along x", "shift along y", "shift along z", "turn about x", "turn about y", "turn about z")


@dataclass(frozen=True, slots=True, eq=False)
class DatumSystem:
    """The motion that lays measured datums onto those of the drawing, and the motions they leave open."""

    names: tuple[str, ...]
    nominal_from_measured: FloatArray  # 4×4
    free: FloatArray  # (6, F): shifts in mm, turns in rad times `ARM_MM`
    fixed: tuple[FloatArray, ...] = ()  # (6, H) of each datum: the motions that it holds and those before it did not

    def apply(self, points_mm: FloatArray) -> FloatArray:
        """Return points (..., 3) as the drawing has them."""
        return points_mm @ self.nominal_from_measured[:3, :3].T + self.nominal_from_measured[:3, 3]

    def rotate(self, direction: FloatArray) -> FloatArray:
        """Return a direction as the drawing has it."""
        return np.asarray(self.nominal_from_measured[:3, :3] @ direction)

    def require_place(self, nominal: Feature, name: str) -> None:
        """Raise InspectionError when the datums leave open where the drawing has this feature."""
        self._require(np.vstack([_locations(nominal, nominal.point_mm), _orientations(nominal)]), "place", name)

    def require_direction(self, nominal: Feature, name: str) -> None:
        """Raise InspectionError when the datums leave open which way the drawing has this feature turned."""
        self._require(_orientations(nominal), "direction", name)

    def require_nothing_open(self, name: str) -> None:
        """Raise InspectionError when the datums leave any motion open: a surface of any form has a place by all of them."""
        self._require(np.eye(6), "place", name)

    def _require(self, rows: FloatArray, what: str, name: str) -> None:
        if len(rows) and self.free.shape[1] and np.abs(rows @ self.free).max() > OPEN:
            raise InspectionError(
                f"The datums {'|'.join(self.names)} do not fix the {what} of {name}: they leave open {', '.join(describe_free_motions(self.free))}"
            )


def describe_free_motions(free: FloatArray) -> tuple[str, ...]:
    """Return the motions (6, F) that are left open, in words."""
    if free.shape[1] == 0:
        return ()
    axes = [name for name, axis in zip(MOTIONS, np.eye(6), strict=True) if np.linalg.norm(free @ (free.T @ axis) - axis) < OPEN]
    return tuple(axes) if axes else ("a turn or shift along no axis of the drawing",)


def require_nominals(datums: Sequence[FoundFeature]) -> list[Feature]:
    """Return the datums of the drawing. Raises InspectionError for what cannot be a datum."""
    for one in datums:
        shape, patch = require_feature(one).shape, len(one.points_mm) > 0
        if (shape == "point" and patch) or shape not in ("plane", *AXES, *CENTRES):
            raise InspectionError(f"{one.name} is a single point of a surface: a datum is a plane, an axis or a centre")
    return [require_nominal(one) for one in datums]


def datum_system(nominals: Sequence[Feature], measured: Sequence[Feature], shifts: Mapping[int, FloatArray] = NO_SHIFTS) -> DatumSystem:
    """Lay measured datums onto the drawing's: A wholly, B as far as A leaves it free, C as far as both do.

    The motions that leave A where it is form a group, so that what B then moves keeps A in place. A later datum is
    turned first and moved then, about where it was measured, which is the fit constrained by the datums before it to
    first order in their angular errors.

    Parameters
    ----------
    shifts : by which motion (H,), in the columns of `fixed`, datums (by number) are then moved away from the drawing's; later ones follow

    Raises
    ------
    InspectionError
        A datum fixes nothing that those before it have not fixed already.
    """
    placed: FloatArray = np.eye(4)
    free: FloatArray = np.eye(6)
    fixed_motions: list[FloatArray] = []
    names = tuple(one.name for one in nominals)
    for number, (nominal, feature) in enumerate(zip(nominals, measured, strict=True)):
        fixed = np.vstack([_orientations(nominal), _locations(nominal, nominal.point_mm)]) @ free
        if np.abs(fixed).max(initial=0.0) < OPEN:
            raise InspectionError(f"Datum {nominal.name} fixes nothing that {'|'.join(names[: names.index(nominal.name)])} has not fixed")
        placed = _align_datum(placed, free, nominal, feature)
        _, rest = pseudo_inverse(fixed)
        fixed_motions.append(free @ np.linalg.svd(fixed)[2][: free.shape[1] - rest.shape[1]].T)
        if number in shifts:
            placed = twist_matrix(fixed_motions[-1] @ shifts[number]) @ placed
        free = free @ rest
    return DatumSystem(names, placed, free, tuple(fixed_motions))


def _align_datum(placed: FloatArray, free: FloatArray, nominal: Feature, feature: Feature) -> FloatArray:
    for _ in range(ROUNDS):
        orientations = _orientations(nominal)
        turn = np.zeros(6)
        turning = free
        if len(orientations):
            direction = placed[:3, :3] @ require_direction(feature)
            expected = require_direction(nominal)
            direction = direction * (np.sign(direction @ expected) or 1.0)  # an axis has no sense
            off = ARM_MM * (tangents(expected) @ (direction - expected))
            inverse, rest = pseudo_inverse(orientations @ free)
            turn, turning = -free @ inverse @ off, free @ rest
        placed = twist_matrix(turn) @ placed
        point = placed[:3, :3] @ feature.point_mm + placed[:3, 3]
        inverse, _ = pseudo_inverse(_locations(nominal, point) @ turning)
        shift = -turning @ inverse @ (location_directions(nominal) @ (point - nominal.point_mm))
        placed = twist_matrix(shift) @ placed
        if np.abs(turn).max() + np.abs(shift).max() < 1e-12:
            break
    return placed


def pseudo_inverse(rows: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the inverse of ``rows`` for the motions they fix, and the motions (columns) that they leave open."""
    u, sizes, vt = np.linalg.svd(rows)
    rank = int(np.count_nonzero(sizes > OPEN))
    return vt[:rank].T @ (u[:, :rank] / sizes[:rank]).T, vt[rank:].T


def twist_matrix(motion: FloatArray) -> FloatArray:
    """Return the 4×4 motion of a screw: shift and turn at once, so that a group of motions is not left."""
    x, y, z = motion[3:] / ARM_MM
    angle = float(np.sqrt(x * x + y * y + z * z))
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    near = angle < SMALL_ANGLE  # the series' first terms, where the quotients lose their digits
    one = 1.0 if near else np.sin(angle) / angle
    two = 0.5 if near else (1 - np.cos(angle)) / angle**2
    three = 1 / 6 if near else (angle - np.sin(angle)) / angle**3
    made = np.eye(4)
    made[:3, :3] += one * cross + two * cross @ cross
    made[:3, 3] = (np.eye(3) + two * cross + three * cross @ cross) @ motion[:3]
    return made


def location_directions(nominal: Feature) -> FloatArray:
    """The directions (K, 3) in which a feature of the drawing has a place."""
    if nominal.shape == "plane":
        return require_direction(nominal)[None]
    return tangents(require_direction(nominal)) if nominal.shape in AXES else np.eye(3)  # a cone counts as its axis


def _locations(nominal: Feature, point_mm: FloatArray) -> FloatArray:
    """What a motion (shift, turn times `ARM_MM`) does to a point of the feature, in its sides (K, 6)."""
    sides = location_directions(nominal)
    return np.hstack([sides, np.cross(point_mm, sides) / ARM_MM])


def _orientations(nominal: Feature) -> FloatArray:
    """What a motion does to the feature's direction times `ARM_MM` (2, 6); nothing for a centre."""
    if nominal.shape in ("sphere", "point") or nominal.direction is None:
        return np.empty((0, 6))
    return np.hstack([np.zeros((2, 3)), np.cross(nominal.direction, tangents(nominal.direction))])
