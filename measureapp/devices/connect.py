"""Connecting a rig through its driver plugin."""

from __future__ import annotations

from pathlib import Path

from measureapp.data.rig import RigDescription
from measureapp.devices.plugin_loader import load_plugin
from measureapp.devices.recorded_rig import require_devices
from measureapp.devices.rig import Rig
from measureapp.errors import DeviceError, MeasureError, PluginError


def connect_rig(description: RigDescription, plugins: Path | None = None) -> Rig:
    """Connect all devices of a rig through the plugin named in its description; the caller closes it.

    Parameters
    ----------
    plugins : folder of the plugins; None: those shipped with the program

    Raises
    ------
    PluginError
        The plugin cannot be loaded, or is not a rig driver.
    DeviceError
        A device does not answer, or the driver raised an unexpected exception.
    """
    require_devices(description)
    plugin = load_plugin(plugins, description.driver)
    if plugin.manifest.kind != "rig":
        raise PluginError(
            f"Rig {description.name}: the plugin {description.driver} drives a {plugin.manifest.kind}, not a rig.",
            "Set `driver` of the rig description to a plugin of kind rig.",
        )
    try:
        return plugin.entry(description, description.driver_settings)
    except MeasureError:
        raise
    except Exception as error:  # foreign code may raise anything
        raise DeviceError(
            f"Rig {description.name}: its driver {description.driver} failed: {type(error).__name__}: {error}.",
            "Check that the devices are on and connected; if they are, report the error to the author of the driver.",
        ) from error
