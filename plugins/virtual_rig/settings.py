"""Settings of the virtual rig."""

from __future__ import annotations

from pydantic import Field

from measureapp.data.board import AnyBoard
from measureapp.data.length_unit import LengthUnit
from measureapp.data.model import Model
from measureapp.data.sample_worlds import IDEAL
from measureapp.simulate.options import WorldOptions
from measureapp.simulate.placing import UPRIGHT_DEG
from measureapp.simulate.world import PAPER_BOARD
from measureapp.simulate.worlds import read_world


class VirtualRigSettings(Model):
    """Settings of the virtual rig: part, seed, time scale, board and world."""

    part: str = Field(default="gypsum", description="one of impeller, gypsum, gear, sphere_plate, flat, or a mesh file (STL, PLY, OBJ)")
    unit: LengthUnit = Field(default=LengthUnit.MM, description="unit of a mesh file")
    part_turn_deg: tuple[float, float, float] = Field(
        default=UPRIGHT_DEG, description="rotation of the part about x, then y, then z, before it is put on the table"
    )
    seed: int = Field(default=1, ge=0, description="seed of the hidden errors and all noise")
    time_scale: float = Field(default=0.0, ge=0, description="1: moves and exposures take as long as on a real rig; 0: no waiting")
    follows: str = Field(
        default="", description="address host:port of a virtual cell in another program, whose axes move this rig; empty: none"
    )
    board: AnyBoard = PAPER_BOARD
    conditions: str = Field(
        default=IDEAL,
        description="how well rig and part are made: ideal, good, usual, bad or a TOML file of a world; a table [world] takes its place",
    )
    world: WorldOptions = WorldOptions()

    @property
    def options(self) -> WorldOptions:
        """Options of the world: those given one by one, else those of the named conditions. Raises InputError."""
        return read_world(self.conditions) if self.world == WorldOptions() else self.world


class SharedRigSettings(Model):
    """Settings of a camera or the projector of a virtual rig that several devices share."""

    link: str = Field(default="cell", description="name of the shared rig; its table [links.NAME] has the settings of a virtual rig")
