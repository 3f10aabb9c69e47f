"""The plugin that drives the world: its settings, and what it keeps hidden."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.data.rig import RigDescription
from measureapp.devices.plugin_loader import LoadedPlugin, load_plugin
from measureapp.errors import DeviceError, InputError
from measureapp.simulate.parts import make_part
from measureapp.simulate.truth import Truth
from measureapp.simulate.world import World


@pytest.fixture(scope="module")
def plugin() -> LoadedPlugin:
    return load_plugin(None, "virtual_rig")


@pytest.mark.parametrize(
    ("settings", "named"),
    [({"seed": -1}, "seed"), ({"colour": "red"}, "colour"), ({"world": {"light": {"gamma": 0}}}, "world.light.gamma")],
)
def test_a_wrong_setting_is_refused_by_name(plugin: LoadedPlugin, paper: RigDescription, settings: dict[str, object], named: str) -> None:
    with pytest.raises(DeviceError, match=named):
        plugin.entry(paper, settings)


def test_a_part_that_does_not_exist_is_refused(plugin: LoadedPlugin, paper: RigDescription) -> None:
    with pytest.raises(InputError, match="teapot"):
        plugin.entry(paper, {"part": "teapot"})


def test_no_device_shows_the_truth_in_its_public_attributes(plugin: LoadedPlugin, paper: RigDescription) -> None:
    rig = plugin.entry(paper, {"part": "flat"})
    for device in (rig.robot, rig.guide, rig.table, rig.projector, *rig.cameras.values()):
        public = [getattr(device, name) for name in dir(device) if not name.startswith("_")]
        assert not any(isinstance(value, World | Truth) for value in public)


def test_all_devices_share_the_world_they_are_given(plugin: LoadedPlugin, paper: RigDescription) -> None:
    world = World(paper, make_part("flat"), seed=9)
    rig = plugin.module.rig_of(world)
    rig.place_on_table("part")
    rig.table.move_to(0.25, timeout_s=1.0)
    rig.guide.move_to(-12.5, timeout_s=1.0)
    assert world.table_holds == "part"
    assert world.readback().table_rad == rig.table.angle_rad() == pytest.approx(0.25, abs=1e-6)
    assert world.readback().guide_mm == rig.guide.position_mm() == pytest.approx(-12.5)


def test_two_rigs_of_one_seed_take_the_same_images(plugin: LoadedPlugin, paper: RigDescription) -> None:
    images = []
    for _ in range(2):
        rig = plugin.entry(paper, {"part": "flat", "seed": 4})
        rig.place_on_table("board")
        rig.projector.show(-1, timeout_s=1.0)
        images.append([camera.grab(timeout_s=5.0).pixels for camera in rig.cameras.values()])
    for first, again in zip(*images, strict=True):
        np.testing.assert_array_equal(first, again)
