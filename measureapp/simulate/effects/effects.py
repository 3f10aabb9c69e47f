"""All effects of one world, drawn from its seed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, read_only
from measureapp.data.rig import CameraDescription, RigDescription
from measureapp.simulate.effects.board_print import PrintErrors, draw_print
from measureapp.simulate.effects.form import made_part, with_surroundings
from measureapp.simulate.effects.motions import GuideMotion, TableMotion, draw_guide_motion, draw_table_motion
from measureapp.simulate.effects.sensor import PixelErrors, draw_pixels
from measureapp.simulate.effects.sharpness import FULL_WIDTH_PX, Sharpness, draw_sharpness
from measureapp.simulate.effects.warmth import Warmth, draw_warmth
from measureapp.simulate.effects.waves import draw_waves, sampled
from measureapp.simulate.kernels import LENS_STEP_PX
from measureapp.simulate.optics import NO_COMA, NO_RESIDUAL
from measureapp.simulate.options import LensEffects, WorldOptions
from measureapp.simulate.part import Part

LENS_WAVELENGTHS_PX = (300.0, 2500.0)
COMA_DEPTH_MM = 80.0  # from focus, where the magnitude of coma is stated


@dataclass(frozen=True, slots=True, eq=False)
class CameraEffects:
    """Effects of one camera."""

    residual_px: FloatArray  # (rows, columns, 2), see `kernels.pixel_rays`
    coma: FloatArray  # (4,), likewise
    sharpness: Sharpness | None
    pixels: PixelErrors | None


@dataclass(frozen=True, slots=True, eq=False)
class Effects:
    """Effects of one world; None where there is none."""

    cameras: Mapping[str, CameraEffects]
    warmth: Warmth | None
    table: TableMotion | None
    guide: GuideMotion | None
    board_print: PrintErrors | None
    part: Part  # as it was made
    seen_part: Part  # with what stands around it


def draw_effects(rig: RigDescription, nominal: Part, options: WorldOptions, seed: int) -> Effects:
    """Draw the effects of a world; the same seed gives the same ones, also at another resolution of the cameras."""
    generators = [np.random.default_rng([seed, 200 + subject]) for subject in range(6)]
    part = made_part(nominal, options, generators[5])
    return Effects(
        {
            camera.name: _camera(camera, rig.standoff_mm, options, rng)
            for camera, rng in zip(rig.cameras, generators[0].spawn(len(rig.cameras)), strict=True)
        },
        draw_warmth(options, rig, generators[1]),
        draw_table_motion(options.motions, generators[2]),
        draw_guide_motion(options.motions, rig, generators[3]),
        draw_print(options, generators[4]),
        part,
        with_surroundings(part) if options.part.fixture else part,
    )


def _camera(camera: CameraDescription, standoff_mm: float, options: WorldOptions, rng: np.random.Generator) -> CameraEffects:
    scale = camera.width_px / FULL_WIDTH_PX
    low, high = (length * scale for length in LENS_WAVELENGTHS_PX)
    waves = draw_waves(rng, options.lenses.residual_px * scale, (low, high), components=2, dimensions=2)
    residual = sampled(waves, camera.width_px, camera.height_px, LENS_STEP_PX) if waves.rms else NO_RESIDUAL
    sharpness = draw_sharpness(options.lenses, standoff_mm, rng)
    pixels = draw_pixels(options.pixels, camera.width_px, camera.height_px, options.sensor.full_well_e, rng)
    return CameraEffects(residual, _coma(options.lenses, standoff_mm, rng), sharpness, pixels)


def _coma(lenses: LensEffects, standoff_mm: float, rng: np.random.Generator) -> FloatArray:
    """Draw how far rays miss one point: slope, depth without displacement, and centre, see `kernels.pixel_rays`."""
    sign, strength, centre = rng.choice([-1.0, 1.0]), rng.uniform(0.7, 1.3), 0.05 * rng.standard_normal(2)
    if not lenses.coma_px:
        return NO_COMA
    slope = sign * strength * lenses.coma_px * standoff_mm / (COMA_DEPTH_MM * 0.5 * FULL_WIDTH_PX)
    return read_only([slope, standoff_mm, *centre], np.float64)
