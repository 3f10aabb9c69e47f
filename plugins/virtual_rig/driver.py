"""Driver of the virtual rig: all its devices share one world."""

from __future__ import annotations

from typing import cast

from measureapp.devices.request import DeviceRequest
from measureapp.devices.rig import Rig
from measureapp.errors import DeviceError
from measureapp.simulate.parts import make_part
from measureapp.simulate.world import TableContent, World

from .axes import VirtualGuide, VirtualRobot, VirtualTable
from .head import SharedLink, VirtualCamera, VirtualProjector
from .settings import VirtualRigSettings
from .waiting import Clock, SteppingClock, clock_of

THINGS = ("board", "part", "empty")


def connect(request: DeviceRequest) -> Rig:
    """Build a world from settings and connect to it.

    Raises
    ------
    DeviceError
        A setting names a camera that the rig has not.
    InputError
        The part cannot be read.
    """
    description, chosen = request.rig, request.settings
    assert isinstance(chosen, VirtualRigSettings)
    strangers = sorted(set(chosen.world.knocked_deg) - {camera.name for camera in description.cameras})
    if strangers:
        raise DeviceError(f"Virtual rig: setting world.knocked_deg names camera {strangers[0]!r}.", "Name cameras of this rig.")
    world = World(description, make_part(chosen.part, chosen.unit), chosen.seed, chosen.board, chosen.world)
    return rig_of(world, clock_of(chosen.time_scale))


def rig_of(world: World, clock: Clock | None = None) -> Rig:
    """Connect to an existing world; without a clock nothing waits."""
    time, link = clock or SteppingClock(), SharedLink()
    cameras = {camera.name: VirtualCamera(camera, world, time, link) for camera in world.description.cameras}

    def place_on_table(thing: str) -> None:
        if thing not in THINGS:
            raise DeviceError(f"The virtual rig has no {thing!r} to put on the table.", f"Request one of: {', '.join(THINGS)}.")
        world.table_holds = cast(TableContent, thing)

    return Rig(
        description=world.description,
        cameras=cameras,
        projector=VirtualProjector(world, time, tuple(cameras.values())),
        robot=VirtualRobot(world, time),
        guide=VirtualGuide(world, time),
        table=VirtualTable(world, time),
        place_on_table=place_on_table,
    )
