"""NumPy statements of cleaning a depth map and gathering its points."""

from __future__ import annotations

import cv2
import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.point_state import PointState
from measureapp.reconstruct.kernels.clean import CHUNK, MAX_STEP_SHARE, MIN_PLACES, MIN_SPREAD, STEP_SIGMAS, Criteria, Plane
from measureapp.reconstruct.kernels.gather import CloudArrays
from measureapp.reconstruct.kernels.structures import Surface, cubic


def invert_depth(
    depth: FloatArray, sigma: FloatArray, max_sigma: float, radius: int, row_start: int, row_stop: int, inverse: FloatArray, state: IntArray
) -> None:
    """Write the inverse depths of points that are precise enough."""
    rows, width = slice(row_start, row_stop), depth.shape[1]
    points, precise = depth[rows] > 0, sigma[rows] <= max_sigma
    inverse[row_start + radius : row_stop + radius, radius : radius + width] = np.where(
        points & precise, 1 / np.where(points, depth[rows], 1), 0
    )
    state[rows][points & ~precise] = PointState.UNCERTAIN


def _unpadded(surface: Surface) -> FloatArray:
    """Return the inverse depths without their border, as a view."""
    r = surface.radius
    return np.asarray(surface.inverse[r:-r, r:-r])


def _fit_planes(surface: Surface, y: IntArray, x: IntArray) -> Plane:
    """Fit a plane w = offset + w_u u + w_v v to the window of every point (N,), by least squares over the places on its surface.

    Inverse depths w are relative to the pixel's own; without a plane, the normal is that of the viewing ray.
    """
    r, near = surface.radius, max(1, surface.radius // 2)
    places = [(dy, dx) for dy in (-r, -near, 0, near, r) for dx in (-r, -near, 0, near, r)]
    dy, dx = np.array(places).T
    own = surface.inverse[y + r, x + r].astype(np.float64)
    depth = 1 / np.maximum(own, 1e-12)
    w = surface.inverse[y[:, None] + r + dy, x[:, None] + r + dx] - own[:, None]
    distance = np.where(np.maximum(np.abs(dx), np.abs(dy)) == r, r, near)
    slack = STEP_SIGMAS * surface.sigma[y, x] * own**2
    limit = np.minimum(distance * (surface.step_per_px * own)[:, None] + slack[:, None], MAX_STEP_SHARE * own[:, None])
    on = (np.abs(w) <= limit).astype(np.float64)
    count = on.sum(axis=1)
    columns = np.stack([np.ones(len(dx)), dx, dy], axis=-1)
    normal = np.einsum("nk,ki,kj->nij", on, columns, columns)
    right = np.einsum("nk,nk,ki->ni", on, w * depth[:, None], columns)
    share = 1 / np.maximum(count, 1)
    xx, yy, xy = (normal[:, i, j] - normal[:, 0, i] * normal[:, 0, j] * share for i, j in ((1, 1), (2, 2), (1, 2)))
    fits = (count >= MIN_PLACES) & (xx * yy - xy**2 > MIN_SPREAD * (xx + yy) ** 2)
    normal[~fits], right[~fits] = np.eye(3), 0
    offset, w_u, w_v = np.linalg.solve(normal, right[..., None])[..., 0].T

    u0, per_u, v0, per_v = (float(value) for value in surface.unit)
    x_u, x_v, y_u, y_v = (cubic.py_func(c, (x - u0) * per_u, (y - v0) * per_v) for c in surface.jacobian)
    ray = surface.rays.reshape(*surface.sigma.shape, 2)[y, x].astype(np.float64)
    p, q = (w_u * y_v - w_v * y_u) / (x_u * y_v - x_v * y_u), (w_v * x_u - w_u * x_v) / (x_u * y_v - x_v * y_u)
    plane = np.stack([p, q, 1 + offset - p * ray[:, 0] - q * ray[:, 1]])  # plane · (x, y, 1) = depth of the pixel over that of the plane
    ray_unit = np.column_stack([ray, np.ones(len(ray))]).T / np.sqrt(1 + (ray**2).sum(axis=1))
    towards = -np.sign(1 + offset) * plane / np.linalg.norm(plane, axis=0)
    normals = np.where(fits, towards, -ray_unit)
    cosine = np.where(fits, np.abs((normals * ray_unit).sum(axis=0)), 1)
    neighbours = np.where(fits | (count < MIN_PLACES), count - 1, 0)
    return Plane(normals[0], normals[1], normals[2], cosine, offset * depth, neighbours)


def reject_points(
    surface: Surface, cameras: IntArray, criteria: Criteria, row_start: int, row_stop: int, state: IntArray, normals: FloatArray,
    removed: IntArray,
) -> None:  # fmt: skip
    """Fit a plane to the window of every point and reject points with the first reason that applies."""
    y, x = np.nonzero(_unpadded(surface)[row_start:row_stop] > 0)
    y += row_start
    plane = _fit_planes(surface, y, x)
    normals[:, y, x] = plane[:3]
    depth, sigma = 1 / _unpadded(surface)[y, x].astype(np.float64), surface.sigma[y, x]
    points = np.column_stack([surface.rays.reshape(*state.shape, 2)[y, x], np.ones(len(y))]) * depth[:, None]
    reason = np.full(len(y), PointState.VALID, np.uint8)
    for k, centre in enumerate(criteria.centres):
        towards = centre - points
        cosine = (np.stack(plane[:3], axis=-1) * towards).sum(axis=1) / np.linalg.norm(towards, axis=1)
        reason[(cosine < criteria.min_partner_cosine) & (cameras[y, x] >> k & 1 != 0)] = PointState.PARTNER_GRAZING
    reason[plane.cosine < criteria.min_cosine] = PointState.GRAZING
    allowed = criteria.outlier_sigmas * sigma + criteria.outlier_share * depth
    reason[np.abs(plane.offset) * plane.cosine > allowed] = PointState.OUTLIER
    reason[plane.neighbours < criteria.min_neighbours] = PointState.FLYING
    rejected = reason != PointState.VALID
    state[y[rejected], x[rejected]] = reason[rejected]
    removed[row_start:row_stop] = 0
    removed[y[rejected], x[rejected] // CHUNK] = 1


def refit_normals(surface: Surface, removed: IntArray, row_start: int, row_stop: int, normals: FloatArray) -> None:
    """Fit the planes again whose windows lost points."""
    near = cv2.dilate(np.asarray(removed), np.ones((2 * surface.radius + 1, 3), np.uint8))
    touched = np.repeat(near, CHUNK, axis=1)[:, : surface.sigma.shape[1]] != 0
    touched &= _unpadded(surface) > 0
    y, x = np.nonzero(touched[row_start:row_stop])
    y += row_start
    normals[:, y, x] = _fit_planes(surface, y, x)[:3]


def _are_linked(surface: Surface, axis: int) -> BoolArray:
    """Whether no depth discontinuity separates pixels from their left (axis 1) or upper (axis 0) neighbours."""
    inverse = _unpadded(surface)
    before, own = (inverse[:-1], inverse[1:]) if axis == 0 else (inverse[:, :-1], inverse[:, 1:])
    sigma = surface.sigma[1:] if axis == 0 else surface.sigma[:, 1:]
    near = np.abs(before - own) <= surface.step_per_px * own + STEP_SIGMAS * sigma * own**2
    return np.asarray(near & (before > 0) & (own > 0))


def find_runs(
    surface: Surface,
    state: IntArray,
    _removed: IntArray,
    row_start: int,
    row_stop: int,
    starts: IntArray,
    stops: IntArray,
    counts: IntArray,
) -> None:
    """Remove rejected points from the inverse depths, and find the runs of points of every row without a depth discontinuity."""
    inverse = _unpadded(surface)
    inverse[row_start:row_stop][state[row_start:row_stop] != 0] = 0
    linked = _are_linked(surface, 1)
    for y in range(row_start, row_stop):
        points = inverse[y] > 0
        begins = np.flatnonzero(points & ~np.concatenate([[False], linked[y]]))
        ends = np.flatnonzero(points & ~np.concatenate([linked[y], [False]])) + 1
        counts[y] = len(begins)
        starts[y, : len(begins)], stops[y, : len(begins)] = begins, ends


def remove_small_components(
    surface: Surface, min_pixels: int, _starts: IntArray, _stops: IntArray, _counts: IntArray, state: IntArray, removed: IntArray,
    points: IntArray,
) -> None:  # fmt: skip
    """Remove the connected components of less than ``min_pixels`` pixels; neighbours without a depth discontinuity are connected."""
    inverse = _unpadded(surface)
    index = np.arange(inverse.size).reshape(inverse.shape)
    across, down = _are_linked(surface, 1), _are_linked(surface, 0)
    first = np.concatenate([index[:, 1:][across], index[1:][down]])
    second = np.concatenate([index[:, :-1][across], index[:-1][down]])
    graph = coo_array((np.ones(len(first), np.bool_), (first, second)), (inverse.size, inverse.size))
    label = connected_components(graph, directed=False)[1].reshape(inverse.shape)
    small = (inverse > 0) & (np.bincount(label.ravel())[label] < min_pixels)
    state[small], inverse[small] = PointState.ISLAND, 0
    y, x = np.nonzero(small)
    removed[y, x // CHUNK] = 1
    points[:] = (inverse > 0).sum(axis=1)


def gather_points(
    inverse: FloatArray, depth: FloatArray, sigma: FloatArray, rays: FloatArray, normals: FloatArray, grey: IntArray, per_grey: float,
    cameras: IntArray, masks: IntArray, pose: FloatArray, starts: IntArray, row_start: int, row_stop: int, cloud: CloudArrays,
) -> None:  # fmt: skip
    """Transform the points of some rows into the frame of the cloud."""
    border = (inverse.shape[0] - depth.shape[0]) // 2
    y, x = np.nonzero(inverse[border:-border, border:-border][row_start:row_stop] > 0)
    y += row_start
    part = slice(starts[row_start], starts[row_start] + len(y))
    ray = np.column_stack([rays.reshape(*depth.shape, 2)[y, x], np.ones(len(y))]).astype(np.float64)
    cloud.points[part] = ray * depth[y, x, None] @ pose[:, :3].T + pose[:, 3]
    cloud.normals[part] = normals[:, y, x].T @ pose[:, :3].T
    cloud.sigma[part] = sigma[y, x] * np.linalg.norm(ray, axis=1)
    cloud.grey[part] = np.minimum(grey[y, x] * per_grey, 1)
    cloud.pixel[part] = np.column_stack([y, x])
    cloud.cameras[part] = masks[cameras[y, x]]
