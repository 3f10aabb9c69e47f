"""`rig teach`: scale and sense of an axis from one step that a person observes."""

from __future__ import annotations

from dataclasses import asdict
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from measureapp.cli.reply import JsonOption, TerminalProgress, reply

if TYPE_CHECKING:
    from measureapp.data.rig import RigDescription

LARGEST_STEP = 10.0  # mm or degrees
UNITS: dict[str, Literal["mm", "degree"]] = {"guide": "mm", "table": "degree"}


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command("teach")
    def teach_axis(
        rig: Annotated[str, typer.Argument(help="Rig description: a TOML file, or a name in resources/rigs.")],
        axis: Annotated[Literal["guide", "table"], typer.Argument(help="The axis to move.")],
        step: Annotated[
            float, typer.Option(min=-LARGEST_STEP, max=LARGEST_STEP, help="Step in mm or degrees, at most 10; the axis really moves.")
        ] = 1.0,
        observed: Annotated[
            float | None, typer.Option(help="How far it went in the rig's positive direction; without it you are asked.")
        ] = None,
        uncertainty: Annotated[float, typer.Option(min=1e-6, help="Standard uncertainty of what you read off, in mm or degrees.")] = 0.1,
        as_json: JsonOption = False,
    ) -> None:
        """Move guide or table by one small step, and set its scale and sense from how far it really went.

        Watch the axis with a dial gauge, ruler or protractor, and keep a hand on the emergency stop.
        """
        from measureapp.acquire.jog import jog
        from measureapp.devices.connect import connect_rig
        from measureapp.devices.teaching import TeachingStep, teach
        from measureapp.project.rig_file import read_rig

        description = read_rig(rig)
        scale = _scale_of(description, axis)
        connected = connect_rig(description)
        try:
            jog(connected, axis, step, TerminalProgress())
        finally:
            connected.close()
        seen = typer.prompt(f"The {axis} was sent {step:g}. How far did it go?", type=float) if observed is None else observed
        found = teach(TeachingStep.of_units(step, *scale), seen, UNITS[axis], uncertainty)
        lines = (
            f"Write into [devices.{axis}.settings]:\n{found.settings_lines()}"
            f"The scale has a relative standard uncertainty of {found.relative_uncertainty:.2g}."
        )
        reply(asdict(found), lines, as_json)


def _scale_of(rig: RigDescription, axis: str) -> tuple[float, Literal[1, -1]]:
    """Return counts per unit and sense of an axis. Raises InputError where its settings do not state them."""
    from measureapp.errors import InputError

    settings = rig.devices[axis].settings if axis in rig.devices else {}
    counts = settings.get("counts_per_unit")
    if not isinstance(counts, int | float):
        raise InputError(
            f"The settings of the {axis} in {rig.name} state no counts_per_unit.", "Write the value of the drive's data sheet there first."
        )
    return float(counts), -1 if settings.get("sense", 1) == -1 else 1
