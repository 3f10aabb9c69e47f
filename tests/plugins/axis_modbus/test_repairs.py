"""Cases at the edges: broken frames, drives that say little, stops between two writes, links that are gone."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import pytest
import serial.tools.list_ports
from axis_peers import Connected, connect, simple_table, toyo_guide

from measureapp.errors import DeviceError, DeviceLost, LimitError, MotionError
from measureapp.peers.modbus_axis import Drive, DriveFaults, SimpleMemory, ToyoMemory
from measureapp.peers.modbus_device import Framing, Kind, LineFaults, ModbusDevice, Refused, on_serial
from measureapp.progress import Cancelled

LOW_FIRST = """
name = "Low words first, bits in a shared register, no word of moving"
source = "this test"
framing = "rtu"
word_order = "low-first"
counts_per_unit = 100.0

[registers]
position = { address = 0x10, words = 2, signed = true }
goal = { address = 0x12, words = 2, signed = true }
input = { address = 0x14, words = 2 }
status = { address = 0x16 }

[conditions]
in_position = { register = "status", mask = 1, equals = 1 }
homed = { register = "status", mask = 2, equals = 2 }

[sequences]
move = [{ write = "goal", value = "goal" }, { write = "input", value = 1, bits = 0x0001 }, { write = "input", value = 0, bits = 0x0001 }]
stop = [{ write = "input", value = 2, bits = 0x0002 }, { write = "input", value = 0, bits = 0x0002 }]
home = [{ write = "input", value = 4, bits = 0x0004 }, { write = "input", value = 0, bits = 0x0004 }]
"""


class LowFirstMemory:
    """The drive of this map; bits 0, 1, 2 of its input start, stop and home, the others belong to somebody else."""

    def __init__(self, drive: Drive) -> None:
        self.drive = drive
        self.input = [0x0080, 0xA000]

    def read(self, kind: Kind, address: int) -> int:
        drive = self.drive
        counts = drive.told_counts()
        known = {0x10: counts & 0xFFFF, 0x11: counts >> 16 & 0xFFFF, 0x12: drive.word(0x12), 0x13: drive.word(0x13)}
        known |= {0x14: self.input[0], 0x15: self.input[1], 0x16: int(not drive.told_moving()) | drive.faults.homed << 1}
        if kind != "holding" or address not in known:
            raise Refused(2)
        return known[address]

    def write(self, kind: Kind, address: int, value: int) -> None:
        if address in (0x12, 0x13):
            self.drive.keep(address, value)
        elif address == 0x15:
            self.input[1] = value
        elif address == 0x14:
            rising, self.input[0] = value & ~self.input[0], value
            goal = self.drive.word(0x13) << 16 | self.drive.word(0x12)
            if rising & 1:
                self.drive.start(goal - (1 << 32) if goal >> 31 else goal)
            if rising & 2:
                self.drive.stop()
            if rising & 4:
                self.drive.find_reference()


@contextmanager
def low_first(tmp_path: Path, speed_mm: float = 2000.0) -> Iterator[tuple[Connected, LowFirstMemory]]:
    path = tmp_path / "low.toml"
    path.write_text(LOW_FIRST, encoding="utf-8")
    drive = Drive(speed=100 * speed_mm, acceleration=2000 * speed_mm)
    memory = LowFirstMemory(drive)
    peer = ModbusDevice(memory)
    with on_serial(peer, "rtu") as port:
        settings = {"drive": str(path), "link": "bus", "speed": speed_mm, "acceleration": 20 * speed_mm, "poll_s": 0.002, "settled_s": 0.02}
        guide, shared = connect("linear-guide", settings, {"bus": {"port": port}})
        yield Connected(guide, peer, drive), memory
        shared.close()


@pytest.mark.parametrize("framing", ["rtu", "ascii"])
def test_frames_with_a_flipped_bit_are_never_taken_for_values(framing: Framing) -> None:
    with toyo_guide(framing=framing) as found:
        found.drive.start(4321)
        time.sleep(0.1)
        found.peer.faults = LineFaults(broken=True)
        for _ in range(3):
            with pytest.raises(DeviceError, match="received"):
                found.device.position_mm()


def test_low_words_first_and_bits_of_a_shared_register(tmp_path: Path) -> None:
    with low_first(tmp_path) as (found, memory):
        for goal_mm in (-650.0, 600.0):
            found.device.move_to(goal_mm, timeout_s=10.0)
            assert found.device.position_mm() == pytest.approx(goal_mm, abs=0.011)
        assert found.drive.moves == [-65_000, 60_000]
        found.device.stop()
        assert memory.input == [0x0080, 0xA000]


def test_a_drive_that_reports_only_in_position_is_followed_to_its_goal(tmp_path: Path) -> None:
    with low_first(tmp_path, speed_mm=200.0) as (found, _):
        found.device.move_to(20.0, timeout_s=10.0)
        assert abs(found.drive.counts() - 2000) <= 2
        found.drive.faults = DriveFaults(early_in_position=True)
        found.device.move_to(40.0, timeout_s=10.0)
        assert abs(found.drive.counts() - 4000) <= 2
        found.drive.faults = DriveFaults(off_counts=30)
        with pytest.raises(MotionError, match=r"rest 0\.300 away"):
            found.device.move_to(20.0, timeout_s=10.0)


def test_bits_are_changed_from_a_value_that_was_read_not_from_a_late_answer(tmp_path: Path) -> None:
    with low_first(tmp_path) as (found, memory):
        found.peer.faults = LineFaults(late_s=0.25, late_once=True)
        found.device.move_to(3.0, timeout_s=10.0)
        assert found.drive.moves == [300]
        assert memory.input == [0x0080, 0xA000]


@pytest.mark.parametrize("commands", [1, 2])
def test_no_write_of_a_move_follows_a_stop(commands: int) -> None:
    """A stop that comes between the writes of a sequence must not be undone by those that remain."""
    with toyo_guide() as found:
        genuine = ToyoMemory.write
        seen = []

        def write(memory: ToyoMemory, kind: Kind, address: int, value: int) -> None:
            genuine(memory, kind, address, value)
            seen.append(address)
            if len(seen) == 2 * commands:  # two words per register
                found.device._axis._stops.stop()

        with pytest.MonkeyPatch.context() as patch, pytest.raises(Cancelled):
            patch.setattr(ToyoMemory, "write", write)
            found.device.move_to(5.0, timeout_s=5.0)
        assert not found.drive.moves
        assert len(seen) == 2 * commands


@pytest.mark.timed
def test_a_stop_goes_before_the_requests_of_others_that_wait_for_the_line() -> None:
    with toyo_guide(speed_mm=20.0, framing="rtu") as found:
        found.peer.faults = LineFaults(late_s=0.04)
        ends = threading.Event()

        def read() -> None:
            while not ends.is_set():
                found.device.position_mm()

        readers = [threading.Thread(target=read) for _ in range(4)]
        for reader in readers:
            reader.start()
        waits_s = []
        for _ in range(10):
            time.sleep(0.01)
            started = time.monotonic()
            found.device.stop()
            waits_s.append(time.monotonic() - started)
        ends.set()
        for reader in readers:
            reader.join()
        assert found.drive.stops == 10
        assert max(waits_s) < 0.2


@pytest.mark.timed
def test_a_stop_is_not_kept_waiting_by_the_line_being_drained() -> None:
    with toyo_guide(speed_mm=20.0, framing="rtu") as found:
        found.peer.faults = LineFaults(late_s=0.2, late_once=True)
        reading = threading.Thread(target=found.device.position_mm)
        reading.start()
        time.sleep(0.21)  # its time-out is over, and the line is drained
        started = time.monotonic()
        found.device.stop()
        assert time.monotonic() - started < 0.2
        reading.join()


def test_whatever_ends_a_move_early_also_stops_the_drive() -> None:
    with simple_table(speed_deg=5.0) as found:
        genuine = found.drive.start

        def start(goal: int) -> None:
            genuine(goal)
            found.drive.faults = replace(found.drive.faults, alarm=2)

        found.drive.start = start  # type: ignore[method-assign]
        with pytest.raises(MotionError, match="following error"):
            found.device.move_to(1.0, timeout_s=5.0)
        assert found.drive.stops == 1


@pytest.mark.timed
def test_an_alarm_while_the_reference_is_searched_is_told_and_stops_the_drive() -> None:
    with simple_table() as found:
        found.drive.faults = DriveFaults(homed=False)

        def find_reference() -> None:
            found.drive.faults = DriveFaults(homed=False, alarm=1)

        found.drive.find_reference = find_reference  # type: ignore[method-assign]
        started = time.monotonic()
        with pytest.raises(MotionError, match="limit switch"):
            found.device.home(timeout_s=30.0)
        assert time.monotonic() - started < 2.0
        assert found.drive.stops == 1


def test_a_drive_that_cannot_report_its_reference_must_find_it_first() -> None:
    with toyo_guide(absolute_encoder=False) as found:
        assert found.device.status().text == "not referenced."
        with pytest.raises(MotionError, match="not referenced"):
            found.device.move_to(1.0, timeout_s=5.0)
        assert not found.drive.moves
        found.device.home(timeout_s=10.0)
        found.device.move_to(1.0, timeout_s=5.0)
        found.device.home(timeout_s=10.0)
        assert found.drive.moves == [0, 100]


def test_a_servo_that_stays_off_is_told() -> None:
    with pytest.MonkeyPatch.context() as patch, pytest.raises(DeviceError, match="does not switch its servo on"):
        patch.setattr(SimpleMemory, "_enable", lambda _: None)
        with simple_table():
            pass


@pytest.mark.parametrize("settings", [{"zero_counts": 2**31 - 10}, {"counts_per_unit": 1e8}, {"speed": 1e9}])
def test_a_value_that_a_register_cannot_hold_is_refused_instead_of_cut_off(settings: dict[str, object]) -> None:
    with toyo_guide() as found:
        pass
    drive = Drive()
    with on_serial(ModbusDevice(ToyoMemory(drive)), "ascii") as port:
        guide, shared = connect(
            "linear-guide", {"drive": "toyo_xc100", "link": "bus", "absolute_encoder": True, **settings}, {"bus": {"port": port}}
        )
        with pytest.raises(LimitError, match="does not fit the register"):
            guide.move_to(500.0, timeout_s=5.0)
        shared.close()
    assert not drive.moves
    assert found.drive.moves == []


def test_a_station_that_is_silent_does_not_take_its_neighbour_along() -> None:
    first, second = ModbusDevice(ToyoMemory(Drive()), 1), ModbusDevice(ToyoMemory(Drive()), 2)
    genuine = first.answer
    first.answer = lambda unit_id, pdu: second.answer(unit_id, pdu) if unit_id == 2 else genuine(unit_id, pdu)  # type: ignore[method-assign]
    with on_serial(first, "rtu") as port:
        line = {"bus": {"port": port, "framing": "rtu"}}
        common = {"drive": "toyo_xc100", "link": "bus", "absolute_encoder": True}
        guide, shared = connect("linear-guide", common, line)
        from measureapp.devices.plugin_loader import load_driver
        from measureapp.devices.request import DeviceRequest
        from measureapp.project.rig_file import read_rig

        loaded = load_driver(None, "axis_modbus", "rotary-table")
        table = loaded.entry(DeviceRequest("table", read_rig("paper"), loaded.settings.model_validate({**common, "unit_id": 2}), shared))
        second.faults = LineFaults(silent=True)
        with pytest.raises(DeviceLost):
            table.angle_rad()
        assert guide.position_mm() == 0.0
        second.faults = LineFaults()
        with pytest.raises(DeviceLost, match="connect again"):
            table.angle_rad()  # what answers now may have lost its reference
        shared.close()


def test_a_closed_line_is_not_opened_again_by_a_call() -> None:
    with on_serial(ModbusDevice(ToyoMemory(Drive())), "ascii") as port:
        guide, shared = connect("linear-guide", {"drive": "toyo_xc100", "link": "bus"}, {"bus": {"port": port}})
        guide.close()
        guide.close()
        assert guide.position_mm() == 0.0  # the line belongs to the rig
        shared.close()
        for call in (guide.position_mm, guide.stop):
            with pytest.raises(DeviceLost, match="the line was closed"):
                call()


def test_an_adapter_that_returns_under_another_name_is_found_by_its_serial_number(monkeypatch: pytest.MonkeyPatch) -> None:
    settings = {"drive": "toyo_xc100", "link": "bus"}
    link = {"bus": {"usb_serial": "A50285BI", "reply_timeout_s": 0.1}}

    def plug(*entries: tuple[str, str | None]) -> None:
        here = [SimpleNamespace(serial_number=number, device=device) for device, number in entries]
        monkeypatch.setattr(serial.tools.list_ports, "comports", lambda: here)

    drive = Drive()
    with on_serial(ModbusDevice(ToyoMemory(drive)), "ascii") as first:
        plug(("/dev/ttyS0", None), (first, "A50285BI"))
        guide, shared = connect("linear-guide", {**settings, "absolute_encoder": True}, link)
        guide.move_to(1.0, timeout_s=5.0)
    with pytest.raises(DeviceLost, match="find the reference anew"):
        for _ in range(2):
            guide.position_mm()
    shared.close()
    with on_serial(ModbusDevice(ToyoMemory(drive)), "ascii") as second:
        plug(("/dev/ttyUSB7", "OTHER"), (second, "A50285BI"))
        guide, shared = connect("linear-guide", settings, link)
        assert guide.position_mm() == pytest.approx(1.0)
        assert not guide.status().ready  # its reference is unknown until it is found anew
        with pytest.raises(MotionError, match="not referenced"):
            guide.move_to(2.0, timeout_s=5.0)
        shared.close()
    plug(("/dev/ttyUSB7", "OTHER"))
    with pytest.raises(DeviceError, match=r"'A50285BI' was found \(adapters here: /dev/ttyUSB7 \(OTHER\)\)"):
        connect("linear-guide", settings, link)
    plug(("/dev/ttyUSB7", "A50285BI"), ("/dev/ttyUSB8", "A50285BI"))
    with pytest.raises(DeviceError, match="2 serial ports have the USB serial number"):
        connect("linear-guide", settings, link)
