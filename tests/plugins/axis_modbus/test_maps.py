"""Drives are data files: each shipped one is sound, and one that does not fit is refused by its field."""

from __future__ import annotations

from pathlib import Path

import pytest
from axis_peers import connect

from measureapp.devices.plugin_loader import load_driver
from measureapp.errors import InputError

SHIPPED = sorted(path.stem for path in (Path(__file__).parents[3] / "plugins/axis_modbus/drives").glob("*.toml"))


@pytest.fixture
def read_map():
    import sys

    load_driver(None, "axis_modbus", "linear-guide")
    return sys.modules["_measureapp_plugins.axis_modbus.drive_map"].read_map


@pytest.mark.parametrize("name", SHIPPED)
def test_every_shipped_map_is_complete_and_names_its_source(read_map, name: str) -> None:
    found = read_map(name)
    assert found.source
    assert found.sequences["stop"]


def test_what_is_known_from_memory_only_is_told(read_map) -> None:
    assert "position" in read_map("iai_pcon").uncertain
    assert not read_map("simple_axis").uncertain


@pytest.mark.parametrize(
    ("change", "named"),
    [
        (("goal = {", "gaol = {"), "registers.goal is not described"),
        (('value = "goal"', "value = 3"), "writes no goal"),
        (("words = 2", "words = 3"), "words"),
        (("equals = 0x4D41", "equals = 0x4D41\ndiffers = 1"), "either equals or differs"),
        (("framing", "farming"), "framing|farming"),
        (("[registers]", "[registers"), "cannot be read"),
    ],
)
def test_a_map_that_does_not_fit_is_refused_by_its_field(read_map, tmp_path: Path, change: tuple[str, str], named: str) -> None:
    text = (Path(__file__).parents[3] / "plugins/axis_modbus/drives/simple_axis.toml").read_text(encoding="utf-8")
    path = tmp_path / "mine.toml"
    path.write_text(text.replace(*change), encoding="utf-8")
    with pytest.raises(InputError, match=named):
        read_map(str(path))


def test_an_unknown_drive_is_refused_with_those_there_are() -> None:
    with pytest.raises(InputError, match="toyo_xc100"):
        connect("linear-guide", {"drive": "zeiss", "link": "bus"}, {"bus": {}})
