"""Pose-graph optimisation (Gauss-Newton): poses of all views from pairwise measurements, with kinematic poses as priors."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.linalg import block_diag, cho_factor, cho_solve
from scipy.spatial.transform import Rotation

from measureapp.arrays import FloatArray
from measureapp.geometry.transform import RigidTransform
from measureapp.register.pairs.icp import PairMeasurement, apply_motion

ITERATIONS = 30
CONVERGED_MM = 1e-7
CAUCHY = 3.0  # scale of the Cauchy weight, in median edge residuals
CHI_SQUARE_MEDIAN = 5.35  # of six degrees of freedom


@dataclass(frozen=True, slots=True, eq=False)
class PoseGraphSolution:
    """The estimated poses and their covariance."""

    part_from_camera: tuple[RigidTransform, ...]
    covariance: FloatArray  # (6N, 6N) of small motions in the part's frame about each view's centre, without the common motion of all views
    edge_sigmas: FloatArray  # (E,) residual of each pair in standard deviations
    surface_information: FloatArray  # (N, 6, 6) of the same motions from the pairs alone, with the other views fixed

    def covariance_of(self, index: int) -> FloatArray:
        """Return the covariance (6, 6) of one view."""
        return self.covariance[6 * index : 6 * index + 6, 6 * index : 6 * index + 6]


def optimise_pose_graph(
    start: Sequence[RigidTransform],
    kinematic: Sequence[RigidTransform],
    prior_information: FloatArray,
    pairs: Sequence[PairMeasurement],
    centres_mm: FloatArray,
) -> PoseGraphSolution:
    """Minimise the weighted squares of pairs and priors; pairs that contradict the others lose weight (Cauchy).

    Parameters
    ----------
    start, kinematic : N poses part_from_camera: initial values, and kinematic poses
    prior_information : (6N, 6N), of the kinematic pose errors, each in its camera's frame
    pairs : measurements with indices into the poses
    centres_mm : (N, 3), centre of each view in the part's frame; decouples translation and rotation
    """
    poses = list(start)
    for _ in range(ITERATIONS):
        matrix, right, _, _ = _normal_equations(poses, kinematic, prior_information, pairs, centres_mm)
        factor = cho_factor(matrix)
        steps = cho_solve(factor, right).reshape(-1, 6)
        poses = [apply_motion(pose, step, centre) for pose, step, centre in zip(poses, steps, centres_mm, strict=True)]
        if np.abs(steps[:, :3]).max() < CONVERGED_MM:
            break
    matrix, _, sigmas, surface = _normal_equations(poses, kinematic, prior_information, pairs, centres_mm)
    apart = relative_motion_projector(centres_mm)
    covariance = apart @ np.linalg.inv(matrix) @ apart.T
    return PoseGraphSolution(tuple(poses), (covariance + covariance.T) / 2, sigmas, surface)


def relative_motion_projector(centres_mm: FloatArray) -> FloatArray:
    """Return the projector (6N, 6N) that removes the common rigid motion from the motions of all views about their centres.

    For a single view it is the identity. The position of the whole part is known far worse than the relative positions of the views, and
    no dimension depends on it.
    """
    if len(centres_mm) == 1:
        return np.eye(6)
    middle = centres_mm.mean(axis=0)
    radius = max(1.0, float(np.sqrt(np.mean(np.sum((centres_mm - middle) ** 2, axis=1)))))
    together = np.vstack([twist_shift(centre, middle) for centre in centres_mm])
    weighted = together * np.tile([1.0] * 3 + [radius**2] * 3, len(centres_mm))[:, None]
    return np.asarray(np.eye(len(together)) - together @ np.linalg.solve(weighted.T @ together, weighted.T))


def _normal_equations(
    poses: Sequence[RigidTransform],
    kinematic: Sequence[RigidTransform],
    prior_information: FloatArray,
    pairs: Sequence[PairMeasurement],
    centres_mm: FloatArray,
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """Return the normal matrix, right side, residual of every pair (E,), and information of every view (N, 6, 6) from the pairs alone."""
    count = len(poses)
    errors, jacobian = np.zeros(6 * count), np.zeros((6 * count, 6 * count))
    for i, (pose, axes) in enumerate(zip(poses, kinematic, strict=True)):
        block = slice(6 * i, 6 * i + 6)
        errors[block] = _twist_vector(axes.inverse() @ pose, np.zeros(3))
        jacobian[block, block] = twist_rotation(axes.rotation.T) @ twist_shift(pose.translation_mm, centres_mm[i])
    matrix = jacobian.T @ prior_information @ jacobian
    right = -jacobian.T @ (prior_information @ errors)
    surface = np.zeros((count, 6, 6))
    parts, weights, squares = _weight_edges(poses, pairs, centres_mm)
    for pair, weighted, (error, by_target, by_source) in zip(pairs, weights, parts, strict=True):
        blocks = ((pair.target, by_target), (pair.source, by_source))
        for a, left in blocks:
            right[6 * a : 6 * a + 6] -= left.T @ weighted @ error
            surface[a] += left.T @ weighted @ left
            for b, other in blocks:
                matrix[6 * a : 6 * a + 6, 6 * b : 6 * b + 6] += left.T @ weighted @ other
    return matrix, right, np.sqrt(squares), surface


def _weight_edges(
    poses: Sequence[RigidTransform], pairs: Sequence[PairMeasurement], centres_mm: FloatArray
) -> tuple[list[tuple[FloatArray, FloatArray, FloatArray]], list[FloatArray], FloatArray]:
    """Return the linearised error, robust information (6, 6) and squared Mahalanobis residual (E,) of every pair."""
    parts = [linearise_edge(poses, pair, centres_mm) for pair in pairs]
    squares = np.array([error @ pair.information @ error for pair, (error, _, _) in zip(pairs, parts, strict=True)])
    usual = max(1.0, float(np.median(squares)) / CHI_SQUARE_MEDIAN) if len(squares) else 1.0
    weights = [
        pair.information / usual / (1 + square / usual / (CAUCHY**2 * CHI_SQUARE_MEDIAN))
        for pair, square in zip(pairs, squares, strict=True)
    ]
    return parts, weights, squares


@dataclass(frozen=True, slots=True, eq=False)
class PoseSensitivity:
    """Derivatives of the least-squares poses with respect to their input, without the common motion of all views."""

    inverse: FloatArray  # (6N, 6N), motions about the centres per change of the right side of the normal equations
    by_axes: FloatArray  # (6N, 6N), right side per motion of the kinematic poses, each in its camera's frame
    by_pairs: tuple[FloatArray, ...]  # (12, 6), right side of target and source per motion of a pair's measured source


def linearise_poses(
    poses: Sequence[RigidTransform],
    kinematic: Sequence[RigidTransform],
    prior_information: FloatArray,
    pairs: Sequence[PairMeasurement],
    centres_mm: FloatArray,
) -> PoseSensitivity:
    """Linearise the result of `optimise_pose_graph` with respect to kinematic poses and pairs; arguments as there."""
    matrix = _normal_equations(poses, kinematic, prior_information, pairs, centres_mm)[0]
    carry = block_diag(
        *(
            twist_rotation(axes.rotation.T) @ twist_shift(pose.translation_mm, centre)
            for pose, axes, centre in zip(poses, kinematic, centres_mm, strict=True)
        )
    )
    parts, weights, _ = _weight_edges(poses, pairs, centres_mm)
    by_pairs = tuple(np.hstack([own, other]).T @ weight for (_, own, other), weight in zip(parts, weights, strict=True))
    return PoseSensitivity(relative_motion_projector(centres_mm) @ np.linalg.inv(matrix), carry.T @ prior_information, by_pairs)


def linearise_edge(
    poses: Sequence[RigidTransform], pair: PairMeasurement, centres_mm: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return the error (6,) of a pair against its measurement, in the target's frame, and its derivatives with respect to both poses."""
    target, source = poses[pair.target], poses[pair.source]
    measured = apply_motion(pair.target_from_source, pair.change, pair.centre_mm)
    turn = target.rotation.T
    # target⁻¹ source measured⁻¹, applied to the pair's centre and to directions
    rotation = turn @ source.rotation @ measured.rotation.T
    seen = source.rotation @ (measured.rotation.T @ (pair.centre_mm - measured.translation_mm)) + source.translation_mm
    error = np.concatenate([turn @ (seen - target.translation_mm) - pair.centre_mm, Rotation.from_matrix(rotation).as_rotvec()])
    centre = target.rotation @ pair.centre_mm + target.translation_mm
    back = twist_rotation(turn)
    return error, -back @ twist_shift(centre, centres_mm[pair.target]), back @ twist_shift(centre, centres_mm[pair.source])


def _twist_vector(small: RigidTransform, centre_mm: FloatArray) -> FloatArray:
    """Return a small motion as displacement of ``centre_mm`` and rotation vector."""
    return np.concatenate([small.apply(np.asarray(centre_mm, float)) - centre_mm, small.rotation_vector])


def twist_rotation(rotation: FloatArray) -> FloatArray:
    """Return the matrix (6, 6) that rotates a small motion (translation, rotation) by ``rotation``."""
    matrix = np.zeros((6, 6))
    matrix[:3, :3] = matrix[3:, 3:] = rotation
    return matrix


def twist_shift(place_mm: FloatArray, centre_mm: FloatArray) -> FloatArray:
    """Return the matrix (6, 6) that moves the reference point of a small motion from ``centre_mm`` to ``place_mm``."""
    x, y, z = place_mm - centre_mm
    matrix = np.eye(6)
    matrix[:3, 3:] = [[0, z, -y], [-z, 0, x], [y, -x, 0]]
    return matrix
