"""What goes wrong with controllers and lines: slower perhaps, never wrong, and reported in words."""

from __future__ import annotations

import threading
import time
from dataclasses import replace
from math import radians

import pytest
from serial_tables import CONTROLLERS, connect, serial_table

from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout, LimitError, MotionError
from measureapp.peers.serial_controllers import Esp301, Shot, Smc100
from measureapp.peers.serial_table import TableAxis, TableFaults, on_serial
from measureapp.progress import Cancelled

ALL = list(CONTROLLERS)
NEWPORT = ["newport_esp301", "newport_smc100"]
ONE_DEGREE = radians(1.0)


@pytest.mark.parametrize("controller", ALL)
@pytest.mark.parametrize("sense", [1, -1])
def test_every_controller_turns_to_absolute_angles_in_the_sense_of_the_rig(controller: str, sense: int) -> None:
    scale = CONTROLLERS[controller][0]
    with serial_table(controller, sense=sense, zero_counts=10.0) as found:
        for goal_deg in (30.0, -12.5, 0.0):
            found.device.move_to(radians(goal_deg), timeout_s=10.0)
            assert found.device.angle_rad() == pytest.approx(radians(goal_deg), abs=radians(0.005))
            assert found.axis.position() == pytest.approx(sense * goal_deg * scale + 10.0, abs=0.005 * scale)
        assert len(found.axis.moves) == 3


@pytest.mark.parametrize("goal_deg", [1e4, -1e4, float("nan"), float("inf")])
@pytest.mark.parametrize("controller", ALL)
def test_a_goal_beyond_the_limits_is_refused_before_anything_is_sent(controller: str, goal_deg: float) -> None:
    with serial_table(controller) as found:
        found.axis.faults = TableFaults(silent=True)
        with pytest.raises(LimitError, match=r"outside .* Choose a goal inside"):
            found.device.move_to(radians(goal_deg), timeout_s=5.0)
        assert not found.axis.moves


@pytest.mark.parametrize("controller", ALL)
def test_a_late_answer_is_discarded_and_the_table_moved_once(controller: str) -> None:
    with serial_table(controller, start=7.0 * CONTROLLERS[controller][0]) as found:
        found.axis.faults = TableFaults(late_s=0.3, late_once=True)
        assert found.device.angle_rad() == pytest.approx(radians(7.0))
        found.axis.faults = TableFaults(late_s=0.3, late_once=True)
        found.device.move_to(ONE_DEGREE, timeout_s=10.0)
        assert len(found.axis.moves) == 1
        for _ in range(10):
            assert found.device.angle_rad() == pytest.approx(ONE_DEGREE, abs=radians(0.005))


@pytest.mark.parametrize("controller", NEWPORT)
def test_the_answer_to_a_move_that_is_late_does_not_repeat_it(controller: str) -> None:
    with serial_table(controller) as found:
        genuine = found.axis.start

        def start(goal: float) -> None:
            genuine(goal)
            found.axis.faults = TableFaults(late_s=0.3, late_once=True)

        found.axis.start = start  # type: ignore[method-assign]
        found.device.move_to(ONE_DEGREE, timeout_s=10.0)
        assert found.axis.moves == [1.0]


@pytest.mark.parametrize("controller", NEWPORT)
def test_answers_that_stay_shifted_by_one_are_never_taken_for_positions(controller: str) -> None:
    with serial_table(controller) as found:
        found.axis.faults = TableFaults(shifted=True)
        with pytest.raises(DeviceError):
            found.device.move_to(ONE_DEGREE, timeout_s=3.0)
        assert found.axis.moves in ([], [1.0])


@pytest.mark.timed
@pytest.mark.parametrize("controller", ALL)
def test_a_silent_controller_is_lost_within_two_time_outs_and_stays_so(controller: str) -> None:
    with serial_table(controller) as found:
        found.axis.faults = TableFaults(silent=True)
        started = time.monotonic()
        with pytest.raises(DeviceLost, match=r"does not answer any more: no reply \(received nothing\)"):
            found.device.angle_rad()
        assert time.monotonic() - started < 2 * 0.2 + 0.2 + 0.3
        found.axis.faults = TableFaults()
        with pytest.raises(DeviceLost, match="Connect again"):
            found.device.move_to(ONE_DEGREE, timeout_s=5.0)
        assert not found.device.status().ready
        assert not found.axis.moves


@pytest.mark.parametrize("faults", [TableFaults(sliced=True), TableFaults(late_s=0.03)])
@pytest.mark.parametrize("controller", ALL)
def test_slow_and_sliced_answers_are_understood(controller: str, faults: TableFaults) -> None:
    with serial_table(controller) as found:
        found.axis.faults = faults
        found.device.move_to(ONE_DEGREE, timeout_s=10.0)
        assert found.device.angle_rad() == pytest.approx(ONE_DEGREE, abs=radians(0.005))


@pytest.mark.parametrize(
    "garbage",
    [b"\x01\x83\x07\xff\xff\r\n", bytes(400), b"HTTP/1.1 400 Bad Request\r\n", b"1.0\r\n2.0\r\n", b"nan\r\n", b"\r\n", b"1e5\xb0\r\n"],
)
@pytest.mark.parametrize("controller", ALL)
def test_malformed_replies_are_refused_with_an_excerpt(controller: str, garbage: bytes) -> None:
    with serial_table(controller) as found:
        found.axis.faults = TableFaults(garbage=garbage)
        with pytest.raises(DeviceError, match=r"received ([0-9a-f]{2}|nothing)"):
            found.device.angle_rad()
        found.axis.faults = TableFaults()
        assert found.device.angle_rad() == 0.0


def test_a_position_that_never_changes_is_no_arrival_and_stops_the_table() -> None:
    with serial_table() as found:
        found.axis.faults = TableFaults(frozen=True)
        with pytest.raises((DeviceTimeout, MotionError), match=r"did not end|came to rest"):
            found.device.move_to(ONE_DEGREE, timeout_s=0.5)
        found.device.angle_rad()  # what was sent before has been heard
        assert found.axis.stops == 1


@pytest.mark.parametrize("controller", ALL)
def test_the_end_of_a_move_reported_early_is_not_believed(controller: str) -> None:
    with serial_table(controller, speed_deg=40.0) as found:
        found.axis.faults = TableFaults(early_done=True)
        found.device.move_to(radians(20.0), timeout_s=10.0)
        assert found.axis.position() / CONTROLLERS[controller][0] == pytest.approx(20.0, abs=0.005)


def test_a_table_that_rests_beside_its_goal_is_refused_with_the_distance() -> None:
    with serial_table() as found:
        found.axis.faults = TableFaults(off_target=0.05)
        with pytest.raises(MotionError, match=r"rest 0\.050° away from its goal"):
            found.device.move_to(ONE_DEGREE, timeout_s=5.0)


@pytest.mark.parametrize(
    ("controller", "code", "words"),
    [
        ("newport_esp301", "13", "refused '1PA1.0000': refused by order"),
        ("newport_smc100", "G", "refused '1PA1.0000': goal outside the controller's own limits"),
        ("owis_ps90", "44", "refused 'PGO1': code 44"),
        ("sigma_koki_shot", "1", "refused 'A:1.P400' with 'NG'"),
    ],
)
def test_a_command_that_the_controller_refuses_is_told_in_words(controller: str, code: str, words: str) -> None:
    with serial_table(controller) as found:
        found.axis.faults = TableFaults(refuse=code)
        with pytest.raises(MotionError, match=words):
            found.device.move_to(ONE_DEGREE, timeout_s=5.0)
        assert not found.axis.moves
        found.axis.faults = TableFaults()
        found.device.move_to(ONE_DEGREE, timeout_s=5.0)


def test_a_table_that_is_not_referenced_is_not_moved_before_it_is() -> None:
    with serial_table() as found:
        found.axis.faults = TableFaults(referenced=False)
        assert found.device.status().text == "not referenced."
        with pytest.raises(MotionError, match="not referenced"):
            found.device.move_to(ONE_DEGREE, timeout_s=5.0)
        assert not found.axis.moves
        found.device.home(timeout_s=5.0)
        found.device.move_to(ONE_DEGREE, timeout_s=5.0)


def test_a_controller_that_cannot_report_its_reference_must_find_it_first() -> None:
    with serial_table("newport_esp301", start=5.0, absolute_encoder=False) as found:
        with pytest.raises(MotionError, match="not referenced"):
            found.device.move_to(ONE_DEGREE, timeout_s=5.0)
        found.device.home(timeout_s=5.0)
        assert found.axis.moves == [0.0]
        found.device.home(timeout_s=5.0)
        found.device.move_to(ONE_DEGREE, timeout_s=5.0)
        assert found.axis.moves == [0.0, 1.0]


def test_an_alarm_is_told_during_a_move_and_the_search_for_the_reference() -> None:
    with serial_table(speed_deg=5.0) as found:
        genuine = found.axis.start

        def start(goal: float) -> None:
            genuine(goal)
            found.axis.faults = replace(found.axis.faults, alarm="0020")

        found.axis.start = start  # type: ignore[method-assign]
        with pytest.raises(MotionError, match="alarm: code 0020"):
            found.device.move_to(ONE_DEGREE, timeout_s=5.0)
        found.axis.faults = TableFaults(referenced=False)
        with pytest.raises(MotionError, match="alarm: code 0020"):
            found.device.home(timeout_s=5.0)
        assert not found.device.status().ready
        assert found.axis.stops == 2


@pytest.mark.timed
@pytest.mark.parametrize("controller", ALL)
def test_a_stop_from_another_thread_takes_effect_at_once_again_and_again(controller: str) -> None:
    latencies_s = []
    with serial_table(controller, speed_deg=3.0) as found:
        for number in range(25):
            outcome: list[str] = []

            def move(goal_deg: float = 170.0 if number % 2 else -170.0, outcome: list[str] = outcome) -> None:
                try:
                    found.device.move_to(radians(goal_deg), timeout_s=60.0)
                except Cancelled:
                    outcome.append("cancelled")

            moves, stops = len(found.axis.moves), found.axis.stops
            thread = threading.Thread(target=move)
            thread.start()
            while len(found.axis.moves) == moves:
                time.sleep(0.001)
            started = time.monotonic()
            stopping = threading.Thread(target=found.device.stop)
            stopping.start()
            while found.axis.stops == stops:
                time.sleep(0.0005)
            latencies_s.append(time.monotonic() - started)
            stopping.join()
            thread.join(2.0)
            assert outcome == ["cancelled"]
    assert max(latencies_s) < 0.2


def test_a_stop_is_sent_while_another_thread_waits_for_a_reply() -> None:
    with serial_table("newport_esp301", link={"reply_timeout_s": 2.0}) as found:
        heard = threading.Event()
        genuine = found.axis.told_position

        def told_position() -> float:
            heard.set()
            return genuine()

        found.axis.told_position = told_position  # type: ignore[method-assign]
        found.axis.faults = TableFaults(late_s=0.15, late_once=True)
        reading = threading.Thread(target=found.device.angle_rad)
        reading.start()
        heard.wait(2.0)
        found.device.stop()
        reading.join()
        assert found.axis.stops == 1


@pytest.mark.parametrize("controller", ALL)
def test_no_command_of_a_move_follows_a_stop(controller: str) -> None:
    """A stop that comes between the commands of a sequence must not be undone by those that remain."""
    with serial_table(controller) as found:
        genuine, commands = found.controller.answer, []

        def answer(command: str) -> str | None:
            commands.append(command)
            if command in ("TB?", "1TE", "?ERR", "Q:"):  # what is asked after every command
                found.device._controller._stops.stop()
            return genuine(command)

        found.device._controller.move(0.0, 1.0, 5.0)
        moves = len(found.axis.moves)
        found.controller.answer = answer  # type: ignore[method-assign]
        with pytest.raises(Cancelled):
            found.device._controller.move(1.0, 1.0, 5.0)
        found.controller.answer = genuine  # type: ignore[method-assign]
        assert commands
        assert len(found.axis.moves) == moves


def test_an_adapter_that_is_unplugged_is_lost() -> None:
    with on_serial(Smc100(TableAxis())) as port:
        table, shared = connect({"controller": "newport_smc100"}, {"port": port})
    with pytest.raises(DeviceLost, match="does not answer any more"):
        for _ in range(3):
            table.angle_rad()
    shared.close()
    shared.close()


def test_another_controller_is_refused_by_its_identity() -> None:
    with on_serial(Shot(TableAxis())) as port, pytest.raises(DeviceError, match=r"'NG' .* no reply of a Newport SMC100"):
        connect({"controller": "newport_smc100"}, {"port": port})
    with on_serial(Esp301(TableAxis())) as port, pytest.raises(DeviceError, match="does not answer: no reply"):
        connect({"controller": "newport_smc100"}, {"port": port})


def test_a_wrong_address_and_a_missing_port_are_told() -> None:
    with on_serial(Smc100(TableAxis(), address=4)) as port, pytest.raises(DeviceError, match="does not answer: no reply"):
        connect({"controller": "newport_smc100"}, {"port": port})
    with pytest.raises(DeviceError, match="/dev/missing cannot be opened"):
        connect({"controller": "newport_smc100"}, {"port": "/dev/missing"})


def test_a_line_that_was_closed_is_not_opened_again_by_a_call() -> None:
    with on_serial(Smc100(TableAxis())) as port:
        table, shared = connect({"controller": "newport_smc100"}, {"port": port})
        table.close()
        table.close()
        assert table.status().ready
        shared.close()
        with pytest.raises(DeviceLost, match="the line was closed"):
            table.angle_rad()


def test_two_tables_share_one_line() -> None:
    class Both:
        command_end, reply_end, echo = b"\r\n", b"\r\n", False

        def __init__(self) -> None:
            self.axis = TableAxis()
            self.first = Smc100(TableAxis(0.0, 3000.0, 6e4), 1)
            self.second = Smc100(TableAxis(0.0, 3000.0, 6e4), 2)

        def answer(self, command: str) -> str | None:
            return self.first.answer(command) if command.startswith("1") else self.second.answer(command)

    from measureapp.devices.links import Links
    from measureapp.devices.plugin_loader import load_driver
    from measureapp.devices.request import DeviceRequest
    from measureapp.project.rig_file import read_rig

    loaded, rig = load_driver(None, "table_serial", "rotary-table"), read_rig("paper")
    with on_serial(Both()) as port:
        shared = Links({"line": {"port": port}})
        tables = [
            loaded.entry(
                DeviceRequest(
                    "table",
                    rig,
                    loaded.settings.model_validate({"controller": "newport_smc100", "link": "line", "axis": axis, "poll_s": 0.002}),
                    shared,
                )
            )
            for axis in (1, 2)
        ]
        threads = [
            threading.Thread(target=lambda table=table, goal=goal: table.move_to(goal, timeout_s=10.0))
            for table, goal in zip(tables, (0.5, -0.25), strict=True)
        ]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert [table.angle_rad() for table in tables] == pytest.approx([0.5, -0.25], abs=1e-5)
        shared.close()
