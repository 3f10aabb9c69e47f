"""A rig is connected through the plugin its description names."""

from __future__ import annotations

from pathlib import Path

import pytest

from measureapp.devices.connect import connect_rig
from measureapp.errors import DeviceError, InputError, PluginError
from measureapp.project.rig_file import read_rig

MANIFEST = 'id = "{id}"\nname = "A rig"\nversion = "1"\napi = 1\nkind = "{kind}"\nentry = "driver:connect"\n'


def connected(folder: Path, driver: str, kind: str = "rig") -> object:
    name = folder.name
    (folder / name).mkdir()
    (folder / name / "plugin.toml").write_text(MANIFEST.format(id=name, kind=kind), encoding="utf-8")
    (folder / name / "driver.py").write_text(driver, encoding="utf-8")
    description = read_rig("paper").model_copy(update={"driver": name, "driver_settings": {"port": 3}})
    return connect_rig(description, folder)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    home = tmp_path / "some_rig"
    home.mkdir()
    return home


def test_the_driver_gets_the_description_and_its_settings(folder: Path) -> None:
    description, settings = connected(folder, "def connect(description, settings): return description, settings")
    assert description.name == read_rig("paper").name
    assert settings == {"port": 3}


def test_a_driver_that_fails_without_words_becomes_a_device_failure(folder: Path) -> None:
    with pytest.raises(DeviceError, match="TimeoutError: nobody answers"):
        connected(folder, "def connect(description, settings): raise TimeoutError('nobody answers')")


def test_a_driver_s_own_words_are_kept(folder: Path) -> None:
    driver = "from measureapp.errors import InputError\ndef connect(description, settings): raise InputError('no such port', 'name one')"
    with pytest.raises(InputError, match="no such port"):
        connected(folder, driver)


def test_a_plugin_of_a_single_device_is_not_taken_for_a_rig(folder: Path) -> None:
    with pytest.raises(PluginError, match="drives a camera, not a rig"):
        connected(folder, "def connect(description, settings): return 1", kind="camera")
