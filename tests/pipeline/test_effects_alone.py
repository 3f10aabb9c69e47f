"""Each effect of the world `bad` alone ends inside U, without a proof, or in a refusal; the two trials of less sharp parts and run-out."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from measureapp.pipeline.sample import SampleScan, sample_request
from measureapp.reconstruct.part_blur import edge_blur_px
from measureapp.simulate.effects.effects import draw_effects
from measureapp.simulate.options import LensEffects, WorldOptions
from measureapp.simulate.parts import make_part
from measureapp.simulate.world import World
from measureapp.simulate.worlds import read_world
from tests.pipeline.effects_alone import measure_in

WARMING = {"warm_share": 0.3}
BAD = read_world("bad").model_dump(exclude_defaults=True)
ONLY_SCAN = {  # effects that the calibration's images do not have: one calibration serves all
    "projector": ("level_spread", "vignetting", "bit_planes"),
    "part": ("form_mm", "penetration_mm", "bounce"),
    "light": ("gamma",),
    "timing": ("rolling_share",),
}
ALL = {
    "pixels": ("gain_spread", "dark_spread_e", "curvature"),
    "lenses": ("residual_px", "glare", "corner_blur_px", "defocus_px", "part_blur_px", "coma_px"),
    "motions": (
        "table_radial_mm",
        "table_axial_mm",
        "table_tilt_arcsec",
        "guide_angle_arcsec",
        "guide_straightness_mm",
        "robot_growth_mm",
        "robot_backlash_mm",
        "settling_mm",
    ),
    "warmth": ("camera_drift_px", "focal_drift", "part_excess_k", "board_excess_k"),
    "board": ("scale_ppm", "local_mm"),
}
TRIALS = ("blunt_part", "run_out")


def alone(group: str, name: str) -> dict[str, Any]:
    """Return the world with one effect at the magnitude of `bad`, whose owner knows what that of `bad` does of lengths and temperatures."""
    world: dict[str, Any] = {group: {name: BAD[group][name]}}
    if name in ("camera_drift_px", "focal_drift", "robot_growth_mm"):
        world["warmth"] = {**world.get("warmth", {}), **WARMING}
    if name in ("scale_ppm", "part_excess_k", "board_excess_k"):
        world["known"] = "bad"
    return world


@pytest.fixture(scope="module")
def calibrated(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A project in the world `ideal`, whose calibration others use."""
    folder = tmp_path_factory.mktemp("ideal")
    assert not measure_in({}, folder).silent_lies
    return folder / "project"


@pytest.mark.slow
@pytest.mark.parametrize(("group", "name"), [(group, name) for group, names in ONLY_SCAN.items() for name in names])
def test_an_effect_on_the_scan_alone_lies_to_nobody(group: str, name: str, calibrated: Path, tmp_path: Path, record_property) -> None:
    found = measure_in(alone(group, name), tmp_path, calibrated=calibrated)
    record_property("row", found.line(f"{group}.{name}"))
    assert not found.silent_lies, found.line(name)


@pytest.mark.slow
@pytest.mark.parametrize(("group", "name"), [(group, name) for group, names in ALL.items() for name in names])
def test_an_effect_on_calibration_and_scan_lies_to_nobody(group: str, name: str, tmp_path: Path, record_property) -> None:
    found = measure_in(alone(group, name), tmp_path)
    record_property("row", found.line(f"{group}.{name}"))
    assert not found.silent_lies, found.line(name)


@pytest.mark.slow
@pytest.mark.parametrize("trial", TRIALS)
def test_the_trials_end_inside_u_with_all_views(trial: str, tmp_path: Path, record_property) -> None:
    found = measure_in(read_world(trial).model_dump(exclude_defaults=True), tmp_path)
    record_property("row", found.line(trial))
    assert found.used == found.views == 8
    assert all(one["contains_truth"] for one in found.dimensions) and len(found.dimensions) == 4


@pytest.mark.slow
def test_a_gear_that_saturates_at_long_exposures_has_the_dimensions_of_one_that_does_not(tmp_path: Path, record_property) -> None:
    """Four times the light: 60 % of its pixels are saturated at the longest exposure, none at the shortest. No dimension moves by U."""
    plain = measure_in({}, tmp_path / "plain", part="gear")
    bright = measure_in({"light": {"projector": 5.6}}, tmp_path / "bright", calibrated=tmp_path / "plain" / "project", part="gear")
    record_property("plain", plain.line("gear"))
    record_property("bright", bright.line("gear, saturated"))
    assert bright.used == bright.views == 8 and len(bright.dimensions) == 4
    for before, after in zip(plain.dimensions, bright.dimensions, strict=True):
        assert abs(after["measured"] - before["measured"]) < after["uncertainty"]


@pytest.mark.parametrize("part_blur_px", [0.0, 2.86])
def test_edges_of_the_part_tell_its_blur_whatever_the_board_showed(part_blur_px: float) -> None:
    """One image of each camera in the light of the projector; the fast form of the trial with a part less sharp."""
    options = WorldOptions(lenses=LensEffects(part_blur_px=part_blur_px))
    request = sample_request(SampleScan(resolution="quarter"), Path("unused"))
    world = World(request.rig, make_part("gypsum"), 1, options=options)
    world.table_holds = "part"
    view = request.plan.viewpoints[0]
    world.turn_table(np.deg2rad(view.table_deg))
    world.move_guide(view.guide_mm)
    world.move_robot(view.flange.transform())
    world.load_patterns(np.full((1, 768, 1024), 128, np.uint8))
    world.show(0)
    effects = draw_effects(request.rig, make_part("gypsum"), options, 1)
    for camera in request.rig.cameras:
        image = np.mean([world.image(camera.name, 100_000).astype(np.float32) for _ in range(8)], axis=0)
        sharpness = effects.cameras[camera.name].sharpness
        further = 0.0 if sharpness is None else sharpness.part_px / 4.0
        wanted = np.sqrt(options.light.lens_blur_px**2 + 1 / 12 + further**2)
        assert edge_blur_px(image.astype(np.float32)) == pytest.approx(wanted, rel=0.04)
