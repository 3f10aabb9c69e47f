"""Matching one camera with all others: by phase along epipolar lines, checked by the cameras that did not take part."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, IntArray, in_bands
from measureapp.data.phase import PhaseMap
from measureapp.reconstruct import kernels
from measureapp.reconstruct.phase_view import PhaseView
from measureapp.reconstruct.rectifier import Rectifier
from measureapp.reconstruct.rectify import RectifiedPair, RectifiedView
from measureapp.reconstruct.settings import ReconstructSettings

BINS_PER_COLUMN = 2
RANGE_MARGIN_RAD = 2 * np.pi
TRIMMED_PX = 3.0


@dataclass(frozen=True, slots=True)
class PhaseBins:
    """How phases are sorted: bin 0 starts at `lowest_rad`."""

    lowest_rad: float
    per_rad: float
    count: int

    @classmethod
    def covering(cls, phase_map: PhaseMap) -> PhaseBins:
        """Cover the projector with two bins per column, and a period more on either side."""
        per_rad = BINS_PER_COLUMN * phase_map.pitch_px / (2 * np.pi)
        range_rad = 2 * np.pi * phase_map.projector_px / phase_map.pitch_px
        return cls(-RANGE_MARGIN_RAD, per_rad, int(np.ceil((range_rad + 2 * RANGE_MARGIN_RAD) * per_rad)))


@dataclass(frozen=True, slots=True, eq=False)
class DepthMap:
    """What one camera sees with the help of others; pixels without a point hold 0."""

    depth_mm: FloatArray  # (H, W) float32, z in the camera's frame
    sigma_mm: FloatArray  # (H, W) float32, standard deviation of it
    others: IntArray  # (H, W) uint8, bit i: the i-th other camera takes part
    matched: tuple[int, ...]  # pixels matched with each other camera
    unmatched: int
    ambiguous: int
    contradicted: int
    shift_squares: FloatArray  # (M,) sum over the matches of each camera of squared shifts in the others, px²
    shift_counts: IntArray  # (M,)


def match_view(
    name: str, others: tuple[str, ...], maps: Mapping[str, PhaseMap], rectifier: Rectifier, settings: ReconstructSettings
) -> DepthMap:
    """Match camera ``name`` with each of ``others``; candidates that another camera contradicts are dropped, the rest fused.

    The phase of a match is bilinear in the other image, so its variance is known; the pixel of ``name`` itself is not resampled.
    """
    bins = PhaseBins.covering(maps[name])
    pairs = [rectifier.pair(name, other) for other in others]
    views = {camera: PhaseView.of(maps[camera], settings.max_phase_step_rad) for camera in (name, *others)}
    tables = [
        (
            _table(pair, pair.here, views[name], bins, settings),
            _table(pair, pair.there, views[other], bins, settings),
        )
        for pair, other in zip(pairs, others, strict=True)
    ]
    work = _ViewMatcher(views[name], [views[other] for other in others], pairs, tables, rectifier.rays(name), bins, settings)
    bands = in_bands(work.rows, len(views[name].phase))
    totals = np.sum([band.totals for band in bands], axis=0)
    return DepthMap(
        depth_mm=np.concatenate([band.depth for band in bands]),
        sigma_mm=np.concatenate([band.sigma for band in bands]),
        others=np.concatenate([band.bits for band in bands]),
        matched=tuple(int(count) for count in totals[:, 0]),
        unmatched=int(totals[:, 1].sum()),
        ambiguous=int(totals[:, 2].sum()),
        contradicted=sum(band.contradicted for band in bands),
        shift_squares=np.sum([band.shift_squares for band in bands], axis=0),
        shift_counts=np.sum([band.shift_counts for band in bands], axis=0),
    )


def _table(
    pair: RectifiedPair, view: RectifiedView, phase: PhaseView, bins: PhaseBins, settings: ReconstructSettings
) -> tuple[IntArray, IntArray]:
    first = np.empty((pair.rows, bins.count), np.int16)
    last = np.empty((pair.rows, bins.count), np.int16)

    def work(start: int, stop: int) -> None:
        kernels.fill_table(
            view.grid,
            pair.stride,
            view.width_px,
            phase.phase,
            phase.state,
            settings.max_phase_step_rad,
            bins.lowest_rad,
            bins.per_rad,
            start,
            stop,
            first,
            last,
        )

    in_bands(work, pair.rows)
    return first, last


@dataclass(frozen=True, slots=True, eq=False)
class _Band:
    depth: FloatArray
    sigma: FloatArray
    bits: IntArray
    totals: IntArray  # (M, 3)
    contradicted: int
    shift_squares: FloatArray
    shift_counts: IntArray


@dataclass(frozen=True, slots=True, eq=False)
class _ViewMatcher:
    """Matches, checks and fuses bands of rows of one camera."""

    view: PhaseView
    others: list[PhaseView]
    pairs: list[RectifiedPair]
    tables: list[tuple[tuple[IntArray, IntArray], tuple[IntArray, IntArray]]]
    rays: FloatArray
    bins: PhaseBins
    settings: ReconstructSettings

    def rows(self, start: int, stop: int) -> _Band:
        """Do the rows from ``start`` to ``stop``."""
        count = len(self.others)
        shape = (stop - start, self.view.phase.shape[1])
        depth = np.empty((count, *shape), np.float32)
        gain, variance, excess, shift = (np.zeros((count, count, *shape), np.float32) for _ in range(4))
        seen = np.zeros((count, count, *shape), np.uint8)
        totals = np.zeros((count, 3), np.int64)
        for k in range(count):
            totals[k] = self._match(k, start, stop, depth[k], gain[k, k], variance[k, k])
        for k in range(count):
            for c in range(count):
                if c != k:
                    observe_rows(
                        self.view,
                        self.others[c],
                        self.pairs[c],
                        self.rays,
                        self.settings,
                        depth[k],
                        (start, stop),
                        (seen[k, c], excess[k, c], shift[k, c], gain[k, c], variance[k, c]),
                    )
        z, sigma = np.empty(shape, np.float32), np.empty(shape, np.float32)
        bits = np.empty(shape, np.uint8)
        contradicted = kernels.fuse(
            self.view.sigma[start:stop],
            depth,
            gain,
            variance,
            excess,
            shift,
            seen,
            self.settings.agreement_sigmas,
            self.settings.agreement_px,
            z,
            sigma,
            bits,
        )
        squares, counts = shift_sums(shift, seen)
        return _Band(z, sigma, bits, totals, int(contradicted), squares.sum(axis=1), counts.sum(axis=1))

    def _match(self, k: int, start: int, stop: int, depth: FloatArray, gain: FloatArray, variance: FloatArray) -> IntArray:
        pair, other = self.pairs[k], self.others[k]
        (first_here, last_here), (first, last) = self.tables[k]
        return np.array(
            kernels.match(
                self.rays,
                self.view.phase,
                self.view.state,
                pair.here.rectified_from_camera,
                pair.here.frame,
                first_here,
                last_here,
                pair.there.frame,
                pair.there.grid,
                pair.stride,
                other.phase,
                other.sigma,
                other.state,
                first,
                last,
                self.bins.lowest_rad,
                self.bins.per_rad,
                self.settings.max_phase_step_rad,
                pair.baseline_mm,
                start,
                stop,
                depth,
                gain,
                variance,
            )
        )


def observe_rows(
    view: PhaseView,
    other: PhaseView,
    pair: RectifiedPair,
    rays: FloatArray,
    settings: ReconstructSettings,
    depth: FloatArray,
    rows: tuple[int, int],
    out: tuple[IntArray, FloatArray, FloatArray, FloatArray, FloatArray],
) -> None:
    """Look with ``other`` at the points that ``view`` has at ``depth`` (rows, W); ``out``: seen, excess, shift, gain, variance."""
    kernels.observe(
        rays,
        view.phase,
        pair.here.rectified_from_camera,
        pair.here.frame,
        pair.there.frame,
        pair.there.grid,
        pair.stride,
        other.phase,
        other.sigma,
        other.state,
        settings.max_phase_step_rad,
        pair.baseline_mm,
        depth,
        rows[0],
        rows[1],
        *out,
    )


def shift_sums(shift: FloatArray, seen: IntArray) -> tuple[FloatArray, IntArray]:
    """Sum the squared shifts (..., rows, W) that other cameras see of points, without gross ones; also how many."""
    usable = (seen == kernels.SEEN) & (np.abs(shift) < TRIMMED_PX)
    return np.where(usable, shift.astype(np.float64) ** 2, 0.0).sum(axis=(-2, -1)), usable.sum(axis=(-2, -1))
