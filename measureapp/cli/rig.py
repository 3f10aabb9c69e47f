"""`rig check`: connection test of all devices of a rig."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.reply import JsonOption, reply
from measureapp.errors import DeviceError, MeasureError

if TYPE_CHECKING:
    from measureapp.devices.rig import Rig


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
        from measureapp.devices.connect import connect_rig
        from measureapp.pipeline.validity import check_before_scan
        from measureapp.project.folder import ProjectFolder
        from measureapp.project.rig_file import read_rig

        description = read_rig(rig)
        known = None if calibration is None else ProjectFolder.open(calibration).require_calibration()
        connected = connect_rig(description, plugins)
        try:
            devices, problems = read_all(connected)
            validity = None if known is None or problems else check_before_scan(connected, known)
        finally:
            connected.close()
        if problems:
            raise DeviceError(f"Rig {description.name}: " + " ".join(problems), "Check the cables and the power of these devices.")
        width = max(len(device["name"]) for device in devices)
        lines = [f"{device['name']:<{width}}  {device['kind']:<13} {device['state']}" for device in devices]
        document: dict[str, Any] = {"rig": description.name, "driver": description.driver, "devices": devices}
        if validity is not None:
            document["calibration"] = {"warnings": list(validity.warnings), "temperature_c": validity.temperature_c}
            lines += [f"Calibration: {warning}" for warning in validity.warnings or ("matches these cameras and is valid.",)]
        reply(document, "\n".join(lines), as_json)


def read_all(rig: Rig) -> tuple[list[dict[str, Any]], list[str]]:
    """Read every device back; return their states, and the problems of those that did not answer."""
    questions: list[tuple[str, str, Callable[[], str]]] = [
        *((name, "camera", lambda camera=camera: camera_state(camera)) for name, camera in rig.cameras.items()),
        (
            rig.projector.name,
            "projector",
            lambda: f"{rig.projector.width_px} × {rig.projector.height_px} px, shows image {rig.projector.shown()}",
        ),
        (rig.robot.name, "robot", lambda: "flange at {:.1f} {:.1f} {:.1f} mm".format(*rig.robot.pose().translation_mm)),
        (rig.guide.name, "linear guide", lambda: f"at {rig.guide.position_mm():.2f} mm"),
        (rig.table.name, "rotary table", lambda: f"at {math.degrees(rig.table.angle_rad()):.4f}°"),
    ]
    devices, problems = [], []
    for name, kind, ask in questions:
        try:
            devices.append({"name": name, "kind": kind, "state": ask()})
        except MeasureError as error:
            problems.append(f"{name}: {error}")
    return devices, problems


def camera_state(camera: Any) -> str:
    """Describe the state of a camera."""
    temperature_c = camera.temperature_c()
    temperature = "no thermometer" if temperature_c is None else f"{temperature_c:.1f} °C"
    return f"{camera.serial}, {camera.width_px} × {camera.height_px} px, exposure {camera.exposure_us()} µs, {temperature}"
