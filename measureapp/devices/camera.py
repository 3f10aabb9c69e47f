"""Camera interface, and an image with the identification reported by the camera."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, Protocol, runtime_checkable

from measureapp.arrays import ImageArray
from measureapp.data.conditions import LensSetting
from measureapp.devices.status import DeviceStatus

Trigger = Literal["software", "hardware"]
Shutter = Literal["global", "rolling", "global-reset"]
"""How the rows of a sensor are exposed: all at once, one after the other, or from a common start to staggered ends."""
MUCH_RESENT = 0.001  # share of packets sent again from which the link deserves attention


@dataclass(frozen=True, slots=True, eq=False)
class Frame:
    """One complete image with what the camera reports about it.

    Which pattern it shows is not the camera's to know: that follows from the order of triggers and from the image itself.
    """

    pixels: ImageArray  # (height, width), uint8 or uint16; the receiver's own copy
    serial: str
    number: int  # counted from 0 at `Camera.arm`; a gap or a repeat means a lost or stale image
    exposure_us: int | None  # as read back with the image, or at its software trigger, rounded; None where the camera cannot tell
    device_time_s: float | None = None  # by the camera's clock; None if it has none


@dataclass(frozen=True, slots=True)
class StreamStatistics:
    """Counters of the image stream since the camera was connected; None where the driver cannot tell."""

    frames: int = 0
    failed_frames: int = 0  # incomplete or rejected by the driver
    resent_packets: int | None = None
    lost_packets: int | None = None
    packets: int | None = None

    @property
    def resend_share(self) -> float | None:
        """Resent packets relative to all."""
        return self.resent_packets / self.packets if self.packets and self.resent_packets is not None else None

    @property
    def warning(self) -> str:
        """What a person should know about the link, as the end of a sentence; empty while few packets are sent again."""
        share = self.resend_share or 0.0
        return f"{share:.2%} of the packets were sent again: check cable, switch and packet delay" if share > MUCH_RESENT else ""


class Camera(Protocol):
    """A triggered monochrome camera. Every driver must pass ``tests/contracts/test_camera.py``.

    The exposure may be changed within a sequence, after `wait_ready`, while images of the former exposure have not been fetched yet.

    A sequence is `arm`, then for each image a trigger (`trigger`, or the projector's pulse), `wait_ready` and `next_frame`, then `disarm`.
    The transfer of one image may overlap the exposure of the next: `next_frame` may be called after the next `trigger`.
    """

    name: str  # as in the rig description
    serial: str
    width_px: int
    height_px: int
    bit_depth: int
    shutter: Shutter
    readout_s: float  # from the end of the first row's exposure until the last row is read out
    transfer_s: float  # of one image, with those of the cameras on the same link; overlaps the next exposure
    exposure_limits_us: tuple[int, int]
    exposure_step_us: int  # exposures are rounded to multiples of this

    def set_exposure_us(self, exposure_us: int) -> None:
        """Set the exposure. Raises LimitError when the camera does not support it."""

    def exposure_us(self) -> int:
        """Read the exposure back, rounded to µs."""

    def arm(self, frames: int, trigger: Trigger) -> None:
        """Begin a sequence of at most ``frames`` images, each started by one trigger; numbers begin at 0. Discards older images."""

    def trigger(self) -> None:
        """Start one exposure now and return at once. Raises DeviceError when the camera is not armed for software triggers."""

    def wait_ready(self, *, timeout_s: float) -> None:
        """Wait until the started exposure has ended, its rows are read out, and the next trigger is accepted. Raises DeviceTimeout."""

    def next_frame(self, *, timeout_s: float) -> Frame:
        """Wait for the next image of the sequence.

        Raises
        ------
        FrameError
            The image arrived damaged or incomplete and was discarded; the sequence goes on with the following one.
        DeviceTimeout
            No image arrived in time.
        DeviceLost
            The camera does not answer any more.
        """

    def disarm(self) -> None:
        """End the sequence; images not taken from it are discarded. Harmless without one."""

    def statistics(self) -> StreamStatistics:
        """Read the counters of the stream."""

    def temperature_c(self) -> float | None:
        """Read the temperature of the camera's housing; None if it has no thermometer."""

    def lens(self) -> LensSetting:
        """Read the lens setting back; empty for a manual lens."""

    def status(self) -> DeviceStatus:
        """Read the state, for display."""

    def stop(self) -> None:
        """Stop now, from any thread; a waiting call then raises Cancelled."""

    def close(self) -> None:
        """Release the camera for other programs. Harmless when repeated."""


@runtime_checkable
class RendersImages(Protocol):
    """A camera that computes its images: each takes as long as the computer needs, and not as long as an exposure and its transfer."""

    longest_rendering_s: float  # of one image, on a busy computer and with kernels that are not compiled yet
