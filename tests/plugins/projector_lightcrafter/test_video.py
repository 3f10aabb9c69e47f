"""Patterns through the video port: the screen shows them, the controller displays one of 8 bits per frame."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from contracts.drivers.projector_lightcrafter import SIZE, connect
from contracts.drivers.projector_second_screen import screens

from measureapp.devices.projector import DARK, PLAIN_LIGHT, TriggeringProjector
from measureapp.errors import DeviceError, InputError
from measureapp.peers.lightcrafter import Light, VirtualLightCrafter

SCREEN = {"driver": "projector_second_screen", "settings": {"name": "beamer", "latency_s": 0.0}}


@pytest.fixture
def video(peer: VirtualLightCrafter) -> Iterator[Any]:
    with screens(main=(640, 480), beamer=(SIZE[1], SIZE[0])):
        driver = connect(peer, "software", source="video", video=SCREEN)
    driver.load(np.arange(4, dtype=np.uint8)[:, None, None] * np.ones(SIZE, np.uint8))
    yield driver
    driver.close()


def test_any_images_are_shown_without_being_in_flash(video: Any, peer: VirtualLightCrafter) -> None:
    for index in (3, PLAIN_LIGHT, 0):
        video.show(index, timeout_s=2.0)
        assert video.shown() == index
        assert peer.lit() == Light(None, 0, 8, 4)
    video.show(DARK, timeout_s=2.0)
    assert video.shown() == DARK and peer.lit() is None


def test_each_frame_of_the_video_shows_one_pattern_of_8_bits(video: Any, peer: VirtualLightCrafter) -> None:
    assert peer.patterns.hex() == "014804"  # number 0, external trigger; blue, 8 bits; swap
    settings = dict(peer.commands)
    assert settings[0x1A22] == b"\0" and settings[0x1A23] == b"\0"
    assert settings[0x1A29] == (16_167).to_bytes(4, "little") * 2
    assert video.frame_us == 16_667
    assert not isinstance(video, TriggeringProjector)


def test_a_stop_darkens_projector_and_screen(video: Any, peer: VirtualLightCrafter) -> None:
    video.show(1, timeout_s=2.0)
    video.stop()
    assert peer.lit() is None and video.shown() == DARK
    video.show(2, timeout_s=2.0)
    assert video.shown() == 2


def test_the_state_is_that_of_projector_and_screen(video: Any, peer: VirtualLightCrafter) -> None:
    assert "on the screen beamer" in video.status().text
    peer.faults.hardware = 0x80
    assert video.status().text == "the sequencer reports an error"


def test_a_screen_that_is_not_there_releases_the_projector(peer: VirtualLightCrafter) -> None:
    with screens(main=(640, 480)), pytest.raises(DeviceError, match="No screen has name 'beamer'"):
        connect(peer, "software", source="video", video=SCREEN)
    assert peer.closed


def test_a_wrong_setting_of_the_screen_is_named(peer: VirtualLightCrafter) -> None:
    with pytest.raises(InputError, match="settings of the screen at the video port: latency_s"):
        connect(peer, "software", source="video", video={"driver": "projector_second_screen", "settings": {"latency_s": -1}})
