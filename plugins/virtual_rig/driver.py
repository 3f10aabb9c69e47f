"""Driver of the virtual rig: all its devices share one world."""

from __future__ import annotations

from collections.abc import Mapping
from typing import cast

from pydantic import ValidationError

from measureapp.data.model import first_problem
from measureapp.data.rig import RigDescription
from measureapp.devices.rig import Rig
from measureapp.errors import DeviceError
from measureapp.simulate.parts import make_part
from measureapp.simulate.world import TableContent, World

from .axes import VirtualGuide, VirtualRobot, VirtualTable
from .head import VirtualCamera, VirtualProjector
from .settings import VirtualRigSettings
from .waiting import Clock, ScaledClock

THINGS = ("board", "part", "empty")


def connect(description: RigDescription, settings: Mapping[str, object]) -> Rig:
    """Build a world from settings and connect to it.

    Raises
    ------
    DeviceError
        A setting is invalid; names it.
    InputError
        The part cannot be read.
    """
    try:
        chosen = VirtualRigSettings.model_validate(dict(settings))
    except ValidationError as error:
        raise DeviceError(
            f"Virtual rig: setting {first_problem(error, 'settings')}.", "Correct it in the rig's driver_settings."
        ) from error
    strangers = sorted(set(chosen.world.knocked_deg) - {camera.name for camera in description.cameras})
    if strangers:
        raise DeviceError(f"Virtual rig: setting world.knocked_deg names camera {strangers[0]!r}.", "Name cameras of this rig.")
    world = World(description, make_part(chosen.part, chosen.unit), chosen.seed, chosen.board, chosen.world)
    return rig_of(world, ScaledClock(chosen.time_scale))


def rig_of(world: World, clock: Clock | None = None) -> Rig:
    """Connect to an existing world; without a clock nothing waits."""
    time = clock or ScaledClock(0.0)

    def place_on_table(thing: str) -> None:
        if thing not in THINGS:
            raise DeviceError(f"The virtual rig has no {thing!r} to put on the table.", f"Request one of: {', '.join(THINGS)}.")
        world.table_holds = cast(TableContent, thing)

    return Rig(
        description=world.description,
        cameras={camera.name: VirtualCamera(camera, world, time) for camera in world.description.cameras},
        projector=VirtualProjector(world, time),
        robot=VirtualRobot(world, time),
        guide=VirtualGuide(world, time),
        table=VirtualTable(world, time),
        place_on_table=place_on_table,
    )
