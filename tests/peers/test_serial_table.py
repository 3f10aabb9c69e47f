"""The virtual rotary table against a client that others wrote: pyserial, with the commands of the manuals."""

from __future__ import annotations

import itertools
import time

import pytest
from serial import Serial

from measureapp.peers.serial_controllers import Esp301, Ps90, Shot, Smc100
from measureapp.peers.serial_table import Controller, TableAxis, TableFaults, on_serial


def talk(controller: Controller, *commands: bytes) -> list[bytes]:
    """Send commands and return the answers to those that end with ?."""
    answers = []
    with on_serial(controller) as name, Serial(name, 9600, timeout=1.0) as port:
        for command in commands:
            asked = command.startswith(b"?")
            port.write(command.removeprefix(b"?") + controller.command_end)
            if asked:
                answers.append(port.read_until(controller.reply_end))
        time.sleep(0.02)
    return answers


def fast(position: float = 0.0, **named: object) -> TableAxis:
    """Return an axis whose clock goes on by a second whenever it is read: a move has ended when its result is requested."""
    clock = itertools.count(0.0, 1.0)
    return TableAxis(position, 1e6, 1e9, now=lambda: next(clock), **named)  # type: ignore[arg-type]


def test_an_esp301_moves_and_keeps_its_errors_until_they_are_read() -> None:
    axis = fast()
    answers = talk(
        Esp301(axis), b"?TB?", b"1PA45.0", b"?TB?", b"1MO", b"1PA45.0", b"1XX", b"?1TP", b"?1MD?", b"?1DP?", b"?TB?", b"?TB?", b"?VE?"
    )
    told = [answer.decode().strip() for answer in answers]
    assert told[0].startswith("0, ")
    assert told[0].endswith("NO ERROR DETECTED")
    assert told[1].split(", ")[0] == "113"
    assert told[2:5] == ["45.0000", "1", "45.0000"]
    assert told[5].split(", ")[0] == "6"
    assert told[6].split(", ")[0] == "0"
    assert "ESP301" in told[7]
    assert axis.moves == [45.0]


def test_an_smc100_repeats_address_and_command_and_must_be_referenced() -> None:
    axis = fast(12.0)
    axis.faults = TableFaults(referenced=False)
    answers = talk(Smc100(axis), b"?1TS", b"1PA5", b"?1TE", b"?1TE", b"1OR", b"?1TS", b"?1TS", b"1PA-5.25", b"?1TP", b"?1PA?", b"?1VE")
    assert answers[:3] == [b"1TS00000A\r\n", b"1TEH\r\n", b"1TE@\r\n"]
    assert answers[4:] == [b"1TS000033\r\n", b"1TP-5.2500\r\n", b"1PA-5.2500\r\n", b"1VE SMC_CC_1.0.1\r\n"]


def test_an_smc100_does_not_answer_to_another_address() -> None:
    assert talk(Smc100(fast(), 2), b"?1TS", b"?2TS") == [b"", b"2TS000033\r\n"]


def test_a_shot_acknowledges_every_command() -> None:
    answers = talk(Shot(fast()), b"?G:", b"?A:1-P1000", b"?G:", b"?!:", b"?Q:", b"?XX", b"?Q:", b"?L:E", b"?H:1", b"?Q:")
    assert answers[:4] == [b"NG\r\n", b"OK\r\n", b"OK\r\n", b"R\r\n"]
    assert answers[4].split(b",")[0].replace(b" ", b"") == b"-1000"
    assert answers[6].endswith(b"X,K,R\r\n")
    assert answers[9].split(b",")[0].strip() == b"0"


def test_a_ps90_tells_all_axes_by_one_letter_each() -> None:
    answers = talk(
        Ps90(fast(), 2), b"??ASTAT", b"INIT2", b"ABSOL2", b"PSET2=-700", b"PGO2", b"??CNT2", b"??ASTAT", b"??ERR", b"NONSENSE", b"??ERR"
    )
    assert answers == [b"OIOOOOOOO\r", b"-700\r", b"OROOOOOOO\r", b"0\r", b"33\r"]


def test_an_axis_that_comes_to_rest_tells_where() -> None:
    rests: list[float] = []
    axis = fast(3.0, on_rest=rests.append)
    talk(Smc100(axis), b"?1TP", b"1PA10", b"?1TP")
    assert rests == [10.0]


def test_what_a_client_hears_of_faults() -> None:
    for faults, heard in (
        (TableFaults(silent=True), b""),
        (TableFaults(garbage=b"?\r\n"), b"?\r\n"),
        (TableFaults(sliced=True), b"1TP0\r\n"),
        (TableFaults(late_s=0.05, late_once=True), b"1TP0\r\n"),
    ):
        axis = fast()
        axis.faults = faults
        assert talk(Smc100(axis), b"?1TP") == [heard]


@pytest.mark.parametrize("echo", [False, True])
def test_a_controller_with_echo_repeats_what_it_heard(echo: bool) -> None:
    expected = b"R\r\n"
    with on_serial(Shot(fast(), echo=echo)) as name, Serial(name, 9600, timeout=1.0) as port:
        port.write(b"!:\r\n")
        if echo:
            assert port.read_until(b"\r\n") == b"!:\r\n"
        assert port.read_until(b"\r\n") == expected
