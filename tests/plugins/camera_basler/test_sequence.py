"""Which results count as images, and which number each of them gets."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from types import ModuleType

import pytest

from measureapp.errors import DeviceError, DeviceTimeout, FrameError, SequenceError

from .conftest import SERIAL, Connect
from .fake_pylon import FakeCamera, Result, ace_2_usb, damaged

SOON_S = 1.0


def spoiled(block: int, made: Callable[[Result], list[Result]]) -> Callable[[Result], list[Result]]:
    """Change what arrives for the image with one block id."""
    return lambda result: made(result) if result.block == block else [result]


def test_a_hardware_sequence_is_numbered_and_has_exposure_and_time_of_every_image(connect: Connect, fake: FakeCamera) -> None:
    camera = connect(fake)
    camera.arm(8, "hardware")
    for _ in range(8):
        fake.fire()
    frames = [camera.next_frame(timeout_s=SOON_S) for _ in range(8)]
    assert [frame.number for frame in frames] == list(range(8))
    assert {(frame.serial, frame.exposure_us) for frame in frames} == {(SERIAL, 35_000)}
    assert frames[1].device_time_s == pytest.approx((frames[0].device_time_s or 0.0) + 0.001)
    assert fake.released == list(range(1, 9)), "every buffer is given back"
    with pytest.raises(DeviceError, match="not armed for triggers by the program"):
        camera.trigger()


def test_a_damaged_image_is_refused_although_its_error_code_is_0_and_the_sequence_goes_on(connect: Connect, fake: FakeCamera) -> None:
    camera = connect(fake)
    fake.spoil = spoiled(2, lambda result: [damaged(result)])
    camera.arm(3, "software")
    numbers: list[int] = []
    for trigger in range(3):
        camera.trigger()
        if trigger == 1:
            with pytest.raises(FrameError, match="Camera left: the image is damaged or incomplete") as caught:
                camera.next_frame(timeout_s=SOON_S)
            assert not isinstance(caught.value, SequenceError)
        else:
            numbers.append(camera.next_frame(timeout_s=SOON_S).number)
    assert numbers == [0, 2]
    assert (camera.statistics().frames, camera.statistics().failed_frames) == (2, 1)
    assert fake.released == [1, 2, 3]


def test_an_image_without_all_its_bytes_or_with_a_wrong_check_sequence_is_refused(connect: Connect, fake: FakeCamera) -> None:
    camera = connect(fake)
    for change, words in (({"payload": 1000}, "1000 of 314928 bytes"), ({"crc_ok": False}, "check sequence")):
        fake.spoil = lambda result, change=change: [replace(result, **change)]
        camera.arm(1, "software")
        camera.trigger()
        with pytest.raises(FrameError, match=words):
            camera.next_frame(timeout_s=SOON_S)


def test_a_lost_image_leaves_a_gap_in_the_numbers(connect: Connect, fake: FakeCamera) -> None:
    camera = connect(fake)
    fake.spoil = spoiled(2, lambda _: [])
    camera.arm(4, "hardware")
    for _ in range(4):
        fake.fire()
    assert [camera.next_frame(timeout_s=SOON_S).number for _ in range(3)] == [0, 2, 3]


def test_a_lost_first_image_is_noticed_once_the_camera_s_first_id_is_known(connect: Connect, fake: FakeCamera) -> None:
    camera = connect(fake)
    for lost in (None, 1):
        fake.spoil = spoiled(lost or -1, lambda _: [])
        camera.arm(2, "hardware")
        fake.fire()
        fake.fire()
        assert camera.next_frame(timeout_s=SOON_S).number == (1 if lost else 0)


def test_a_repeated_and_an_older_image_are_refused(connect: Connect, fake: FakeCamera) -> None:
    camera = connect(fake)
    fake.spoil = spoiled(2, lambda result: [result, result, replace(result, block=1)])
    camera.arm(2, "hardware")
    fake.fire()
    fake.fire()
    assert [camera.next_frame(timeout_s=SOON_S).number for _ in range(2)] == [0, 1]
    for words in ("image 2 came after image 2", "image 1 came after image 2"):
        with pytest.raises(SequenceError, match=words):
            camera.next_frame(timeout_s=SOON_S)


def test_a_second_exposure_for_one_trigger_is_refused(connect: Connect, fake: FakeCamera) -> None:
    camera = connect(fake)
    fake.spoil = lambda result: [result, replace(result, block=result.block + 1)]
    camera.arm(5, "software")
    camera.trigger()
    camera.next_frame(timeout_s=SOON_S)
    with pytest.raises(SequenceError, match="it sent image 2 after 1 triggers"):
        camera.next_frame(timeout_s=SOON_S)


def test_more_images_than_the_sequence_has_are_refused(connect: Connect, fake: FakeCamera) -> None:
    camera = connect(fake)
    camera.arm(1, "hardware")
    fake.fire()
    fake.fire()
    camera.next_frame(timeout_s=SOON_S)
    with pytest.raises(SequenceError, match="image 2 of a sequence of 1"):
        camera.next_frame(timeout_s=SOON_S)


def test_a_trigger_that_the_camera_ignored_is_noticed(connect: Connect, fake: FakeCamera) -> None:
    camera = connect(fake)
    camera.arm(4, "hardware")
    fake.ignored = 7  # of an earlier program
    fake.fire()
    camera.next_frame(timeout_s=SOON_S)
    fake.ignored = 8
    fake.fire()
    with pytest.raises(SequenceError, match="1 triggers came while it was busy and were ignored"):
        camera.next_frame(timeout_s=SOON_S)


def test_a_trigger_without_an_exposure_is_a_timeout(connect: Connect, fake: FakeCamera) -> None:
    camera = connect(fake)
    fake.spoil = lambda _: []
    camera.arm(2, "software")
    camera.trigger()
    with pytest.raises(DeviceTimeout, match=r"no image within 0.05 s after 1 triggers"):
        camera.next_frame(timeout_s=0.05)


def test_an_image_of_another_exposure_is_refused_by_what_came_with_it(connect: Connect, fake: FakeCamera) -> None:
    camera = connect(fake)
    camera.set_exposure_us(20_000)
    fake.spoil = spoiled(2, lambda result: [replace(result, exposure_us=40_000.0)])
    camera.arm(2, "software")
    camera.trigger()
    assert camera.next_frame(timeout_s=SOON_S).exposure_us == 20_000
    camera.trigger()
    with pytest.raises(FrameError, match="image 1 was exposed for 40000 µs, not 20000 µs"):
        camera.next_frame(timeout_s=SOON_S)


def test_an_exposure_set_for_the_next_image_does_not_spoil_the_one_before(connect: Connect) -> None:
    for fake in (FakeCamera(SERIAL), FakeCamera(SERIAL, ace_2_usb(), first_block=0)):  # with and without exposures in the images
        camera = connect(fake, shutter="rolling" if "GevSCPD" in fake.nodes.nodes else "global")
        camera.set_exposure_us(80_000)
        camera.arm(2, "software")
        camera.trigger()
        camera.set_exposure_us(60_000)
        camera.trigger()
        assert [camera.next_frame(timeout_s=SOON_S).exposure_us for _ in range(2)] == [80_000, 60_000]


def test_without_exposures_in_the_images_one_that_changed_by_itself_is_noticed(connect: Connect) -> None:
    fake = FakeCamera(SERIAL, ace_2_usb(), first_block=0)
    camera = connect(fake, shutter="global")
    camera.arm(1, "software")
    camera.trigger()
    fake.nodes.nodes["ExposureTime"].value = 9999.0
    with pytest.raises(FrameError, match="its exposure reads 9999 µs, and 5000 µs was set"):
        camera.next_frame(timeout_s=SOON_S)


def test_an_image_of_another_camera_is_refused(connect: Connect, fake: FakeCamera) -> None:
    camera = connect(fake)
    fake.spoil = lambda result: [replace(result, context=result.context + 1)]
    camera.arm(1, "software")
    camera.trigger()
    with pytest.raises(DeviceError, match="an image of another camera"):
        camera.next_frame(timeout_s=SOON_S)


def test_more_triggers_than_images_are_refused(connect: Connect, fake: FakeCamera) -> None:
    camera = connect(fake)
    camera.arm(1, "software")
    camera.trigger()
    with pytest.raises(DeviceError, match="All 1 images"):
        camera.trigger()


def test_packets_are_counted_over_all_sequences_and_many_resends_are_told(connect: Connect, fake: FakeCamera) -> None:
    camera = connect(fake)
    assert camera.statistics().packets is None, "nothing is known before the first sequence"
    for _ in range(2):
        camera.arm(2, "hardware")
        fake.fire()
        fake.fire()
        fake.stream.nodes["Statistic_Resend_Packet_Count"].value = 4
        fake.stream.nodes["Statistic_Failed_Packet_Count"].value = 1
        fake.stream.nodes["Statistic_Buffer_Underrun_Count"].value = 1
    counted = camera.statistics()
    assert (counted.packets, counted.resent_packets, counted.lost_packets, counted.failed_frames) == (4000, 8, 2, 2)
    assert "0.20 % of the packets were sent again" in camera.status().text


@pytest.mark.parametrize(
    ("ids", "numbers"),
    [
        ([1, 2, 3], [0, 1, 2]),
        ([0, 1, 4], [0, 1, 4]),
        ([65_534, 65_535, 1, 2], [0, 1, 2, 3]),
        ([65_535, 3], [0, 3]),
        ([70_000, 70_001], [0, 1]),
        ([None, None], [0, 1]),
    ],
)
def test_images_are_numbered_by_the_differences_of_their_block_ids(
    module: Callable[[str], ModuleType], ids: list[int | None], numbers: list[int]
) -> None:
    counter = module("frames").BlockCounter()
    assert [counter.number(block) for block in ids] == numbers


def test_ids_that_go_on_over_sequences_are_learnt(module: Callable[[str], ModuleType]) -> None:
    counter = module("frames").BlockCounter()
    for start in (1, 4, 7):
        counter.begin()
        assert [counter.number(start + step) for step in range(3)] == [0, 1, 2]


def test_damaged_images_before_the_first_good_one_are_counted(module: Callable[[str], ModuleType]) -> None:
    counter = module("frames").BlockCounter()
    counter.skip()
    assert [counter.number(block) for block in (2, 3)] == [1, 2]
    unnumbered = module("frames").BlockCounter()
    unnumbered.number(None)
    unnumbered.skip()
    assert unnumbered.number(None) == 2
