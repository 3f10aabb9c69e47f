"""The decoding of one camera's images of one fringe direction, all exposures at once or one by one."""

from __future__ import annotations

from collections.abc import Callable
from math import tau
from typing import Any

import numpy as np

from measureapp.arrays import ImageArray, IntArray, in_bands, read_only
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.errors import DecodeError
from measureapp.fringe.absolute import (
    GRAY_SLACK_CYCLES,
    SAMPLED_CHUNKS,
    Solve,
    make_maps,
    make_model,
    make_work,
    plan_of,
    sampled_chunks,
    with_origin,
)
from measureapp.fringe.blooming import near_saturation
from measureapp.fringe.kernels import decoding, solving, summing
from measureapp.fringe.kernels.records import CHUNK, Layout, Maps, Model, Sums
from measureapp.fringe.order_vote import VoteLimits, order_steps, settle_orders
from measureapp.fringe.recipe import Recipe
from measureapp.fringe.unwrap import extent_px
from measureapp.map_memory import MapMemory

LEAST_USABLE, MOST_OUTSIDE = 0.01, 0.8
COUNTERS = len(PixelState) + 1  # of every state, and of complete pixels
NOWHERE = np.empty(0, np.uint8)  # no pixel is kept from an exposure by its neighbours
NOTHING_COMING = np.empty((0, 0), np.uint8)  # no images are needed after these sums
Fill = Callable[[Sums, int, int, int], None]  # puts the sums of pixels begin … end at a place: fill(sums, place, begin, end)
UNLIT = (PixelState.SATURATED, PixelState.WEAK_MODULATION, PixelState.SHADOW, PixelState.BLOOMING)


class DirectionDecoder:
    """Decodes the images of one camera and one fringe direction.

    Call `decode` with all images, or `add` for every exposure from long to short and then `finish`; both give the same.

    Parameters
    ----------
    camera, viewpoint_id : named in the phase map
    shape : (height, width)
    dtype : of the images, uint8 or uint16
    memory : where the maps are made
    """

    def __init__(
        self,
        recipe: Recipe,
        camera: str,
        viewpoint_id: str,
        shape: tuple[int, int],
        dtype: np.dtype[np.unsignedinteger],
        memory: MapMemory,
    ) -> None:
        self._recipe, self._camera, self._viewpoint_id = recipe, camera, viewpoint_id
        self._shape, self._dtype = shape, np.dtype(dtype)
        self._pixels = shape[0] * shape[1]
        self._layout, self._rule = recipe.layout(), recipe.rule(self._dtype)
        self._memory = memory
        self._seen = self._nothing_seen()
        self._sums: Sums | None = None

    def decode(self, images: ImageArray) -> PhaseMap:
        """Decode all exposures (E, P, H, W) at once."""
        if self._recipe.settings.blooming_radius_px:
            for exposure in range(len(images)):
                self.add(exposure, images[exposure])
            return self.finish()
        flat = _flat(images.reshape(*images.shape[:2], self._pixels))
        recipe, layout = self._recipe, self._layout

        def sum_sample(sample: Sums, first: int, begin: int, end: int) -> None:
            scratch, seen = recipe.scratch(self._dtype), self._nothing_seen()
            summing.add_exposures(flat, 0, NOWHERE, layout, self._rule, scratch, sample, begin - first, begin, end, seen)

        model = self._model(sum_sample)
        maps = make_maps(self._dtype, self._pixels, self._memory)

        def work(start: int, stop: int) -> tuple[IntArray, IntArray]:
            seen, counts = self._nothing_seen(), np.zeros(COUNTERS, np.int64)
            scratch, blocks = recipe.scratch(self._dtype), make_work(len(layout.steps))
            sums = recipe.sums(self._dtype, CHUNK, self._memory)
            decoding.sum_and_solve(flat, NOWHERE, layout, self._rule, model, scratch, sums, blocks, start, stop, maps, seen, counts)
            return seen, counts

        done = self._in_bands(work)
        self._seen = np.sum([seen for seen, _ in done], axis=0)
        return self._phase_map(maps, model, np.sum([counts for _, counts in done], axis=0))

    def add(self, exposure: int, images: ImageArray) -> None:
        """Add the images (P, H, W) of one exposure to the sums."""
        if self._sums is None:
            self._sums = self._recipe.sums(self._dtype, self._pixels, self._memory)
        sums, recipe = self._sums, self._recipe
        flat = _flat(images.reshape(1, len(images), self._pixels))
        radius = recipe.settings.blooming_radius_px
        blocked = near_saturation(flat[0], self._shape, self._layout, self._rule, radius) if radius else NOWHERE

        def work(start: int, stop: int) -> IntArray:
            seen = self._nothing_seen()
            scratch = recipe.scratch(self._dtype)
            summing.add_exposures(flat, exposure, blocked, self._layout, self._rule, scratch, sums, 0, start, stop, seen)
            return seen

        self._seen += np.sum(self._in_bands(work), axis=0)

    def finish(self) -> PhaseMap:
        """Turn the sums into the phase map."""
        assert self._sums is not None
        sums = self._sums

        def copy_sample(sample: Sums, first: int, begin: int, end: int) -> None:
            for whole, part in zip(sums[:-1], sample[:-1], strict=True):
                part[..., first : first + end - begin] = whole[..., begin:end]
            sample.alike[first // CHUNK] = sums.alike[begin // CHUNK]

        model = self._model(copy_sample)
        maps = make_maps(self._dtype, self._pixels, self._memory)

        def work(start: int, stop: int) -> IntArray:
            counts, blocks = np.zeros(COUNTERS, np.int64), make_work(len(self._layout.steps))
            solving.solve(sums, 0, NOTHING_COMING, self._layout, model, blocks, start, stop, maps, counts)
            return counts

        done = self._in_bands(work)
        self._sums = None
        return self._phase_map(maps, model, np.sum(done, axis=0))

    def _in_bands(self, work: Callable[[int, int], Any]) -> list[Any]:
        """Share whole chunks of pixels among the processors."""
        chunks = -(-self._pixels // CHUNK)
        return in_bands(lambda start, stop: work(start * CHUNK, min(stop * CHUNK, self._pixels)), chunks)

    def _nothing_seen(self) -> IntArray:
        """Return counters for `summing.add_exposures`."""
        return np.zeros((2, 2, len(self._recipe.exposures_us)), np.int64)

    def _model(self, fill: Fill) -> Model:
        """Return what turns sums into phase, its origin told from as many chunks as that takes."""
        plan = plan_of(self._recipe)
        model, known = make_model(self._recipe, plan, decides_later=self._recipe.settings.vote_radius > 0), False
        for number in SAMPLED_CHUNKS:
            if not known:
                model, known = with_origin(model, plan, self._layout, self._sample(fill, sampled_chunks(self._pixels, number)))
        return model

    def _sample(self, fill: Fill, chunks: list[tuple[int, int]]) -> Solve:
        """Return what solves the sums of some chunks; these are too few to be worth sharing among processors."""
        pixels = sum(end - begin for begin, end in chunks)
        sums = self._recipe.sums(self._dtype, pixels, self._memory)
        for number, (begin, end) in enumerate(chunks):
            fill(sums, number * CHUNK, begin, end)

        def solve(trial: Model, layout: Layout) -> Maps:
            maps, blocks = make_maps(self._dtype, pixels, self._memory), make_work(len(layout.steps))
            solving.solve(sums, 0, NOTHING_COMING, layout, trial, blocks, 0, pixels, maps, np.zeros(COUNTERS, np.int64))
            return maps

        return solve

    def _valid_ratios(self) -> tuple[float, ...]:
        """Return the share of pixels above zero and unsaturated in every exposure.

        Where one exposure is enough, that of the shorter ones is estimated from the chunks looked at; what is unsaturated in a longer
        exposure is so in a shorter one, too.
        """
        (due, good), (sampled, found) = self._seen
        share = np.divide(found, sampled, out=np.ones(len(good)), where=sampled > 0)
        return tuple(float(ratio) for ratio in (good + (self._pixels - due) * share) / self._pixels)

    def _phase_map(self, maps: Maps, model: Model, counts: IntArray) -> PhaseMap:
        recipe = self._recipe
        states, complete = counts[:-1], int(counts[-1])
        self._check_within(states)
        plan = plan_of(recipe)
        amplification = plan.amplification if plan else 0.0
        repaired = 0
        limits = self._limits(model, amplification)
        if limits.radius or limits.edge_step_rad < recipe.patterns.phase_range_rad:
            repaired, change = settle_orders(maps, self._shape, limits)
            states = states + change
        return PhaseMap(
            camera=self._camera,
            viewpoint_id=self._viewpoint_id,
            phase_rad=read_only(maps.phase.reshape(self._shape)),
            sigma_rad=read_only(maps.sigma.reshape(self._shape)),
            modulation=read_only(maps.modulation.reshape(self._shape)),
            grey=read_only(maps.grey.reshape(self._shape)),
            state=read_only(maps.state.reshape(self._shape)),
            exposure_index=read_only(maps.exposure.reshape(self._shape)),
            pitch_px=recipe.patterns.finest_pitch_px,
            projector_px=extent_px(recipe.patterns),
            valid_ratio_exposures=self._valid_ratios(),
            valid_ratio_composite=complete / self._pixels,
            details={
                "decoded_ratio": float(states[PixelState.VALID] / self._pixels),
                "order_conflicts": float(states[PixelState.ORDER_CONFLICT]),
                "orders_repaired": float(repaired),
                "origin_rad": float(model.origin) * tau,
                "order_amplification": amplification,
                **{state.name.lower(): float(states[state]) for state in PixelState},
            },
            saturation=float(recipe.saturation),
            direction=recipe.direction,
            snr_at_one_rad=_snr_at_one_rad(model, self._layout),
        )

    def _limits(self, model: Model, amplification: float) -> VoteLimits:
        settings = self._recipe.settings
        origin = float(model.origin)
        return VoteLimits(
            radius=settings.vote_radius,
            edge_step_rad=settings.edge_step_rad,
            gate_cycles=float(model.gate),
            amplification=amplification * float(np.sqrt((model.scales.astype(float) ** 2).sum())),
            slack_cycles=0.0 if amplification else GRAY_SLACK_CYCLES,
            range_rad=((float(model.lowest) + origin) * tau, (float(model.highest) + origin) * tau),
            order_steps_rad=order_steps(model.scales.astype(float), self._layout.steps),
        )

    def _check_within(self, states: IntArray) -> None:
        """Raise DecodeError where nearly all phases lie beyond the projector: the images are not what the set says."""
        usable = int(states.sum() - states[list(UNLIT)].sum())
        outside = int(states[PixelState.OUT_OF_RANGE])
        if usable > LEAST_USABLE * self._pixels and outside > MOST_OUTSIDE * usable:
            raise DecodeError(
                f"{outside / usable:.0%} of the phases of camera {self._camera!r} lie beyond the projector.",
                "Check shift_sign, the order of the images, the pitches and projector_px.",
            )


def _snr_at_one_rad(model: Model, layout: Layout) -> float:
    """Return B/σ_I of a single image of a pixel whose absolute phase has a standard deviation of one radian."""
    return float(1 / np.sqrt((model.scales.astype(float) ** 2 * layout.steps / 2).sum()))


def _flat(images: ImageArray) -> ImageArray:
    """Return a read-only contiguous view, so that the kernels see one type only."""
    flat = np.ascontiguousarray(images).view()
    flat.flags.writeable = False
    return flat
