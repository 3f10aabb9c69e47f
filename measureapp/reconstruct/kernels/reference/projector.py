"""NumPy statement of triangulating a camera and the projector, all pixels with a phase at once."""

from __future__ import annotations

import cv2
import numpy as np

from measureapp.arrays import FloatArray
from measureapp.reconstruct.kernels.projector import (
    BEHIND,
    CONTRADICTED,
    NO_PHASE,
    OUTSIDE,
    PARALLEL,
    POINT,
    SOLVED_PX,
    STEPS,
    TINY,
    UNSOLVED,
    Fringes,
    Output,
    Projector,
)

DIFFERENCE = 1e-6  # relative, of numerical derivatives by the inverse depth


def project(projector: Projector, undistorted: FloatArray) -> FloatArray:
    """Return the projector pixels (N, 2) of undistorted normalised coordinates (N, 2); OpenCV's lens model."""
    points = np.column_stack([undistorted, np.ones(len(undistorted))])
    plain = cv2.projectPoints(points, np.zeros(3), np.zeros(3), np.eye(3), np.asarray(projector.distortion))[0].reshape(-1, 2)
    homogeneous = np.column_stack([plain, np.ones(len(plain))]) @ projector.image.T
    return np.asarray(homogeneous[:, :2] / homogeneous[:, 2:])


def undistorted_at(projector: Projector, a: FloatArray, w: FloatArray) -> FloatArray:
    """Return the undistorted image (N, 2) of the points with inverse depth w on rays ``a`` (N, 3) in the projector's axes."""
    points = a + w[:, None] * projector.centre
    return np.asarray(points[:, :2] / points[:, 2:])


@np.errstate(all="ignore")
def triangulate(
    rays: FloatArray, columns: Fringes, rows: Fringes, projector: Projector, row_start: int, row_stop: int, out: Output
) -> None:
    """Solve projected column = column (and row = row) for the inverse depth by Gauss-Newton steps with numerical derivatives."""
    part, fringes = slice(row_start, row_stop), (columns, rows)
    out.depth[part], out.sigma[part], out.state[part] = 0, 0, NO_PHASE
    if columns.present and rows.present:
        out.residual[part] = 0
    shape = rays[part].shape[:2]
    has = [each.present & (each.state[part] == 0) if each.present else np.zeros(shape, np.bool_) for each in fringes]
    y, x = np.nonzero(has[0] | has[1])
    goal, weight = np.zeros((len(y), 2)), np.zeros((len(y), 2))
    for axis, each in enumerate(fringes):
        valid = has[axis][y, x]
        phase, sigma = (
            (image[part][y[valid], x[valid]].astype(np.float64) for image in (each.phase, each.sigma)) if each.present else ([], [])
        )
        goal[valid, axis] = np.asarray(phase) * each.scale[0] + each.scale[1]
        weight[valid, axis] = 1 / ((np.asarray(sigma) * each.scale[0]) ** 2 + TINY)
    a = np.column_stack([rays[part][y, x], np.ones(len(y))]).astype(np.float64) @ np.asarray(projector.rotation).T

    matrix, t = projector.image, projector.centre
    start = (goal - matrix[[0, 1], 2]) / matrix[[0, 1], [0, 1]]  # exact for a lens without distortion
    below = start * t[2] - t[:2]
    by_column = (weight[:, 1] == 0) | ((weight[:, 0] > 0) & (np.abs(below[:, 0]) > np.abs(below[:, 1])))
    w = np.where(by_column, *((a[:, axis] - start[:, axis] * a[:, 2]) / below[:, axis] for axis in (0, 1)))
    for step in range(STEPS + 1):
        seen = project(projector, undistorted_at(projector, a, w))
        slope = (project(projector, undistorted_at(projector, a, w * (1 + DIFFERENCE))) - seen) / (w * DIFFERENCE)[:, None]
        square, left = (weight * slope**2).sum(axis=1), (weight * slope * (goal - seen)).sum(axis=1)
        if step < STEPS:
            w = w + left / (square + TINY)

    undistorted, ahead = undistorted_at(projector, a, w), a[:, 2] + w * t[2]
    change = (t[:2] - undistorted * t[2]) / ahead[:, None]
    across = np.where(weight > 0, np.abs(change) / np.sqrt(1 + undistorted**2), 0)
    sine = across.max(axis=1) * np.abs(w * ahead) / np.linalg.norm(a, axis=1)
    norm, off = (slope**2).sum(axis=1) + TINY, goal - seen
    miss = (off[:, 0] * slope[:, 1] - off[:, 1] * slope[:, 0]) / np.sqrt(norm)  # off the epipolar line, which no depth explains
    noise = np.sqrt(((slope[:, ::-1] ** 2) / (weight + TINY)).sum(axis=1) / norm)
    both, bounds = (weight > 0).all(axis=1), projector.bounds
    state = np.full(len(y), POINT)
    state[both & (np.abs(miss) > projector.sigmas * noise + projector.px)] = CONTRADICTED
    state[~(np.abs(left / np.sqrt(weight.sum(axis=1) * square + TINY)) <= SOLVED_PX)] = UNSOLVED
    state[(seen < [bounds[0], bounds[2]]).any(axis=1) | (seen > [bounds[1], bounds[3]]).any(axis=1)] = OUTSIDE
    state[~((w > 0) & (ahead > 0))] = BEHIND
    state[~(sine >= projector.min_sine)] = PARALLEL

    out.state[part][y, x] = state
    points, compared = state == POINT, both & np.isin(state, (POINT, CONTRADICTED))
    if columns.present and rows.present:
        out.residual[part][y[compared], x[compared]] = miss[compared]
    out.depth[part][y[points], x[points]] = 1 / w[points]
    out.sigma[part][y[points], x[points]] = 1 / (w[points] ** 2 * np.sqrt(square[points]))
