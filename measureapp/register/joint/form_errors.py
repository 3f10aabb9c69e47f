"""Form errors of single clouds: smooth Gaussian random fields with the variance that the pairs show."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.view_errors import POSE, RANK_TOLERANCE, FormErrors, smooth_basis
from measureapp.geometry.transform import RigidTransform
from measureapp.register.pairs.prepare import PreparedCloud
from measureapp.register.pairs.smooth_errors import CORRELATION_LENGTH, pivoted_cholesky

NEGLECTED_VARIANCE = 0.1  # share of the variance at any point that the nodes need not explain
MOST_POINTS = 2000  # of a view, for the compensating motion


def estimate_form_errors(
    clouds: Sequence[PreparedCloud], sizes_mm: FloatArray, poses: Sequence[RigidTransform], centres_mm: FloatArray
) -> FormErrors:
    """Model the form errors of all views, in the frame of the poses' ``to_frame``.

    The variance follows from the residuals of the pairs, the correlation length from decision 9. Registration compensates the rigid part
    of an error by moving the view, so that only the rest is a form error.

    Parameters
    ----------
    sizes_mm : (V,), standard deviation of each cloud's smooth error
    centres_mm : (V, 3), centres of rotation of the motions
    """
    reaches = np.array([CORRELATION_LENGTH * cloud.radius_mm for cloud in clouds])
    placed = [_place_thinned(cloud, pose) for cloud, pose in zip(clouds, poses, strict=True)]
    chosen = [pivoted_cholesky(points, reach, NEGLECTED_VARIANCE)[0] for (points, _), reach in zip(placed, reaches, strict=True)]
    motions = np.zeros((POSE * len(clouds), sum(map(len, chosen))))
    column = 0
    for number, ((points, normals), own) in enumerate(zip(placed, chosen, strict=True)):
        compensation = _compensating_motions(points, normals, points[own], float(reaches[number]), centres_mm[number])
        motions[POSE * number : POSE * (number + 1), column : column + len(own)] = sizes_mm[number] * compensation
        column += len(own)
    nodes = np.vstack([points[own] for (points, _), own in zip(placed, chosen, strict=True)])
    return FormErrors(nodes, np.repeat(np.arange(len(clouds)), [len(own) for own in chosen]), sizes_mm, reaches, motions)


def _place_thinned(cloud: PreparedCloud, pose: RigidTransform) -> tuple[FloatArray, FloatArray]:
    step = max(1, -(-len(cloud) // MOST_POINTS))
    return pose.apply(cloud.points_mm[::step]), pose.rotate(np.asarray(cloud.normals[::step], float))


def _compensating_motions(
    points_mm: FloatArray, normals: FloatArray, nodes_mm: FloatArray, reach_mm: float, centre_mm: FloatArray
) -> FloatArray:
    """Return the least-squares motions (6, N) of a view about its centre that compensate a smooth error of variance one."""
    if not len(points_mm):
        return np.zeros((POSE, len(nodes_mm)))
    lever = np.hstack([normals, np.cross(points_mm - centre_mm, normals) / reach_mm])
    motions = -np.linalg.pinv(lever, rcond=RANK_TOLERANCE) @ smooth_basis(points_mm, nodes_mm, reach_mm)
    motions[3:] /= reach_mm
    return np.asarray(motions)
