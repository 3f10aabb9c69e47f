"""`rig check`: connection test of all devices of a rig."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.reply import JsonOption, TerminalProgress, reply
from measureapp.errors import DeviceError

if TYPE_CHECKING:
    from measureapp.data.rig import RigDescription


def register(app: typer.Typer) -> None:
    """Add the command group."""
    group = typer.Typer(help="The connected devices.", no_args_is_help=True)
    app.add_typer(group, name="rig")

    @group.callback()
    def about() -> None:
        """The connected devices."""

    @group.command()
    def check(
        rig: Annotated[str, typer.Argument(help="Rig description: a TOML file, or a name in resources/rigs.")],
        plugins: Annotated[Path | None, typer.Option(help="Folder of the plugins; default: those shipped with the program.")] = None,
        calibration: Annotated[
            Path | None, typer.Option("--calibration", help="Project whose calibration is checked for these cameras.")
        ] = None,
        as_json: JsonOption = False,
    ) -> None:
        """Connect every device of a rig and read its state back; nothing moves."""
        from measureapp.acquire.states import read_states
        from measureapp.devices.connect import connect_rig
        from measureapp.pipeline.validity import check_before_scan
        from measureapp.project.folder import ProjectFolder
        from measureapp.project.rig_file import read_rig

        description = read_rig(rig)
        known = None if calibration is None else ProjectFolder.open(calibration).require_calibration()
        connected = connect_rig(description, plugins)
        try:
            states = read_states(connected)
            problems = [state for state in states if not state.status.ready]
            validity = None if known is None or problems else check_before_scan(connected, known)
        finally:
            connected.close()
        if problems:
            found = " ".join(f"{state.name}: {state.status.text} {state.status.remedy}".strip() for state in problems)
            raise DeviceError(f"Rig {description.name}: {found}", "Check the cables and the power of these devices.")
        lines = [f"{state.name:<10} {state.kind:<13} {state.status.identity:<14} {state.status.text}".rstrip() for state in states]
        document: dict[str, Any] = {
            "rig": description.name,
            "drivers": description.drivers,
            "devices": [
                {"name": state.name, "kind": state.kind, "state": state.status.text, "identity": state.status.identity} for state in states
            ],
        }
        if validity is not None:
            document["calibration"] = {"warnings": list(validity.warnings), "temperature_c": validity.temperature_c}
            lines += [f"Calibration: {warning}" for warning in validity.warnings or ("matches these cameras and is valid.",)]
        reply(document, "\n".join(lines), as_json)

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
