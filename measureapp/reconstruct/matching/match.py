"""Matching of one camera with all others: by phase along epipolar lines, checked by the cameras that did not take part."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, IntArray, in_bands
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.reconstruct import kernels
from measureapp.reconstruct.kernels.fuse import Camera, Others, OwnTable
from measureapp.reconstruct.kernels.structures import DepthArrays, Limits, Observer, Pair, Partner, Table
from measureapp.reconstruct.matching.tables import PairTables
from measureapp.reconstruct.phase_view import PhaseView
from measureapp.reconstruct.rectification.rectifier import Rectifier
from measureapp.reconstruct.settings import ReconstructSettings

ROWS_PER_BAND = 80
SAMPLES = 160  # along the longer side of an image: shifts between the cameras are sampled at so many places


@dataclass(frozen=True, slots=True, eq=False)
class CameraSet:
    """The phases of all cameras at one viewpoint, with what kernels need of each."""

    phases: Mapping[str, PhaseView]
    rectifier: Rectifier
    settings: ReconstructSettings
    memory: BufferPool

    @property
    def limits(self) -> Limits:
        """The phase differences at which cameras contradict each other."""
        return Limits(np.float32(self.settings.agreement_sigmas), np.float32(self.settings.agreement_px))

    def camera(self, name: str, skip: IntArray) -> Camera:
        """Return what kernels need of a camera that is matched; ``skip`` (H, W) uint8 is 0 for pixels to match."""
        rays, phase = self.rectifier.rays(name), self.phases[name]
        return Camera(rays, flatten(rays), phase.phase, phase.sigma, skip)

    def pair(self, name: str, other: str) -> Pair:
        """Return the rectified geometry of a pair for kernels."""
        pair = self.rectifier.pair(name, other)
        here, there = pair.here, pair.there
        return Pair(here.rectified_from_camera, here.frame, there.frame, there.grid, pair.stride, pair.baseline_mm)

    def observer(self, name: str, other: str, phases: Mapping[str, PhaseView] | None = None) -> Observer:
        """Return what kernels need to observe points of camera ``name`` with ``other``; None: its phases of this view."""
        return Observer((phases or self.phases)[other].kernel_image, self.pair(name, other))

    def partner(self, name: str, other: str, tables: PairTables) -> Partner:
        """Return what `kernels.match` needs of ``other`` to match camera ``name`` with it."""
        pair, there, lines = self.rectifier.pair(name, other), self.phases[other], self.rectifier.lines(name, other, other)
        return Partner(
            there.phase.shape,
            there.phase.reshape(-1),
            there.quads.reshape(-1),
            there.records.reshape(-1),
            lines.rectified.reshape(-1),
            lines.jacobian.cubics,
            lines.jacobian.unit,
            Table(tables.there.reshape(-1), np.float32(tables.lowest_rad), np.float32(tables.per_rad)),
            tables.there.shape,
            flatten(self.rectifier.lines(name, other, name).rectified),
            tuple(np.float32(value) for value in pair.here.rectified_from_camera[2]),
            np.float32(pair.here.frame[0]),
            np.float32(pair.here.frame[1] - pair.there.frame[1]),
            np.float32(pair.baseline_mm),
        )

    def own_table(self, name: str, other: str, tables: PairTables) -> OwnTable:
        """Return what kernels need to find what occludes points of camera ``name`` from ``other``."""
        table = Table(tables.here, tables.lowest_rad, tables.per_rad)
        return OwnTable(table, self.rectifier.lines(name, other, name).rectified, self.rectifier.pair(name, other).here.frame[1])

    def px_per_mm(self, name: str, other: str) -> tuple[np.float32, ...]:
        """Return (c0, c1, c2): (c0 · x + c1 · y + c2) · z is the share of z that moves a point by a pixel in ``other``."""
        pair = self.rectifier.pair(name, other)
        return tuple(np.float32(value / (pair.there.frame[0] * pair.baseline_mm)) for value in pair.here.rectified_from_camera[2])


@dataclass(frozen=True, slots=True, eq=False)
class DepthMap:
    """What one camera measures with the help of others; pixels without a point hold 0."""

    depth_mm: FloatArray  # (H, W) float32, z in the camera's frame
    sigma_mm: FloatArray  # (H, W) float32, standard deviation of it
    others: IntArray  # (H, W) uint8, bit i: the i-th other camera takes part
    state: IntArray  # (H, W) uint8 of PointState
    pair_gain: FloatArray  # (H, W) float32 with one other camera: change of its phase with z, rad/mm; (0, 0) with more
    matched: tuple[int, ...]  # pixels matched with each other camera
    shifts: FloatArray  # (M, rows, columns, 2) float32: px by which others see points of one pair shifted, at samples, and variance

    @property
    def kernel_arrays(self) -> DepthArrays:
        """The arrays that kernels write to."""
        return DepthArrays(self.depth_mm, self.sigma_mm, self.others, self.state, self.pair_gain)


def sample_step(shape: tuple[int, ...]) -> int:
    """Return the distance in pixels of the samples of shifts."""
    return max(1, max(shape[:2]) // SAMPLES)


def match_camera(
    name: str, others: Sequence[str], camera_set: CameraSet, tables: Mapping[str, PairTables], skip: IntArray, used: Mapping[str, IntArray]
) -> DepthMap:
    """Match camera ``name`` with each of ``others``; candidates that another camera contradicts are rejected, the rest fused.

    The phase of a match is bilinear in the other image, so its variance is known; the pixel of ``name`` itself is not resampled.

    Parameters
    ----------
    skip : (H, W) uint8, 0 for pixels to match
    used : per other camera (H, W) uint8, set to 1 where its pixels take part in points
    """
    shape, memory = camera_set.phases[name].phase.shape, camera_set.memory
    every = sample_step(shape)
    shifts = np.zeros((len(others), *(-(-length // every) for length in shape), 2), np.float32)
    depth, sigma = memory.empty(shape, np.float32), memory.empty(shape, np.float32)
    cameras, state = memory.empty(shape, np.uint8), memory.empty(shape, np.uint8)
    out = DepthArrays(depth, sigma, cameras, state, memory.empty(shape if len(others) == 1 else (0, 0), np.float32))
    camera = camera_set.camera(name, skip)
    inputs = Others(
        tuple(camera_set.partner(name, other, tables[other]) for other in others),
        tuple(camera_set.observer(name, other) for other in others),
        tuple(camera_set.own_table(name, other, tables[other]) for other in others),
        camera_set.px_per_mm(name, others[-1]),
    )
    marks = tuple(used[other].reshape(-1) for other in others)

    def match_rows(start: int, stop: int) -> IntArray:
        matched = np.empty(len(others), np.int64)
        kernels.match_and_fuse(camera, inputs, camera_set.limits, every, start, stop, out, marks, shifts, matched)
        return matched

    totals = np.sum(in_bands(match_rows, shape[0], max(8, shape[0] // ROWS_PER_BAND)), axis=0)
    return DepthMap(depth, sigma, cameras, state, out.pair_gain, tuple(int(count) for count in totals), shifts)


def flatten(pairs: FloatArray) -> FloatArray:
    """Return a map of pairs (H, W, 2) as rows of numbers (H, 2 W)."""
    return pairs.reshape(len(pairs), -1)
