"""Driver of the virtual rig: all its devices share one world."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import cast

import numpy as np
from pydantic import ValidationError

from measureapp.data.model import first_problem
from measureapp.data.rig import RigDescription
from measureapp.devices.request import DeviceRequest
from measureapp.devices.rig import Rig
from measureapp.errors import DeviceError, InputError
from measureapp.geometry.transform import RigidTransform
from measureapp.peers.positions import PositionsAsked
from measureapp.simulate.parts import make_part
from measureapp.simulate.placing import place_part
from measureapp.simulate.world import TableContent, World

from .axes import VirtualGuide, VirtualRobot, VirtualTable
from .head import SharedLink, VirtualCamera, VirtualProjector
from .settings import SharedRigSettings, VirtualRigSettings
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
    assert isinstance(request.settings, VirtualRigSettings)
    return _build(request.rig, request.settings)


def connect_camera(request: DeviceRequest) -> VirtualCamera:
    """Return one camera of the virtual rig that the devices of this rig share."""
    camera = _shared(request).cameras[request.name]
    assert isinstance(camera, VirtualCamera)
    return camera


def connect_projector(request: DeviceRequest) -> VirtualProjector:
    """Return the projector of the virtual rig that the devices of this rig share."""
    projector = _shared(request).projector
    assert isinstance(projector, VirtualProjector)
    return projector


def _shared(request: DeviceRequest) -> Rig:
    """Return the virtual rig behind a link, made from the link's settings by the first device. Raises InputError."""
    assert isinstance(request.settings, SharedRigSettings)

    def build(table: Mapping[str, object]) -> Rig:
        try:
            return _build(request.rig, VirtualRigSettings.model_validate(dict(table)))
        except ValidationError as error:
            raise InputError(f"[links]: {first_problem(error, 'the virtual rig')}.", "Correct it in the rig description.") from error

    return request.links.open(request.settings.link, Rig, build, Rig.close)


def _build(description: RigDescription, chosen: VirtualRigSettings) -> Rig:
    strangers = sorted(set(chosen.world.knocked_deg) - {camera.name for camera in description.cameras})
    if strangers:
        raise DeviceError(f"Virtual rig: setting world.knocked_deg names camera {strangers[0]!r}.", "Name cameras of this rig.")
    part = place_part(make_part(chosen.part, chosen.unit), chosen.part_turn_deg)
    world = World(description, part, chosen.seed, chosen.board, chosen.options)
    clock = clock_of(chosen.time_scale)
    if not chosen.follows:
        return rig_of(world, clock)
    cell = PositionsAsked(chosen.follows)
    return replace(rig_of(world, clock, lambda: _follow(world, cell)), release=cell.close)


def _follow(world: World, cell: PositionsAsked) -> None:
    """Move a world to where the axes of a cell in another program are."""
    told = cell.ask()
    world.move_robot(RigidTransform(np.array(told["base_from_flange"]), "base", "flange"))
    world.move_guide(told["guide_mm"])
    world.turn_table(told["table_rad"])
    if world.table_holds != told["table_holds"]:
        world.table_holds = told["table_holds"]


def rig_of(world: World, clock: Clock | None = None, follow: Callable[[], None] = lambda: None) -> Rig:
    """Connect to an existing world; without a clock nothing waits.

    Parameters
    ----------
    follow : called before the images of a pose are taken
    """
    time, link = clock or SteppingClock(), SharedLink()
    cameras = {camera.name: VirtualCamera(camera, world, time, link, follow) for camera in world.description.cameras}

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
        truth=lambda: world.truth().with_projector(),
    )
