"""`rig latency`: how late the projector shows an image."""

from __future__ import annotations

from dataclasses import asdict
from typing import TYPE_CHECKING, Annotated

import typer

from measureapp.cli.reply import JsonOption, TerminalProgress, reply

if TYPE_CHECKING:
    from measureapp.data.rig import RigDescription


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command()
    def latency(
        rig: Annotated[str, typer.Argument(help="Rig description: a TOML file, or a name in resources/rigs.")],
        flips: Annotated[int, typer.Option(min=10, max=500, help="Changes between black and white.")] = 50,
        hold_s: Annotated[float, typer.Option("--hold-s", min=0.05, max=5.0, help="How long each is shown.")] = 0.6,
        as_json: JsonOption = False,
    ) -> None:
        """Measure with a camera how late the projector shows an image; nothing moves.

        Point the head at a bright surface first. A setting latency_s of the projector is taken as 0 meanwhile.
        """
        from measureapp.acquire.latency import measure_projector_latency
        from measureapp.devices.connect import connect_rig
        from measureapp.project.rig_file import read_rig

        connected = connect_rig(_without_latency(read_rig(rig)))
        try:
            found = measure_projector_latency(connected, TerminalProgress(), flips=flips, hold_s=hold_s)
        finally:
            connected.close()
        words = f"Latency {found.smallest_s * 1e3:.0f} to {found.largest_s * 1e3:.0f} ms, median {found.median_s * 1e3:.0f} ms."
        advice = f"Set `latency_s = {found.wait_s:.3f}` in the settings of the projector."
        reply(asdict(found), f"{words} {advice}", as_json)


def _without_latency(rig: RigDescription) -> RigDescription:
    """Return the rig with a projector that is not waited for, where its driver has such a setting."""
    choice = rig.devices.get("projector")
    if choice is None or "latency_s" not in choice.settings:
        return rig
    bare = choice.model_copy(update={"settings": {**choice.settings, "latency_s": 0.0}})
    return rig.model_copy(update={"devices": {**rig.devices, "projector": bare}})
