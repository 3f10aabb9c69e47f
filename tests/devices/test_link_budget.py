"""The arithmetic of a shared link against the figures of the cameras' data, and its words."""

from __future__ import annotations

import pytest

from measureapp.devices.link_budget import LinkCamera, check_link, delay_ticks, frame_s, packet_s, packets

IMAGE_BYTES = 2592 * 1944
NAMES = ("left", "right", "upper")


@pytest.mark.parametrize(
    ("packet_bytes", "count", "packet_us", "frame_ms", "mb_per_s", "three_ms", "per_s", "ticks"),
    [(1500, 3442, 12.30, 42.4, 119.0, 127.1, 7.87, 3076), (9000, 563, 72.30, 40.7, 123.8, 122.1, 8.19, 18_076)],
)
def test_packets_times_and_delays_are_those_of_the_table(
    packet_bytes: int, count: int, packet_us: float, frame_ms: float, mb_per_s: float, three_ms: float, per_s: float, ticks: int
) -> None:
    alone = LinkCamera("left", IMAGE_BYTES, packet_bytes)
    shared = LinkCamera("left", IMAGE_BYTES, packet_bytes, ticks)
    assert packets(IMAGE_BYTES, packet_bytes) == count
    assert packet_s(packet_bytes) * 1e6 == pytest.approx(packet_us, abs=0.005)
    assert frame_s(alone) * 1e3 == pytest.approx(frame_ms, abs=0.05)
    assert IMAGE_BYTES / frame_s(alone) / 1e6 == pytest.approx(mb_per_s, abs=0.05)
    assert frame_s(shared) * 1e3 == pytest.approx(three_ms, abs=0.05)
    assert 1.0 / frame_s(shared) == pytest.approx(per_s, abs=0.005)
    assert delay_ticks(packet_bytes, 3) == ticks


def test_one_camera_alone_needs_no_delay() -> None:
    assert delay_ticks(1500, 1) == 0
    assert check_link([LinkCamera("left", IMAGE_BYTES)], period_s=0.0885) == ()


def test_cameras_without_a_delay_are_told_what_they_need() -> None:
    (problem,) = check_link([LinkCamera(name, IMAGE_BYTES) for name in NAMES])
    assert "left, right and upper together send at 300 % of link ethernet (1 Gbit/s)" in problem
    assert "3076 ticks" in problem


def test_cameras_on_links_of_their_own_do_not_disturb_each_other() -> None:
    assert check_link([LinkCamera(name, IMAGE_BYTES, link=name) for name in NAMES]) == ()


def test_with_the_least_delay_three_cameras_fit_and_with_one_tick_less_they_do_not() -> None:
    assert check_link([LinkCamera(name, IMAGE_BYTES, delay_ticks=3076) for name in NAMES]) == ()
    assert len(check_link([LinkCamera(name, IMAGE_BYTES, delay_ticks=3070) for name in NAMES])) == 1


def test_an_exposure_shorter_than_the_transfer_slows_the_sequence_down() -> None:
    cameras = [LinkCamera(name, IMAGE_BYTES, delay_ticks=3076) for name in NAMES]
    (problem,) = check_link(cameras, period_s=0.0885)
    assert "transferred in 127.1 ms" in problem
    assert "after 88.5 ms" in problem
    (tight,) = check_link(cameras, period_s=0.1285)
    assert "less than 10 %" in tight
    assert check_link(cameras, period_s=0.1685) == ()


def test_twelve_bits_in_two_bytes_double_the_transfer() -> None:
    assert frame_s(LinkCamera("left", 2 * IMAGE_BYTES)) == pytest.approx(2 * frame_s(LinkCamera("left", IMAGE_BYTES)), rel=1e-3)
