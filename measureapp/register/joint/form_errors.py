"""What form the clouds of the views have by themselves, by how large the smooth errors are that their pairs show."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.view_errors import HELD, POSE, FormErrors, smooth_patterns
from measureapp.geometry.transform import RigidTransform
from measureapp.register.pairs.prepare import PreparedCloud
from measureapp.register.pairs.smooth_errors import LENGTH, pivoted

LEFT_OUT = 0.1  # of a smooth error's variance at any point: what its nodes need not explain
MOST_POINTS = 2000  # tell how a view follows


def form_errors(
    clouds: Sequence[PreparedCloud], sizes_mm: FloatArray, poses: Sequence[RigidTransform], centres_mm: FloatArray
) -> FormErrors:
    """Return the errors of form of all views, in the frame that the poses lead to.

    A cloud's own error is as large as its pairs' residuals let expect (decision 9), and changes over the distance that is assumed there. What
    of it is a motion moves the view to the other side, so that only the rest is an error of form.

    Parameters
    ----------
    sizes_mm : (V,), standard deviation of each cloud's smooth error
    centres_mm : (V, 3), that motions turn about
    """
    reaches = np.array([LENGTH * cloud.radius_mm for cloud in clouds])
    placed = [_thinned(cloud, pose) for cloud, pose in zip(clouds, poses, strict=True)]
    chosen = [pivoted(points, reach, LEFT_OUT)[0] for (points, _), reach in zip(placed, reaches, strict=True)]
    motions = np.zeros((POSE * len(clouds), sum(map(len, chosen))))
    column = 0
    for number, ((points, normals), own) in enumerate(zip(placed, chosen, strict=True)):
        following = _following(points, normals, points[own], float(reaches[number]), centres_mm[number])
        motions[POSE * number : POSE * (number + 1), column : column + len(own)] = sizes_mm[number] * following
        column += len(own)
    nodes = np.vstack([points[own] for (points, _), own in zip(placed, chosen, strict=True)])
    return FormErrors(nodes, np.repeat(np.arange(len(clouds)), [len(own) for own in chosen]), sizes_mm, reaches, motions)


def _thinned(cloud: PreparedCloud, pose: RigidTransform) -> tuple[FloatArray, FloatArray]:
    step = max(1, -(-len(cloud) // MOST_POINTS))
    return pose.apply(cloud.points_mm[::step]), pose.rotate(np.asarray(cloud.normals[::step], float))


def _following(points_mm: FloatArray, normals: FloatArray, nodes_mm: FloatArray, reach_mm: float, centre_mm: FloatArray) -> FloatArray:
    """Return the motions (6, N) of a view about its centre that take off what they can of a smooth error of variance one."""
    if not len(points_mm):
        return np.zeros((POSE, len(nodes_mm)))
    lever = np.hstack([normals, np.cross(points_mm - centre_mm, normals) / reach_mm])
    motions = -np.linalg.pinv(lever, rcond=HELD) @ smooth_patterns(points_mm, nodes_mm, reach_mm)
    motions[3:] /= reach_mm
    return np.asarray(motions)
