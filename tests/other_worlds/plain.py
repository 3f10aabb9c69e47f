"""A plain decoder and matcher, by the textbook and pixel by pixel: what a scan gives without any of the methods of this project.

It states what there is to be had: a pixel counts when its modulation reaches a limit and its column agrees with its neighbours', and a
pair when both cameras' pixels count and lie on one epipolar line.
"""

from __future__ import annotations

from itertools import pairwise

import cv2
import numpy as np

from measureapp.arrays import BoolArray, FloatArray
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.fringe import FringeStack, GrayCodeGroup

AGREES = 0.25  # of a period


def plain_columns(stack: FringeStack, camera: str, least_modulation: float) -> tuple[FloatArray, FloatArray]:
    """Return the projector columns (H, W), NaN where they are not valid and consistent, and the modulation, of the longest exposure."""
    images, sign = stack.images[camera][0].astype(float), stack.patterns.shift_sign
    cycles, pitches, modulations, code, at = [], [], [], None, 0
    for group in stack.patterns.groups:
        shown = images[at : at + group.count]
        at += group.count
        if isinstance(group, GrayCodeGroup):
            code = (group, shown)
            continue
        turn = 2 * np.pi * np.arange(group.count) / group.count
        sine, cosine = np.tensordot(np.sin(turn), shown, 1), np.tensordot(np.cos(turn), shown, 1)
        cycles.append((np.arctan2(-sign * sine, cosine) / (2 * np.pi)) % 1.0)
        modulations.append(2 / group.count * np.hypot(sine, cosine))
        pitches.append(group.pitch_px)
    modulation = np.min(modulations, axis=0)
    lit = (modulation >= least_modulation) & (images.max(axis=0) < stack.saturation)
    mean = images[: stack.patterns.groups[0].count].mean(axis=0)
    found = []
    for origin in (0.0, 0.5):  # column 0 is a crest or a trough; the right one makes sense
        turned = [(one + origin) % 1.0 for one in cycles]
        column = _by_gray_code(turned[0], pitches[0], *code, mean) if code else _by_beats(turned, pitches)
        found.append(_consistent(np.where(lit, column, np.nan), AGREES * min(pitches)))
    return max(found, key=lambda one: np.isfinite(one).sum()), modulation


def _consistent(column: FloatArray, tolerance: float) -> FloatArray:
    """Keep columns that agree with the median of the 3 x 3 pixels around them, of which five are valid."""
    wide = np.pad(column, 1, constant_values=np.nan)
    height, width = column.shape
    around = np.stack([wide[y : y + height, x : x + width] for y in range(3) for x in range(3)])
    enough = np.isfinite(around).sum(axis=0) >= 5
    middle = np.full(column.shape, np.nan)
    middle[enough] = np.nanmedian(around[:, enough], axis=0)
    return np.where(np.abs(column - middle) < tolerance, column, np.nan)


def _by_beats(cycles: list[FloatArray], pitches: list[float]) -> FloatArray:
    """Unwrap the finest of two or three pitches by their differences."""
    row = list(zip(cycles, pitches, strict=True))
    chain = []
    while row:
        chain.append(row[0])
        row = [((a - b) % 1.0, 1 / (1 / p - 1 / q)) for (a, p), (b, q) in pairwise(row)]
    column = chain[-1][0] * chain[-1][1]
    for fine, pitch in reversed(chain[:-1]):
        column = (np.rint(column / pitch - fine) + fine) * pitch
    return np.asarray(column)


def _by_gray_code(fine: FloatArray, pitch: float, group: GrayCodeGroup, shown: FloatArray, mean: FloatArray) -> FloatArray:
    """Number the periods by a complementary Gray code."""
    assert group.complementary
    bits = np.bitwise_xor.accumulate(shown > mean, axis=0)
    code = (1 << np.arange(len(bits))[::-1]) @ bits.reshape(len(bits), -1).astype(int)
    code = code.reshape(fine.shape)
    period = np.select([fine < 0.25, fine >= 0.75], [(code + 1) // 2, (code + 1) // 2 - 1], code // 2)
    return np.asarray((period + fine) * pitch)


def plain_pairs(columns: dict[str, FloatArray], cameras: CameraArrayCalibration) -> BoolArray:
    """Return which pixels (H, W) of the left camera have a partner: two neighbours of the right one on the same row, rectified, enclose its column."""
    left, right = cameras.cameras["left"], cameras.cameras["right"]
    right_from_left = (right.reference_from_camera.inverse() @ left.reference_from_camera).matrix
    height, width = columns["left"].shape
    own = [(np.asarray(one.pinhole.matrix), np.asarray(one.pinhole.distortion, float).reshape(-1)) for one in (left, right)]
    turned = cv2.stereoRectify(*own[0], *own[1], (width, height), right_from_left[:3, :3].copy(), right_from_left[:3, 3:].copy(), flags=0)
    places = [cv2.initUndistortRectifyMap(*own[n], turned[n], turned[2 + n], (width, height), cv2.CV_32FC1) for n in (0, 1)]
    one, other = (
        cv2.remap(columns[name].astype(np.float32), *places[n], cv2.INTER_NEAREST, borderValue=np.nan)
        for n, name in enumerate(("left", "right"))
    )
    found = np.zeros((height, width), bool)
    for y in range(height):
        here, there = one[y], other[y]
        lower, upper = np.minimum(there[:-1], there[1:]), np.maximum(there[:-1], there[1:])
        whole = np.isfinite(lower) & (upper - lower < 16)
        if whole.any() and np.isfinite(here).any():
            x = np.flatnonzero(np.isfinite(here))
            has = ((lower[whole] <= here[x, None]) & (here[x, None] <= upper[whole])).any(axis=1)
            at = np.rint([places[0][1][y, x[has]], places[0][0][y, x[has]]]).astype(int)
            found[np.clip(at[0], 0, height - 1), np.clip(at[1], 0, width - 1)] = True
    return found & np.isfinite(columns["left"])


def predicted_over_observed(values: FloatArray, sigma: FloatArray, valid: BoolArray) -> float:
    """Return predicted over observed standard deviation; observed: about quadratic surfaces through 5 x 5 pixels, by medians."""
    y, x = np.mgrid[-2:3, -2:3].reshape(2, -1)
    surface = np.stack([np.ones(25), x, y, x * x, x * y, y * y], axis=1)
    residual = (np.eye(25) - surface @ np.linalg.pinv(surface))[12].reshape(5, 5)
    whole = cv2.erode(valid.astype(np.uint8), np.ones((5, 5), np.uint8), borderValue=0) > 0
    off = cv2.filter2D(np.where(valid, values, 0.0), -1, residual) / np.linalg.norm(residual)
    return float(1 / (1.4826 * np.median(np.abs(off[whole] / sigma[whole]))))
