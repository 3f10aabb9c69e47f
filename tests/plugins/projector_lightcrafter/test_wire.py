"""Reports byte by byte, as the programmer's guide states them, and replies that are none."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import pytest

from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout

from .conftest import module


class Script:
    """A device that expects reports in order and gives each its replies."""

    def __init__(self, *steps: tuple[str, Sequence[str]]) -> None:
        self.steps = list(steps)
        self.waiting: list[bytes] = []

    def write(self, report: bytes) -> int:
        expected, replies = self.steps.pop(0)
        assert report == b"\0" + bytes.fromhex(expected).ljust(64, b"\0")
        self.waiting += [bytes.fromhex(one).ljust(64, b"\0") if len(bytes.fromhex(one)) > 3 else bytes.fromhex(one) for one in replies]
        return 65

    def read(self, length: int, timeout_ms: int) -> list[int]:
        return list(self.waiting.pop(0)[:length]) if self.waiting else []

    def close(self) -> None: ...


def link(device: Any) -> Any:
    return module("link").Link(device, "LightCrafter", 0.01)


def command(name: str) -> Any:
    return module("registers").Command[name]


def test_a_question_has_the_code_low_byte_first_and_its_reply_has_data_only() -> None:
    device = Script(("C0 01 02 00 0C 1A", ["C0 01 01 00 02"]))
    assert link(device).read(command("MAIN_STATUS"), 1) == b"\x02"


def test_exposure_and_period_go_out_as_two_little_endian_numbers() -> None:
    device = Script(("40 01 0A 00 29 1A 10 27 00 00 F6 27 00 00", ["40 01 00 00"]))
    link(device).write(command("TIMES"), bytes.fromhex("10270000F6270000"))
    assert not device.steps


def test_long_data_goes_on_in_raw_reports_after_58_bytes() -> None:
    table = bytes(range(200))
    expected = ["40 01 CA 00 34 1A" + table[:58].hex(), table[58:122].hex(), table[122:186].hex(), table[186:].hex()]
    device = Script(*((report, []) for report in expected[:3]), (expected[3], ["40 01 00 00"]))
    link(device).write(command("MAILBOX_DATA"), table)
    assert not device.steps


def test_a_long_reply_is_put_together_from_its_reports() -> None:
    table = bytes(range(130))
    device = Script(("C0 01 02 00 34 1A", ["C0 01 82 00" + table[:60].hex(), table[60:124].hex(), table[124:].hex()]))
    assert link(device).read(command("MAILBOX_DATA")) == table


def test_numbers_run_from_1_to_255_and_begin_again() -> None:
    numbers = [*range(1, 256), 1]
    device = Script(*((f"C0 {n:02X} 02 00 0C 1A", [f"C0 {n:02X} 01 00 00"]) for n in numbers))
    talk = link(device)
    for _ in numbers:
        talk.read(command("MAIN_STATUS"), 1)


def test_a_reply_with_the_error_bit_names_the_command_and_the_bytes() -> None:
    device = Script(("40 01 03 00 24 1A 02", ["60 01 00 00"]))
    with pytest.raises(DeviceError, match=r"refused the command start stop \(1A:24\) \(02; reply 60 01 00 00"):
        link(device).write(command("START_STOP"), b"\x02")


def test_a_reply_with_another_number_is_refused_with_its_bytes() -> None:
    device = Script(("C0 01 02 00 0C 1A", ["C0 08 01 00 02"]))
    with pytest.raises(DeviceError, match=r"sequence number 8 instead of 1 \(c0 08 01 00 02"):
        link(device).read(command("MAIN_STATUS"), 1)


def test_a_reply_of_three_bytes_is_refused_with_its_bytes() -> None:
    device = Script(("C0 01 02 00 0C 1A", ["C0 01 01"]))
    with pytest.raises(DeviceError, match=r"has 3 bytes, and a reply begins with 4 \(c0 01 01\)"):
        link(device).read(command("MAIN_STATUS"), 1)


def test_a_reply_that_states_an_absurd_length_is_refused() -> None:
    device = Script(("C0 01 02 00 0C 1A", ["C0 01 FF FF 02"]))
    with pytest.raises(DeviceError, match="length of 65535 bytes"):
        link(device).read(command("MAIN_STATUS"), 1)


def test_a_reply_of_another_length_than_the_question_has_is_refused() -> None:
    device = Script(("C0 01 02 00 0C 1A", ["C0 01 02 00 02 00"]))
    with pytest.raises(DeviceError, match="has 2 bytes of data instead of 1"):
        link(device).read(command("MAIN_STATUS"), 1)


def test_a_missing_reply_is_a_timeout_and_the_late_one_is_not_taken_for_the_next() -> None:
    device = Script(
        ("C0 01 02 00 0C 1A", []),
        ("C0 02 02 00 0C 1A", ["C0 01 01 00 00", "C0 02 01 00 02"]),
    )
    talk = link(device)
    with pytest.raises(DeviceTimeout, match=r"did not answer the command main status \(1A:0C\)"):
        talk.read(command("MAIN_STATUS"), 1)
    assert talk.read(command("MAIN_STATUS"), 1) == b"\x02"


def test_a_command_at_once_wants_no_reply() -> None:
    device = Script(("00 01 03 00 24 1A 00", []))
    link(device).write_at_once(command("START_STOP"), b"\x00")
    assert not device.steps


def test_a_broken_connection_is_lost_for_every_later_call() -> None:
    class Gone(Script):
        def read(self, length: int, timeout_ms: int) -> list[int]:
            raise OSError("read error")

    talk = link(Gone(("C0 01 02 00 0C 1A", [])))
    for _ in range(2):
        with pytest.raises(DeviceLost, match="does not answer any more: read error"):
            talk.read(command("MAIN_STATUS"), 1)
