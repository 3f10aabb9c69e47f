"""A small rig and worlds for the tests of the simulator."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from measureapp.data.plan import Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.planning.viewpoints import LookAt, viewpoint_looking_at
from measureapp.project.rig_file import read_rig
from measureapp.simulate.options import LightSettings, WorldOptions
from measureapp.simulate.sensor import SensorSettings
from measureapp.simulate.world import World


@pytest.fixture(scope="session")
def paper() -> RigDescription:
    return read_rig("paper").at_resolution("quarter")


@pytest.fixture(scope="session")
def ideal() -> WorldOptions:
    """No noise, no blur, a linear projector."""
    light = LightSettings(gamma=1.0, black=0.0, defocus_px=0.0, lens_blur_px=0.0)
    return WorldOptions(light=light, sensor=SensorSettings(noise=False))


@pytest.fixture(scope="session")
def look_from() -> Callable[..., None]:
    """Bring the axes of a world to a place from which the head looks at a point above the table's centre."""

    def look(
        world: World, azimuth_deg: float, elevation_deg: float, height_mm: float = 30.0, table_deg: float = 0.0, guide_mm: float = 0.0
    ) -> None:
        rig = world.description
        target = np.add(rig.table.centre_in_guide_mm, [0.0, 0.0, height_mm])
        gaze = LookAt(azimuth_deg, elevation_deg, rig.standoff_mm)
        view: Viewpoint = viewpoint_looking_at(rig, "view", target, gaze, guide_mm=guide_mm, table_deg=table_deg)
        world.move_robot(view.flange.transform())
        world.move_guide(view.guide_mm)
        world.turn_table(np.deg2rad(view.table_deg))

    return look
