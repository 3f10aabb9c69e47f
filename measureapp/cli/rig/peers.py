"""`rig peers`: a virtual cell for the true drivers."""

from __future__ import annotations

import signal
import sys
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from measureapp.cli.reply import JsonOption, reply, say

if TYPE_CHECKING:
    from measureapp.peers.positions import CellPositions

THINGS = ("board", "part", "empty")
HOW = f"Type {', '.join(THINGS[:-1])} or {THINGS[-1]} and Enter to change what lies on the table. Ctrl+C ends the cell."


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command()
    def peers(
        out: Annotated[
            Path, typer.Argument(help="Rig description (TOML) to write; connect it in the window or by other commands.", dir_okay=False)
        ],
        rig: Annotated[str, typer.Option(help="Rig to imitate: a TOML file, or a name in resources/rigs.")] = "paper",
        part: Annotated[
            str, typer.Option(help="impeller, gypsum, gear, sphere_plate, flat, or a mesh file in mm (STL, PLY, OBJ).")
        ] = "gypsum",
        seed: Annotated[int, typer.Option(min=0, help="Seed of the hidden errors and noise.")] = 1,
        quick: Annotated[bool, typer.Option("--quick", help="Axes arrive at once, and exposures take no time.")] = False,
        as_json: JsonOption = False,
    ) -> None:
        """Run a virtual cell until Ctrl+C: a robot controller, a guide and a table that the true drivers talk to.

        The robot controller speaks Robot Web Services, the guide Modbus RTU on a serial port, the table Modbus TCP. Cameras and projector
        are simulated in the program that connects, and follow these axes. Nothing is reachable from other computers.
        """
        from measureapp.data.length_unit import LengthUnit
        from measureapp.peers.cell import rig_at, virtual_cell
        from measureapp.peers.positions import CellPositions, tell_positions
        from measureapp.project.rig_file import read_rig, write_rig
        from measureapp.simulate.parts import make_part

        description, positions = read_rig(rig), CellPositions()
        make_part(part, LengthUnit.MM)  # refused here rather than where a program connects
        shape = str(Path(part).resolve()) if Path(part).suffix else part
        with virtual_cell(positions, realtime=not quick) as addresses, tell_positions(positions) as told_at:
            head = {"follows": told_at, "part": shape, "seed": seed, "time_scale": 0.0 if quick else 1.0}
            write_rig(out, rig_at(addresses, description, head, realtime=not quick))
            lines = (
                f"Robot controller at {addresses.robot_url}, guide at {addresses.guide_port}, table at 127.0.0.1:{addresses.table_port}.",
                f"Rig description: {out}.",
                HOW,
            )
            reply({**asdict(addresses), "rig": str(out)}, "\n".join(lines), as_json)
            _serve(positions)


def _serve(positions: CellPositions) -> None:
    """Place on the table what is typed, until Ctrl+C."""
    for line in sys.stdin:
        thing = line.strip()
        if thing in THINGS:
            positions.place_on_table(thing)
            say(f"On the table: {thing}.")
        elif thing:
            say(f"There is no {thing!r}. {HOW}")
    signal.pause()  # nothing more is typed
