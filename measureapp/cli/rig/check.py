"""`rig check`: connection test of all devices of a rig."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from measureapp.cli.reply import JsonOption, reply
from measureapp.errors import DeviceError


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command()
    def check(
        rig: Annotated[str, typer.Argument(help="Rig description: a TOML file, or a name in resources/rigs.")],
        plugins: Annotated[
            Path | None, typer.Option(help="Folder of the plugins; default: the program's and ~/MeasureApp/plugins.")
        ] = None,
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
