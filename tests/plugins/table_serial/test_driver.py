"""Rotary tables on a serial line: what goes out, what is believed, and what is told."""

from __future__ import annotations

import threading
import time
from math import radians
from pathlib import Path
from types import SimpleNamespace

import pytest
import serial
from axis_peers import serial_axis

from measureapp.devices.links import Links
from measureapp.devices.plugin_loader import load_driver
from measureapp.devices.request import DeviceRequest
from measureapp.errors import DeviceError, DeviceLost, InputError, LimitError, MotionError
from measureapp.peers.modbus_axis import Drive, DriveFaults
from measureapp.peers.serial_table import TableFaults, serial_table
from measureapp.progress import Cancelled
from measureapp.project.rig_file import read_rig

TABLES = Path(__file__).parents[3] / "plugins/table_serial/tables"


def connect(**settings: object) -> object:
    loaded = load_driver(None, "table_serial", "rotary-table")
    return loaded.entry(DeviceRequest("table", read_rig("paper"), loaded.settings.model_validate(settings), Links({})))


def test_a_foreign_client_reads_and_moves_the_virtual_table() -> None:
    drive = Drive(speed=1e9, acceleration=1e12)
    with serial_table(drive) as (_, port), serial.Serial(port, 9600, timeout=1) as client:
        client.write(b"1PA12.5\r")
        client.write(b"1MD?\r")
        client.readline()
        time.sleep(0.1)
        client.write(b"1TP\r")
        assert client.readline() == b"12.50000\r\n"


def test_a_move_is_one_absolute_command_followed_by_the_question_for_errors() -> None:
    with serial_axis() as found:
        found.device.move_to(radians(-30.0), timeout_s=10.0)
        sent = [line for line in found.peer.heard if line.startswith("1PA")]
        assert sent == ["1PA-30.0"]
        assert found.peer.heard[found.peer.heard.index("1PA-30.0") + 1] == "TE?"
        assert found.device.angle_rad() == pytest.approx(radians(-30.0), abs=1e-6)


def test_sense_and_zero_turn_the_controller_s_angle_into_the_rig_s() -> None:
    with serial_axis(sense=-1, zero_deg=10.0) as found:
        found.device.move_to(radians(30.0), timeout_s=10.0)
        assert found.drive.counts() == -20_000_000
        assert found.device.angle_rad() == pytest.approx(radians(30.0), abs=1e-6)


def test_a_refused_command_is_told_with_the_controller_s_words() -> None:
    with serial_axis() as found:
        found.peer.faults = TableFaults(error="38")
        with pytest.raises(MotionError, match=r"refused '1PA5\.0': '38'"):
            found.device.move_to(radians(5.0), timeout_s=5.0)


@pytest.mark.parametrize("goal_deg", [361.0, -1e9, float("nan")])
def test_an_angle_beyond_the_limits_is_refused_before_anything_is_sent(goal_deg: float) -> None:
    with serial_axis() as found:
        before = len(found.peer.heard)
        with pytest.raises(LimitError):
            found.device.move_to(radians(goal_deg), timeout_s=5.0)
        assert len(found.peer.heard) == before


def test_rest_told_early_is_not_believed() -> None:
    with serial_axis(speed_deg=100.0) as found:
        found.peer.faults = TableFaults(early_rest=True)
        found.device.move_to(radians(20.0), timeout_s=10.0)
        assert found.drive.counts() == pytest.approx(20e6, abs=500)


def test_a_table_that_rests_beside_its_goal_is_refused_with_the_distance() -> None:
    with serial_axis() as found:
        found.drive.faults = DriveFaults(off_counts=50_000)
        with pytest.raises(MotionError, match=r"0\.050° away from its goal"):
            found.device.move_to(radians(20.0), timeout_s=5.0)


def test_a_table_that_is_not_referenced_is_not_moved_before_it_is() -> None:
    with serial_axis("smc100") as found:
        found.peer.faults = TableFaults(referenced=False)
        assert not found.device.status().ready
        with pytest.raises(MotionError, match="not referenced"):
            found.device.move_to(radians(1.0), timeout_s=5.0)
        found.device.home(timeout_s=5.0)
        found.device.move_to(radians(1.0), timeout_s=5.0)


def test_a_late_reply_is_never_taken_for_the_next() -> None:
    with serial_axis(reply_timeout_s=0.15) as found:
        found.device.move_to(radians(7.0), timeout_s=5.0)
        found.peer.faults = TableFaults(late_s=0.25, late_once=True)
        for _ in range(10):
            assert found.device.angle_rad() == pytest.approx(radians(7.0), abs=1e-6)


def test_a_silent_controller_is_lost_within_two_time_outs() -> None:
    with serial_axis(reply_timeout_s=0.15) as found:
        found.peer.faults = TableFaults(silent=True)
        started = time.monotonic()
        with pytest.raises(DeviceLost, match="did not reply"):
            found.device.angle_rad()
        assert time.monotonic() - started < 3 * 0.15 + 0.3  # and the wait for a late reply


@pytest.mark.parametrize("garbage", [b"what?\r\n", b"\xff\xfe\r\n", bytes(500)])
def test_a_reply_that_is_none_is_refused(garbage: bytes) -> None:
    with serial_axis() as found:
        found.peer.faults = TableFaults(garbage=garbage)
        with pytest.raises(DeviceError, match="replied to '1TP' with"):
            found.device.angle_rad()


def test_a_reply_in_slices_is_understood() -> None:
    with serial_axis() as found:
        found.peer.faults = TableFaults(sliced=True)
        found.device.move_to(radians(3.0), timeout_s=10.0)
        assert found.device.angle_rad() == pytest.approx(radians(3.0), abs=1e-6)


def test_a_stop_from_another_thread_takes_effect_at_once_again_and_again() -> None:
    with serial_axis(speed_deg=5.0) as found:
        for _ in range(20):
            outcome: list[str] = []

            def move(outcome: list[str] = outcome) -> None:
                try:
                    found.device.move_to(radians(300.0), timeout_s=60.0)
                except Cancelled:
                    outcome.append("cancelled")

            moves = len(found.drive.moves)
            thread = threading.Thread(target=move)
            thread.start()
            while len(found.drive.moves) == moves:
                time.sleep(0.002)
            started = time.monotonic()
            found.device.stop()
            assert time.monotonic() - started < 0.2
            thread.join(2.0)
            assert outcome == ["cancelled"]


def test_an_adapter_is_found_by_its_serial_number_under_another_name(monkeypatch: pytest.MonkeyPatch) -> None:
    with serial_table(Drive()) as (_, port):
        adapters = [SimpleNamespace(serial_number="A50285BI", device=port)]
        monkeypatch.setattr("serial.tools.list_ports.comports", lambda: adapters)
        table = connect(controller="esp301", usb_serial="A50285BI")
        assert table.angle_rad() == 0.0  # type: ignore[attr-defined]
        table.close()  # type: ignore[attr-defined]
        with pytest.raises(DeviceError, match=r"'B1' was found \(adapters here: .*A50285BI"):
            connect(controller="esp301", usb_serial="B1")


def test_a_port_that_does_not_exist_is_told() -> None:
    with pytest.raises(DeviceError, match="cannot be opened"):
        connect(controller="esp301", port="/dev/no-such-port")


@pytest.mark.parametrize("name", sorted(path.stem for path in TABLES.glob("*.toml")))
def test_every_shipped_table_is_complete(name: str) -> None:
    with pytest.raises(DeviceError, match="cannot be opened"):  # it was read before
        connect(controller=name, port="/dev/no-such-port")


@pytest.mark.parametrize(
    ("change", "named"),
    [
        (("(?P<value>", "(?P<angle>"), "needs a group"),
        (("(?P<value>", "(?P<value"), "no regular expression"),
        (('stop = "1ST"\n', ""), "commands.stop"),
        (("baudrate", "boardrate"), "baudrate|boardrate"),
    ],
)
def test_a_table_that_does_not_fit_is_refused_by_its_field(tmp_path: Path, change: tuple[str, str], named: str) -> None:
    text = (TABLES / "esp301.toml").read_text(encoding="utf-8")
    path = tmp_path / "mine.toml"
    path.write_text(text.replace(*change), encoding="utf-8")
    with pytest.raises(InputError, match=named):
        connect(controller=str(path), port="/dev/no-such-port")
