"""Controllers are data files: each shipped one is sound, one that does not fit is refused by its field, and every field has its effect."""

from __future__ import annotations

import sys
from collections.abc import Callable
from math import radians
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
import serial.tools.list_ports
from serial_tables import connect

from measureapp.devices.plugin_loader import load_driver
from measureapp.errors import DeviceError, DeviceLost, InputError, MotionError
from measureapp.peers.serial_controllers import Esp301, Shot, Smc100
from measureapp.peers.serial_table import TableAxis, TableFaults, on_serial

FOLDER = Path(__file__).parents[3] / "plugins/table_serial/controllers"
SHIPPED = sorted(path.stem for path in FOLDER.glob("*.toml"))
FAST_AXIS = (0.0, 3000.0, 60_000.0)
FAST = {"speed": 3000.0, "acceleration": 60_000.0}


@pytest.fixture
def read_table() -> Callable[[str], Any]:
    load_driver(None, "table_serial", "rotary-table")
    return sys.modules["_measureapp_plugins.table_serial.command_table"].read_table


def changed(folder: Path, name: str, *changes: tuple[str, str]) -> str:
    text = (FOLDER / f"{name}.toml").read_text(encoding="utf-8")
    for change in changes:
        assert change[0] in text
        text = text.replace(*change)
    path = folder / "mine.toml"
    path.write_text(text, encoding="utf-8")
    return str(path)


@pytest.mark.parametrize("name", SHIPPED)
def test_every_shipped_table_names_its_source_and_what_is_uncertain(read_table: Callable[[str], Any], name: str) -> None:
    found = read_table(name)
    assert found.source
    assert found.uncertain
    assert set(found.uncertain) <= {*found.queries, *found.sequences, *type(found).model_fields}


@pytest.mark.parametrize(
    ("change", "named"),
    [
        (("position = {", "place = {"), "queries.position with a group value"),
        ((r"(?P<value>[01])", r"(?P<value>[01]"), "not a regular expression"),
        ((r"(?P<value>[01])", r"[01]"), "needs a named group"),
        (("{goal}", "{gaol}"), "sends no goal"),
        (("VA{speed}", "VA{velocity}"), "unknown place 'velocity'"),
        (('query = "done"', 'query = "finished"'), "conditions.moving names a query"),
        (('matches = "0"', 'matches = "0", differs = "1"'), "either matches or differs"),
        (("refused = {", "enabled2 = {"), "enabled2"),
        (('refused = { query = "error", differs = "0" }', ""), "conditions.refused or acknowledge"),
        (('stop = ["{axis}ST"]', ""), "sequences.stop is not described"),
        (("terminator", "terminated"), "terminated"),
        (("[queries]", "[queries"), "cannot be read"),
    ],
)
def test_a_table_that_does_not_fit_is_refused_by_its_field(
    read_table: Callable[[str], Any], tmp_path: Path, change: tuple[str, str], named: str
) -> None:
    with pytest.raises(InputError, match=named):
        read_table(changed(tmp_path, "newport_esp301", change))


def test_an_unknown_controller_is_refused_with_those_there_are() -> None:
    with pytest.raises(InputError, match="newport_esp301, newport_smc100"):
        connect({"controller": "zeiss"}, {"port": "/dev/null"})


def test_an_unknown_setting_of_the_line_is_refused_by_name() -> None:
    with pytest.raises(InputError, match="speed: is not a known field"):
        connect({"controller": "newport_smc100"}, {"port": "/dev/null", "speed": 9600})


def test_a_controller_that_repeats_commands_is_understood(tmp_path: Path) -> None:
    table = changed(tmp_path, "sigma_koki_shot", ("decimals", "echo = true\ndecimals"))
    axis = TableAxis(0.0, 1e6, 1e8)
    with on_serial(Shot(axis, echo=True)) as port:
        device, shared = connect({"controller": table, "absolute_encoder": True, **FAST}, {"port": port})
        device.move_to(radians(90.0), timeout_s=10.0)
        assert axis.moves == [36_000]
        device.stop()
        assert device.angle_rad() == pytest.approx(radians(90.0))
        axis.faults = TableFaults(garbage=b"RUBBISH\r\n")
        with pytest.raises(DeviceError, match="did not repeat"):
            device.angle_rad()
        shared.close()


class OneTurn(Smc100):
    """An SMC100 whose position returns to 0 after one turn."""

    def _tell(self, mnemonic: str, value: str) -> str | None:
        return f"{self.axis.told_position() % 360.0:.4f}" if mnemonic == "TP" else super()._tell(mnemonic, value)


def test_a_position_that_returns_to_0_after_one_turn_is_read_inside_the_limits(tmp_path: Path) -> None:
    table = changed(tmp_path, "newport_smc100", ("decimals", 'turns = "modulo"\ndecimals'))
    axis = TableAxis(*FAST_AXIS)
    with on_serial(OneTurn(axis)) as port:
        device, shared = connect({"controller": table, **FAST}, {"port": port}, limits_deg=(-170.0, 170.0))
        for goal_deg in (-90.0, 90.0, -0.001, 170.0, -170.0):
            device.move_to(radians(goal_deg), timeout_s=10.0)
            assert device.angle_rad() == pytest.approx(radians(goal_deg), abs=radians(0.001))
        assert axis.moves == [270.0, 90.0, 359.999, 170.0, 190.0]
        shared.close()


def test_limits_of_a_whole_turn_do_not_determine_a_position_that_returns_to_0(tmp_path: Path) -> None:
    table = changed(tmp_path, "newport_smc100", ("decimals", 'turns = "modulo"\ndecimals'))
    with pytest.raises(InputError, match="do not determine the turn"):
        connect({"controller": table}, {"port": "/dev/null"}, limits_deg=(-180.0, 180.0))


def test_a_motor_that_stays_off_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Esp301, "_do", lambda *_: None)
    with on_serial(Esp301(TableAxis())) as port, pytest.raises(DeviceError, match="does not switch its motor on"):
        connect({"controller": "newport_esp301"}, {"port": port})


def test_two_programs_cannot_use_one_port() -> None:
    with on_serial(Smc100(TableAxis())) as port:
        _, shared = connect({"controller": "newport_smc100"}, {"port": port})
        with pytest.raises(DeviceError, match=r"cannot be opened.* no other program uses it"):
            connect({"controller": "newport_smc100"}, {"port": port})
        shared.close()


def test_an_adapter_that_returns_under_another_name_is_found_by_its_serial_number(monkeypatch: pytest.MonkeyPatch) -> None:
    settings = {"controller": "newport_esp301", **FAST}

    def plug(*entries: tuple[str, str | None]) -> None:
        here = [SimpleNamespace(serial_number=number, device=device) for device, number in entries]
        monkeypatch.setattr(serial.tools.list_ports, "comports", lambda: here)

    axis, link = TableAxis(*FAST_AXIS), {"usb_serial": "FT1AB2"}
    with on_serial(Esp301(axis)) as first:
        plug(("/dev/ttyS0", None), (first, "FT1AB2"))
        table, shared = connect(settings, link)
        table.home(timeout_s=10.0)
        table.move_to(radians(1.0), timeout_s=5.0)
    with pytest.raises(DeviceLost, match="find the reference anew"):
        for _ in range(2):
            table.angle_rad()
    shared.close()
    with on_serial(Esp301(axis)) as second:
        plug(("/dev/ttyUSB7", "OTHER"), (second, "FT1AB2"))
        table, shared = connect(settings, link)
        assert table.angle_rad() == pytest.approx(radians(1.0))
        with pytest.raises(MotionError, match="not referenced"):
            table.move_to(radians(2.0), timeout_s=5.0)
        table.home(timeout_s=10.0)
        table.move_to(radians(2.0), timeout_s=5.0)
        shared.close()
    plug(("/dev/ttyUSB7", "OTHER"))
    with pytest.raises(DeviceError, match=r"'FT1AB2' was found \(adapters here: /dev/ttyUSB7 \(OTHER\)\)"):
        connect(settings, link)
