"""One estimate of all views' poses from pairwise measurements and the kinematic poses as priors (Gauss-Newton)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.linalg import block_diag, cho_factor, cho_solve
from scipy.spatial.transform import Rotation

from measureapp.arrays import FloatArray
from measureapp.geometry.transform import RigidTransform
from measureapp.register.pairs.icp import PairMeasurement, stepped

ITERATIONS = 30
CONVERGED_MM = 1e-7
CAUCHY = 3.0  # in units of the usual edge residual
CHI_SQUARE_MEDIAN = 5.35  # of six degrees of freedom


@dataclass(frozen=True, slots=True, eq=False)
class PoseGraphSolution:
    """The poses and how certain they are."""

    part_from_camera: tuple[RigidTransform, ...]
    covariance: FloatArray  # (6N, 6N) of small motions in the part's frame about each view's centre, beside what all views have in common
    edge_sigmas: FloatArray  # (E,) residual of each pair in standard deviations
    surface_information: FloatArray  # (N, 6, 6) of the same motions by the pairs alone, were the other views certain

    def of_view(self, index: int) -> FloatArray:
        """Return the covariance (6, 6) of one view."""
        return self.covariance[6 * index : 6 * index + 6, 6 * index : 6 * index + 6]


def solve(
    start: Sequence[RigidTransform],
    kinematic: Sequence[RigidTransform],
    prior_information: FloatArray,
    pairs: Sequence[PairMeasurement],
    centres_mm: FloatArray,
) -> PoseGraphSolution:
    """Minimise the pairs' and the priors' weighted squares together; pairs that contradict the others lose weight (Cauchy).

    Parameters
    ----------
    start, kinematic : N poses part_from_camera to begin with, and by the axes
    prior_information : (6N, 6N), of the error of each pose in its camera's frame
    pairs : measurements with indices into the poses
    centres_mm : (N, 3), a point in the middle of each view in the part's frame; keeps millimetres and radians apart
    """
    poses = list(start)
    for _ in range(ITERATIONS):
        matrix, right, _, _ = _normal_equations(poses, kinematic, prior_information, pairs, centres_mm)
        factor = cho_factor(matrix)
        steps = cho_solve(factor, right).reshape(-1, 6)
        poses = [stepped(pose, step, centre) for pose, step, centre in zip(poses, steps, centres_mm, strict=True)]
        if np.abs(steps[:, :3]).max() < CONVERGED_MM:
            break
    matrix, _, sigmas, surface = _normal_equations(poses, kinematic, prior_information, pairs, centres_mm)
    apart = beside_each_other(centres_mm)
    covariance = apart @ np.linalg.inv(matrix) @ apart.T
    return PoseGraphSolution(tuple(poses), (covariance + covariance.T) / 2, sigmas, surface)


def beside_each_other(centres_mm: FloatArray) -> FloatArray:
    """Return the matrix (6N, 6N) that takes from all views' motions about their centres the motion that they have in common.

    Of a single view it leaves all. Where the part as a whole lies is known far worse than how its views lie to each other, and no
    dimension depends on it.
    """
    if len(centres_mm) == 1:
        return np.eye(6)
    middle = centres_mm.mean(axis=0)
    radius = max(1.0, float(np.sqrt(np.mean(np.sum((centres_mm - middle) ** 2, axis=1)))))
    together = np.vstack([moved_to(centre, middle) for centre in centres_mm])
    weighted = together * np.tile([1.0] * 3 + [radius**2] * 3, len(centres_mm))[:, None]
    return np.asarray(np.eye(len(together)) - together @ np.linalg.solve(weighted.T @ together, weighted.T))


def _normal_equations(
    poses: Sequence[RigidTransform],
    kinematic: Sequence[RigidTransform],
    prior_information: FloatArray,
    pairs: Sequence[PairMeasurement],
    centres_mm: FloatArray,
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """Return the normal matrix, its right side, every pair's residual (E,) and every view's information (N, 6, 6) by the pairs alone."""
    count = len(poses)
    errors, jacobian = np.zeros(6 * count), np.zeros((6 * count, 6 * count))
    for i, (pose, axes) in enumerate(zip(poses, kinematic, strict=True)):
        block = slice(6 * i, 6 * i + 6)
        errors[block] = _vector(axes.inverse() @ pose, np.zeros(3))
        jacobian[block, block] = turned(axes.rotation.T) @ moved_to(pose.translation_mm, centres_mm[i])
    matrix = jacobian.T @ prior_information @ jacobian
    right = -jacobian.T @ (prior_information @ errors)
    surface = np.zeros((count, 6, 6))
    parts, weights, squares = _weighted(poses, pairs, centres_mm)
    for pair, weighted, (error, by_target, by_source) in zip(pairs, weights, parts, strict=True):
        blocks = ((pair.target, by_target), (pair.source, by_source))
        for a, left in blocks:
            right[6 * a : 6 * a + 6] -= left.T @ weighted @ error
            surface[a] += left.T @ weighted @ left
            for b, other in blocks:
                matrix[6 * a : 6 * a + 6, 6 * b : 6 * b + 6] += left.T @ weighted @ other
    return matrix, right, np.sqrt(squares), surface


def _weighted(
    poses: Sequence[RigidTransform], pairs: Sequence[PairMeasurement], centres_mm: FloatArray
) -> tuple[list[tuple[FloatArray, FloatArray, FloatArray]], list[FloatArray], FloatArray]:
    """Return every pair's `edge_error`, its information (6, 6) as it counts among the others, and its weighted square (E,)."""
    parts = [edge_error(poses, pair, centres_mm) for pair in pairs]
    squares = np.array([error @ pair.information @ error for pair, (error, _, _) in zip(pairs, parts, strict=True)])
    usual = max(1.0, float(np.median(squares)) / CHI_SQUARE_MEDIAN) if len(squares) else 1.0
    weights = [
        pair.information / usual / (1 + square / usual / (CAUCHY**2 * CHI_SQUARE_MEDIAN))
        for pair, square in zip(pairs, squares, strict=True)
    ]
    return parts, weights, squares


@dataclass(frozen=True, slots=True, eq=False)
class Following:
    """How poses of least squares follow small changes of what they are estimated from, beside what all views have in common."""

    inverse: FloatArray  # (6N, 6N), takes changes of the right side of the normal equations to motions about the centres
    by_axes: FloatArray  # (6N, 6N), right side by motions of the poses by the axes, each in its camera's frame
    by_pairs: tuple[FloatArray, ...]  # (12, 6), right side of target and source by motions of a pair's source as measured


def following(
    poses: Sequence[RigidTransform],
    kinematic: Sequence[RigidTransform],
    prior_information: FloatArray,
    pairs: Sequence[PairMeasurement],
    centres_mm: FloatArray,
) -> Following:
    """Return how the poses that `solve` leads to follow the poses by the axes and the pairs; arguments as there."""
    matrix = _normal_equations(poses, kinematic, prior_information, pairs, centres_mm)[0]
    carry = block_diag(
        *(
            turned(axes.rotation.T) @ moved_to(pose.translation_mm, centre)
            for pose, axes, centre in zip(poses, kinematic, centres_mm, strict=True)
        )
    )
    parts, weights, _ = _weighted(poses, pairs, centres_mm)
    by_pairs = tuple(np.hstack([own, other]).T @ weight for (_, own, other), weight in zip(parts, weights, strict=True))
    return Following(beside_each_other(centres_mm) @ np.linalg.inv(matrix), carry.T @ prior_information, by_pairs)


def edge_error(poses: Sequence[RigidTransform], pair: PairMeasurement, centres_mm: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return how far the pair is from its measurement (6,), in the target's frame, and its derivatives by both poses."""
    target, source = poses[pair.target], poses[pair.source]
    measured = stepped(pair.target_from_source, pair.change, pair.centre_mm)
    turn = target.rotation.T
    # target⁻¹ source measured⁻¹, by what it does to the pair's centre and to directions
    rotation = turn @ source.rotation @ measured.rotation.T
    seen = source.rotation @ (measured.rotation.T @ (pair.centre_mm - measured.translation_mm)) + source.translation_mm
    error = np.concatenate([turn @ (seen - target.translation_mm) - pair.centre_mm, Rotation.from_matrix(rotation).as_rotvec()])
    centre = target.rotation @ pair.centre_mm + target.translation_mm
    back = turned(turn)
    return error, -back @ moved_to(centre, centres_mm[pair.target]), back @ moved_to(centre, centres_mm[pair.source])


def _vector(small: RigidTransform, centre_mm: FloatArray) -> FloatArray:
    """Return a small motion as the displacement of ``centre_mm`` and the rotation vector."""
    return np.concatenate([small.apply(np.asarray(centre_mm, float)) - centre_mm, small.rotation_vector])


def turned(rotation: FloatArray) -> FloatArray:
    """Return the matrix (6, 6) that takes a small motion to the frame that ``rotation`` leads to."""
    matrix = np.zeros((6, 6))
    matrix[:3, :3] = matrix[3:, 3:] = rotation
    return matrix


def moved_to(place_mm: FloatArray, centre_mm: FloatArray) -> FloatArray:
    """Return the matrix that takes a small motion about ``centre_mm`` to the same motion seen at ``place_mm``."""
    x, y, z = place_mm - centre_mm
    matrix = np.eye(6)
    matrix[:3, 3:] = [[0, z, -y], [-z, 0, x], [y, -x, 0]]
    return matrix
