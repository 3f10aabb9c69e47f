"""The decoding of one camera's images of one fringe direction, all exposures at once or one by one."""

from __future__ import annotations

from collections.abc import Callable
from math import tau

import numpy as np

from measureapp.arrays import ImageArray, IntArray, read_only
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.errors import DecodeError
from measureapp.fringe.absolute import (
    GRAY_SLACK_CYCLES,
    SAMPLED_CHUNKS,
    Solve,
    make_maps,
    make_model,
    of_pixels,
    plan_of,
    sampled_chunks,
    with_origin,
)
from measureapp.fringe.exposures.blooming import near_saturation
from measureapp.fringe.kernels.records import CHUNK, STRETCH, Layout, Maps, Model, Sums
from measureapp.fringe.order_vote import VoteLimits, order_steps, settle_orders
from measureapp.fringe.pixel_loop import NOWHERE, STRETCH_ALONE, PixelLoop, Room, flat
from measureapp.fringe.recipe import Recipe
from measureapp.fringe.unwrap import extent_px

LEAST_USABLE, MOST_OUTSIDE = 0.01, 0.8
Fill = Callable[[Sums, list[tuple[int, int]]], None]  # puts the sums of stretches of pixels (begin, end) one after the other
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
        memory: BufferPool,
    ) -> None:
        self._recipe, self._camera, self._viewpoint_id = recipe, camera, viewpoint_id
        self._shape, self._dtype = shape, np.dtype(dtype)
        self._pixels = shape[0] * shape[1]
        self._memory = memory
        self._plan = plan_of(recipe)
        self._looking = make_model(recipe, self._plan, decides_later=recipe.settings.vote_radius > 0)  # for where the fringes start
        self._loop = PixelLoop(recipe, self._dtype, self._pixels, self._looking, memory)
        self._seen = self._loop.nothing_seen()
        self._sums: Sums | None = None

    def decode(self, images: ImageArray) -> PhaseMap:
        """Decode all exposures (E, P, H, W) at once."""
        if self._recipe.settings.blooming_radius_px:
            for exposure in range(len(images)):
                self.add(exposure, images[exposure])
            return self.finish()
        whole, loop = flat(images.reshape(*images.shape[:2], self._pixels)), self._loop

        def sum_sample(sample: Sums, stretches: list[tuple[int, int]]) -> None:
            shown = flat(np.concatenate([whole[..., begin:end] for begin, end in stretches], axis=-1))
            loop.run(sample, 0, 0, shown.shape[-1], images=shown)

        model = self._model(sum_sample)
        maps = make_maps(self._dtype, self._pixels, self._memory)
        spare: list[tuple[Sums, Room]] = []

        def work(start: int, stop: int) -> tuple[IntArray, IntArray]:
            try:
                sums, room = spare.pop()
            except IndexError:
                sums, room = self._recipe.sums(self._dtype, STRETCH, self._memory), loop.room(loop.layout)
            done = loop.run(sums, STRETCH_ALONE, start, stop, images=whole, model=model, maps=maps, room=room)
            spare.append((sums, room))
            return done

        done = self._loop.in_bands(work)
        self._seen = np.sum([seen for seen, _ in done], axis=0)
        return self._phase_map(maps, model, np.sum([counts for _, counts in done], axis=0))

    def add(self, exposure: int, images: ImageArray) -> None:
        """Add the images (P, H, W) of one exposure to the sums."""
        if self._sums is None:
            self._sums = self._recipe.sums(self._dtype, self._pixels, self._memory)
        sums, radius = self._sums, self._recipe.settings.blooming_radius_px
        one, loop = flat(images.reshape(1, len(images), self._pixels)), self._loop
        blocked = near_saturation(one[0], self._shape, loop.layout, loop.rule, radius) if radius else NOWHERE
        done = loop.in_bands(lambda start, stop: loop.run(sums, 0, start, stop, images=one, exposure=exposure, blocked=blocked)[0])
        self._seen += np.sum(done, axis=0)

    def finish(self) -> PhaseMap:
        """Turn the sums into the phase map."""
        assert self._sums is not None
        sums = self._sums

        def copy_sample(sample: Sums, stretches: list[tuple[int, int]]) -> None:
            for number, (begin, _) in enumerate(stretches):
                for whole, part in zip(sums[:-1], sample[:-1], strict=True):
                    part[..., number * CHUNK : (number + 1) * CHUNK] = whole[..., begin : begin + CHUNK]
                sample.alike[number] = sums.alike[begin // CHUNK]

        model = self._model(copy_sample)
        maps = make_maps(self._dtype, self._pixels, self._memory)
        done = self._loop.in_bands(lambda start, stop: self._loop.run(sums, 0, start, stop, model=model, maps=maps)[1])
        self._sums = None
        return self._phase_map(maps, model, np.sum(done, axis=0))

    def _model(self, fill: Fill) -> Model:
        """Return what turns sums into phase, its origin told from as many chunks as that takes."""
        model, known = self._looking, False
        for number in SAMPLED_CHUNKS:
            if not known:
                model, known = with_origin(model, self._plan, self._loop.layout, self._sample(fill, sampled_chunks(self._pixels, number)))
        return model

    def _sample(self, fill: Fill, chunks: list[tuple[int, int]]) -> Solve:
        """Return what solves the sums of some chunks; these are too few to be worth sharing among processors."""
        pixels = sum(end - begin for begin, end in chunks)
        sums = self._recipe.sums(self._dtype, pixels, self._memory)
        fill(sums, chunks)

        def solve(trial: Model, layout: Layout) -> Maps:
            maps = make_maps(self._dtype, pixels, self._memory)
            self._loop.run(sums, 0, 0, pixels, model=trial, layout=layout, maps=maps)
            return of_pixels(maps, pixels)

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
        recipe, maps = self._recipe, of_pixels(maps, self._pixels)
        states, complete = counts[:-1], int(counts[-1])
        self._check_within(states)
        amplification = self._plan.amplification if self._plan else 0.0
        repaired = 0
        limits = self._limits(model, amplification)
        if limits.radius or limits.edge_step_rad < recipe.patterns.phase_range_rad:
            repaired, change = settle_orders(maps, self._shape, limits, self._memory)
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
            exposures_us=tuple(float(exposure) for exposure in recipe.exposures_us),
            snr_at_one_rad=_snr_at_one_rad(model, self._loop.layout),
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
            order_steps_rad=order_steps(model.scales.astype(float), self._loop.layout.steps),
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
