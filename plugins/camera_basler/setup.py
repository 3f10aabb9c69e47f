"""Bringing a camera into a known state, in the order that its settings depend on each other."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, floor

from measureapp.data.rig import CameraDescription
from measureapp.devices.camera import Shutter
from measureapp.devices.link_budget import TICK_HZ, LinkCamera, delay_ticks
from measureapp.errors import DeviceError

from . import nodes as names
from .nodes import Nodes
from .settings import BaslerSettings

SHUTTER_WORDS: dict[Shutter, tuple[str, ...]] = {
    "rolling": ("Rolling",),
    "global-reset": ("GlobalResetRelease", "GlobalReset"),
    "global": ("Global",),
}
READOUT_START_US: dict[Shutter, float] = {"rolling": 490.0, "global-reset": 810.0, "global": 0.0}
PACKED = {10: ("Mono10Packed", "Mono10p"), 12: ("Mono12Packed", "Mono12p")}
PACKED_BITS = {"Mono8": 8, "Mono10p": 10, "Mono10Packed": 12, "Mono12p": 12, "Mono12Packed": 12}  # the others: 16
CHUNKS = ("exposuretime", "frametriggerignoredcounter", "payloadcrc16")


@dataclass(frozen=True, slots=True)
class SetUp:
    """What is known of a camera after it was set up."""

    pixel_format: str
    image_bytes: int
    readout_s: float
    exposure_limits_us: tuple[int, int]
    exposure_step_us: int
    tick_hz: float  # of the time stamps of images
    link: LinkCamera


def set_up(nodes: Nodes, camera: CameraDescription, settings: BaslerSettings, cameras_on_link: int) -> SetUp:
    """Set everything but the exposure, reading each setting back.

    Raises
    ------
    DeviceError
        The camera lacks a setting, or reads another value back.
    """
    _load_defaults(nodes)
    _set_trigger(nodes)
    pixel_format = _set_image(nodes, camera, settings)
    _set_shutter(nodes, settings.shutter)
    _set_levels(nodes, settings)
    _enable_chunks(nodes)
    image_bytes = ceil(camera.width_px * camera.height_px * PACKED_BITS.get(pixel_format, 16) / 8)
    link = _set_link(nodes, camera.name, settings, image_bytes, cameras_on_link)
    accepted = nodes.range(names.EXPOSURE)
    readout_us = nodes.number(names.READOUT)
    if readout_us is None:
        readout_us = settings.row_us * camera.height_px + (READOUT_START_US[settings.shutter] if settings.row_us else 0.0)
    return SetUp(
        pixel_format,
        image_bytes,
        readout_us * 1e-6,
        (ceil(accepted.low), floor(accepted.high)),
        max(1, ceil(accepted.step or nodes.number(names.EXPOSURE_STEP) or 1.0)),
        nodes.number(names.TICK_RATE) or 1e9,
        link,
    )


def set_hardware_trigger(nodes: Nodes, settings: BaslerSettings) -> None:
    """Let a trigger line or an action command start the exposures."""
    source = settings.hardware_trigger
    if source == "Action1":
        nodes.write_number(("ActionDeviceKey",), settings.action.device_key)
        nodes.write_number(("ActionGroupKey",), settings.action.group_key)
        nodes.write_number(("ActionGroupMask",), settings.action.group_mask)
    elif settings.debounce_us is not None and nodes.has("LineSelector"):
        nodes.write_word(("LineSelector",), source)
        if nodes.has(*names.DEBOUNCE):
            nodes.write_number(names.DEBOUNCE, settings.debounce_us, step=1.0)
    nodes.write_word(("TriggerSource",), source)
    nodes.write_word(("TriggerActivation",), "RisingEdge")


def _load_defaults(nodes: Nodes) -> None:
    if nodes.has("UserSetSelector"):
        nodes.write_word(("UserSetSelector",), "Default")
        nodes.execute("UserSetLoad")
    for automatic in ("ExposureAuto", "GainAuto"):
        if nodes.has(automatic):
            nodes.write_word((automatic,), "Off")
    nodes.write_word(("AcquisitionMode",), "Continuous")


def _set_trigger(nodes: Nodes) -> None:
    """Switch every trigger off but that of single images; a user set may have left another one on."""
    for selected in nodes.words("TriggerSelector"):
        nodes.write_word(("TriggerSelector",), selected)
        if "Off" in nodes.words("TriggerMode"):
            nodes.write_word(("TriggerMode",), "Off")
    nodes.write_word(("TriggerSelector",), "FrameStart")
    nodes.write_word(("TriggerMode",), "On")
    nodes.write_word(("TriggerSource",), "Software")
    if nodes.has("ExposureMode"):
        nodes.write_word(("ExposureMode",), "Timed")


def _set_image(nodes: Nodes, camera: CameraDescription, settings: BaslerSettings) -> str:
    packed = PACKED.get(camera.bit_depth, ()) if settings.packed else ()
    pixel_format = nodes.write_word(("PixelFormat",), *packed, f"Mono{camera.bit_depth}")
    sides = (("OffsetX", "Width", camera.width_px, settings.offset_px[0]), ("OffsetY", "Height", camera.height_px, settings.offset_px[1]))
    for offset, size, pixels, start in sides:
        nodes.write_number((offset,), 0)  # the largest size depends on it
        largest = nodes.range((size,)).high
        if pixels + start > largest:
            raise DeviceError(
                f"Camera {camera.name} has {largest:g} pixels of {size.lower()}, fewer than the {pixels + start} of the rig description.",
                "Correct width_px and height_px in the rig description, or offset_px in the settings.",
            )
        if nodes.write_number((size,), pixels) != pixels or nodes.write_number((offset,), start) != start:
            raise DeviceError(
                f"Camera {camera.name} does not accept {size} {pixels} at {offset} {start}.",
                "Choose multiples of its step (often 2 or 16).",
            )
    return pixel_format


def _set_shutter(nodes: Nodes, shutter: Shutter) -> None:
    """Set the shutter mode, if the camera has several; never while it acquires, which may crash it."""
    if nodes.has(*names.SHUTTER):
        nodes.write_word(names.SHUTTER, *SHUTTER_WORDS[shutter])
    elif nodes.has(*names.GLOBAL_RESET):
        nodes.write_flag(names.GLOBAL_RESET, shutter == "global-reset")


def _set_levels(nodes: Nodes, settings: BaslerSettings) -> None:
    if settings.gain is not None or nodes.has(*names.GAIN):
        nodes.write_number(names.GAIN, nodes.range(names.GAIN).low if settings.gain is None else settings.gain)
    if settings.black_level is not None:
        nodes.write_number(names.BLACK_LEVEL, settings.black_level)


def _enable_chunks(nodes: Nodes) -> None:
    """Let the camera send exposure, ignored triggers and check sequence with every image, where it can."""
    wanted = [word for word in nodes.words("ChunkSelector") if word.lower() in CHUNKS]
    if not wanted:
        return
    nodes.write_flag(("ChunkModeActive",), True)
    for word in wanted:
        nodes.write_word(("ChunkSelector",), word)
        nodes.write_flag(("ChunkEnable",), True)


def _set_link(nodes: Nodes, name: str, settings: BaslerSettings, image_bytes: int, cameras: int) -> LinkCamera:
    """Set packet size and inter-packet delay so that the cameras of the link can send at once."""
    if not nodes.has(*names.PACKET_SIZE):
        return LinkCamera(name, image_bytes, link=settings.link)
    size = round(nodes.write_number(names.PACKET_SIZE, settings.packet_bytes))
    tick_hz = nodes.number(names.TICK_RATE) or TICK_HZ
    wanted = delay_ticks(size, cameras, tick_hz) if settings.inter_packet_delay is None else settings.inter_packet_delay
    delay = round(nodes.write_number(names.PACKET_DELAY, wanted))
    return LinkCamera(name, image_bytes, size, delay, tick_hz, settings.link)
