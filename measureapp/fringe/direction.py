"""The decoding of one camera's images of one fringe direction, all exposures at once or one by one."""

from __future__ import annotations

from collections.abc import Callable
from math import tau

import numpy as np

from measureapp.arrays import FloatArray, ImageArray, IntArray, read_only
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.data.phase import PhaseMap, PixelState, StackEvidence
from measureapp.errors import DecodeError
from measureapp.fringe.decode_model import crop, find_chain, make_maps, make_model
from measureapp.fringe.decode_plan import DecodePlan
from measureapp.fringe.exposures.blooming import mark_near_saturation
from measureapp.fringe.fringe_origin import Solve, find_origin
from measureapp.fringe.kernels.structures import CHUNK, STRETCH, Counts, DecodeModel, ExposureSums, ImageLayout, PixelMaps, Workspace
from measureapp.fringe.noise.phase_scatter import scatter_ratios, widen
from measureapp.fringe.noise.residuals import StackResiduals
from measureapp.fringe.order_vote import settle_orders, vote_limits
from measureapp.fringe.pixel_loop import UNGUARDED, PixelLoop, contiguous, total_counts
from measureapp.fringe.unwrap import extent_px

CLEARLY = 2.0  # times the phase noise, from which on changing light counts
LEAST_USABLE, MOST_OUTSIDE = 0.01, 0.8
Fill = Callable[[ExposureSums, list[tuple[int, int]]], None]  # writes the sums of some chunks (begin, end) one after the other
UNLIT = (PixelState.SATURATED, PixelState.WEAK_MODULATION, PixelState.SHADOW, PixelState.BLOOMING)


class DirectionDecoder:
    """Decodes the images of one camera and one fringe direction.

    Call `decode` with all images, or `add` for every exposure from long to short and then `finish`; both give the same.

    Parameters
    ----------
    names : camera and viewpoint, for the phase map
    shape : (height, width)
    dtype : of the images, uint8 or uint16
    memory : where sums and maps are allocated
    """

    def __init__(
        self,
        plan: DecodePlan,
        names: tuple[str, str],
        shape: tuple[int, int],
        dtype: np.dtype[np.unsignedinteger],
        memory: BufferPool,
    ) -> None:
        self._plan, self._shape, self._dtype, self._memory = plan, shape, np.dtype(dtype), memory
        self._camera, self._viewpoint_id = names
        self._pixels = shape[0] * shape[1]
        self._chain = find_chain(plan)
        self._at_crest = make_model(plan, self._chain, votes=plan.settings.vote_radius > 0, noise=plan.noise)
        self._loop = PixelLoop(plan, self._dtype, self._pixels, self._at_crest, memory)
        layout, self._noise = plan.layout(), plan.noise
        groups = [(int(first), int(steps)) for first, steps in zip(layout.first_image, layout.steps, strict=True)]
        self._residuals = StackResiduals(groups, plan.exposures_us, plan.saturation, plan.noise, shape)
        self._added = self._loop.no_counts()
        self._sums: ExposureSums | None = None

    def decode(self, images: ImageArray) -> PhaseMap:
        """Decode all exposures (E, P, H, W) at once."""
        if self._plan.settings.blooming_radius_px:
            for exposure in range(len(images)):
                self.add(exposure, images[exposure])
            return self.finish()
        for exposure in range(len(images)):
            self._residuals.add(exposure, images[exposure])
        flat, loop = contiguous(images.reshape(*images.shape[:2], self._pixels)), self._loop

        def sum_sample(sums: ExposureSums, chunks: list[tuple[int, int]]) -> None:
            shown = contiguous(np.concatenate([flat[..., begin:end] for begin, end in chunks], axis=-1))
            loop.add(shown, sums, (0, shown.shape[-1]))

        model = self._find_origin(sum_sample)
        maps = make_maps(self._dtype, self._pixels, self._memory)
        spare: list[tuple[ExposureSums, Workspace]] = []

        def decode_band(start: int, stop: int) -> Counts:
            try:
                sums, work = spare.pop()
            except IndexError:
                sums, work = self._plan.sums(self._dtype, STRETCH, self._memory), loop.workspace()
            counts = loop.decode(flat, sums, (start, stop), model, work, maps)
            spare.append((sums, work))
            return counts

        counts = total_counts(loop.in_bands(decode_band))
        return self._phase_map(maps, model, counts)

    def add(self, exposure: int, images: ImageArray) -> None:
        """Add the images (P, H, W) of one exposure to the sums."""
        if self._sums is None:
            self._sums = self._plan.sums(self._dtype, self._pixels, self._memory)
        self._residuals.add(exposure, images)
        sums, radius, loop = self._sums, self._plan.settings.blooming_radius_px, self._loop
        one = contiguous(images.reshape(1, len(images), self._pixels))
        blocked = mark_near_saturation(one[0], self._shape, loop.layout, loop.rule, radius) if radius else UNGUARDED

        added = loop.in_bands(lambda start, stop: loop.add(one, sums, (start, stop), exposure, blocked))
        self._added = total_counts([self._added, *added])

    def finish(self) -> PhaseMap:
        """Convert the sums to the phase map."""
        assert self._sums is not None
        sums, loop = self._sums, self._loop

        def copy_sample(sample: ExposureSums, chunks: list[tuple[int, int]]) -> None:
            for number, (begin, _) in enumerate(chunks):
                for whole, part in zip(sums[:-1], sample[:-1], strict=True):
                    part[..., number * CHUNK : (number + 1) * CHUNK] = whole[..., begin : begin + CHUNK]
                sample.complete[number] = sums.complete[begin // CHUNK]

        model = self._find_origin(copy_sample)
        maps = make_maps(self._dtype, self._pixels, self._memory)
        solved = loop.in_bands(lambda start, stop: loop.solve(sums, (start, stop), model, maps))
        self._sums = None
        return self._phase_map(maps, model, total_counts([self._added, *solved]))

    def _find_origin(self, fill: Fill) -> DecodeModel:
        """Return the model with noise of the camera and origin of the phase; the samples are too small to be worth sharing among processors."""
        plan = self._plan
        if plan.settings.noise_from_images and self._camera not in plan.settings.camera_noise:
            self._noise = self._residuals.noise()
            self._at_crest = make_model(plan, self._chain, plan.settings.vote_radius > 0, self._noise)

        def sample(chunks: list[tuple[int, int]]) -> Solve:
            pixels = sum(end - begin for begin, end in chunks)
            sums = self._plan.sums(self._dtype, pixels, self._memory)
            fill(sums, chunks)

            def solve(model: DecodeModel, layout: ImageLayout) -> PixelMaps:
                maps = make_maps(self._dtype, pixels, self._memory)
                self._loop.solve(sums, (0, pixels), model, maps, layout)
                return crop(maps, pixels)

            return solve

        return find_origin(self._at_crest, self._chain, self._loop.layout, self._pixels, sample)

    def _valid_ratios(self, counts: Counts) -> tuple[float, ...]:
        """Return the share of pixels above zero and unsaturated in every exposure.

        Where one exposure is enough, that of the shorter ones is estimated from a sample of the chunks; what is unsaturated in a longer
        exposure is so in a shorter one, too.
        """
        (due, good), (sampled, found) = counts.exposures
        share = np.divide(found, sampled, out=np.ones(len(good)), where=sampled > 0)
        return tuple(float(ratio) for ratio in (good + (self._pixels - due) * share) / self._pixels)

    def _phase_map(self, maps: PixelMaps, model: DecodeModel, counts: Counts) -> PhaseMap:
        plan, maps = self._plan, crop(maps, self._pixels)
        states = counts.states
        self._check_within(states)
        amplification = self._chain.amplification if self._chain else 0.0
        repaired = 0
        limits = vote_limits(plan.settings, model, self._loop.layout.steps, amplification)
        if limits.radius or limits.edge_step < plan.patterns.phase_range_rad:
            repaired, change = settle_orders(maps, self._shape, limits, self._memory)
            states = states + change
        evidence = self._widen(maps)
        return PhaseMap(
            camera=self._camera,
            viewpoint_id=self._viewpoint_id,
            phase_rad=read_only(maps.phase.reshape(self._shape)),
            sigma_rad=read_only(maps.sigma.reshape(self._shape)),
            modulation=read_only(maps.modulation.reshape(self._shape)),
            grey=read_only(maps.grey.reshape(self._shape)),
            state=read_only(maps.state.reshape(self._shape)),
            exposure_index=read_only(maps.exposure.reshape(self._shape)),
            pitch_px=plan.patterns.finest_pitch_px,
            projector_px=extent_px(plan.patterns),
            valid_ratio_exposures=self._valid_ratios(counts),
            valid_ratio_composite=int(counts.complete[0]) / self._pixels,
            details={
                "decoded_ratio": float(states[PixelState.VALID] / self._pixels),
                "order_conflicts": float(states[PixelState.ORDER_CONFLICT]),
                "orders_repaired": float(repaired),
                "origin_rad": float(model.origin) * tau,
                "order_amplification": amplification,
                **{state.name.lower(): float(states[state]) for state in PixelState},
            },
            saturation=float(plan.saturation),
            direction=plan.direction,
            evidence=evidence,
            exposures_us=tuple(float(exposure) for exposure in plan.exposures_us),
            snr_at_one_rad=_snr_at_one_rad(model, self._loop.layout),
        )

    def _widen(self, maps: PixelMaps) -> StackEvidence:
        """Widen the standard deviations where the phases contradict the noise model; return what the images say of it."""
        if not self._plan.settings.noise_from_images:
            return self._residuals.evidence(self._noise, 1.0)
        phase, sigma, state = (each.reshape(self._shape) for each in (maps.phase, maps.sigma, maps.state))
        scatter, factors = scatter_ratios(phase, sigma, state)
        evidence = self._residuals.evidence(self._noise, scatter)
        if factors is not None:
            widen(sigma, factors)
        moved, known = evidence.vibration_rad, sigma[:: max(1, self._shape[0] // 100)]
        lit = evidence.light_rad if evidence.light_rad > CLEARLY * _median_of_known(known) else 0.0
        if moved or lit:
            np.sqrt(sigma * sigma + np.where(sigma > 0, np.float32(moved**2 + lit**2), np.float32(0)), out=sigma)
        return evidence

    def _check_within(self, states: IntArray) -> None:
        """Raise DecodeError where nearly all phases are beyond the projector: the images do not match the set."""
        usable = int(states.sum() - states[list(UNLIT)].sum())
        outside = int(states[PixelState.OUT_OF_RANGE])
        if usable > LEAST_USABLE * self._pixels and outside > MOST_OUTSIDE * usable:
            raise DecodeError(
                f"{outside / usable:.0%} of the phases of camera {self._camera!r} lie beyond the projector.",
                "Check shift_sign, the order of the images, the pitches and projector_px.",
            )


def _median_of_known(sigma: FloatArray) -> float:
    """Return the median of the standard deviations that are not 0; 0 without any."""
    return float(np.median(sigma[sigma > 0])) if (sigma > 0).any() else 0.0


def _snr_at_one_rad(model: DecodeModel, layout: ImageLayout) -> float:
    """Return B/σ_I of a single image of a pixel whose absolute phase has a standard deviation of one radian."""
    return float(1 / np.sqrt((model.pitches.scales.astype(float) ** 2 * layout.steps / 2).sum()))
