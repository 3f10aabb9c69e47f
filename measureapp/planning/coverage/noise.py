"""Predicted standard deviation of a measured point, from phase noise, base, distance and the tilt of the surface."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import BoolArray, FloatArray
from measureapp.planning.coverage.head import Eye, Head
from measureapp.planning.coverage.limits import VisibilityLimits

LEAST_SLOPE = 1e-6  # columns per mm; a pair with less sees no change of phase with depth


def sigma_along_ray(points_mm: FloatArray, normals: FloatArray, cameras: BoolArray, head: Head, limits: VisibilityLimits) -> FloatArray:
    """Return the standard deviation of points along the ray of a camera.

    Camera j finds the phase that camera i measured at a pixel. If the point moves by dt along the ray of i, the ray of j meets the tangent
    plane at ``(d_i - d_j (n·d_i) / (n·d_j)) dt``; with the gradient g of the projector column there, the phase changes by
    ``2π / pitch · g · (…) dt``. Both phases have the noise ``phase_sigma_rad``, divided by the square root of the light: cosine of the
    incidence over the squared distance (shot noise). C cameras have C - 1 independent pairs; the mean information of all pairs counts.

    Parameters
    ----------
    points_mm, normals : (N, 3), in the frame `head`
    cameras : (N, C), which cameras measure a point; at least two of them, or the only one, with the projector as its partner

    Returns
    -------
    (N,) float
    """
    rays = np.stack([_rays(camera, points_mm) for camera in head.cameras])  # (C, N, 3)
    gradient, light = _column_gradient(head.projector, points_mm), _light(head, points_mm, normals)
    per_mm = 2.0 * np.pi / limits.pitch_px
    facing = np.einsum("cni,ni->cn", rays, normals)
    count = len(head.cameras)
    if count == 1:
        slope = np.abs(np.einsum("ni,ni->n", gradient, rays[0])) * per_mm
        return limits.phase_sigma_rad / np.sqrt(light) / np.maximum(slope, LEAST_SLOPE)
    information, pairs = np.zeros(len(points_mm)), np.zeros(len(points_mm))
    for i in range(count):
        for j in range(i + 1, count):
            shift = rays[i] - rays[j] * (facing[i] / facing[j])[:, None]
            slope = np.einsum("ni,ni->n", gradient, shift) * per_mm
            both = cameras[:, i] & cameras[:, j]
            information += np.where(both, slope**2 * light / (2.0 * limits.phase_sigma_rad**2), 0.0)
            pairs += both
    independent = np.maximum(cameras.sum(axis=1) - 1.0, 1.0)
    return 1.0 / np.sqrt(np.maximum(information / np.maximum(pairs, 1.0) * independent, LEAST_SLOPE**2))


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
