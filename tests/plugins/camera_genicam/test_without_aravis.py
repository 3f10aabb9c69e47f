"""Where Aravis is missing, connecting says what to install, and nothing is left running."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from genicam_camera import NAME, rig_with

from measureapp.devices.links import Links
from measureapp.devices.plugin_loader import load_driver
from measureapp.devices.request import DeviceRequest
from measureapp.errors import PluginError
from measureapp.resources import plugin_folder


def test_a_missing_library_is_named_with_the_package_to_install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("measureapp.devices.plugin_loader.is_allowed", lambda _folder: True)
    folder = tmp_path / "camera_genicam"
    shutil.copytree(plugin_folder() / "camera_genicam", folder, ignore=shutil.ignore_patterns("__pycache__"))
    bindings = folder / "aravis.py"
    bindings.write_text(bindings.read_text(encoding="utf-8").replace("libaravis-0.8", "libmissing-0.8"), encoding="utf-8")
    driver = load_driver(tmp_path, "camera_genicam", "camera")
    with pytest.raises(PluginError, match=rf"Camera {NAME}: The library Aravis 0\.8 is not installed.* apt-get install libaravis-0\.8-0"):
        driver.entry(DeviceRequest(NAME, rig_with(), driver.settings(), Links({})))
