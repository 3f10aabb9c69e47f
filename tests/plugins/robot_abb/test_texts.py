"""What travels between driver and controller: RAPID values, envelopes, the module's text and the messages of the pose stream."""

from __future__ import annotations

import re
import socket
import time
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError
from robot_requests import plugin_module, until

from measureapp.errors import DeviceError, DeviceLost
from measureapp.peers.rws.symbols import Symbols, parse, same_shape
from measureapp.resources import resource

rapid = plugin_module("robot_abb", "rapid")
dialect = plugin_module("robot_abb", "dialect")
egm = plugin_module("robot_abb", "egm")
mailbox = plugin_module("robot_abb", "mailbox")
settings = plugin_module("robot_abb", "settings")

MODULE = Path(resource("rapid/MeasureApp.mod")).read_text(encoding="ascii")
ANGLES = st.lists(st.floats(-400, 400), min_size=6, max_size=6)


@given(ANGLES, st.integers(1, 2**23 - 1))
def test_an_order_survives_the_controllers_23_bits(angles: list[float], number: int) -> None:
    order = rapid.order(number, np.array(angles), 150.0, 30.0)
    kept = parse(order)
    assert same_shape(kept, Symbols(MODULE).find("mm_order").value)
    assert kept[0] == number
    np.testing.assert_allclose(kept[1][0], angles, atol=1e-4)
    from measureapp.peers.rws.symbols import write

    assert rapid.equal(write(kept), order)


@pytest.mark.parametrize(
    ("one", "other"), [("8388606", "8388607"), ("[1,[0,0]]", "[1,[0,0.1]]"), ('"a"', '"b"'), ("1", '"1"'), ("[1,2]", "[1,2,3]")]
)
def test_different_values_are_not_equal(one: str, other: str) -> None:
    assert not rapid.equal(one, other)


@given(st.text(st.characters(codec="ascii", exclude_categories=("Cc",)), max_size=80))
def test_a_string_survives_its_quotes(text: str) -> None:
    assert rapid.read_text(rapid.text(text)) == text


@pytest.mark.parametrize("text", ["", "12", '"', '"open', "TRUE"])
def test_what_is_no_string_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match="no string"):
        rapid.read_text(text)


@pytest.mark.parametrize("text", ["", "[]", "TRUE", "[1,nan]", "[1,2;3]", "__import__('os')", "1e999"])
def test_what_is_no_record_of_numbers_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match="numbers"):
        rapid.read_numbers(text)


def test_envelopes_of_both_versions_are_read() -> None:
    first = {"_links": {"base": {"href": "http://192.168.125.1/rw/"}}, "_embedded": {"_state": [{"_type": "pnl-opmode", "opmode": "AUTO"}]}}
    second = {"_links": {}, "status": {"code": 294912}, "state": [{"_type": "pnl-opmode", "opmode": "AUTO"}]}
    listed = {"_links": {}, "_embedded": {"resources": [{"_type": "elog-message-li"}]}, "status": {"code": 294912}}
    assert dialect.states(first)[0]["opmode"] == dialect.states(second)[0]["opmode"] == "AUTO"
    assert len(dialect.states(listed)) == 1
    for nonsense in ([], {}, {"_embedded": 3}, {"state": [1]}, None, {"_embedded": {"_state": {}}}):
        with pytest.raises(ValueError, match="no "):
            dialect.states(nonsense)


def test_errors_of_both_versions_are_read() -> None:
    assert dialect.refusal({"_embedded": {"status": {"code": -1073414146, "msg": "no mastership"}}}) == (-1073414146, "no mastership")
    assert dialect.refusal({"status": {"code": "-1073436672", "msg": "m"}}) == (-1073436672, "m")
    assert dialect.refusal({"status": {"code": "x", "msg": "m"}}) == (0, "m")
    assert dialect.refusal(None) == (0, "")


def test_the_versions_differ_in_paths_and_headers_alone() -> None:
    first, second = dialect.VERSIONS["1.0"], dialect.VERSIONS["2.0"]
    names = {"task": "T_ROB1", "module": "MeasureApp", "name": "mm_cmd"}
    assert first.path("set symbol", names) == "/rw/rapid/symbol/data/RAPID/T_ROB1/MeasureApp/mm_cmd?action=set&json=1"
    assert second.path("set symbol", names) == "/rw/rapid/symbol/RAPID/T_ROB1/MeasureApp/mm_cmd/data"
    assert first.path("ctrlstate", {}) == "/rw/panel/ctrlstate?json=1"
    assert set(first.paths) == set(second.paths)
    assert second.headers["Accept"].endswith("v=2.0")


def test_the_shipped_module_states_its_own_digest() -> None:
    told = Symbols(MODULE).find("mm_program").value
    assert told == mailbox.digest(MODULE), "write the digest into mm_program of resources/rapid/MeasureApp.mod"
    assert mailbox.digest(MODULE.replace("\n", "\r\n")) == told
    assert mailbox.digest(MODULE.replace("VelSet 100,250", "VelSet 100,900")) != told


def test_the_shipped_module_closes_what_it_opens_and_fits_a_controller() -> None:
    code = [line.partition("!")[0] for line in MODULE.splitlines()]
    text = "\n".join(code)
    for opening, closing in (
        ("PROC", "ENDPROC"),
        ("TRAP", "ENDTRAP"),
        ("RECORD", "ENDRECORD"),
        ("WHILE", "ENDWHILE"),
        ("MODULE", "ENDMODULE"),
    ):
        assert len(re.findall(rf"^\s*{opening}\b", text, re.MULTILINE)) == len(re.findall(rf"\b{closing}\b", text)), opening
    assert len(re.findall(r"\bIF\b.*\bTHEN\b", text)) == len(re.findall(r"\bENDIF\b", text))
    assert all(len(name) <= 32 for name in re.findall(r"\b\w+\b", text))
    assert all(line.isascii() and len(line) <= 120 for line in MODULE.splitlines())
    declared = {name.lower() for name in re.findall(r"(?:PERS|CONST|VAR)\s+\w+\s+(\w+)", text)}
    used = {name.lower() for name in re.findall(r"\bmm_\w+", text)} - {"mm_job", "mm_report", "mm_trap_abort", "mm_trap_beat"}
    assert used <= declared


def test_an_old_order_is_never_run_by_the_shipped_module() -> None:
    main = MODULE[MODULE.index("PROC main") : MODULE.index("WHILE TRUE")]
    assert "mm_seen:=mm_cmd;" in main
    assert "WaitUntil mm_cmd>mm_seen" in MODULE
    assert MODULE.index("IF mm_now.id<>mm_seen") < MODULE.index("MoveAbsJ")


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"address": "192.168.125.1"}, "address"),
        ({"address": "http://192.168.125.1/rw"}, "address"),
        ({"version": "2.0", "address": "http://192.168.125.1"}, "https"),
        ({"version": "1.0", "address": "https://192.168.125.1"}, "http"),
        ({"certificate_sha256": "12:34"}, "certificate"),
        ({"speed_mm_per_s": 2000}, "speed"),
        ({"loss_s": 10}, "loss"),
        ({"task": "T_ROB1/../x"}, "task"),
    ],
)
def test_impossible_settings_are_refused_by_name(given: dict[str, object], words: str) -> None:
    with pytest.raises(ValidationError, match=words):
        settings.AbbSettings.model_validate(given)


def test_the_password_is_not_shown() -> None:
    assert "robotics" not in repr(settings.AbbSettings())


def robot_message(counter: int, joints: list[float]) -> bytes:
    pb = pytest.importorskip(
        "abb_robot_client._egm_protobuf.egm_pb2", reason="needs the package abb-robot-client (pip install abb-robot-client)"
    )
    message = pb.EgmRobot()
    message.header.seqno, message.header.tm, message.header.mtype = counter, 4000000000, 2
    message.feedBack.joints.joints.extend(joints)
    for name, value in zip("xyz", (412.5, -3.25, 600.0), strict=True):
        setattr(message.feedBack.cartesian.pos, name, value)
    for index, value in enumerate((0.5, 0.5, -0.5, 0.5)):
        setattr(message.feedBack.cartesian.orient, f"u{index}", value)
    message.motorState.state, message.mciState.state, message.mciConvergenceMet = 1, 3, True
    message.rapidExecState.state, message.utilizationRate = 2, 12.5
    return message.SerializeToString()


def test_a_message_of_the_reference_implementation_is_read() -> None:
    pose = egm.read_message(robot_message(4_000_000_001, [1.5, -2.5, 3.0, 0.0, 30.0, -179.0]))
    assert pose.counter == 4_000_000_001
    np.testing.assert_array_equal(pose.joints_deg, [1.5, -2.5, 3.0, 0.0, 30.0, -179.0])
    np.testing.assert_array_equal(pose.position_mm, [412.5, -3.25, 600.0])
    np.testing.assert_array_equal(pose.quaternion_wxyz, [0.5, 0.5, -0.5, 0.5])


@given(st.data())
def test_a_damaged_message_is_refused_and_never_crashes(data: st.DataObject) -> None:
    message = bytearray(robot_message(17, [0.0] * 6))
    if data.draw(st.booleans()):
        del message[data.draw(st.integers(0, len(message) - 1)) :]
    else:
        message[data.draw(st.integers(0, len(message) - 1))] = data.draw(st.integers(0, 255))
    try:
        pose = egm.read_message(bytes(message))
    except DeviceError as error:
        assert "invalid" in error.message
    else:
        assert pose.joints_deg.shape == (6,)


@pytest.mark.parametrize("message", [b"", b"\xff" * 12, b"\x0a\x02\x08", b"\x0b\x00", [0.0] * 5, [float("nan")] * 6])
def test_a_wrong_message_is_refused_with_its_bytes(message: bytes | list[float]) -> None:
    message = message if isinstance(message, bytes) else robot_message(1, message)
    with pytest.raises(DeviceError, match=r"invalid \(.+\): (nothing|[0-9a-f]{2})"):
        egm.read_message(message)


def test_a_stream_whose_counter_stands_still_for_half_a_second_is_lost() -> None:
    clock = [100.0]
    stream = egm.PoseStream(0, "127.0.0.1", lambda: clock[0])
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as robot:
        try:
            with pytest.raises(DeviceLost, match="not begun"):
                stream.latest()

            def send(counter: int) -> None:
                robot.sendto(robot_message(counter, [float(counter)] * 6), ("127.0.0.1", stream.port))

            send(1)
            until(lambda: stream._latest is not None)
            assert stream.latest().counter == 1
            clock[0] += 0.4
            send(1)
            time.sleep(0.05)
            assert stream.latest().counter == 1
            clock[0] += 0.2  # the same counter is 600 ms old, though messages still come
            send(1)
            time.sleep(0.05)
            with pytest.raises(DeviceLost, match="stale"):
                stream.latest()
            robot.sendto(b"garbage", ("127.0.0.1", stream.port))
            send(2)
            until(lambda: stream._latest.counter == 2)
            assert stream.latest().joints_deg[0] == 2.0
        finally:
            stream.close()
