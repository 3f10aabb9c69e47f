"""Connecting a rig through the plugin that drives it."""

from __future__ import annotations

from pathlib import Path

from measureapp.data.rig import RigDescription
from measureapp.devices.plugin_loader import load_plugin
from measureapp.devices.rig import Rig
from measureapp.errors import DeviceError, MeasureError, PluginError


def connect_rig(description: RigDescription, plugins: Path | None = None) -> Rig:
    """Connect all devices of a rig by the plugin its description names; the caller closes it.

    Parameters
    ----------
    plugins : folder of the plugins; None: those that come with the program

    Raises
    ------
    PluginError
        The plugin cannot be loaded, or drives something smaller than a rig.
    DeviceError
        A device does not answer, or the driver failed in a way it does not explain.
    """
    plugin = load_plugin(plugins, description.driver)
    if plugin.manifest.kind != "rig":
        raise PluginError(
            f"Rig {description.name}: the plugin {description.driver} drives a {plugin.manifest.kind}, not a rig.",
            "Name a plugin of kind rig as `driver` of the rig description.",
        )
    try:
        return plugin.entry(description, description.driver_settings)
    except MeasureError:
        raise
    except Exception as error:  # foreign code may raise anything
        raise DeviceError(
            f"Rig {description.name}: its driver {description.driver} failed: {type(error).__name__}: {error}.",
            "Check that the devices are on and connected; if they are, the driver is at fault.",
        ) from error
