"""What the views of a stitched cloud err by: where each lies, how the calibration bends its cloud, what form it has by itself or as all have."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from measureapp.arrays import FloatArray, IntArray, read_only
from measureapp.geometry.transform import RigidTransform

POSE = 6
HELD = 1e-3  # singular value over the largest, from which on a surface holds a motion
DEGREE = 3
RADIAN = 1.0  # over which common errors change: of unit normals, between one side of a part and another
POWERS = tuple((i, j, k) for i in range(DEGREE + 1) for j in range(DEGREE + 1 - i) for k in range(DEGREE + 1 - i - j))


@dataclass(frozen=True, slots=True, eq=False)
class CloudBends:
    """How independent errors of the cameras' calibration, of one standard deviation each, displace the points of every cloud.

    Polynomials of the place in the reference camera's frame, as lenses err smoothly.
    """

    middle_mm: FloatArray  # (3,), where the polynomials are about
    reach_mm: FloatArray  # (3,), how far along each axis
    coefficients_mm: FloatArray  # (B, 3, K), of the products x^i y^j z^k by `POWERS`

    def __post_init__(self) -> None:
        object.__setattr__(self, "middle_mm", read_only(self.middle_mm, np.float64, (3,)))
        object.__setattr__(self, "reach_mm", read_only(self.reach_mm, np.float64, (3,)))
        object.__setattr__(self, "coefficients_mm", read_only(self.coefficients_mm, np.float64, (len(POWERS), 3, None)))

    @property
    def count(self) -> int:
        """How many errors."""
        return int(self.coefficients_mm.shape[2])

    def products(self, points_mm: FloatArray) -> FloatArray:
        """Return the products (N, B) of points (N, 3) in the camera's frame."""
        x, y, z = ((points_mm - self.middle_mm) / self.reach_mm).T
        return np.column_stack([x**i * y**j * z**k for i, j, k in POWERS])

    def along(self, points_mm: FloatArray, directions: FloatArray) -> FloatArray:
        """Return the displacements (N, K) of points (N, 3) along directions (N, 3), all in the camera's frame."""
        products = self.products(points_mm)
        return sum(((directions[:, axis, None] * products) @ self.coefficients_mm[:, axis] for axis in range(3)), np.zeros(()))


@dataclass(frozen=True, slots=True, eq=False)
class CalibrationErrors:
    """Independent errors of the cameras' calibration: how they bend every cloud, and move where the axes place it."""

    bends: CloudBends
    by_axes: FloatArray  # (6V, K), motions of each camera in its own frame: shift (mm), then turn (rad)


@dataclass(frozen=True, slots=True, eq=False)
class FormErrors:
    """Errors of form that the clouds of the views have by themselves: smooth over the surface, independent from view to view.

    Each is a random field with a Gaussian covariance, told by its values at a few nodes (C. E. Rasmussen, C. K. I. Williams, Gaussian
    Processes for Machine Learning, 2006, 8.3.2), less the motion of the view that lays it onto the surface: that one stitching follows.
    """

    nodes_mm: FloatArray  # (N, 3), in the frame that the poses lead to
    view: IntArray  # (N,), whose
    sizes_mm: FloatArray  # (V,), standard deviation
    reaches_mm: FloatArray  # (V,), over which they change
    motions: FloatArray  # (6V, N), by which the views follow, as those of `ViewErrors`

    def __post_init__(self) -> None:
        object.__setattr__(self, "nodes_mm", read_only(self.nodes_mm, np.float64, (None, 3)))
        object.__setattr__(self, "view", read_only(self.view, np.int64, (len(self.nodes_mm),)))
        object.__setattr__(self, "sizes_mm", read_only(self.sizes_mm, np.float64, (None,)))
        object.__setattr__(self, "reaches_mm", read_only(self.reaches_mm, np.float64, (len(self.sizes_mm),)))
        object.__setattr__(self, "motions", read_only(self.motions, np.float64, (POSE * len(self.sizes_mm), len(self.nodes_mm))))

    def of(self, number: int, points_mm: FloatArray) -> FloatArray:
        """Return the displacements (M, N) of points (M, 3) along their normals by the errors of view ``number``, motions not in them."""
        own = np.flatnonzero(self.view == number)
        by_node = np.zeros((len(points_mm), len(self.nodes_mm)))
        by_node[:, own] = self.sizes_mm[number] * smooth_patterns(points_mm, self.nodes_mm[own], float(self.reaches_mm[number]))
        return by_node


@dataclass(frozen=True, slots=True, eq=False)
class CommonErrors:
    """Errors that all clouds have in common, by how the surface is turned to the cameras: light and blur act by that in every view.

    A random field over directions, along the normals, told by its values at a few of them as `FormErrors` are by theirs at places.
    """

    nodes: FloatArray  # (N, 3), unit normals in the reference camera's frame
    size_mm: float  # standard deviation
    motions: FloatArray  # (6V, N), by which the views follow, as those of `ViewErrors`

    def __post_init__(self) -> None:
        object.__setattr__(self, "nodes", read_only(self.nodes, np.float64, (None, 3)))
        object.__setattr__(self, "motions", read_only(self.motions, np.float64, (None, len(self.nodes))))

    @property
    def count(self) -> int:
        """How many independent errors the field is told by."""
        return len(self.nodes)

    def along(self, points_mm: FloatArray, directions: FloatArray) -> FloatArray:
        """Return the displacements (M, N) of points (M, 3) along their normals (M, 3), to either side, all in the camera's frame; motions not in them."""
        towards = -np.sign(np.sum(points_mm * directions, axis=1))[:, None]
        return np.asarray(towards * self.size_mm * smooth_patterns(towards * directions, self.nodes, RADIAN))


def smooth_patterns(points_mm: FloatArray, nodes_mm: FloatArray, reach_mm: float) -> FloatArray:
    """Return patterns (M, N) at points (M, 3) whose products sum to the covariance of a smooth error of variance one, seen from its nodes."""

    def alike(places_mm: FloatArray) -> FloatArray:
        squared = np.sum((places_mm[:, None] - nodes_mm) ** 2, axis=2)
        return np.asarray(np.exp(-squared / (2 * reach_mm**2)))

    values, vectors = np.linalg.eigh(alike(nodes_mm))
    return np.asarray(alike(points_mm) @ vectors / np.sqrt(np.maximum(values, HELD)))


@dataclass(frozen=True, slots=True, eq=False)
class ViewErrors:
    """Independent errors of one standard deviation each, and what each does to all views; what moves all alike may be left out.

    A motion is a shift of the view's centre (mm) and a turn about it (rad), in the frame that the poses lead to.
    """

    poses: tuple[RigidTransform, ...]  # V, the cloud's frame from the camera
    centres_mm: FloatArray  # (V, 3)
    by_stitching: FloatArray  # (6V, M), motions of all views
    by_calibration: FloatArray  # (6V, K), motions by the errors of the cameras' calibration
    bends: CloudBends | None = None  # by the same K errors; None where the calibration's errors are not known
    form: FormErrors | None = None  # None where they are not known
    common: CommonErrors | None = None  # None where they are not known
    scale: float = 0.0  # standard uncertainty of what all lengths are measured by, relative; 0: taken as exact

    def __post_init__(self) -> None:
        rows = POSE * len(self.poses)
        object.__setattr__(self, "centres_mm", read_only(self.centres_mm, np.float64, (len(self.poses), 3)))
        object.__setattr__(self, "by_stitching", read_only(self.by_stitching, np.float64, (rows, None)))
        object.__setattr__(self, "by_calibration", read_only(self.by_calibration, np.float64, (rows, None)))

    def seen_from(self, transform: RigidTransform) -> ViewErrors:
        """Return the same errors in ``transform.to_frame``."""
        return replace(
            self,
            poses=tuple(transform @ pose for pose in self.poses),
            centres_mm=transform.apply(self.centres_mm),
            by_stitching=_turned(transform.rotation, self.by_stitching),
            by_calibration=_turned(transform.rotation, self.by_calibration),
            form=None
            if self.form is None
            else replace(self.form, nodes_mm=transform.apply(self.form.nodes_mm), motions=_turned(transform.rotation, self.form.motions)),
            common=None if self.common is None else replace(self.common, motions=_turned(transform.rotation, self.common.motions)),
        )

    def along(self, points_mm: FloatArray, directions: FloatArray, view: IntArray) -> dict[str, FloatArray]:
        """Return the displacements of points along their normals (N, 3), by "stitching" (N, M) and, where known, by "calibration", "form", "common" and "scale".

        Parameters
        ----------
        view : (N,), which view measured each point
        """
        stitching = np.zeros((len(points_mm), self.by_stitching.shape[1]))
        calibration = np.zeros((len(points_mm), self.by_calibration.shape[1]))
        form = np.zeros((len(points_mm), 0 if self.form is None else len(self.form.nodes_mm)))
        common = np.zeros((len(points_mm), 0 if self.common is None else self.common.count))
        for number in np.unique(view):
            rows = np.flatnonzero(view == number)
            arms, across = points_mm[rows] - self.centres_mm[number], directions[rows]
            lever = np.hstack([across, np.cross(arms, across)])
            block = slice(POSE * number, POSE * number + POSE)
            stitching[rows] = lever @ self.by_stitching[block]
            calibration[rows] = lever @ self.by_calibration[block]
            back = self.poses[number].inverse()
            seen = back.apply(points_mm[rows]), back.rotate(across)
            if self.bends is not None:
                calibration[rows] += self.bends.along(*seen)
            if self.form is not None:
                form[rows] = self.form.of(number, points_mm[rows]) + lever @ self.form.motions[block]
            if self.common is not None:
                common[rows] = self.common.along(*seen) + lever @ self.common.motions[block]
        scale = self.scale * np.sum((points_mm - self.centres_mm.mean(axis=0)) * directions, axis=1)[:, None]
        known = {
            "stitching": True,
            "calibration": self.bends is not None,
            "form": self.form is not None,
            "common": self.common is not None,
            "scale": self.scale > 0,
        }
        return {share: columns for share, columns in zip(known, (stitching, calibration, form, common, scale), strict=True) if known[share]}


def without_common_motion(errors: ViewErrors, points_mm: FloatArray, normals: FloatArray, view: IntArray) -> ViewErrors:
    """Return the errors without what lays all points together beside their surface: where a part is aligned by its surface, that has followed.

    Parameters
    ----------
    points_mm, normals : (N, 3), in the frame that the poses lead to; as small a choice as shows the part
    view : (N,), which view measured each point
    """
    middle = points_mm.mean(axis=0)
    arms = points_mm - middle
    length = float(np.sqrt(np.mean(np.sum(arms**2, axis=1))))
    gain = np.linalg.pinv(np.hstack([normals, np.cross(arms, normals) / length]), rcond=HELD)
    moved = errors.along(points_mm, normals, view)

    def left(share: str, motions: FloatArray) -> FloatArray:
        if share not in moved:
            return motions
        shift, turn = np.split(gain @ moved[share], 2)
        turn = turn / length
        common = [np.vstack([shift + np.cross(turn.T, centre - middle).T, turn]) for centre in errors.centres_mm]
        return motions - np.vstack(common)

    return replace(
        errors,
        by_stitching=left("stitching", errors.by_stitching),
        by_calibration=left("calibration", errors.by_calibration),
        form=None if errors.form is None else replace(errors.form, motions=left("form", errors.form.motions)),
        common=None if errors.common is None else replace(errors.common, motions=left("common", errors.common.motions)),
    )


def independent(covariance: FloatArray, negligible: float = 1e-10) -> FloatArray:
    """Return columns (P, M) whose products sum to a covariance (P, P): independent errors of one standard deviation each.

    Errors below the ``negligible`` share of the largest variance, in units that make the rows comparable, are left out.
    """
    size = np.sqrt(np.maximum(np.diag(covariance), 0))
    size = np.where(size > 0, size, 1.0)
    values, vectors = np.linalg.eigh(covariance / np.outer(size, size))
    kept = values > negligible * max(float(values[-1]), 0.0) if len(values) else np.zeros(0, bool)
    return np.asarray(size[:, None] * vectors[:, kept] * np.sqrt(values[kept]))


def motions_of(chosen: Sequence[int], motions: FloatArray, count: int) -> FloatArray:
    """Return motions (6C, M) of chosen views as those of all (6 ``count``, M); the others do not move."""
    rows = (POSE * np.asarray(chosen, int)[:, None] + np.arange(POSE)).ravel()
    every = np.zeros((POSE * count, motions.shape[1]))
    every[rows] = motions
    return every


def _turned(rotation: FloatArray, motions: FloatArray) -> FloatArray:
    vectors = motions.reshape(len(motions) // 3, 3, motions.shape[1])
    return np.einsum("ij,vjm->vim", rotation, vectors).reshape(motions.shape)
