"""Error model of a stitched cloud: poses of the views, camera calibration, form errors of each cloud, systematic errors, joint of set-ups."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray, read_only
from measureapp.geometry.transform import RigidTransform

POSE = 6
RANK_TOLERANCE = 1e-3  # relative singular value above which a surface determines a motion
DEGREE = 3
DIRECTION_REACH_RAD = 1.0  # correlation length of systematic errors over the directions of normals
POWERS = tuple((i, j, k) for i in range(DEGREE + 1) for j in range(DEGREE + 1 - i) for k in range(DEGREE + 1 - i - j))


@dataclass(frozen=True, slots=True, eq=False)
class CloudDistortion:
    """Displacement fields of the points of every cloud by independent errors of the camera calibration, one standard deviation each.

    Polynomials of the position in the reference camera's frame, as lens errors are smooth.
    """

    middle_mm: FloatArray  # (3,), origin of the polynomials
    reach_mm: FloatArray  # (3,), scale along each axis
    coefficients_mm: FloatArray  # (B, 3, K), of the products x^i y^j z^k by `POWERS`
    views: BoolArray | None = None  # (V, K), which views each error distorts, if they have several calibrations; None: all

    def __post_init__(self) -> None:
        object.__setattr__(self, "middle_mm", read_only(self.middle_mm, np.float64, (3,)))
        object.__setattr__(self, "reach_mm", read_only(self.reach_mm, np.float64, (3,)))
        object.__setattr__(self, "coefficients_mm", read_only(self.coefficients_mm, np.float64, (len(POWERS), 3, None)))
        if self.views is not None:
            object.__setattr__(self, "views", read_only(self.views, np.bool_, (None, self.count)))

    @property
    def count(self) -> int:
        """The number of errors."""
        return int(self.coefficients_mm.shape[2])

    def products(self, points_mm: FloatArray) -> FloatArray:
        """Return the monomials (N, B) at points (N, 3) in the camera's frame."""
        x, y, z = ((points_mm - self.middle_mm) / self.reach_mm).T
        return np.column_stack([x**i * y**j * z**k for i, j, k in POWERS])

    def along(self, points_mm: FloatArray, directions: FloatArray) -> FloatArray:
        """Return the displacements (N, K) of points (N, 3) along directions (N, 3), all in the camera's frame."""
        products = self.products(points_mm)
        return sum(((directions[:, axis, None] * products) @ self.coefficients_mm[:, axis] for axis in range(3)), np.zeros(()))

    def of_view(self, number: int, points_mm: FloatArray, directions: FloatArray) -> FloatArray:
        """Return `along` for the points of view ``number``; zero for the errors of another calibration."""
        displaced = self.along(points_mm, directions)
        return displaced if self.views is None else displaced * self.views[number]


@dataclass(frozen=True, slots=True, eq=False)
class CalibrationErrors:
    """Independent errors of the camera calibration: distortion of every cloud, and motions of the kinematic poses."""

    distortion: CloudDistortion
    kinematic_motions: FloatArray  # (6V, K), motions of each camera in its own frame: translation (mm), rotation (rad)


@dataclass(frozen=True, slots=True, eq=False)
class FormErrors:
    """Form errors of single clouds: smooth over the surface, independent between views.

    Each is a Gaussian random field, represented by its values at a few nodes (C. E. Rasmussen, C. K. I. Williams, Gaussian Processes for
    Machine Learning, 2006, 8.3.2), less its rigid part, which registration compensates by a motion of the view.
    """

    nodes_mm: FloatArray  # (N, 3), in the frame of the poses' `to_frame`
    view: IntArray  # (N,), view of each node
    sizes_mm: FloatArray  # (V,), standard deviation
    reaches_mm: FloatArray  # (V,), correlation length
    motions: FloatArray  # (6V, N), compensating motions of the views, as in `ViewErrors`

    def __post_init__(self) -> None:
        object.__setattr__(self, "nodes_mm", read_only(self.nodes_mm, np.float64, (None, 3)))
        object.__setattr__(self, "view", read_only(self.view, np.int64, (len(self.nodes_mm),)))
        object.__setattr__(self, "sizes_mm", read_only(self.sizes_mm, np.float64, (None,)))
        object.__setattr__(self, "reaches_mm", read_only(self.reaches_mm, np.float64, (len(self.sizes_mm),)))
        object.__setattr__(self, "motions", read_only(self.motions, np.float64, (POSE * len(self.sizes_mm), len(self.nodes_mm))))

    def of(self, number: int, points_mm: FloatArray) -> FloatArray:
        """Return the displacements (M, N) of points (M, 3) along their normals by the errors of view ``number``, without motions."""
        own = np.flatnonzero(self.view == number)
        by_node = np.zeros((len(points_mm), len(self.nodes_mm)))
        by_node[:, own] = self.sizes_mm[number] * smooth_basis(points_mm, self.nodes_mm[own], float(self.reaches_mm[number]))
        return by_node


@dataclass(frozen=True, slots=True, eq=False)
class SystematicErrors:
    """Systematic errors shared by all views, as a function of the surface orientation relative to the cameras (light, blur).

    A Gaussian random field over directions, along the normals, represented by its values at a few nodes, as `FormErrors`.
    """

    nodes: FloatArray  # (N, 3), unit normals in the reference camera's frame
    size_mm: float  # standard deviation
    motions: FloatArray  # (6V, N), compensating motions of the views, as in `ViewErrors`

    def __post_init__(self) -> None:
        object.__setattr__(self, "nodes", read_only(self.nodes, np.float64, (None, 3)))
        object.__setattr__(self, "motions", read_only(self.motions, np.float64, (None, len(self.nodes))))

    @property
    def count(self) -> int:
        """The number of independent errors."""
        return len(self.nodes)

    def along(self, points_mm: FloatArray, directions: FloatArray) -> FloatArray:
        """Return the displacements (M, N) of points (M, 3) along their normals (M, 3, either sign), in the camera's frame, without motions."""
        towards = -np.sign(np.sum(points_mm * directions, axis=1))[:, None]
        return np.asarray(towards * self.size_mm * smooth_basis(towards * directions, self.nodes, DIRECTION_REACH_RAD))


def smooth_basis(points_mm: FloatArray, nodes_mm: FloatArray, reach_mm: float) -> FloatArray:
    """Nyström basis of a Gaussian covariance: return (M, N) at points (M, 3) whose products sum to the covariance of variance one."""

    def correlation(places_mm: FloatArray) -> FloatArray:
        squared = np.sum((places_mm[:, None] - nodes_mm) ** 2, axis=2)
        return np.asarray(np.exp(-squared / (2 * reach_mm**2)))

    values, vectors = np.linalg.eigh(correlation(nodes_mm))
    return np.asarray(correlation(points_mm) @ vectors / np.sqrt(np.maximum(values, RANK_TOLERANCE)))


@dataclass(frozen=True, slots=True, eq=False)
class ViewErrors:
    """Independent errors, one standard deviation each, and their effect on all views; a common motion of all views may be missing.

    A motion is a translation of the view's centre (mm) and a rotation about it (rad), in the frame of the poses' `to_frame`.
    """

    poses: tuple[RigidTransform, ...]  # V, from the camera to the cloud's frame
    centres_mm: FloatArray  # (V, 3)
    stitching_motions: FloatArray  # (6V, M), motions of all views
    calibration_motions: FloatArray  # (6V, K), motions by the errors of the camera calibration
    distortion: CloudDistortion | None = None  # by the same K errors; None where not known
    form: FormErrors | None = None  # None where not known
    systematic: SystematicErrors | None = None  # None where not known
    scale: float = 0.0  # relative standard uncertainty of the length scale; 0: taken as exact
    unexplained_mm: float = 0.0  # standard deviation of what checks of the data find beyond all these, in the form of `systematic`
    temperature: float = 0.0  # relative standard uncertainty of the correction of lengths to 20 °C
    setup_motions: FloatArray | None = None  # (6V, J), motions by the errors of the joint of several set-ups; None: a single set-up

    def __post_init__(self) -> None:
        rows = POSE * len(self.poses)
        if self.setup_motions is not None:
            object.__setattr__(self, "setup_motions", read_only(self.setup_motions, np.float64, (rows, None)))
        object.__setattr__(self, "centres_mm", read_only(self.centres_mm, np.float64, (len(self.poses), 3)))
        object.__setattr__(self, "stitching_motions", read_only(self.stitching_motions, np.float64, (rows, None)))
        object.__setattr__(self, "calibration_motions", read_only(self.calibration_motions, np.float64, (rows, None)))

    def seen_from(self, transform: RigidTransform) -> ViewErrors:
        """Return the same errors in ``transform.to_frame``."""
        return replace(
            self,
            poses=tuple(transform @ pose for pose in self.poses),
            centres_mm=transform.apply(self.centres_mm),
            stitching_motions=_rotate_motions(transform.rotation, self.stitching_motions),
            calibration_motions=_rotate_motions(transform.rotation, self.calibration_motions),
            form=None
            if self.form is None
            else replace(
                self.form, nodes_mm=transform.apply(self.form.nodes_mm), motions=_rotate_motions(transform.rotation, self.form.motions)
            ),
            systematic=None
            if self.systematic is None
            else replace(self.systematic, motions=_rotate_motions(transform.rotation, self.systematic.motions)),
            setup_motions=None if self.setup_motions is None else _rotate_motions(transform.rotation, self.setup_motions),
        )

    def along(self, points_mm: FloatArray, directions: FloatArray, view: IntArray) -> dict[str, FloatArray]:
        """Return the displacements of points along directions (N, 3), by contribution: "stitching" (N, M) and, if known, the others.

        Parameters
        ----------
        view : (N,), which view measured each point
        """
        stitching = np.zeros((len(points_mm), self.stitching_motions.shape[1]))
        calibration = np.zeros((len(points_mm), self.calibration_motions.shape[1]))
        form = np.zeros((len(points_mm), 0 if self.form is None else len(self.form.nodes_mm)))
        common = np.zeros((len(points_mm), 0 if self.systematic is None else self.systematic.count))
        setups = np.zeros((len(points_mm), 0 if self.setup_motions is None else self.setup_motions.shape[1]))
        for number in np.unique(view):
            rows = np.flatnonzero(view == number)
            arms, across = points_mm[rows] - self.centres_mm[number], directions[rows]
            lever = np.hstack([across, np.cross(arms, across)])
            block = slice(POSE * number, POSE * number + POSE)
            stitching[rows] = lever @ self.stitching_motions[block]
            calibration[rows] = lever @ self.calibration_motions[block]
            back = self.poses[number].inverse()
            seen = back.apply(points_mm[rows]), back.rotate(across)
            if self.distortion is not None:
                calibration[rows] += self.distortion.of_view(int(number), *seen)
            if self.form is not None:
                form[rows] = self.form.of(number, points_mm[rows]) + lever @ self.form.motions[block]
            if self.systematic is not None:
                common[rows] = self.systematic.along(*seen) + lever @ self.systematic.motions[block]
            if self.setup_motions is not None:
                setups[rows] = lever @ self.setup_motions[block]
        outwards = np.sum((points_mm - self.centres_mm.mean(axis=0)) * directions, axis=1)[:, None]
        known = {
            "stitching": True,
            "calibration": self.distortion is not None,
            "form": self.form is not None,
            "common": self.systematic is not None,
            "setups": self.setup_motions is not None,
            "unexplained": self.systematic is not None and self.unexplained_mm > 0,
            "temperature": self.temperature > 0,
            "scale": self.scale > 0,
        }
        columns = (
            stitching,
            calibration,
            form,
            common,
            setups,
            self._unexplained(common),
            self.temperature * outwards,
            self.scale * outwards,
        )
        return {name: values for name, values in zip(known, columns, strict=True) if known[name]}

    def _unexplained(self, common: FloatArray) -> FloatArray:
        """Return the displacements by what is unexplained: as those of the systematic errors, to which registration responds equally."""
        size = 0.0 if self.systematic is None else self.systematic.size_mm
        return common * (self.unexplained_mm / size if size > 0 else 0.0)


def remove_common_motion(errors: ViewErrors, points_mm: FloatArray, normals: FloatArray, view: IntArray) -> ViewErrors:
    """Remove the common motion of all points that an alignment by the surface compensates.

    Parameters
    ----------
    points_mm, normals : (N, 3), in the frame of the poses' `to_frame`; a sample that covers the part
    view : (N,), which view measured each point
    """
    middle = points_mm.mean(axis=0)
    arms = points_mm - middle
    length = float(np.sqrt(np.mean(np.sum(arms**2, axis=1))))
    gain = np.linalg.pinv(np.hstack([normals, np.cross(arms, normals) / length]), rcond=RANK_TOLERANCE)
    moved = errors.along(points_mm, normals, view)

    def rest(contribution: str, motions: FloatArray) -> FloatArray:
        if contribution not in moved:
            return motions
        shift, turn = np.split(gain @ moved[contribution], 2)
        turn = turn / length
        common = [np.vstack([shift + np.cross(turn.T, centre - middle).T, turn]) for centre in errors.centres_mm]
        return motions - np.vstack(common)

    return replace(
        errors,
        stitching_motions=rest("stitching", errors.stitching_motions),
        calibration_motions=rest("calibration", errors.calibration_motions),
        form=None if errors.form is None else replace(errors.form, motions=rest("form", errors.form.motions)),
        systematic=None if errors.systematic is None else replace(errors.systematic, motions=rest("common", errors.systematic.motions)),
        setup_motions=None if errors.setup_motions is None else rest("setups", errors.setup_motions),
    )


def factor_covariance(covariance: FloatArray, negligible: float = 1e-10) -> FloatArray:
    """Factor a covariance (P, P) into independent errors: return columns (P, M) whose products sum to it.

    Eigenvalues of the correlation matrix below the ``negligible`` share of the largest are dropped.
    """
    size = np.sqrt(np.maximum(np.diag(covariance), 0))
    size = np.where(size > 0, size, 1.0)
    values, vectors = np.linalg.eigh(covariance / np.outer(size, size))
    kept = values > negligible * max(float(values[-1]), 0.0) if len(values) else np.zeros(0, bool)
    return np.asarray(size[:, None] * vectors[:, kept] * np.sqrt(values[kept]))


def expand_motions(chosen: Sequence[int], motions: FloatArray, count: int) -> FloatArray:
    """Expand motions (6C, M) of chosen views to all views (6 ``count``, M), with zeros for the others."""
    rows = (POSE * np.asarray(chosen, int)[:, None] + np.arange(POSE)).ravel()
    every = np.zeros((POSE * count, motions.shape[1]))
    every[rows] = motions
    return every


def _rotate_motions(rotation: FloatArray, motions: FloatArray) -> FloatArray:
    vectors = motions.reshape(len(motions) // 3, 3, motions.shape[1])
    return np.einsum("ij,vjm->vim", rotation, vectors).reshape(motions.shape)
