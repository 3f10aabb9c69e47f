"""A camera in whatever state is brought into that of the settings; what is then known of it."""

from __future__ import annotations

from dataclasses import dataclass

from measureapp.data.rig import CameraDescription
from measureapp.devices.camera import Shutter
from measureapp.errors import DeviceError, InputError

from .features import DEBOUNCE, EXPOSURE, FIRMWARE, GAIN, READOUT, SHUTTER, SLOW_S, Features
from .pixels import FORMATS, GreyFormat
from .settings import GenicamSettings

SHUTTERS: dict[str, Shutter] = {
    "Global": "global",
    "Rolling": "rolling",
    "GlobalReset": "global-reset",
    "GlobalResetRelease": "global-reset",
}
CHUNK_EXPOSURE = "ChunkExposureTime"
PACKET_HEADERS_BYTES, ETHERNET_BYTES = 36, 38  # IP, UDP and GVSP; Ethernet with preamble and gap
DELAY_STEP_US = 0.5  # clocks of cameras are finer


@dataclass(frozen=True, slots=True)
class CameraFacts:
    """What does not change while a camera is connected."""

    pixel_format: GreyFormat
    exposure: str  # name of the feature
    exposure_limits_us: tuple[int, int]
    exposure_step_us: int
    shutter: Shutter
    readout_s: float
    payload_bytes: int
    transfer_s: float
    exposure_chunk: str  # name of the chunk with the exposure of an image; empty: images have none
    reports_ready: bool  # whether the camera tells that it waits for a trigger
    identity: str


def set_up(features: Features, description: CameraDescription, settings: GenicamSettings) -> CameraFacts:
    """Write all settings, each read back, and collect the facts. Raises DeviceError, InputError."""
    if features.link.call("available", "AcquisitionStop"):
        features.link.call("execute", "AcquisitionStop")  # a program that crashed may have left it running, and settings locked
    features.load_user_set(settings.user_set)
    for name in ("ExposureAuto", "GainAuto"):
        features.write_if_any(name, "Off")
    features.write_if_any("ExposureMode", "Timed")
    features.write("AcquisitionMode", "Continuous")
    features.all_triggers_off()
    _set_region(features, description, settings)
    pixel_format = _set_pixel_format(features, description, settings)
    for names, value in ((GAIN, settings.gain), (DEBOUNCE, settings.debounce_us)):
        if value is not None:
            features.write_number(names, value)
    packets = _set_packets(features, settings)
    chunk = _enable_exposure_chunk(features) if settings.exposure_chunk else ""
    payload_bytes = features.link.call("payload_bytes")
    exposure = features.need(EXPOSURE)
    low, high, step = features.link.call("bounds", exposure)
    return CameraFacts(
        pixel_format,
        exposure,
        (max(1, int(-(-low // 1))), int(high)),
        max(1, round(step)),
        SHUTTERS.get(str(features.read_first(SHUTTER)), settings.shutter),
        1e-6 * float(features.read_first(READOUT) or 1e6 * settings.readout_s),
        payload_bytes,
        transfer_s(payload_bytes, packets, settings.link_mbit_per_s, settings.cameras_on_link),
        chunk,
        _reports_ready(features),
        f"{features.read_first(('DeviceModelName',))} {description.serial}, firmware {features.read_first(FIRMWARE)}",
    )


def transfer_s(payload_bytes: int, packets: tuple[int, int] | None, link_mbit_per_s: int, cameras: int) -> float:
    """Return how long an image takes on a link that ``cameras`` share, each sending one.

    Parameters
    ----------
    packets : size of a packet with its IP, UDP and GVSP headers (bytes), and the delay after each (ns); None: USB3 Vision
    """
    if packets is None:
        return cameras * payload_bytes * 8e-6 / link_mbit_per_s
    size_bytes, delay_ns = packets
    count = -(-payload_bytes // (size_bytes - PACKET_HEADERS_BYTES))
    wire_s = count * (size_bytes + ETHERNET_BYTES) * 8e-6 / link_mbit_per_s
    return max(cameras * wire_s, wire_s + count * delay_ns * 1e-9)


def _set_region(features: Features, description: CameraDescription, settings: GenicamSettings) -> None:
    for name in ("OffsetX", "OffsetY"):  # first: they limit the size
        features.write_if_any(name, 0)
    features.write_number(("Width",), description.width_px)
    features.write_number(("Height",), description.height_px)
    for name, value in (("OffsetX", settings.offset_x_px), ("OffsetY", settings.offset_y_px)):
        if value:
            features.write_number((name,), value)


def _set_pixel_format(features: Features, description: CameraDescription, settings: GenicamSettings) -> GreyFormat:
    offered = features.link.call("entries", "PixelFormat")
    wanted = [name for name in settings.formats(description.bit_depth) if FORMATS[name].bits == description.bit_depth]
    chosen = next((name for name in wanted if name in offered), None)
    if chosen is None:
        raise InputError(
            f"Camera {description.name} has no pixel format for {description.bit_depth} bit "
            f"(setting: {settings.pixel_format}; the camera has {', '.join(offered)}).",
            "Correct bit_depth in the rig description, or pixel_format in the camera's settings.",
        )
    features.write("PixelFormat", chosen)
    return FORMATS[chosen]


def _set_packets(features: Features, settings: GenicamSettings) -> tuple[int, int] | None:
    """Set size (bytes) of and delay (ns) between packets and return both; None for USB3 Vision, which has none."""
    delay_ns = None if settings.packet_delay_us is None else round(1000 * settings.packet_delay_us)
    read = features.link.call("packets", settings.packet_size_bytes, delay_ns, timeout_s=SLOW_S)
    if read is None:
        return None
    size_bytes, read_ns = read
    if settings.packet_size_bytes not in (None, size_bytes) or abs(read_ns - (delay_ns or 0)) > 1000 * DELAY_STEP_US:
        raise DeviceError(
            f"Camera {features.camera}: packets have {size_bytes} bytes and a delay of {read_ns / 1000:g} µs, "
            f"instead of {settings.packet_size_bytes or size_bytes} bytes and {settings.packet_delay_us or 0:g} µs.",
            "Choose a packet size and a delay that the camera supports.",
        )
    return size_bytes, read_ns


def _enable_exposure_chunk(features: Features) -> str:
    """Let each image carry its exposure; empty where the camera cannot."""
    if not features.link.call("available", "ChunkModeActive"):
        return ""
    features.write("ChunkModeActive", True)
    if not features.link.call("available", "ChunkSelector") or "ExposureTime" not in features.link.call("entries", "ChunkSelector"):
        features.write("ChunkModeActive", False)
        return ""
    features.write("ChunkSelector", "ExposureTime")
    features.write("ChunkEnable", True)
    return CHUNK_EXPOSURE


def _reports_ready(features: Features) -> bool:
    if features.first(("AcquisitionStatus",)) is None:
        return False
    if "FrameTriggerWait" not in features.link.call("entries", "AcquisitionStatusSelector"):
        return False
    features.write("AcquisitionStatusSelector", "FrameTriggerWait")
    return True
