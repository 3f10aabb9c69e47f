"""Connecting a rig: by one plugin for all of it, or device by device as its description says."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from measureapp.data.model import first_problem
from measureapp.data.rig import RigDescription
from measureapp.devices.links import Links
from measureapp.devices.plugin_loader import PluginKind, load_driver
from measureapp.devices.recorded_rig import require_devices
from measureapp.devices.request import DeviceRequest
from measureapp.devices.rig import Rig
from measureapp.devices.rig_lock import hold_rig
from measureapp.errors import DeviceError, InputError, MeasureError

KINDS: Mapping[str, PluginKind] = {"projector": "projector", "robot": "robot", "guide": "linear-guide", "table": "rotary-table"}


def connect_rig(description: RigDescription, plugins: Path | None = None, given: Mapping[str, object] | None = None) -> Rig:
    """Connect all devices of a rig; the caller closes it.

    Parameters
    ----------
    plugins : folder of the plugins; None: those shipped with the program and those of this user
    given : links that exist already, by name

    Raises
    ------
    PluginError
        A plugin cannot be loaded, or drives another kind of device.
    DeviceError
        Devices do not answer, or a driver raised an unexpected exception; names all of them at once. Those connected are closed again.
        Or another program has connected one of the devices, see `rig_lock`; nothing was sent to any of them then.
    InputError
        A setting of a driver is invalid.
    """
    require_devices(description)
    let_go = hold_rig(description)
    try:
        rig = _connect_all(description, Links(description.links, given), plugins)
    except BaseException:
        let_go()
        raise
    return replace(rig, release=_in_turn(rig.release, let_go))


def _in_turn(first: Callable[[], None], last: Callable[[], None]) -> Callable[[], None]:
    def both() -> None:
        try:
            first()
        finally:
            last()

    return both


def _connect_all(description: RigDescription, links: Links, plugins: Path | None) -> Rig:
    if description.driver:
        request = ("rig", description.driver, description.driver_settings)
        whole: Rig = _connect("rig", *request, description, links, plugins)
        return whole
    connected: dict[str, Any] = {}
    problems: list[MeasureError] = []
    for name, choice in description.devices.items():
        try:
            connected[name] = _connect(KINDS.get(name, "camera"), name, choice.driver, choice.settings, description, links, plugins)
        except MeasureError as error:
            problems.append(error)
    if problems:
        _close(connected, links)
        raise _gather(description.name, problems)
    return Rig(
        description=description,
        cameras={camera.name: connected[camera.name] for camera in description.cameras},
        projector=connected["projector"],
        robot=connected["robot"],
        guide=connected["guide"],
        table=connected["table"],
        place_on_table=lambda _: None,  # a person puts the part there
        release=links.close,
    )


def _connect(
    kind: PluginKind,
    name: str,
    driver: str,
    settings: Mapping[str, object],
    rig: RigDescription,
    links: Links,
    plugins: Path | None,
) -> Any:
    loaded = load_driver(plugins, driver, kind)
    place = "driver_settings" if kind == "rig" else f"[devices.{name}] settings"
    try:
        chosen = loaded.settings.model_validate(dict(settings))
    except ValidationError as error:
        raise InputError(
            f"Rig {rig.name}: {place}: {first_problem(error, 'the settings')} (driver {driver}).", "Correct it in the rig description."
        ) from error
    try:
        return loaded.entry(DeviceRequest(name, rig, chosen, links))
    except MeasureError:
        raise
    except Exception as error:  # foreign code may raise anything
        raise DeviceError(
            f"Rig {rig.name}: the driver {driver} of {name} failed: {type(error).__name__}: {error}.",
            "Check that the device is on and connected; if it is, report the error to the author of the driver.",
        ) from error


def _gather(rig: str, problems: list[MeasureError]) -> MeasureError:
    """Return one error that names every device that could not be connected."""
    if len(problems) == 1:
        return problems[0]
    kind = InputError if all(isinstance(problem, InputError) for problem in problems) else DeviceError
    return kind(f"Rig {rig}: {len(problems)} devices cannot be connected. " + " ".join(map(str, problems)))


def _close(connected: Mapping[str, Any], links: Links) -> None:
    for device in connected.values():
        device.close()
    links.close()
