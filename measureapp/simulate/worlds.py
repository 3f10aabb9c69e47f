"""Worlds by name: a rig as the program's model describes it, a good, a usual and a bad one.

The magnitudes are those that data sheets and publications state for such rigs; decision 31 has the list with its sources.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Literal, get_args

from measureapp.simulate.options import (
    AxisEffects,
    BoardEffects,
    LensEffects,
    LightSettings,
    PartEffects,
    ProjectorEffects,
    SensorEffects,
    WarmthEffects,
    WorldOptions,
)
from measureapp.simulate.sensor import SensorSettings

WorldName = Literal["ideal", "good", "usual", "bad"]
WORLD_NAMES: tuple[WorldName, ...] = get_args(WorldName)

GOOD = WorldOptions(
    light=LightSettings(gamma=1.01, defocus_px=0.6, lens_blur_px=0.6),
    sensor=SensorSettings(full_well_e=20_000, read_noise_e=2.5),
    board_bow_mm=0.01,
    ambient_flicker=0.02,
    pixels=SensorEffects(gain_spread=0.005, dark_spread_e=2.0, curvature=0.002),
    lenses=LensEffects(residual_px=0.01, glare=0.005, corner_blur_px=0.3, defocus_px=0.3, part_blur_px=0.1),
    projector=ProjectorEffects(level_spread=0.0005, vignetting=0.3, drift_px=0.05),
    motions=AxisEffects(
        table_radial_mm=0.001,
        table_axial_mm=0.001,
        table_tilt_arcsec=2,
        guide_angle_arcsec=5,
        guide_straightness_mm=0.003,
        robot_growth_mm=0.01,
    ),
    warmth=WarmthEffects(camera_drift_px=0.05, focal_drift=1e-5, warm_share=0.9, part_excess_k=0.2, board_excess_k=0.2),
    board=BoardEffects(scale_ppm=3, local_mm=0.001),
    part=PartEffects(form_mm=0.01, penetration_mm=0.005, bounce=0.5),
)
USUAL = WorldOptions(
    light=LightSettings(gamma=1.07, defocus_px=1.0, lens_blur_px=0.8),
    sensor=SensorSettings(full_well_e=10_000, read_noise_e=7.0),
    board_bow_mm=0.03,
    ambient_flicker=0.05,
    pixels=SensorEffects(gain_spread=0.01, dark_spread_e=5.0, curvature=0.01),
    lenses=LensEffects(residual_px=0.03, glare=0.015, corner_blur_px=0.6, defocus_px=0.6, part_blur_px=0.3),
    projector=ProjectorEffects(level_spread=0.002, vignetting=0.5, drift_px=0.2),
    motions=AxisEffects(
        table_radial_mm=0.007,
        table_axial_mm=0.005,
        table_tilt_arcsec=10,
        guide_angle_arcsec=20,
        guide_straightness_mm=0.015,
        robot_growth_mm=0.06,
    ),
    warmth=WarmthEffects(camera_drift_px=0.2, focal_drift=4e-5, warm_share=0.7, part_excess_k=0.5, board_excess_k=0.5),
    board=BoardEffects(scale_ppm=20, local_mm=0.005),
    part=PartEffects(form_mm=0.03, penetration_mm=0.02, bounce=1.0),
)
BAD = WorldOptions(
    light=LightSettings(gamma=1.2, defocus_px=1.8, lens_blur_px=1.1),
    sensor=SensorSettings(full_well_e=6_000, read_noise_e=15.0),
    board_bow_mm=0.1,
    ambient_flicker=0.2,
    pixels=SensorEffects(gain_spread=0.02, dark_spread_e=10.0, curvature=0.03),
    lenses=LensEffects(residual_px=0.1, glare=0.04, corner_blur_px=1.2, defocus_px=1.2, part_blur_px=0.6),
    projector=ProjectorEffects(level_spread=0.01, vignetting=0.7, drift_px=1.0),
    motions=AxisEffects(
        table_radial_mm=0.03,
        table_axial_mm=0.02,
        table_tilt_arcsec=30,
        guide_angle_arcsec=60,
        guide_straightness_mm=0.05,
        robot_growth_mm=0.2,
    ),
    warmth=WarmthEffects(camera_drift_px=1.0, focal_drift=2e-4, warm_share=0.3, part_excess_k=2.0, board_excess_k=3.0),
    board=BoardEffects(scale_ppm=150, local_mm=0.02),
    part=PartEffects(form_mm=0.1, penetration_mm=0.08, bounce=1.0),
)
WORLDS: Mapping[WorldName, WorldOptions] = MappingProxyType({"ideal": WorldOptions(), "good": GOOD, "usual": USUAL, "bad": BAD})
