"""The head takes all cameras together, in either way of synchronisation, as fast as exposures, read-outs and one link allow."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

import numpy as np
import pytest

from measureapp.devices.camera import Camera, Frame
from measureapp.devices.head import HardwareHead, SoftwareHead
from measureapp.devices.head_timing import check_timing, period_us
from measureapp.devices.plugin_loader import load_driver
from measureapp.devices.projector import PLAIN_LIGHT
from measureapp.devices.rig import Rig
from measureapp.errors import DeviceError, FrameError, LimitError, SequenceError
from measureapp.project.rig_file import read_rig
from measureapp.simulate.parts import make_part
from measureapp.simulate.world import World

BRACKET_US = (100_000, 80_000, 60_000, 40_000, 20_000)
PATTERNS = 8
HEADS = {"software": SoftwareHead, "hardware": HardwareHead}


class Undrawn(World):
    """A world whose images cost nothing: each has the number of the pattern shown, as the virtual projector knows it, in every pixel."""

    def image(self, camera: str, exposure_us: int) -> np.ndarray:
        described = self.description.camera(camera)
        return np.full((described.height_px, described.width_px), self.shown + 10, np.uint8)


@pytest.fixture(params=["full", "quarter"])
def resolution(request: pytest.FixtureRequest) -> str:
    return request.param


def connected(resolution: str = "quarter") -> tuple[Rig, object]:
    description = read_rig("paper").at_resolution(resolution)
    module = load_driver(None, "virtual_rig", "rig").module
    clock = module.SteppingClock()
    rig = module.rig_of(Undrawn(description, make_part("flat"), 3), clock)
    rig.projector.load(np.zeros((PATTERNS, rig.projector.height_px, rig.projector.width_px), np.uint8))
    return rig, clock


@pytest.mark.parametrize("way", HEADS)
def test_every_pattern_is_taken_by_every_camera_at_every_exposure(way: str) -> None:
    rig, _ = connected()
    head = HEADS[way](rig.cameras, rig.projector)
    head.prepare(range(PATTERNS), BRACKET_US)
    shots = list(head.acquire())
    assert [(shot.exposure_us, shot.pattern) for shot in shots] == [(e, p) for e in BRACKET_US for p in range(PATTERNS)]
    for shot in shots:
        assert set(shot.frames) == set(rig.cameras)
        assert all(frame.pixels[0, 0] == shot.pattern + 10 for frame in shot.frames.values())


def test_all_cameras_are_triggered_together() -> None:
    rig, _ = connected()
    head = SoftwareHead(rig.cameras, rig.projector)
    head.prepare(range(PATTERNS), (20_000,))
    for shot in head.acquire():
        assert len({frame.device_time_s for frame in shot.frames.values()}) == 1


def test_a_hardware_sequence_of_the_paper_s_bracket_takes_little_more_than_exposures_and_read_outs() -> None:
    """Three cameras of 5 megapixels on one link of 1 Gbit/s: transfers overlap the next exposure."""
    rig, clock = connected("full")
    head = HardwareHead(rig.cameras, rig.projector)
    head.prepare(range(PATTERNS), BRACKET_US)
    started = clock.now()  # type: ignore[attr-defined]
    assert len(list(head.acquire())) == 40
    seconds = clock.now() - started  # type: ignore[attr-defined]
    camera = next(iter(rig.cameras.values()))
    exposures_s = sum(PATTERNS * (exposure_us * 1e-6 + camera.readout_s) for exposure_us in BRACKET_US)
    assert seconds - camera.transfer_s <= 1.08 * exposures_s, "until the last row is read out"
    assert seconds <= 1.102 * exposures_s, "until the last image has arrived"


def test_a_software_sequence_hides_transfers_and_pays_for_the_projector_s_latency_only() -> None:
    rig, clock = connected("full")
    head = SoftwareHead(rig.cameras, rig.projector)
    head.prepare(range(PATTERNS), BRACKET_US)
    started = clock.now()  # type: ignore[attr-defined]
    list(head.acquire())
    camera = next(iter(rig.cameras.values()))
    latency_s = 0.02
    least = sum(PATTERNS * max(exposure_us * 1e-6 + camera.readout_s + latency_s, camera.transfer_s) for exposure_us in BRACKET_US)
    assert clock.now() - started <= 1.01 * least + camera.transfer_s  # type: ignore[attr-defined]


class Disturbed:
    """A camera of the rig whose images are changed on their way."""

    def __init__(self, camera: Camera, change: object) -> None:
        self._camera, self._change, self._count = camera, change, 0

    def __getattr__(self, name: str) -> object:
        return getattr(self._camera, name)

    def next_frame(self, *, timeout_s: float) -> Frame:
        self._count += 1
        return self._change(self._camera.next_frame(timeout_s=timeout_s), self._count)  # type: ignore[operator]


def damaged(frame: Frame, count: int) -> Frame:
    if count in (3, 4):
        raise FrameError("The buffer is incomplete.", "Check the link.")
    return frame


def always_damaged(frame: Frame, count: int) -> Frame:
    raise FrameError("The buffer is incomplete.", "Check the link.")


def skipping(frame: Frame, count: int) -> Frame:
    return replace(frame, number=frame.number + (count > 3))


@pytest.mark.parametrize("way", HEADS)
def test_damaged_images_are_taken_again_and_come_last(way: str) -> None:
    rig, _ = connected()
    cameras = {**rig.cameras, "right": Disturbed(rig.cameras["right"], damaged)}
    head = HEADS[way](cameras, rig.projector)
    head.prepare(range(PATTERNS), (20_000,))
    shots = list(head.acquire())
    assert sorted(shot.pattern for shot in shots) == list(range(PATTERNS))
    assert [shot.pattern for shot in shots[-2:]] == [2, 3]
    assert all(frame.pixels[0, 0] == shot.pattern + 10 for shot in shots for frame in shot.frames.values())


@pytest.mark.parametrize("way", HEADS)
def test_an_image_that_stays_damaged_is_given_up_after_three_retakes(way: str) -> None:
    rig, _ = connected()
    taken: Counter[int] = Counter()

    def change(frame: Frame, count: int) -> Frame:
        if frame.pixels[0, 0] == 12:
            taken[2] += 1
            raise FrameError("The buffer is incomplete.", "Check the link.")
        return frame

    head = HEADS[way]({**rig.cameras, "left": Disturbed(rig.cameras["left"], change)}, rig.projector)
    head.prepare(range(PATTERNS), (20_000,))
    with pytest.raises(FrameError, match="taken again 3 times in vain"):
        list(head.acquire())
    assert taken[2] == 4


@pytest.mark.parametrize("way", HEADS)
def test_numbers_that_jump_end_the_sequence_because_images_cannot_be_assigned(way: str) -> None:
    rig, _ = connected()
    head = HEADS[way]({**rig.cameras, "upper": Disturbed(rig.cameras["upper"], skipping)}, rig.projector)
    head.prepare(range(PATTERNS), (20_000,))
    with pytest.raises(SequenceError, match="Camera upper delivered image 4 where image 3 was due"):
        list(head.acquire())


def test_pulses_that_the_projector_did_not_send_are_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    rig, _ = connected()
    monkeypatch.setattr(rig.projector, "triggers_sent", lambda: PATTERNS + 1)
    head = HardwareHead(rig.cameras, rig.projector)
    head.prepare(range(PATTERNS), (20_000,))
    with pytest.raises(SequenceError, match="9 trigger pulses for 8 patterns"):
        list(head.acquire())


def test_an_exposure_that_a_camera_clamps_is_refused_before_anything_is_taken(monkeypatch: pytest.MonkeyPatch) -> None:
    rig, _ = connected()
    monkeypatch.setattr(rig.cameras["right"], "exposure_us", lambda: 50_000)
    head = SoftwareHead(rig.cameras, rig.projector)
    with pytest.raises(DeviceError, match="right set 50000 µs instead of the requested 100000"):
        head.prepare((PLAIN_LIGHT,), (100_000,))


def test_an_exposure_must_fit_whole_frames_of_the_projector(monkeypatch: pytest.MonkeyPatch) -> None:
    rig, _ = connected()
    monkeypatch.setattr(rig.projector, "frame_us", 16_667, raising=False)
    check_timing(rig.cameras, rig.projector, 100_000)
    with pytest.raises(LimitError, match=r"not a whole number of the frames.*Choose 33334 or 50001"):
        check_timing(rig.cameras, rig.projector, 40_000)
    with pytest.raises(LimitError, match="16667"):
        check_timing(rig.cameras, rig.projector, 8_000)


@pytest.mark.parametrize(
    ("shutter", "gated", "fits"),
    [
        ("rolling", True, False),
        ("rolling", False, True),
        ("global-reset", True, True),
        ("global-reset", False, False),
        ("global", True, True),
    ],
)
def test_rows_that_would_see_different_light_are_refused(shutter: str, gated: bool, fits: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    rig, _ = connected()
    monkeypatch.setattr(rig.cameras["left"], "shutter", shutter, raising=False)
    others = {"left": rig.cameras["left"]}
    if fits:
        check_timing(others, rig.projector, 40_000, gated=gated)
        return
    with pytest.raises(DeviceError, match="Camera left"):
        check_timing(others, rig.projector, 40_000, gated=gated)


def test_the_period_covers_exposure_read_out_and_the_transfer_of_all_cameras() -> None:
    rig, _ = connected("full")
    camera = rig.cameras["left"]
    assert period_us(rig.cameras, 100_000) == pytest.approx(1e6 * camera.readout_s + 101_000, abs=1)
    assert period_us(rig.cameras, 20_000) == pytest.approx(1e6 * camera.transfer_s, abs=1)
    assert camera.transfer_s == pytest.approx(0.1221, abs=0.0001)
    assert camera.readout_s == pytest.approx(0.06853, abs=1e-5)
