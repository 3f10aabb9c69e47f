"""The writes that bring a camera into a known state, by the names of SFNC 1.x and 2.x, and what is refused."""

from __future__ import annotations

import pytest

from measureapp.devices.link_budget import OnLink, check_link
from measureapp.errors import DeviceError, LimitError

from .conftest import SERIAL, Connect, rig_of
from .fake_pylon import FakeCamera, Node, ace_2_usb, ace_gige

WIDTH, HEIGHT = 648, 486
DEFAULTS = [
    ("UserSetSelector", "Default"),
    ("UserSetLoad", "execute"),
    ("ExposureAuto", "Off"),
    ("GainAuto", "Off"),
    ("AcquisitionMode", "Continuous"),
]
IMAGE = [("OffsetX", 0), ("Width", WIDTH), ("OffsetX", 0), ("OffsetY", 0), ("Height", HEIGHT), ("OffsetY", 0)]


def triggers(*selected: str) -> list[tuple[str, object]]:
    off = [write for name in selected for write in (("TriggerSelector", name), ("TriggerMode", "Off"))]
    return [
        *off,
        ("TriggerSelector", "FrameStart"),
        ("TriggerMode", "On"),
        ("TriggerSource", "Software"),
        ("ExposureMode", "Timed"),
    ]


def test_an_ace_gige_is_set_up_by_the_names_of_sfnc_1(connect: Connect, fake: FakeCamera) -> None:
    camera = connect(fake)
    chunks = [
        write
        for word in ("ExposureTime", "Frametriggerignoredcounter", "PayloadCRC16")
        for write in (("ChunkSelector", word), ("ChunkEnable", True))
    ]
    assert fake.nodes.writes == [
        *DEFAULTS,
        *triggers("AcquisitionStart", "FrameStart"),
        ("PixelFormat", "Mono8"),
        *IMAGE,
        ("ShutterMode", "Rolling"),
        ("GainRaw", 0),
        ("ChunkModeActive", True),
        *chunks,
        ("GevSCPSPacketSize", 1500),
        ("GevSCPD", 3076),
    ]
    assert camera.readout_s == pytest.approx(0.06853)
    assert camera.exposure_limits_us == (35, 9_999_990)
    assert camera.exposure_step_us == 35
    assert camera.temperature_c() == 41.5


def test_a_camera_of_sfnc_2_is_set_up_by_its_own_names(connect: Connect) -> None:
    fake = FakeCamera(SERIAL, ace_2_usb(), first_block=0)
    camera = connect(fake, shutter="global", gain=6.0)
    assert fake.nodes.writes == [
        *DEFAULTS,
        *triggers("FrameBurstStart", "FrameStart"),
        ("PixelFormat", "Mono8"),
        *IMAGE,
        ("SensorShutterMode", "Global"),
        ("Gain", 6),
    ]
    camera.set_exposure_us(20_000)
    assert fake.nodes.writes[-1] == ("ExposureTime", 20_000)
    assert camera.readout_s == pytest.approx(0.0142)
    assert (camera.exposure_limits_us, camera.exposure_step_us) == ((19, 10_000_000), 1)
    assert camera.temperature_c() == 38.25
    assert fake.nodes["DeviceTemperatureSelector"] == "Coreboard"


def test_a_camera_that_reports_no_read_out_is_given_that_of_its_rows(connect: Connect) -> None:
    nodes = ace_gige()
    del nodes.nodes["ReadoutTimeAbs"]
    rolling = connect(FakeCamera(SERIAL, nodes), row_us=35.0)
    assert rolling.readout_s == pytest.approx((35 * HEIGHT + 490) * 1e-6)
    resetting = connect(FakeCamera(SERIAL, nodes), row_us=35.0, shutter="global-reset")
    assert resetting.readout_s == pytest.approx((35 * HEIGHT + 810) * 1e-6)
    assert nodes["ShutterMode"] == "GlobalResetRelease"


@pytest.mark.parametrize(
    ("bit_depth", "packed", "pixel_format", "image_bytes"),
    [(8, True, "Mono8", WIDTH * HEIGHT), (12, True, "Mono12Packed", WIDTH * HEIGHT * 3 // 2), (12, False, "Mono12", WIDTH * HEIGHT * 2)],
)
def test_the_bit_depth_of_the_rig_chooses_the_pixel_format(
    connect: Connect, fake: FakeCamera, bit_depth: int, packed: bool, pixel_format: str, image_bytes: int
) -> None:
    camera = connect(fake, rig=rig_of(bit_depth=bit_depth), packed=packed)
    assert fake.nodes["PixelFormat"] == pixel_format
    assert camera.link.image_bytes == image_bytes


def test_a_bit_depth_that_the_camera_lacks_is_refused_with_what_it_has(connect: Connect, fake: FakeCamera) -> None:
    with pytest.raises(DeviceError, match=r"no PixelFormat Mono10Packed or Mono10p or Mono10 .*Mono8, Mono12"):
        connect(fake, rig=rig_of(bit_depth=10))
    assert fake.closed == 1, "it is free for other programs"


def test_an_image_larger_than_the_sensor_is_refused(connect: Connect, fake: FakeCamera) -> None:
    with pytest.raises(DeviceError, match="has 2592 pixels of width, fewer than the 2600"):
        connect(fake, rig=rig_of(width_px=2600))


def test_a_shutter_that_the_sensor_has_not_is_refused(connect: Connect, fake: FakeCamera) -> None:
    with pytest.raises(DeviceError, match=r"no ShutterMode Global \(it has: Rolling, GlobalResetRelease\)"):
        connect(fake, shutter="global")


@pytest.mark.parametrize(("name", "setting"), [("GainRaw", {"gain": 20}), ("GevSCPD", {"inter_packet_delay": 3076})])
def test_a_value_that_the_camera_limits_is_found_before_anything_is_taken(connect: Connect, name: str, setting: dict[str, int]) -> None:
    nodes = ace_gige()
    nodes.nodes[name].accept = lambda value: min(value, 10)
    with pytest.raises(DeviceError, match=f"reads back {name} = 10"):
        connect(FakeCamera(SERIAL, nodes), **setting)


def test_an_exposure_that_the_camera_ignores_or_limits_is_found_at_once(connect: Connect, fake: FakeCamera) -> None:
    camera = connect(fake)
    before = fake.nodes["ExposureTimeAbs"]
    fake.nodes.nodes["ExposureTimeAbs"].accept = lambda _: before
    with pytest.raises(DeviceError, match=r"reads back ExposureTimeAbs = 35000\.0 after 20000 was set"):
        camera.set_exposure_us(20_000)
    fake.nodes.nodes["ExposureTimeAbs"].accept = lambda value: 35.0 * round(value / 35.0)
    camera.set_exposure_us(20_000)
    assert camera.exposure_us() == 19_985, "within one step of 35 µs"


def test_an_exposure_outside_the_limits_is_not_sent(connect: Connect, fake: FakeCamera) -> None:
    camera = connect(fake)
    sent = len(fake.nodes.writes)
    for exposure_us in (34, 9_999_991):
        with pytest.raises(LimitError, match="35…9999990"):
            camera.set_exposure_us(exposure_us)
    assert len(fake.nodes.writes) == sent


def test_a_gain_outside_the_limits_is_refused_with_the_camera_s_reason(connect: Connect, fake: FakeCamera) -> None:
    with pytest.raises(DeviceError, match="refused GainRaw = 64: Value 64 must be between 0 and 63"):
        connect(fake, gain=64)


def test_a_setting_that_the_camera_lacks_is_named(connect: Connect) -> None:
    nodes = ace_gige()
    del nodes.nodes["GainRaw"]
    with pytest.raises(DeviceError, match="has no setting GainRaw or Gain"):
        connect(FakeCamera(SERIAL, nodes), gain=3)


def test_the_line_trigger_is_set_with_its_debouncer(connect: Connect, fake: FakeCamera) -> None:
    camera = connect(fake, debounce_us=30)
    sent = len(fake.nodes.writes)
    camera.arm(8, "hardware")
    camera.arm(8, "hardware")
    camera.arm(8, "software")
    assert fake.nodes.writes[sent:] == [
        ("LineSelector", "Line1"),
        ("LineDebouncerTimeAbs", 30),
        ("TriggerSource", "Line1"),
        ("TriggerActivation", "RisingEdge"),
        ("TriggerSource", "Software"),
    ]


def test_an_action_command_as_trigger_is_set_with_its_keys(connect: Connect, fake: FakeCamera) -> None:
    camera = connect(fake, hardware_trigger="Action1", action={"device_key": 11, "group_key": 12, "group_mask": 3})
    sent = len(fake.nodes.writes)
    camera.arm(8, "hardware")
    assert fake.nodes.writes[sent:] == [
        ("ActionDeviceKey", 11),
        ("ActionGroupKey", 12),
        ("ActionGroupMask", 3),
        ("TriggerSource", "Action1"),
        ("TriggerActivation", "RisingEdge"),
    ]


def test_three_cameras_share_their_link_and_one_alone_has_it_for_itself(connect: Connect, fake: FakeCamera) -> None:
    shared = connect(fake)
    assert isinstance(shared, OnLink)
    assert check_link([shared.link] * 3) == ()
    delayed = connect(FakeCamera(SERIAL), inter_packet_delay=0)
    assert "300 %" in check_link([delayed.link] * 3)[0]
    rig = rig_of()
    choices = {name: {"driver": "camera_basler", "settings": {"link": name}} for name in ("left", "right", "upper")}
    others = {name: {"driver": "other"} for name in ("projector", "robot", "guide", "table")}
    apart = type(rig).model_validate({**rig.model_dump(), "driver": "", "devices": {**choices, **others}})
    alone = connect(FakeCamera(SERIAL), rig=apart, link="left")
    assert (alone.link.delay_ticks, alone.link.link) == (0, "left")
    assert alone.transfer_s == pytest.approx(shared.transfer_s / 3, rel=1e-3)


def test_a_camera_without_packets_has_no_delay(connect: Connect) -> None:
    camera = connect(FakeCamera(SERIAL, ace_2_usb(), first_block=0), shutter="global")
    assert camera.link.delay_ticks == 0
    assert camera.transfer_s == 0.0


def test_a_word_that_the_camera_does_not_keep_is_found(connect: Connect) -> None:
    stubborn = Node("Once", ("Off", "Once", "Continuous"))
    stubborn.accept = lambda _: "Once"
    with pytest.raises(DeviceError, match="reads back ExposureAuto = Once after Off was set"):
        connect(FakeCamera(SERIAL, ace_gige(ExposureAuto=stubborn)))
