"""The plugin that drives the world: its settings, and what it keeps hidden."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.acquire.session import RigSession
from measureapp.data.rig import RigDescription
from measureapp.devices.connect import connect_rig
from measureapp.devices.plugin_loader import LoadedDriver, load_driver
from measureapp.devices.projector import PLAIN_LIGHT
from measureapp.devices.rig import Rig
from measureapp.errors import DeviceError, InputError
from measureapp.simulate.parts import make_part
from measureapp.simulate.truth import Truth
from measureapp.simulate.world import World


@pytest.fixture(scope="module")
def plugin() -> LoadedDriver:
    return load_driver(None, "virtual_rig", "rig")


def connected(paper: RigDescription, settings: dict[str, object]) -> Rig:
    return connect_rig(paper.model_copy(update={"driver_settings": settings}))


@pytest.mark.parametrize(
    ("settings", "named"),
    [({"seed": -1}, "seed"), ({"colour": "red"}, "colour"), ({"world": {"light": {"gamma": 0}}}, "world.light.gamma")],
)
def test_a_wrong_setting_is_refused_by_name(paper: RigDescription, settings: dict[str, object], named: str) -> None:
    with pytest.raises(InputError, match=named):
        connected(paper, settings)


def test_a_knocked_camera_that_the_rig_does_not_have_is_refused(paper: RigDescription) -> None:
    with pytest.raises(DeviceError, match="'top'"):
        connected(paper, {"part": "flat", "world": {"knocked_deg": {"top": (0.1, 0.0, 0.0)}}})


def test_a_part_that_does_not_exist_is_refused(paper: RigDescription) -> None:
    with pytest.raises(InputError, match="teapot"):
        connected(paper, {"part": "teapot"})


def test_no_device_shows_the_truth_in_its_public_attributes(paper: RigDescription) -> None:
    rig = connected(paper, {"part": "flat"})
    for device in (rig.robot, rig.guide, rig.table, rig.projector, *rig.cameras.values()):
        public = [getattr(device, name) for name in dir(device) if not name.startswith("_")]
        assert not any(isinstance(value, World | Truth) for value in public)


def test_all_devices_share_the_world_they_are_given(plugin: LoadedDriver, paper: RigDescription) -> None:
    world = World(paper, make_part("flat"), seed=9)
    rig = plugin.module.rig_of(world)
    rig.place_on_table("part")
    rig.table.move_to(0.25, timeout_s=1.0)
    rig.guide.move_to(-12.5, timeout_s=1.0)
    assert world.table_holds == "part"
    assert world.readback().table_rad == rig.table.angle_rad() == pytest.approx(0.25, abs=1e-6)
    assert world.readback().guide_mm == rig.guide.position_mm() == pytest.approx(-12.5)


def test_two_rigs_of_one_seed_take_the_same_images(paper: RigDescription) -> None:
    images = []
    for _ in range(2):
        rig = connected(paper, {"part": "flat", "seed": 4})
        rig.place_on_table("board")
        with RigSession(rig) as session:
            (shot,) = session.shots((PLAIN_LIGHT,), (20_000,))
        images.append([frame.pixels for frame in shot.frames.values()])
    for first, again in zip(*images, strict=True):
        np.testing.assert_array_equal(first, again)
