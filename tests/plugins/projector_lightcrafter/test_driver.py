"""The projector on its virtual peer: what it is told, in which order, and what it shows."""

from __future__ import annotations

import contextlib
import threading
import time
from typing import Any

import numpy as np
import pytest
from contracts.drivers.projector_lightcrafter import SIZE, connect, contract_images, rig

from measureapp.devices.links import Links
from measureapp.devices.plugin_loader import load_driver
from measureapp.devices.projector import DARK, PLAIN_LIGHT, TriggeringProjector
from measureapp.devices.request import DeviceRequest
from measureapp.errors import DeviceError, DeviceLost, InputError, LimitError
from measureapp.peers.lightcrafter import Light, VirtualLightCrafter
from measureapp.progress import Cancelled

BLUE = 4


def test_a_sequence_is_set_in_the_order_of_the_manual(projector: Any, peer: VirtualLightCrafter) -> None:
    projector.play(0, 8, exposure_us=9000, period_us=10_000)
    codes = [f"{command >> 8:02X}:{command & 0xFF:02X}" for command, _ in peer.commands]
    table = ["1A:33", "1A:32", "1A:34", "1A:32", "1A:33"]
    order = ["1A:24", "1A:22", "1A:23", "1A:29", "1A:31", *table, *table, "1A:1D", "1A:1E", "1A:1A", "1A:07", "1A:24"]
    assert [code for code in codes if code != "1A:1B"] == order
    assert peer.commands[0][1] == b"\0" and peer.commands[-1][1] == b"\2"


def test_every_image_shown_is_the_one_declared(projector: Any, peer: VirtualLightCrafter) -> None:
    for index in (0, 2, 3, 7):
        projector.show(index, timeout_s=2.0)
        assert peer.lit() == Light(index // 3, index % 3, 8, BLUE)
        assert projector.shown() == index


def test_plain_light_lights_all_pixels_and_dark_none(projector: Any, peer: VirtualLightCrafter) -> None:
    projector.show(PLAIN_LIGHT, timeout_s=2.0)
    assert peer.lit() == Light(None, 24, 1, BLUE)
    projector.show(DARK, timeout_s=2.0)
    assert peer.lit() is None
    assert projector.shown() == DARK


def test_a_pattern_that_is_held_is_not_set_again(projector: Any, peer: VirtualLightCrafter) -> None:
    projector.show(1, timeout_s=2.0)
    peer.commands.clear()
    projector.show(1, timeout_s=2.0)
    assert not peer.commands


@pytest.mark.parametrize("count", [8, 4])  # three flash images; two, whose table is reversed
def test_patterns_are_played_once_in_order_dark_between_them_with_a_pulse_each(count: int) -> None:
    clock = [0.0]
    peer = VirtualLightCrafter(load_s=0.0, now=lambda: clock[0])
    projector = connect(peer)
    projector.load(contract_images())
    projector.play(0, count, exposure_us=9000, period_us=12_000)
    for index in range(count):
        clock[0] = 0.012 * index + 0.005
        assert peer.lit() == Light(index // 3, index % 3, 8, BLUE)
        clock[0] = 0.012 * index + 0.010
        assert peer.lit() is None
        assert peer.pulses() == index + 1
    clock[0] = 0.012 * count
    assert peer.lit() is None
    projector.close()


def test_a_sequence_that_has_ended_has_sent_a_pulse_for_each_pattern(projector: Any, peer: VirtualLightCrafter) -> None:
    projector.play(0, 8, exposure_us=9000, period_us=12_000)
    assert 1 <= projector.triggers_sent() <= 8
    end = time.monotonic() + 3.0
    while projector._controller.is_playing() and time.monotonic() < end:
        time.sleep(0.005)
    assert projector.triggers_sent() == peer.pulses() == 8
    assert projector.shown() == DARK
    assert isinstance(projector, TriggeringProjector) and projector.gated


def test_impossible_times_are_refused_before_anything_is_sent(projector: Any, peer: VirtualLightCrafter) -> None:
    for exposure_us, period_us in ((8332, 20_000), (19_771, 20_000)):
        with pytest.raises(LimitError):
            projector.play(0, 8, exposure_us=exposure_us, period_us=period_us)
    assert not peer.commands


def test_a_set_that_needs_three_images_waits_for_the_flash(peer: VirtualLightCrafter) -> None:
    peer._load_s = 0.2
    projector = connect(peer)
    projector.load(contract_images())
    with pytest.raises(LimitError, match="200 ms to load flash image 2"):
        projector.play(0, 8, exposure_us=9000, period_us=12_000)
    projector.close()


def test_images_that_are_not_declared_are_refused_with_the_way_to_program_them(projector: Any, peer: VirtualLightCrafter) -> None:
    unknown = np.full((4, *SIZE), 77, np.uint8)
    with pytest.raises(DeviceError, match=r"the pattern set of 4 images \([0-9a-f]{16}\) is not in its flash") as refused:
        projector.load(unknown)
    assert "measureapp patterns export --width 912 --height 1140" in refused.value.hint
    assert not peer.commands


def test_images_of_another_size_are_refused(projector: Any) -> None:
    with pytest.raises(DeviceError, match="does not support images of shape"):
        projector.load(contract_images()[:, :-1])


def test_an_image_beyond_the_sequence_is_refused_and_nothing_changes(projector: Any) -> None:
    projector.show(1, timeout_s=2.0)
    with pytest.raises(DeviceError, match="has 8 images and cannot show image 8"):
        projector.show(8, timeout_s=2.0)
    with pytest.raises(DeviceError, match="cannot play"):
        projector.play(5, 4, exposure_us=9000, period_us=12_000)
    assert projector.shown() == 1


@pytest.mark.timed
def test_a_stop_makes_it_dark_and_ends_a_waiting_call(projector: Any, peer: VirtualLightCrafter) -> None:
    projector.show(0, timeout_s=2.0)
    peer.faults.never_starts = True
    outcome: list[BaseException] = []

    def wait() -> None:
        try:
            projector.show(1, timeout_s=5.0)
        except BaseException as error:
            outcome.append(error)

    thread = threading.Thread(target=wait)
    thread.start()
    time.sleep(0.03)
    asked = time.monotonic()
    projector.stop()
    thread.join(1.0)
    assert time.monotonic() - asked < 0.2
    assert isinstance(outcome[0], Cancelled)
    assert peer.lit() is None


@pytest.mark.timed
def test_a_stop_takes_effect_while_another_call_waits_for_a_reply(projector: Any, peer: VirtualLightCrafter) -> None:
    projector.show(0, timeout_s=2.0)
    peer.faults.drops = {0x1A0A}
    thread = threading.Thread(target=projector.status)
    thread.start()
    time.sleep(0.02)
    stopping = threading.Thread(target=projector.stop)
    asked = time.monotonic()
    stopping.start()
    while peer.lit() is not None:
        time.sleep(0.001)
    assert time.monotonic() - asked < 0.1
    thread.join(1.0)
    stopping.join(1.0)


def test_no_start_slips_through_after_a_stop(projector: Any, peer: VirtualLightCrafter) -> None:
    def show() -> None:
        with contextlib.suppress(Cancelled):
            projector.show(0, timeout_s=2.0)

    for delay_s in np.linspace(0.0, 0.02, 12):
        thread = threading.Thread(target=show)
        thread.start()
        time.sleep(delay_s)
        projector.stop()
        thread.join(1.0)
        time.sleep(0.002)
        assert peer.lit() is None


def test_software_sequences_have_whole_cycles_and_hardware_sequences_any_exposure(peer: VirtualLightCrafter) -> None:
    assert connect(peer, "software").frame_us == 10_000
    assert connect(VirtualLightCrafter(), "hardware").frame_us == 0


def test_a_projector_in_standby_is_woken(peer: VirtualLightCrafter) -> None:
    peer.standby()
    projector = connect(peer)
    assert projector.status().ready
    assert (0x0200, b"\0") in peer.commands
    projector.close()


def test_the_trigger_edge_is_counted_in_steps_of_107_nanoseconds(peer: VirtualLightCrafter) -> None:
    projector = connect(peer, trigger_delay_us=-1.072, trigger_inverted=True)
    projector.load(contract_images())
    projector.play(0, 1, exposure_us=9000, period_us=12_000)
    assert dict(peer.commands)[0x1A1D] == bytes([1, 0xBB - 10, 0xBB])
    projector.close()


def test_the_current_counts_down_from_255(peer: VirtualLightCrafter) -> None:
    connect(peer, led_current=55).close()
    assert dict(peer.commands)[0x0B01] == bytes([200, 200, 200])


def test_the_state_names_firmware_and_patterns(projector: Any) -> None:
    status = projector.status()
    assert status.ready and status.text == "dark, rows 8, 8 images"
    assert status.identity == "LightCrafter 4500, firmware 4.2.0"


def test_closing_makes_it_dark_and_may_be_repeated(projector: Any, peer: VirtualLightCrafter) -> None:
    projector.show(0, timeout_s=2.0)
    projector.close()
    projector.close()
    assert peer.closed and peer.lit() is None
    with pytest.raises(DeviceLost, match="was released"):
        projector.show(1, timeout_s=1.0)


def test_a_rig_with_a_projector_of_another_size_is_refused() -> None:
    driver = load_driver(None, "projector_lightcrafter", "projector")
    described = rig().model_copy(update={"projector": rig().projector.model_copy(update={"width_px": 1024})})
    with pytest.raises(InputError, match="1024 × 1140 px, and a LightCrafter 4500 912 × 1140"):
        driver.entry(DeviceRequest("projector", described, driver.settings(), Links({})))


def test_no_projector_on_the_usb_is_said_in_words() -> None:
    pytest.importorskip("hid", reason="install the library by: pip install hidapi")
    driver = load_driver(None, "projector_lightcrafter", "projector")
    with pytest.raises(DeviceError, match="no LightCrafter on the USB"):
        driver.entry(DeviceRequest("projector", rig(), driver.settings(), Links({})))


def test_a_projector_that_shows_its_video_is_darkened_at_once(peer: VirtualLightCrafter) -> None:
    projector = connect(peer)
    assert [command for command, _ in peer.commands[:3]] == [0x1A07, 0x1A1B, 0x1A24]  # light off, pattern mode, stop
    assert projector.shown() == DARK and peer.lit() is None
    projector.close()
