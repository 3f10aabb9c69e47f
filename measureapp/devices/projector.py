"""Projector interfaces."""

from __future__ import annotations

from typing import Protocol, runtime_checkable

from measureapp.arrays import ImageArray
from measureapp.devices.status import DeviceStatus

DARK, PLAIN_LIGHT = -2, -1
"""Indices of what a projector can show besides its images: no light, and uniform light."""


class Projector(Protocol):
    """A projector with a loadable image sequence. Every driver must pass ``tests/contracts/test_projector.py``."""

    name: str
    width_px: int
    height_px: int
    frame_us: int  # grey levels are only right over whole frames of this duration (bit planes); 0: at any exposure

    def load(self, images: ImageArray) -> None:
        """Load a sequence (count, height, width) of uint8 images. Raises DeviceError for a wrong size."""

    def show(self, index: int, *, timeout_s: float) -> None:
        """Show image ``index`` of the sequence, PLAIN_LIGHT or DARK, and wait until it is lit and stable, latency included."""

    def shown(self) -> int:
        """Read back the index of the image shown, PLAIN_LIGHT or DARK."""

    def status(self) -> DeviceStatus:
        """Read the state, for display."""

    def stop(self) -> None:
        """Switch the light off now, from any thread."""

    def close(self) -> None:
        """Release the projector. Harmless when repeated."""


@runtime_checkable
class TriggeringProjector(Projector, Protocol):
    """A projector that plays its images by itself and triggers the cameras with each of them."""

    gated: bool  # the light is on during the exposure only, and dark for the rest of the period

    def play(self, first: int, count: int, *, exposure_us: int, period_us: int) -> None:
        """Play images ``first`` … ``first + count - 1`` once, a trigger pulse with each, and return when the sequence has started.

        Raises LimitError when exposure or period is not possible, before anything is shown.
        """

    def triggers_sent(self) -> int:
        """Read the number of trigger pulses since the last `play`."""
