"""A few thousand pixels of every camera, matched along whole epipolar lines: enough to check phases against the geometry."""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.calibration import CameraCalibration
from measureapp.data.phase import PhaseMap

SAMPLES = 2_000  # pixels of a camera that are used
COARSE_PX = 2.0  # step of the undistorted phase and along epipolar lines
GRADIENT_PX = 3  # half the base of phase gradients
WHOLE = 0.999  # share of valid pixels under an interpolated phase


@dataclass(frozen=True, slots=True, eq=False)
class Samples:
    """Pixels of one camera with a phase on all sides; `gradient` is that of the phase, rad per pixel along (x, y)."""

    pixel: FloatArray  # (N, 2) x, y
    phase: FloatArray  # (N,)
    sigma: FloatArray  # (N,)
    gradient: FloatArray  # (N, 2)

    @classmethod
    def of(cls, phase_map: PhaseMap) -> Samples:
        """Subsample the pixels whose neighbours at `GRADIENT_PX` also have a phase."""
        step = GRADIENT_PX
        valid = np.asarray(phase_map.valid)
        inner = np.zeros_like(valid)
        if min(valid.shape) > 2 * step:
            inner[step:-step, step:-step] = (
                valid[step:-step, step:-step]
                & valid[: -2 * step, step:-step]
                & valid[2 * step :, step:-step]
                & valid[step:-step, : -2 * step]
                & valid[step:-step, 2 * step :]
            )
        places = np.flatnonzero(inner)
        rows, columns = np.divmod(places[:: max(1, len(places) // SAMPLES)], valid.shape[1])
        phase = phase_map.phase_rad
        across = phase[rows, columns + step].astype(float) - phase[rows, columns - step]
        down = phase[rows + step, columns].astype(float) - phase[rows - step, columns]
        return cls(
            np.column_stack([columns, rows]).astype(float),
            phase[rows, columns].astype(float),
            phase_map.sigma_rad[rows, columns].astype(float),
            np.column_stack([across, down]) / (2 * step),
        )

    def __len__(self) -> int:
        return len(self.phase)

    def subsample(self, count: int) -> Samples:
        """Return about ``count`` of the samples, evenly chosen."""
        every = slice(None, None, max(1, len(self) // count))
        return Samples(self.pixel[every], self.phase[every], self.sigma[every], self.gradient[every])

    def orthogonal(self, phase_map: PhaseMap) -> Samples:
        """Return the same pixels with the phase of the orthogonal fringes; NaN where there is none."""
        columns, rows = self.pixel.astype(int).T
        there = np.asarray(phase_map.valid)[rows, columns]
        phase = np.where(there, phase_map.phase_rad[rows, columns].astype(float), np.nan)
        return replace(self, phase=phase, sigma=phase_map.sigma_rad[rows, columns].astype(float))


@dataclass(frozen=True, slots=True, eq=False)
class FlatView:
    """The phase of a camera on a regular grid of normalised coordinates: node (0, 0) at `origin`, `step` apart."""

    phase: FloatArray  # (h, w) float32
    whole: FloatArray  # (h, w) float32, share of valid pixels under it
    origin: FloatArray  # (2,)
    step: float
    focal_px: float

    @classmethod
    def of(cls, phase_map: PhaseMap, camera: CameraCalibration) -> FlatView:
        """Undistort a phase map."""
        lens = camera.pinhole
        x, y = np.linspace(0, lens.width_px - 1, 9), np.linspace(0, lens.height_px - 1, 9)
        border = [np.column_stack([x, np.full(9, side)]) for side in (0.0, lens.height_px - 1.0)]
        border += [np.column_stack([np.full(9, side), y]) for side in (0.0, lens.width_px - 1.0)]
        flat = lens.normalise(np.concatenate(border))
        origin, far = flat.min(axis=0), flat.max(axis=0)
        step = COARSE_PX / float(lens.matrix[0, 0])
        columns, rows = (np.ceil((far - origin) / step).astype(int) + 1).tolist()
        new = np.array([[1 / step, 0, -origin[0] / step], [0, 1 / step, -origin[1] / step], [0, 0, 1]])
        maps = cv2.initUndistortRectifyMap(np.array(lens.matrix), np.array(lens.distortion), np.eye(3), new, (columns, rows), cv2.CV_32FC1)
        phase = cv2.remap(np.array(phase_map.phase_rad, np.float32), *maps, cv2.INTER_LINEAR)
        whole = cv2.remap(np.asarray(phase_map.valid).astype(np.float32), *maps, cv2.INTER_LINEAR)
        return cls(np.asarray(phase), np.asarray(whole), origin, step, float(lens.matrix[0, 0]))

    def at(self, flat: FloatArray) -> tuple[FloatArray, BoolArray]:
        """Return the phase at normalised coordinates (N, K, 2), and where there is one."""
        place = ((flat - self.origin) / self.step).astype(np.float32)
        place = np.where(np.isfinite(place), place, np.float32(-1e4)).clip(-1e4, 1e5)
        x, y = np.ascontiguousarray(place[..., 0]), np.ascontiguousarray(place[..., 1])
        phase = cv2.remap(self.phase, x, y, cv2.INTER_LINEAR)
        whole = cv2.remap(self.whole, x, y, cv2.INTER_LINEAR)
        return np.asarray(phase), np.asarray(whole > WHOLE)

    @property
    def box(self) -> tuple[FloatArray, FloatArray]:
        """The lower and upper corner in normalised coordinates."""
        height, width = self.phase.shape
        return self.origin, self.origin + self.step * np.array([width - 1, height - 1])


@dataclass(frozen=True, slots=True, eq=False)
class SampleMatches:
    """Samples of one camera found in another; all arrays have one entry per match."""

    flat: FloatArray  # (M, 2) normalised coordinates in the first camera
    index: IntArray  # (M,) which sample
    inverse_depth: FloatArray  # (M,) 1/z in the first camera, 1/mm; not above 0 behind it
    front: BoolArray  # (M,) in front of both cameras
    slope: FloatArray  # (M,) rad of phase per 1/mm in the other camera
    depth_per_px: FloatArray  # (M,) mm of depth per pixel along the epipolar line
    samples: int


def match_samples(samples: Samples, here: CameraCalibration, there: CameraCalibration, view: FlatView) -> SampleMatches:
    """Search for the phase of every sample of ``here`` along its whole epipolar line in ``there``, behind the cameras as well.

    In the other camera's frame the ray's point is (a + w t) / w with the inverse depth w; its image runs along a straight line, on which
    w follows from either coordinate. Samples with two matches or none are not used.
    """
    flat = here.pinhole.normalise(samples.pixel)
    there_from_here = there.reference_from_camera.inverse() @ here.reference_from_camera
    a = np.column_stack([flat, np.ones(len(flat))]) @ there_from_here.rotation.T
    t = there_from_here.translation_mm
    way = t[:2] * a[:, 2:] - a[:, :2] * t[2]
    way /= np.maximum(np.linalg.norm(way, axis=1, keepdims=True), 1e-30)
    start, count = _in_box(a, t, way, view)
    line = start[:, None] + np.arange(count)[None, :, None] * view.step * way[:, None]
    phase, there_is = view.at(line)
    gap = phase - samples.phase[:, None]
    crossing = there_is[:, 1:] & there_is[:, :-1] & ((gap[:, 1:] > 0) != (gap[:, :-1] > 0)) & (np.abs(gap[:, 1:] - gap[:, :-1]) < np.pi)
    index = np.flatnonzero(crossing.sum(axis=1) == 1)
    first = np.argmax(crossing[index], axis=1)
    before, after = gap[index, first], gap[index, first + 1]
    spot = line[index, first] + (before / (before - after))[:, None] * view.step * way[index]
    w = _inverse_depth(spot, a[index], t)
    w_next = _inverse_depth(spot + way[index] * view.step, a[index], t)
    front = (w > 0) & ((a[index, 2] + w * t[2]) > 0)
    per_w = (w_next - w) / COARSE_PX
    depth_per_px = np.abs(per_w) / np.maximum(w**2, 1e-30)
    slope = (after - before) / COARSE_PX / np.where(per_w == 0, 1e-30, per_w)
    return SampleMatches(flat[index], index, w, front, slope, depth_per_px, len(samples))


def _in_box(a: FloatArray, t: FloatArray, way: FloatArray, view: FlatView) -> tuple[FloatArray, int]:
    """Return where each line enters the image (N, 2), and how many steps the longest has in it."""
    low, high = view.box
    on_line = np.where(np.abs(a[:, 2:]) > 1e-9, a[:, :2] / a[:, 2:], t[:2] / (t[2] if abs(t[2]) > 1e-9 else 1e-9))
    safe = np.where(np.abs(way) < 1e-12, 1e-12, way)
    sides = np.stack([(low - on_line) / safe, (high - on_line) / safe])
    enter, leave = sides.min(axis=0).max(axis=1), sides.max(axis=0).min(axis=1)
    longest = float(np.max(leave - enter, initial=0.0))
    return on_line + enter[:, None] * way, max(2, int(np.ceil(longest / view.step)) + 1)


def _inverse_depth(spot: FloatArray, a: FloatArray, t: FloatArray) -> FloatArray:
    below = spot * t[2] - t[:2]
    axis = np.argmax(np.abs(below), axis=1)
    rows = np.arange(len(spot))
    under = below[rows, axis]
    return np.asarray((a[rows, axis] - spot[rows, axis] * a[:, 2]) / np.where(under == 0, 1e-30, under))
