"""Compiled loops over pixels. Every kernel processes the items ``start … stop`` (pixels, rows or blocks of pixels) and releases the
interpreter lock, so that bands run in parallel threads (`in_bands`).
"""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise
from typing import Any

import numpy as np
from numba import njit

from measureapp.arrays import BoolArray, FloatArray, IntArray

PROCESSORS = os.cpu_count() or 1
UNDISTORT_STEPS = 30
UNDISTORT_TOLERANCE = 1e-11  # on the plane z = 1
NOT_LIT = -1e6  # projector column of a point in shadow
NO_HIT = 0xFFFFFFFF
LENS_STEP_PX = 16.0  # between the nodes of a lens residual
PLAIN_SUMS: dict[str, Any] = {"cache": True, "error_model": "numpy", "fastmath": True}  # nothing in them overflows or divides by zero


def in_bands(kernel: Callable[..., None], start: int, stop: int, *arguments: Any) -> None:
    """Run ``kernel(start, stop, *arguments)`` in bands, one per processor."""
    edges = [start + (stop - start) * band // PROCESSORS for band in range(PROCESSORS + 1)]
    with ThreadPoolExecutor(PROCESSORS) as pool:
        for done in [pool.submit(kernel, low, high, *arguments) for low, high in pairwise(edges)]:
            done.result()


@njit(**PLAIN_SUMS)
def _distorted(x, y, d):  # type: ignore[no-untyped-def]
    """Brown-Conrady distortion with k1 k2 p1 p2 k3."""
    r2 = x * x + y * y
    radial = 1.0 + r2 * (d[0] + r2 * (d[1] + r2 * d[4]))
    return (
        x * radial + 2.0 * d[2] * x * y + d[3] * (r2 + 2.0 * x * x),
        y * radial + d[2] * (r2 + 2.0 * y * y) + 2.0 * d[3] * x * y,
    )


@njit(**PLAIN_SUMS)
def undistorted(u, v, k, d, aside, down):  # type: ignore[no-untyped-def]
    """Fixed-point inverse of `_distorted` for a pixel; ``k`` = fx, fy, cx, cy; it begins with the displacement of a pixel nearby."""
    x0 = (u - k[2]) / k[0]
    y0 = (v - k[3]) / k[1]
    x, y = x0 + aside, y0 + down
    for _ in range(UNDISTORT_STEPS):
        dx, dy = _distorted(x, y, d)
        dx, dy = x0 - dx, y0 - dy
        x += dx
        y += dy
        if abs(dx) + abs(dy) < UNDISTORT_TOLERANCE:
            break
    return x, y, x - x0, y - y0


@njit(**PLAIN_SUMS)
def interpolated(field, x, y, step):  # type: ignore[no-untyped-def]
    """Two components of a field (rows, columns, 2) with a node every ``step``, bilinearly; zero if it has a single node."""
    if field.shape[0] == 1:
        return 0.0, 0.0
    across = min(max(x / step, 0.0), field.shape[1] - 1.001)
    down = min(max(y / step, 0.0), field.shape[0] - 1.001)
    c, r = int(across), int(down)
    p, q = across - c, down - r
    a = (1.0 - p) * (1.0 - q)
    b = p * (1.0 - q)
    e = (1.0 - p) * q
    f = p * q
    return (
        a * field[r, c, 0] + b * field[r, c + 1, 0] + e * field[r + 1, c, 0] + f * field[r + 1, c + 1, 0],
        a * field[r, c, 1] + b * field[r, c + 1, 1] + e * field[r + 1, c, 1] + f * field[r + 1, c + 1, 1],
    )


@njit(cache=True, nogil=True)
def pixel_rays(
    start: int,
    stop: int,
    box: IntArray,
    k: FloatArray,
    d: FloatArray,
    residual: FloatArray,
    coma: FloatArray,
    pose: FloatArray,
    rays: FloatArray,
) -> None:
    """Fill ``rays`` (n, 6) float32: origin and unit direction of the pixels in ``box``; ``pose`` is scene_from_camera.

    A box is (first row, end row, first column, end column). ``residual`` (rows, columns, 2) is the distortion in px that the lens
    parameters lack, with a node every LENS_STEP_PX. ``coma`` = slope, depth in mm, x and y of its centre on the plane z = 1: rays do not
    meet in one point, so that an image is displaced with the distance from this depth.
    """
    columns = box[3] - box[2]
    for i in range(start, stop):
        u, v = float(box[2] + i % columns), float(box[0] + i // columns)
        du, dv = interpolated(residual, u, v, LENS_STEP_PX)
        x, y, _, _ = undistorted(u + du, v + dv, k, d, 0.0, 0.0)
        aside, down = coma[0] * (x - coma[2]), coma[0] * (y - coma[3])
        x, y = x + aside, y + down
        length = np.sqrt(x * x + y * y + 1.0)
        for a in range(3):
            rays[i, a] = pose[a, 3] - coma[1] * (pose[a, 0] * aside + pose[a, 1] * down)
            rays[i, 3 + a] = (pose[a, 0] * x + pose[a, 1] * y + pose[a, 2]) / length


@njit(cache=True)
def radiance(normal, to_light, to_eye, material, standoff_mm):  # type: ignore[no-untyped-def]
    """Radiance towards the camera, relative to a facing white surface at standoff: Lambert plus a Blinn-Phong lobe."""
    distance = np.sqrt(to_light[0] ** 2 + to_light[1] ** 2 + to_light[2] ** 2)
    cosine = (normal[0] * to_light[0] + normal[1] * to_light[1] + normal[2] * to_light[2]) / distance
    if cosine <= 0.0:
        return 0.0
    lobe = 0.0
    if material[1] > 0.0:
        hx = to_light[0] / distance + to_eye[0]
        hy = to_light[1] / distance + to_eye[1]
        hz = to_light[2] / distance + to_eye[2]
        h = max(0.0, (normal[0] * hx + normal[1] * hy + normal[2] * hz) / np.sqrt(hx * hx + hy * hy + hz * hz))
        lobe = material[1] * h ** material[2]
    return (material[0] * cosine + lobe * np.sqrt(cosine)) * (standoff_mm / distance) ** 2


@njit(cache=True)
def projector_pixel(point, light_from_scene, k, d):  # type: ignore[no-untyped-def]
    """Column and row of the projector that light a point; NOT_LIT behind it."""
    m = light_from_scene
    z = m[2, 0] * point[0] + m[2, 1] * point[1] + m[2, 2] * point[2] + m[2, 3]
    if z <= 0.0:
        return NOT_LIT, NOT_LIT
    x = (m[0, 0] * point[0] + m[0, 1] * point[1] + m[0, 2] * point[2] + m[0, 3]) / z
    y = (m[1, 0] * point[0] + m[1, 1] * point[1] + m[1, 2] * point[2] + m[1, 3]) / z
    dx, dy = _distorted(x, y, d)
    return k[0] * dx + k[2], k[1] * dy + k[3]


@njit(cache=True, nogil=True)
def light_surface(
    start: int,
    stop: int,
    rays: FloatArray,
    triangle: IntArray,
    corner: FloatArray,
    normals: FloatArray,
    material: IntArray,
    materials: FloatArray,
    light: FloatArray,
    light_from_scene: FloatArray,
    light_k: FloatArray,
    light_d: FloatArray,
    standoff_mm: float,
    offset_mm: float,
    depth_mm: float,
    out: FloatArray,
    shadow_rays: FloatArray,
) -> None:
    """Intersect every ray with the plane of its triangle and compute the illumination there.

    ``out`` (n, 4) float32 receives projector column and row, reflected light and albedo; ``shadow_rays`` (n, 6) float32
    lead from the surface to the projector, with its distance as their length. The light comes back from ``depth_mm`` below the surface,
    so that the projector's pixel is the one that lights the point there.
    """
    for i in range(start, stop):
        t = triangle[i]
        out[i, 0] = NOT_LIT
        out[i, 1] = 0.0
        out[i, 2] = 0.0
        out[i, 3] = 0.0
        for a in range(3):
            shadow_rays[i, a] = 1e7
            shadow_rays[i, 3 + a] = 1.0
        if t == NO_HIT:
            continue
        ox, oy, oz = float(rays[i, 0]), float(rays[i, 1]), float(rays[i, 2])
        dx, dy, dz = float(rays[i, 3]), float(rays[i, 4]), float(rays[i, 5])
        nx, ny, nz = normals[t, 0], normals[t, 1], normals[t, 2]
        slope = nx * dx + ny * dy + nz * dz
        if slope == 0.0:
            continue
        s = (nx * (corner[t, 0] - ox) + ny * (corner[t, 1] - oy) + nz * (corner[t, 2] - oz)) / slope
        if slope > 0.0:
            nx, ny, nz = -nx, -ny, -nz
        point = (ox + s * dx, oy + s * dy, oz + s * dz)
        to_light = (light[0] - point[0], light[1] - point[1], light[2] - point[2])
        properties = materials[material[t]]
        reflected = radiance((nx, ny, nz), to_light, (-dx, -dy, -dz), properties, standoff_mm)
        out[i, 3] = properties[0]
        if reflected <= 0.0:
            continue
        out[i, 2] = reflected
        below = (point[0] - depth_mm * nx, point[1] - depth_mm * ny, point[2] - depth_mm * nz)
        u, v = projector_pixel(below, light_from_scene, light_k, light_d)
        out[i, 0] = u
        out[i, 1] = v
        shadow_rays[i, 0] = point[0] + offset_mm * nx
        shadow_rays[i, 1] = point[1] + offset_mm * ny
        shadow_rays[i, 2] = point[2] + offset_mm * nz
        for a in range(3):
            shadow_rays[i, 3 + a] = to_light[a]


@njit(cache=True, nogil=True)
def darken_shadows(start: int, stop: int, hidden: BoolArray, out: FloatArray) -> None:
    """Mark the pixels in shadow in ``out`` (n, 4)."""
    for i in range(start, stop):
        if hidden[i]:
            out[i, 0] = NOT_LIT


@njit(cache=True, nogil=True, fastmath=True)
def expose(
    start: int, stop: int, light: FloatArray, pattern: FloatArray, lamp: float, ambient: float, scale: float, floor: float, out: FloatArray
) -> None:
    """Mean image (n,) float32 relative to full scale for the illumination ``light`` (n, 4) of `light_surface`.

    ``pattern`` (h, w) is sampled bilinearly; ``lamp`` illuminates everything from the projector's position, ``ambient`` from all
    directions.
    """
    height, width = pattern.shape
    for i in range(start, stop):
        albedo = light[i, 3]
        value = 0.0
        if albedo > 0.0:
            reflected = light[i, 2]
            strength = lamp
            u = light[i, 0]
            v = light[i, 1]
            if reflected > 0.0 and u >= -0.5 and v >= -0.5 and u <= width - 0.5 and v <= height - 0.5:
                u = min(max(u, 0.0), width - 1.001)
                v = min(max(v, 0.0), height - 1.001)
                c = int(u)
                r = int(v)
                fu = u - c
                fv = v - r
                top = pattern[r, c] + fu * (pattern[r, c + 1] - pattern[r, c])
                low = pattern[r + 1, c] + fu * (pattern[r + 1, c + 1] - pattern[r + 1, c])
                strength += top + fv * (low - top)
            value = reflected * strength + ambient * albedo
        out[i] = value * scale + floor
