"""The virtual LightCrafter, driven by a public client that was written for the real one."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from types import ModuleType

import pytest

from measureapp.peers.lightcrafter import VirtualLightCrafter


class UsbDevice:
    """What the client uses of a device of pyusb, on top of the peer's reports."""

    def __init__(self, peer: VirtualLightCrafter) -> None:
        self.peer = peer
        self.answers: list[list[int]] = []

    def set_configuration(self) -> None: ...

    def reset(self) -> None: ...

    def write(self, endpoint: int, report: list[int]) -> int:
        assert endpoint == 1 and len(report) == 64
        return self.peer.write(bytes([0, *report])) - 1

    def read(self, endpoint: int, length: int) -> list[int]:
        assert endpoint == 0x81
        self.answers.append(self.peer.read(length, 100))
        return self.answers[-1]


@pytest.fixture
def clock() -> Iterator[list[float]]:
    return [0.0]


@pytest.fixture
def device(clock: list[float]) -> UsbDevice:
    return UsbDevice(VirtualLightCrafter(load_s=0.0, now=lambda: clock[0]))


@pytest.fixture
def client(device: UsbDevice, monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    reason = "install the public client by: pip install pycrafter4500"
    package = pytest.importorskip("pycrafter4500.pycrafter4500", reason=reason)
    monkeypatch.setattr(package.usb.core, "find", lambda **_: device)
    monkeypatch.setattr(package.time, "sleep", lambda _: None)
    return package


def test_a_public_client_plays_its_three_patterns_again_and_again(client: ModuleType, device: UsbDevice, clock: list[float]) -> None:
    client.pattern_mode(period=8334, bit_depth=8, led_color=0b100)
    assert all(answer[0] & 0x20 == 0 for answer in device.answers)
    seen = []
    for clock[0] in itertools.islice(itertools.count(0.004, 0.008334), 6):
        light = device.peer.lit()
        assert light is not None and light.leds == 0b100 and light.bits == 8 and light.image is None
        seen.append(light.pattern)
    assert seen == [0, 1, 2, 0, 1, 2]
    assert device.peer.pulses() == 6


def test_a_public_client_stops_the_light_by_video_mode(client: ModuleType, device: UsbDevice) -> None:
    client.pattern_mode(period=8334, bit_depth=8)
    client.video_mode()
    assert device.peer.lit() is None


def test_a_public_client_reads_that_the_sequencer_runs(client: ModuleType, device: UsbDevice, capsys: pytest.CaptureFixture[str]) -> None:
    client.pattern_mode(period=8334, bit_depth=8)
    with client.connect_usb() as projector:
        projector.get_main_status(pretty_print=True)
    assert "running normally" in capsys.readouterr().out


def test_standby_parks_the_mirrors_until_it_is_left(client: ModuleType, device: UsbDevice, capsys: pytest.CaptureFixture[str]) -> None:
    client.power_down()
    with client.connect_usb() as projector:
        projector.get_main_status(pretty_print=True)
    client.power_up()
    with client.connect_usb() as projector:
        projector.get_main_status(pretty_print=True)
    told = [line for line in capsys.readouterr().out.splitlines() if "micromirrors" in line]
    assert told == ["DMD micromirrors are parked", "DMD micromirrors are not parked"]


def test_an_exposure_below_the_limit_of_its_bit_depth_does_not_validate(client: ModuleType, device: UsbDevice) -> None:
    client.pattern_mode(period=8000, bit_depth=8)
    peer = device.peer
    for _ in range(3):
        peer.write(bytes([0, 0xC0, 9, 2, 0, 0x1A, 0x1A]).ljust(65, b"\0"))
        answer = peer.read(64, 100)
    assert answer[:5] == [0x80, 9, 1, 0, 0x01]


def test_a_report_of_another_length_is_not_taken(device: UsbDevice) -> None:
    assert device.peer.write(b"\0" * 64) == -1


def test_pulses_are_counted_across_sequences_as_a_camera_counts_them(client: ModuleType, device: UsbDevice, clock: list[float]) -> None:
    for _ in range(2):
        client.pattern_mode(period=10_000, bit_depth=8)
        clock[0] += 0.045
    assert device.peer.pulses() == 5
    client.video_mode()
    assert device.peer.all_pulses() == 2 * (1 + 5)  # the client starts twice, and the first start ends with its first pulse
