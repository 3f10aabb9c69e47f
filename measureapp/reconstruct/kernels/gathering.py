"""Compiled loop that writes the points left on a depth map into a cloud.

A cloud is written once and is larger than the caches. So points wait on a stage until they fill whole cache lines in every array of the
cloud, which are written by non-temporal stores; ordinary stores would first read these lines from memory.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numba import njit

from measureapp.compiled.buffer_pool import CACHE_LINE_BYTES
from measureapp.compiled.cache_hints import stream_line
from measureapp.compiled.options import INLINE, LOOP
from measureapp.compiled.simd.elements import convert, minimum, sqrt
from measureapp.compiled.simd.memory import load, load_records, store, store_records
from measureapp.reconstruct.kernels.cleaning import CHUNK, INV, NX, NY, NZ, OFF, OWN, ROW_X, ROW_Y, SCRATCH, planes_of_chunk
from measureapp.reconstruct.kernels.constants import PIXELS
from measureapp.reconstruct.kernels.scratch import stack_float32, stack_float64, stack_int32, stack_uint8

BLOCK = CACHE_LINE_BYTES  # so many points fill whole cache lines in arrays of any number of elements of any type
STAGE = BLOCK + CHUNK
TRIPLES, PAIRS = 3 * STAGE, 2 * STAGE
(PX, PY, PZ) = (k * CHUNK for k in range(3))
POINTS = 3 * CHUNK
ZERO, ONE = np.float32(0), np.float32(1)
A, B, THREE = np.uint32(1), np.uint32(2), np.uint32(3)  # unsigned: negative places would be looked for at the end of an array


class Points(NamedTuple):
    """The arrays of a cloud of N points, or of the stage, flat."""

    points: Any  # (3 N,) float64
    normals: Any  # (3 N,) float32
    along: Any  # (N,) float32, standard deviation along the viewing ray
    light: Any  # (N,) float32
    pixel: Any  # (2 N,) int32
    cameras: Any  # (N,) uint8


@njit(**INLINE)
def pour(stage: Any, out: Any, per_point: int, begin: int, first: int, stop: int, held: int) -> None:
    """Write the points ``first … stop`` of the stage, whose first belongs at ``begin`` of the cloud, and move the rest to the front."""
    end, into = stop * per_point, out[begin * per_point : (begin + stop) * per_point]
    done = first * per_point
    if first == 0 and into.ctypes.data % CACHE_LINE_BYTES == 0:
        step = CACHE_LINE_BYTES // out.itemsize
        done = end - end % step
        for j in range(0, done, step):
            stream_line(stage, into, j)
    for j in range(done, end):
        into[j] = stage[j]
    for j in range(held * per_point - end):
        stage[j] = stage[end + j]


@njit(**INLINE)
def count_left(inverse: Any) -> Any:
    """Count the points of a chunk of a row."""
    left = np.int32(0)
    for i in range(len(inverse)):
        left += inverse[i] > ZERO
    return left


@njit(**INLINE)
def is_touched(removed: Any, y: int, chunk: int, border: int) -> bool:
    """Whether points were removed from a window about a pixel of a chunk of a row."""
    some = np.uint8(0)
    for v in range(max(y - border, 0), min(y + border + 1, len(removed))):
        for k in range(max(chunk - 1, 0), min(chunk + 2, removed.shape[1])):
            some |= removed[v, k]
    return some != 0


@njit(**INLINE)
def take_judged(s: Any, inverse: Any, sigma: Any, rays: Any, judged: Any, border: int, y: int, first: int, n: int) -> None:
    """Take what `planes_of_chunk` would compute again from where it was written when the points were judged."""
    middle, noise = inverse[y + border, border + first : border + first + n], sigma[y, first : first + n]
    nx, ny, nz = judged[0, y, first : first + n], judged[1, y, first : first + n], judged[2, y, first : first + n]
    ray = rays[y, 2 * first : 2 * (first + n)]
    for i in range(n):
        s[INV + i] = middle[i]
    for i in range(n):
        s[OWN + i] = noise[i]
    for i in range(n):
        s[NX + i] = nx[i]
    for i in range(n):
        s[NY + i] = ny[i]
    for i in range(n):
        s[NZ + i] = nz[i]
    for i in range(n):
        s[ROW_X + i], s[ROW_Y + i] = ray[2 * i], ray[2 * i + 1]


@njit(**INLINE)
def stage_judged(maps: Any, first: int, n: int, per_grey: Any, pose: Any, stage: Points, held: int) -> None:
    """Put n pixels, whole PIXELS, that all are points on the stage, behind the ``held`` there are, with the normals they were judged by.

    The pixels themselves and the cameras are left to `stage_places`.
    """
    sigma, depth, grey, rays, normal_x, normal_y, normal_z = maps
    (a0, a1, a2, a3), (b0, b1, b2, b3), (c0, c1, c2, c3) = pose
    for i in range(0, n, PIXELS):
        x, y0 = load_records(rays, 2 * (first + i), PIXELS, 2)
        nx, ny, nz = load(normal_x, first + i, PIXELS), load(normal_y, first + i, PIXELS), load(normal_z, first + i, PIXELS)
        turned = (
            np.float32(a0) * nx + np.float32(a1) * ny + np.float32(a2) * nz,
            np.float32(b0) * nx + np.float32(b1) * ny + np.float32(b2) * nz,
            np.float32(c0) * nx + np.float32(c1) * ny + np.float32(c2) * nz,
        )
        store_records(turned, stage.normals, 3 * (held + i))
        store(load(sigma, first + i, PIXELS) * sqrt(ONE + x * x + y0 * y0), stage.along, held + i)
        store(minimum(convert(load(grey, first + i, PIXELS), np.float32) * per_grey, ONE), stage.light, held + i)
        z = convert(load(depth, first + i, PIXELS), np.float64)
        p, q = convert(x, np.float64) * z, convert(y0, np.float64) * z
        placed = a0 * p + a1 * q + a2 * z + a3, b0 * p + b1 * q + b2 * z + b3, c0 * p + c1 * q + c2 * z + c3
        store_records(placed, stage.points, 3 * (held + i))


@njit(**INLINE)
def stage_places(stage: Points, masks: Any, taking: Any, held: int, y: int, first: int, n: int) -> None:
    """Put on the stage where n pixels, all of them points, lie in the image, and which cameras take part."""
    pixel, cameras = stage.pixel[2 * held : 2 * (held + n)], stage.cameras[held : held + n]
    for i in range(n):
        pixel[2 * i], pixel[2 * i + 1] = y, first + i
    for i in range(n):
        cameras[i] = masks[taking[i]]


@njit(**INLINE)
def pour_all(stage: Points, written: Points, begin: Any, first: Any, stop: Any, held: Any) -> None:
    """Pour all that is known of the points."""
    pour(stage.points, written.points, 3, begin, first, stop, held)
    pour(stage.normals, written.normals, 3, begin, first, stop, held)
    pour(stage.along, written.along, 1, begin, first, stop, held)
    pour(stage.light, written.light, 1, begin, first, stop, held)
    pour(stage.pixel, written.pixel, 2, begin, first, stop, held)
    pour(stage.cameras, written.cameras, 1, begin, first, stop, held)


@njit(**INLINE)
def stage_some(s: Any, d: Any, stage: Points, masks: Any, taking: Any, held: int, y: int, first: int, n: int) -> int:
    """Put those of n pixels that are points on the stage, behind the ``held`` there are; returns how many are there then."""
    points, normals, along, light, pixel, cameras = stage
    for i in range(n):  # a place without a point is written over by the next
        k = np.uint32(held)
        points[THREE * k], points[THREE * k + A], points[THREE * k + B] = d[PX + i], d[PY + i], d[PZ + i]
        normals[THREE * k], normals[THREE * k + A], normals[THREE * k + B] = s[NX + i], s[NY + i], s[NZ + i]
        along[k], light[k] = s[OWN + i], s[OFF + i]
        pixel[B * k], pixel[B * k + A] = y, first + i
        cameras[k] = masks[taking[i]]
        held += s[INV + i] > ZERO
    return held


@njit(**INLINE)
def place(s: Any, d: Any, depth: Any, pose: Any, n: int) -> None:
    """Take n points and their normals from the camera's frame to the cloud's, and the standard deviations of z to those along the rays."""
    p00, p01, p02, p03 = pose[0, 0], pose[0, 1], pose[0, 2], pose[0, 3]
    p10, p11, p12, p13 = pose[1, 0], pose[1, 1], pose[1, 2], pose[1, 3]
    p20, p21, p22, p23 = pose[2, 0], pose[2, 1], pose[2, 2], pose[2, 3]
    t00, t01, t02 = np.float32(p00), np.float32(p01), np.float32(p02)
    t10, t11, t12 = np.float32(p10), np.float32(p11), np.float32(p12)
    t20, t21, t22 = np.float32(p20), np.float32(p21), np.float32(p22)
    for i in range(n):
        p, q, w = s[NX + i], s[NY + i], s[NZ + i]
        x, y = s[ROW_X + i], s[ROW_Y + i]
        s[NX + i], s[NY + i], s[NZ + i] = t00 * p + t01 * q + t02 * w, t10 * p + t11 * q + t12 * w, t20 * p + t21 * q + t22 * w
        s[OWN + i] *= np.sqrt(ONE + x * x + y * y)
    for i in range(n):
        z = float(depth[i])
        a, b = float(s[ROW_X + i]) * z, float(s[ROW_Y + i]) * z
        d[PX + i] = p00 * a + p01 * b + p02 * z + p03
        d[PY + i] = p10 * a + p11 * b + p12 * z + p13
        d[PZ + i] = p20 * a + p21 * b + p22 * z + p23


@njit(**LOOP)
def gather_points(
    inverse: Any,
    depth: Any,
    sigma: Any,
    rays: Any,  # (H, 2 W) float32
    to_rays: Any,
    to_unit: Any,
    per_px: Any,
    border: int,
    judged: Any,  # (3, H, W) float32, normals by all points that were judged
    removed: Any,  # (H, chunks) uint8, 1 where points of a chunk of a row were removed since
    grey: Any,
    per_grey: Any,  # float32
    bits: Any,
    masks: Any,  # (2^M,) uint8, cameras of a point in the order of the calibration, by `bits`
    pose: Any,  # (3, 4) float64, reference from camera
    begins: Any,  # (H,) int64, index of the first point of every row
    row_start: int,
    row_stop: int,
    written: Points,  # out
) -> None:
    """Write the points that are left, with the normals of the planes through them."""
    width = sigma.shape[1]
    s, d = stack_float32(SCRATCH), stack_float64(POINTS)
    normals, along, light = stack_float32(TRIPLES), stack_float32(STAGE), stack_float32(STAGE)
    stage = Points(stack_float64(TRIPLES), normals, along, light, stack_int32(PAIRS), stack_uint8(STAGE))
    first_of_band = begins[row_start] % BLOCK  # what lies before on the stage belongs to the band before
    numbers = (
        (pose[0, 0], pose[0, 1], pose[0, 2], pose[0, 3]),
        (pose[1, 0], pose[1, 1], pose[1, 2], pose[1, 3]),
        (pose[2, 0], pose[2, 1], pose[2, 2], pose[2, 3]),
    )
    begin, held = begins[row_start] - first_of_band, first_of_band
    for y in range(row_start, row_stop):
        for first in range(0, width, CHUNK):
            n = min(CHUNK, width - first)
            left = count_left(inverse[y + border, border + first : border + first + n])
            if left == 0:
                continue
            touched, taking = is_touched(removed, y, first // CHUNK, border), bits[y, first : first + n]
            if left == n and n % PIXELS == 0 and not touched:
                maps = (sigma[y], depth[y], grey[y], rays[y], judged[0, y], judged[1, y], judged[2, y])
                stage_judged(maps, first, n, per_grey, numbers, stage, held)
                stage_places(stage, masks, taking, held, y, first, n)
                held += n
            else:
                if touched:
                    planes_of_chunk(s, inverse, sigma, rays, to_rays, to_unit, per_px, border, y, first, n)
                else:
                    take_judged(s, inverse, sigma, rays, judged, border, y, first, n)
                place(s, d, depth[y, first : first + n], pose, n)
                level = grey[y, first : first + n]
                for i in range(n):
                    s[OFF + i] = min(np.float32(level[i]) * per_grey, ONE)
                held = stage_some(s, d, stage, masks, taking, held, y, first, n)
            stop = held - held % BLOCK
            if stop > 0:
                pour_all(stage, written, begin, first_of_band, stop, held)
                begin, held, first_of_band = begin + stop, held - stop, 0
    pour_all(stage, written, begin, first_of_band, held, held)
