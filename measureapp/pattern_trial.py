"""Trials of pattern sets: decoded images of the virtual rig compared with the true projector column of every pixel."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import radians
from typing import Literal

import cv2
import numpy as np

from measureapp.arrays import BoolArray, FloatArray, ImageArray
from measureapp.data.fringe import FringeStack, PatternSet
from measureapp.data.phase import PhaseMap
from measureapp.data.rig import Resolution
from measureapp.fringe.decode import decode
from measureapp.fringe.patterns.draw import pattern_images
from measureapp.fringe.settings import DecodeSettings
from measureapp.planning.viewpoints import plan_around_part
from measureapp.project.geometry.robot_file import arm_of
from measureapp.project.rig_file import read_rig
from measureapp.simulate.options import LightSettings, WorldOptions
from measureapp.simulate.parts import make_part
from measureapp.simulate.world import World

BORDER_PX = 3  # around shadows, edges of the part and depth discontinuities, where pixels mix two surfaces
STEP_COLUMNS = 3.0
UNSATURATED = 240.0  # greatest grey level without saturation by noise
BLUR_MARGIN = 1.5  # on the modulation, for the blur of projector and lens
SHARE_OF_PITCH = 0.45  # errors beyond it are wrong fringe orders
VIEWS = 6


@dataclass(frozen=True, slots=True)
class Scene:
    """One view of a part; ``brightness`` scales the projector's light."""

    part: str = "gear"
    resolution: Resolution = "quarter"
    seed: int = 1
    view: int = 1
    brightness: float = 1.0

    def world(self) -> World:
        """Build the world and move its axes to the view."""
        rig, part = read_rig("paper").at_resolution(self.resolution), make_part(self.part)
        light = LightSettings(projector=LightSettings().projector * self.brightness)
        world = World(rig, part, self.seed, options=WorldOptions(light=light))
        world.table_holds = "part"
        plan = plan_around_part(rig, part.name, radius_mm=part.radius_mm, height_mm=part.height_mm, count=VIEWS, arm=arm_of(rig))
        viewpoint = plan[self.view % VIEWS]
        world.turn_table(radians(viewpoint.table_deg))
        world.move_guide(viewpoint.guide_mm)
        world.move_robot(viewpoint.flange.transform())
        return world


@dataclass(frozen=True, slots=True, eq=False)
class PhaseMapErrors:
    """Comparison of a phase map with the truth; counts are camera pixels."""

    wrong: int  # valid illuminated pixels with a wrong fringe order
    valid: int  # valid illuminated pixels
    decodable: int  # pixels of a single surface with sufficient modulation at an unsaturated exposure
    decoded: int  # of these, valid ones with the right fringe order
    error_px: FloatArray  # (decoded,), projector column minus truth
    sigma_px: FloatArray  # (decoded,), predicted standard deviation of the column


@dataclass(frozen=True, slots=True)
class Trial:
    """Result of one pattern set and exposure rule over all scenes."""

    patterns: str
    rule: str
    images: int
    wrong_share: float  # relative to the valid pixels
    decoded_share: float  # relative to the decodable pixels
    column_error_px: float  # 1.4826 · median |error|, the standard deviation of a normal distribution
    noise_ratio: float  # robust standard deviation of error / predicted σ
    valid_px: int


def run_trial(scenes: tuple[Scene, ...], patterns: PatternSet, rule: Literal["combined", "paper"] = "combined") -> Trial:
    """Decode ``patterns`` on every scene with the left camera and compare with the ground truth."""
    found = []
    for scene in scenes:
        world = scene.world()
        found.append(evaluate(world, decode(capture(world, patterns), DecodeSettings(rule=rule))["left"]))
    return summarise(patterns, rule, found)


def summarise(patterns: PatternSet, rule: str, found: Sequence[PhaseMapErrors]) -> Trial:
    """Return what the phase maps of all scenes amount to."""
    error, sigma = (np.concatenate([getattr(each, name) for each in found]) for name in ("error_px", "sigma_px"))
    valid, decodable = sum(each.valid for each in found), sum(each.decodable for each in found)
    return Trial(
        patterns=patterns.name,
        rule=rule,
        images=patterns.count,
        wrong_share=sum(each.wrong for each in found) / max(1, valid),
        decoded_share=sum(each.decoded for each in found) / max(1, decodable),
        column_error_px=_spread(error),
        noise_ratio=_spread(error / sigma),
        valid_px=valid,
    )


def capture(world: World, patterns: PatternSet, cameras: tuple[str, ...] = ("left",)) -> FringeStack:
    """Take all images of the set at the exposures of the rig."""
    projector = world.description.projector
    world.load_patterns(pattern_images(patterns, projector.width_px, projector.height_px))
    exposures = tuple(world.description.exposures_us)
    images = {name: np.stack([[_shot(world, name, n, us) for n in range(patterns.count)] for us in exposures]) for name in cameras}
    for stack in images.values():
        stack.flags.writeable = False
    return FringeStack("trial", patterns, exposures, images, min(camera.saturation for camera in world.description.cameras))


def evaluate(world: World, phase_map: PhaseMap) -> PhaseMapErrors:
    """Compare a phase map with the true projector columns."""
    light = world.true_light(phase_map.camera)
    column, width = light[..., 0], world.description.projector.width_px
    lit = (column > 1) & (column < width - 2)
    whole = lit & ~_near(~lit | _steps(column))
    decodable = whole & (_best_modulation(world, light) > BLUR_MARGIN * DecodeSettings().min_modulation)
    found = phase_map.column_px
    limit = SHARE_OF_PITCH * phase_map.pitch_px
    good = decodable & phase_map.valid & (np.abs(found - column) < limit)
    of_a_neighbour = _least_error(found, column) < limit  # at a depth discontinuity the blurred image shows the brighter surface
    return PhaseMapErrors(
        wrong=int((phase_map.valid & lit & ~_near(~lit) & ~of_a_neighbour).sum()),
        valid=int((phase_map.valid & lit).sum()),
        decodable=int(decodable.sum()),
        decoded=int(good.sum()),
        error_px=(found - column)[good],
        sigma_px=phase_map.sigma_rad[good] * phase_map.pixel_of_phase()[0],
    )


def _shot(world: World, camera: str, pattern: int, exposure_us: int) -> ImageArray:
    world.show(pattern)
    return world.image(camera, exposure_us)


def _best_modulation(world: World, light: FloatArray) -> FloatArray:
    """Return the modulation (H, W) in 8-bit grey levels, without blur, at the longest unsaturated exposure; 0 for none."""
    settings = world.options.light
    full_swing = 0.5 * 255.0 * settings.projector * light[..., 2]
    brightest = 2.0 * full_swing + 255.0 * settings.ambient * light[..., 3]
    best = np.zeros_like(full_swing)
    for exposure_us in world.description.exposures_us:
        share = exposure_us / settings.reference_exposure_us
        best = np.maximum(best, np.where(brightest * share < UNSATURATED, full_swing * share, 0.0))
    return best


def _near(mask: BoolArray) -> BoolArray:
    size = 2 * BORDER_PX + 1
    return np.asarray(cv2.dilate(mask.astype(np.uint8), np.ones((size, size), np.uint8)) > 0)


def _steps(column: FloatArray) -> BoolArray:
    step = np.zeros(column.shape, bool)
    step[:, 1:] |= np.abs(np.diff(column, axis=1)) > STEP_COLUMNS
    step[1:] |= np.abs(np.diff(column, axis=0)) > STEP_COLUMNS
    return step


def _least_error(found: FloatArray, column: FloatArray) -> FloatArray:
    """Return the smallest error of the column relative to the pixel and its eight neighbours."""
    shifts = [(dy, dx) for dy in (-1, 0, 1) for dx in (-1, 0, 1)]
    return np.asarray(np.min([np.abs(found - np.roll(column, shift, axis=(0, 1))) for shift in shifts], axis=0))


def _spread(values: FloatArray) -> float:
    return float(1.4826 * np.median(np.abs(values))) if values.size else float("nan")
