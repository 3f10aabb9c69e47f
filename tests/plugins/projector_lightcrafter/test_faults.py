"""What happens when the projector refuses, forgets, disappears or does something else."""

from __future__ import annotations

import time
from typing import Any

import pytest
from contracts.drivers.projector_lightcrafter import connect, contract_images

from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout, InputError
from measureapp.peers.lightcrafter import VirtualLightCrafter


def play(projector: Any, period_us: int = 12_000, count: int = 8) -> None:
    projector.play(0, count, exposure_us=9000, period_us=period_us)


@pytest.mark.parametrize(
    ("command", "words"),
    [
        (0x1A22, "pattern source"),
        (0x1A23, "trigger mode"),
        (0x1A29, "times"),
        (0x1A31, "sequence"),
        (0x1A34, "table of patterns"),
        (0x1A1D, "trigger out 1"),
        (0x1A1E, "trigger out 2"),
    ],
)
def test_a_setting_that_is_not_taken_over_is_noticed(peer: VirtualLightCrafter, command: int, words: str) -> None:
    projector = connect(peer, trigger_inverted=True)
    projector.load(contract_images())
    if command == 0x1A1E:
        peer._settings[command] = b"\1\xbb"
    if command == 0x1A34:
        peer.patterns = bytes(24)
    if command == 0x1A23:
        peer._settings[command] = b"\3"
    peer.faults.ignores = {command}
    with pytest.raises(DeviceError, match=f"did not take over the setting {words}"):
        play(projector)
    assert peer.pulses() == 0
    peer.faults.ignores = set()
    projector.close()


def test_a_refused_command_is_named(projector: Any, peer: VirtualLightCrafter) -> None:
    peer.faults.refuses = {0x1A31}
    with pytest.raises(DeviceError, match=r"refused the command sequence \(1A:31\)"):
        play(projector)


@pytest.mark.parametrize(
    ("bit", "words"),
    [
        (0x01, "the exposure or the period is not valid"),
        (0x02, "a pattern number that is not valid"),
        (0x04, "trigger output 1 stays high"),
        (0x08, "waits for an external trigger"),
        (0x10, "less than 230 µs"),
    ],
)
def test_every_bit_of_the_validation_becomes_a_sentence(projector: Any, peer: VirtualLightCrafter, bit: int, words: str) -> None:
    peer.faults.validation = bit
    with pytest.raises(DeviceError, match=f"does not accept the sequence: .*{words}"):
        play(projector)
    assert peer.pulses() == 0


@pytest.mark.parametrize("fault", ["other_sequence", "longer", "absurd_length", "truncated"])
def test_a_malformed_reply_is_refused_with_its_bytes(projector: Any, peer: VirtualLightCrafter, fault: str) -> None:
    setattr(peer.faults, fault, {0x1A0C})
    with pytest.raises(DeviceError, match=r"\(([0-9a-f]{2} ?)+.*\)"):
        play(projector)


def test_a_dropped_reply_is_a_timeout_and_no_write_is_repeated(projector: Any, peer: VirtualLightCrafter) -> None:
    peer.faults.drops = {0x1A29}
    with pytest.raises(DeviceTimeout, match="did not answer the command times"):
        play(projector)
    assert [command for command, _ in peer.commands].count(0x1A29) == 1
    peer.faults.drops = set()
    play(projector)


def test_a_late_reply_is_not_taken_for_another(projector: Any, peer: VirtualLightCrafter) -> None:
    peer.faults.late = {0x1A29}
    with pytest.raises(DeviceTimeout):
        play(projector)
    peer.faults.late = set()
    play(projector)
    assert projector.triggers_sent() >= 0


@pytest.mark.timed
def test_a_pulled_cable_is_lost_at_once(projector: Any, peer: VirtualLightCrafter) -> None:
    projector.show(0, timeout_s=2.0)
    peer.unplug()
    asked = time.monotonic()
    with pytest.raises(DeviceLost, match="does not answer any more"):
        projector.show(1, timeout_s=2.0)
    assert time.monotonic() - asked < 0.2
    assert not projector.status().ready


def test_a_sequence_that_does_not_start_is_an_error(projector: Any, peer: VirtualLightCrafter) -> None:
    peer.faults.never_starts = True
    with pytest.raises(DeviceError, match="did not start the sequence: its sequencer does not run"):
        projector.show(0, timeout_s=2.0)


def test_an_aborted_sequence_has_no_known_number_of_pulses(projector: Any, peer: VirtualLightCrafter) -> None:
    play(projector)
    peer.faults.hardware = 0x40
    with pytest.raises(DeviceError, match=r"the sequencer stopped before the end .* number of its trigger pulses is unknown"):
        projector.triggers_sent()


def test_a_sequence_that_ends_early_has_no_known_number_of_pulses(projector: Any, peer: VirtualLightCrafter) -> None:
    play(projector, period_us=100_000)
    peer._halt()
    with pytest.raises(DeviceError, match="number of its trigger pulses is unknown"):
        projector.triggers_sent()


def test_firmware_that_repeats_what_shall_run_once_is_noticed(projector: Any, peer: VirtualLightCrafter) -> None:
    peer.faults.repeats_always = True
    play(projector, period_us=10_000, count=1)
    time.sleep(0.8)
    with pytest.raises(DeviceError, match="it repeats the patterns"):
        projector.triggers_sent()


@pytest.mark.parametrize(
    ("faults", "words"),
    [({"hardware": 0x80}, "the sequencer reports an error"), ({"memory_test_fails": True}, "its memory test failed")],
)
def test_a_projector_with_a_fault_is_not_connected(peer: VirtualLightCrafter, faults: dict[str, Any], words: str) -> None:
    for name, value in faults.items():
        setattr(peer.faults, name, value)
    with pytest.raises(DeviceError, match=words):
        connect(peer)
    assert peer.closed


def test_declared_images_that_do_not_exist_are_refused() -> None:
    with pytest.raises(InputError, match="has 2 images in flash, and the settings name others"):
        connect(VirtualLightCrafter(images=2))


def test_a_light_that_stays_on_after_a_stop_is_an_error(projector: Any, peer: VirtualLightCrafter) -> None:
    projector.show(0, timeout_s=2.0)
    peer.faults.ignores = {0x1A07}
    with pytest.raises(DeviceError, match="did not switch its light off"):
        projector.stop()
    peer.faults.ignores = set()
