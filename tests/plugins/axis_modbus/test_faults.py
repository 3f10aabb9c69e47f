"""What goes wrong with drives and lines: slower perhaps, never wrong, and told in words."""

from __future__ import annotations

import threading
import time
from contextlib import suppress

import pytest
from axis_peers import PATIENT_S, connect, simple_table, toyo_guide

from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout, LimitError, MotionError
from measureapp.peers.modbus_axis import Drive, DriveFaults, SimpleMemory, ToyoMemory
from measureapp.peers.modbus_device import Framing, LineFaults, ModbusDevice, on_serial, on_tcp
from measureapp.progress import Cancelled

FRAMINGS = pytest.mark.parametrize("framing", ["rtu", "ascii"])


@FRAMINGS
def test_a_command_whose_answer_is_late_is_carried_out_once(framing: Framing) -> None:
    with toyo_guide(framing=framing) as found:
        genuine = ToyoMemory.write

        def write(memory: ToyoMemory, kind: str, address: int, value: int) -> None:
            genuine(memory, kind, address, value)  # type: ignore[arg-type]
            if address == 0x201E and value == 1:
                found.peer.faults = LineFaults(late_s=0.3, late_once=True)

        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(ToyoMemory, "write", write)
            found.device.move_to(5.0, timeout_s=5.0)
        assert found.drive.moves == [500]
        assert found.device.position_mm() == pytest.approx(5.0)


@FRAMINGS
def test_after_a_late_answer_nothing_is_believed_before_the_identity_was_read(framing: Framing) -> None:
    with toyo_guide(framing=framing) as found:
        found.drive.start(1234)
        time.sleep(0.05)
        found.peer.faults = LineFaults(late_s=0.25, late_once=True)
        assert found.device.position_mm() == pytest.approx(12.34, abs=0.011)
        for _ in range(20):
            assert found.device.position_mm() == pytest.approx(12.34, abs=0.011)


def test_answers_that_stay_shifted_by_one_are_never_taken_for_positions() -> None:
    with simple_table() as found:
        found.peer.faults = LineFaults(shifted=True)
        with pytest.raises(DeviceError):
            found.device.move_to(1.0, timeout_s=2.0)
        assert found.drive.moves in ([], [round(1.0 * 57.29577951308232 * 1e4)])


@pytest.mark.parametrize(
    ("code", "words"),
    [
        (1, "does not know this function"),
        (2, "has no such register"),
        (3, "refuses this value"),
        (4, "failed while executing"),
        (11, "gateway"),
    ],
)
def test_exception_codes_become_sentences_and_stop(code: int, words: str) -> None:
    with toyo_guide() as found:
        found.peer.faults = LineFaults(refuse=code)
        before = found.peer.requests
        with pytest.raises(DeviceError, match=words):
            found.device.position_mm()
        assert found.peer.requests == before + 1


def test_a_drive_that_is_busy_is_asked_again() -> None:
    with toyo_guide() as found:
        found.peer.faults = LineFaults(refuse=6, refuse_times=3)
        assert found.device.position_mm() == 0.0
        found.peer.faults = LineFaults(refuse=6)
        with pytest.raises(DeviceError, match="is busy"):
            found.device.position_mm()


def test_a_position_that_never_changes_is_no_arrival_and_stops_the_drive() -> None:
    with toyo_guide() as found:
        found.drive.faults = DriveFaults(frozen=True)
        with pytest.raises((DeviceTimeout, MotionError), match=r"did not end|came to rest"):
            found.device.move_to(20.0, timeout_s=0.5)


@pytest.mark.timed
def test_a_move_that_never_ends_is_over_after_one_and_a_half_times_its_prediction_and_two_seconds() -> None:
    with toyo_guide(speed_mm=100.0) as found:
        found.drive.faults = DriveFaults(frozen=True)
        found.drive.told_moving = lambda: True  # type: ignore[method-assign]
        predicted_s = 20.0 / 100.0 + 100.0 / 2000.0  # constant speed, and the ramps at 20 times as much per second
        started = time.monotonic()
        with pytest.raises(DeviceTimeout, match=r"within 2\.[34]\d* s"):
            found.device.move_to(20.0, timeout_s=60.0)
        assert time.monotonic() - started < 1.5 * predicted_s + 2.0 + 0.5
        assert found.drive.stops


def test_in_position_told_early_is_not_believed() -> None:
    with toyo_guide(speed_mm=100.0) as found:
        found.drive.faults = DriveFaults(early_in_position=True)
        found.device.move_to(20.0, timeout_s=5.0)
        assert found.device.position_mm() == pytest.approx(20.0, abs=0.02)
        assert abs(found.drive.counts() - 2000) <= 2


def test_an_axis_that_rests_beside_its_goal_is_refused_with_the_distance() -> None:
    with toyo_guide() as found:
        found.drive.faults = DriveFaults(off_counts=30)
        with pytest.raises(MotionError, match=r"rest 0\.300 away from its goal"):
            found.device.move_to(20.0, timeout_s=5.0)


@pytest.mark.parametrize("goal_mm", [650.1, -2000.0, float("nan"), float("inf")])
def test_a_goal_beyond_the_limits_is_refused_before_anything_is_sent(goal_mm: float) -> None:
    with toyo_guide() as found:
        before = found.peer.requests
        with pytest.raises(LimitError):
            found.device.move_to(goal_mm, timeout_s=5.0)
        assert found.peer.requests == before


def test_an_adapter_that_is_unplugged_is_lost_at_once() -> None:
    drive = Drive()
    peer = ModbusDevice(ToyoMemory(drive))
    with on_serial(peer, "rtu") as port:
        guide, shared = connect("linear-guide", {"drive": "toyo_xc100", "link": "bus"}, {"bus": {"port": port, "framing": "rtu"}})
    with pytest.raises(DeviceLost, match="does not answer any more"):
        for _ in range(3):
            guide.position_mm()
    shared.close()


def test_an_adapter_that_is_not_there_is_named_with_those_that_are() -> None:
    with pytest.raises(DeviceError, match="No serial adapter with serial number 'A50285BI'"):
        connect("linear-guide", {"drive": "toyo_xc100", "link": "bus"}, {"bus": {"usb_serial": "A50285BI"}})


def test_an_axis_that_is_not_referenced_is_not_moved_before_it_is() -> None:
    with simple_table() as found:
        found.drive.faults = DriveFaults(homed=False)
        assert found.device.status().text == "not referenced."
        with pytest.raises(MotionError, match="not referenced"):
            found.device.move_to(1.0, timeout_s=5.0)
        found.device.home(timeout_s=5.0)
        found.device.move_to(1.0, timeout_s=5.0)


def test_an_alarm_is_told_with_its_meaning() -> None:
    with simple_table() as found:
        found.drive.faults = DriveFaults(alarm=2)
        assert "following error" in found.device.status().text
        with pytest.raises(MotionError, match="following error"):
            found.device.move_to(1.0, timeout_s=5.0)


@pytest.mark.timed
def test_a_silent_drive_is_lost_within_two_time_outs() -> None:
    with toyo_guide() as found:
        found.peer.faults = LineFaults(silent=True)
        started = time.monotonic()
        with pytest.raises(DeviceLost, match="no reply"):
            found.device.position_mm()
        assert time.monotonic() - started < 2 * (0.15 + 0.2) + 0.3


@pytest.mark.parametrize("faults", [LineFaults(sliced=True), LineFaults(late_s=0.05)])
@FRAMINGS
def test_slow_and_sliced_answers_are_understood(faults: LineFaults, framing: Framing) -> None:
    with toyo_guide(framing=framing, reply_timeout_s=PATIENT_S) as found:
        found.peer.faults = faults
        found.device.move_to(3.0, timeout_s=10.0)
        assert found.device.position_mm() == pytest.approx(3.0)


@pytest.mark.parametrize(
    "faults", [LineFaults(garbage=b"\x01\x83\x07\xff\xff"), LineFaults(garbage=bytes(300)), LineFaults(garbage=b"HTTP/1.1 400 Bad Request")]
)
@FRAMINGS
def test_garbage_is_refused_with_an_excerpt(faults: LineFaults, framing: Framing) -> None:
    with toyo_guide(framing=framing) as found:
        found.peer.faults = faults
        with pytest.raises(DeviceError, match=r"received [0-9a-f]{2} "):
            found.device.position_mm()


@pytest.mark.timed
def test_a_stop_from_another_thread_takes_effect_at_once_a_hundred_times() -> None:
    with toyo_guide(speed_mm=20.0) as found:
        for _ in range(100):
            outcome: list[str] = []

            def move(outcome: list[str] = outcome) -> None:
                try:
                    found.device.move_to(600.0, timeout_s=60.0)
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
            assert found.drive.stops


def stops_while_replies_are_late(times: int) -> float:
    """Return the longest time from a stop until the drive has it, while the move's own reads wait for replies that come late."""
    worst = 0.0
    with simple_table(speed_deg=2.0) as found:
        genuine, stopped_at = found.drive.stop, [0.0]

        def note() -> None:
            stopped_at.append(time.monotonic())
            genuine()

        found.drive.stop = note  # type: ignore[method-assign]
        for turn in range(times):
            outcome: list[BaseException] = []

            def move(goal: float = 3.0 - 6.0 * (turn % 2), outcome: list[BaseException] = outcome) -> None:
                try:
                    found.device.move_to(goal, timeout_s=60.0)
                except (Cancelled, DeviceError) as error:
                    outcome.append(error)

            moves = len(found.drive.moves)
            thread = threading.Thread(target=move)
            thread.start()
            while len(found.drive.moves) == moves:
                assert thread.is_alive(), outcome
                time.sleep(0.002)
            found.peer.faults = LineFaults(late_s=0.1)
            time.sleep(0.05 + 0.002 * turn % 0.1)
            started = time.monotonic()
            with suppress(DeviceTimeout):  # the reply to the stop itself may come too late on a busy computer
                found.device.stop()
            worst = max(worst, stopped_at[-1] - started)
            thread.join(5.0)
            time.sleep(0.12)  # for the last late reply
            found.peer.faults = LineFaults()
            assert stopped_at[-1] > started
            assert isinstance(outcome[0], Cancelled | DeviceTimeout)
    return worst


@pytest.mark.timed
def test_a_stop_comes_next_on_a_line_whose_replies_are_late() -> None:
    assert stops_while_replies_are_late(20) < 0.2


@pytest.mark.slow
def test_a_stop_comes_next_on_a_line_whose_replies_are_late_a_hundred_times() -> None:
    assert stops_while_replies_are_late(100) < 0.2


def test_two_drives_share_one_line() -> None:
    drives = Drive(speed=2e5, acceleration=4e6), Drive(speed=1e7, acceleration=1e9)
    memories = ToyoMemory(drives[0]), ToyoMemory(drives[1])
    first, second = ModbusDevice(memories[0], 1), ModbusDevice(memories[1], 2)
    genuine = first.answer
    first.answer = lambda unit_id, pdu: second.answer(unit_id, pdu) if unit_id == 2 else genuine(unit_id, pdu)  # type: ignore[method-assign]
    with on_serial(first, "rtu") as port:
        from measureapp.devices.links import Links
        from measureapp.devices.plugin_loader import load_driver
        from measureapp.devices.request import DeviceRequest
        from measureapp.project.rig_file import read_rig

        shared, rig = Links({"bus": {"port": port, "framing": "rtu"}}), read_rig("paper")
        made = []
        for kind, unit_id in (("linear-guide", 1), ("rotary-table", 2)):
            loaded = load_driver(None, "axis_modbus", kind)  # type: ignore[arg-type]
            settings = loaded.settings.model_validate(
                {"drive": "toyo_xc100", "link": "bus", "unit_id": unit_id, "speed": 2000.0, "absolute_encoder": True}
            )
            made.append(loaded.entry(DeviceRequest(kind, rig, settings, shared)))
        guide, table = made
        threads = [
            threading.Thread(target=lambda: guide.move_to(50.0, timeout_s=10.0)),
            threading.Thread(target=lambda: table.move_to(0.5, timeout_s=10.0)),
        ]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert guide.position_mm() == pytest.approx(50.0, abs=0.02)
        assert table.angle_rad() == pytest.approx(0.5, abs=4e-4)
        shared.close()


def test_a_device_that_is_another_one_is_refused_by_its_identity() -> None:
    peer = ModbusDevice(ToyoMemory(Drive()))
    with on_tcp(peer) as port, pytest.raises(DeviceError, match=r"no such register|is not a Simple axis"):
        connect("rotary-table", {"drive": "simple_axis", "link": "bus"}, {"bus": {"host": "127.0.0.1", "tcp_port": port}})


def test_a_wrong_station_number_is_told() -> None:
    peer = ModbusDevice(SimpleMemory(Drive()))
    with on_tcp(peer) as port, pytest.raises(DeviceError, match="station 7"):
        connect("rotary-table", {"drive": "simple_axis", "link": "bus", "unit_id": 7}, {"bus": {"host": "127.0.0.1", "tcp_port": port}})


def test_a_port_that_does_not_exist_is_told() -> None:
    with pytest.raises(DeviceError, match="cannot be opened"):
        connect("rotary-table", {"drive": "simple_axis", "link": "bus"}, {"bus": {"host": "127.0.0.1", "tcp_port": 1}})
