"""`rig teach`: scale and sense of an axis from one step that a person observes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Literal

import typer

from measureapp.cli.reply import JsonOption, TerminalProgress, reply

if TYPE_CHECKING:
    from measureapp.data.rig import RigDescription

LARGEST_STEP = 10.0  # mm or degrees


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command()
    def teach(
        rig: Annotated[str, typer.Argument(help="Rig description: a TOML file, or a name in resources/rigs.")],
        axis: Annotated[Literal["guide", "table"], typer.Argument(help="The axis to move.")],
        step: Annotated[
            float, typer.Option(min=-LARGEST_STEP, max=LARGEST_STEP, help="Step in mm or degrees, at most 10; the axis really moves.")
        ] = 1.0,
        observed: Annotated[
            float | None, typer.Option(help="How far it went in the rig's positive direction; without it you are asked.")
        ] = None,
        as_json: JsonOption = False,
    ) -> None:
        """Move guide or table by one small step, and set its scale and sense from how far it really went.

        Watch the axis with a dial gauge, ruler or protractor, and keep a hand on the emergency stop.
        """
        from measureapp.acquire.jog import jog
        from measureapp.devices.connect import connect_rig
        from measureapp.devices.teaching import teach_scale
        from measureapp.project.rig_file import read_rig

        description = read_rig(rig)
        scale = _scale_of(description, axis)
        connected = connect_rig(description)
        try:
            jog(connected, axis, step, TerminalProgress())
        finally:
            connected.close()
        seen = typer.prompt(f"The {axis} was sent {step:g}. How far did it go?", type=float) if observed is None else observed
        found = teach_scale(step, seen, *scale)
        lines = f"Write into [devices.{axis}.settings]:\n{found.lines()}"
        reply({"counts_per_unit": found.counts_per_unit, "sense": found.sense}, lines, as_json)


def _scale_of(rig: RigDescription, axis: str) -> tuple[float, int]:
    """Return counts per unit and sense of an axis. Raises InputError where its settings do not state them."""
    from measureapp.errors import InputError

    settings = rig.devices[axis].settings if axis in rig.devices else {}
    counts = settings.get("counts_per_unit")
    if not isinstance(counts, int | float):
        raise InputError(
            f"The settings of the {axis} in {rig.name} state no counts_per_unit.", "Write the value of the drive's data sheet there first."
        )
    return float(counts), int(str(settings.get("sense", 1)))
