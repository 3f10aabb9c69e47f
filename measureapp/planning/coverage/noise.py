"""Predicted standard deviation of a measured point, from phase noise, base, distance and the tilt of the surface."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import BoolArray, FloatArray
from measureapp.planning.coverage.head import Eye, Head
from measureapp.planning.coverage.limits import VisibilityLimits

BETWEEN_PIXELS = (2 / 3) ** 2  # mean variance of a value interpolated between four pixels, over that of one
LEAST_SLOPE = 1e-6  # columns per mm; a pair with less sees no change of phase with depth


def sigma_along_ray(points_mm: FloatArray, normals: FloatArray, cameras: BoolArray, head: Head, limits: VisibilityLimits) -> FloatArray:
    """Return the standard deviation of points along the ray of a camera.

    If the point moves by dt along the ray of camera i, the ray of j meets the tangent plane at ``(d_i - d_j (n·d_i) / (n·d_j)) dt``; with the
    gradient g of the projector column there, its phase changes by ``s_ij dt = 2π / pitch · g · (…) dt``. Cameras of weights w (inverse
    variances of their phases) determine the point and its phase by least squares: ``σ² = Σ w / Σ_{i<j} w_i w_j s_ij²``, as
    reconstruction does. The first camera reads its own pixel, the others between four pixels, whose noise averages.

    Parameters
    ----------
    points_mm, normals : (N, 3), in the frame `head`
    cameras : (N, C), which cameras measure a point; at least two of them, or the only one, with the projector as its partner

    Returns
    -------
    (N,) float
    """
    rays = np.stack([_rays(camera, points_mm) for camera in head.cameras])  # (C, N, 3)
    gradient = _column_gradient(head.projector, points_mm)
    sigma_rad = limits.fringes.sigma_at(_light(head, points_mm, normals))
    per_mm = 2.0 * np.pi / limits.fringes.pitch_px
    count = len(head.cameras)
    if count == 1:
        slope = np.abs(np.einsum("ni,ni->n", gradient, rays[0])) * per_mm
        return sigma_rad / np.maximum(slope, LEAST_SLOPE)
    facing = np.einsum("cni,ni->cn", rays, normals)
    weights = _weights(cameras)
    spread = np.zeros(len(points_mm))
    for i in range(count):
        for j in range(i + 1, count):
            shift = rays[i] - rays[j] * (facing[i] / facing[j])[:, None]
            slope = np.einsum("ni,ni->n", gradient, shift) * per_mm
            spread += weights[:, i] * weights[:, j] * slope**2
    return np.asarray(sigma_rad * np.sqrt(weights.sum(axis=1) / np.maximum(spread, LEAST_SLOPE**2)))


def _weights(cameras: BoolArray) -> FloatArray:
    """Return the inverse variances (N, C) of the phases that cameras contribute, relative to that of a pixel; 0 for those that see nothing."""
    first = np.argmax(cameras, axis=1)
    weights = np.where(cameras, 1.0 / BETWEEN_PIXELS, 0.0)
    weights[np.arange(len(cameras)), first] = cameras.any(axis=1)
    return weights


def _rays(eye: Eye, points_mm: FloatArray) -> FloatArray:
    """Return unit rays (N, 3) from a device to points, in the frame `head`."""
    rays = points_mm - eye.position_mm
    return rays / np.linalg.norm(rays, axis=1, keepdims=True)


def _column_gradient(projector: Eye, points_mm: FloatArray) -> FloatArray:
    """Return the gradient (N, 3) of the projector column, in columns per mm."""
    x, _, z = ((points_mm - projector.position_mm) @ projector.head_from_eye).T
    right, _, forward = projector.head_from_eye.T
    return projector.focal_px / z[:, None] * (right - (x / z)[:, None] * forward)


def _light(head: Head, points_mm: FloatArray, normals: FloatArray) -> FloatArray:
    """Return the light that a matt surface reflects (N,), relative to one that faces the projector at the standoff."""
    rays = points_mm - head.projector.position_mm
    distance = np.linalg.norm(rays, axis=1)
    cosine = -np.einsum("ni,ni->n", rays, normals) / distance
    return np.maximum(cosine, 1e-3) * (head.standoff_mm / distance) ** 2
