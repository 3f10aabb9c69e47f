"""Projector interface."""

from __future__ import annotations

from typing import Protocol

from measureapp.arrays import ImageArray


class Projector(Protocol):
    """A projector with a loadable image sequence. Every driver must pass ``tests/contracts/test_projector.py``."""

    name: str
    width_px: int
    height_px: int

    def load(self, images: ImageArray) -> None:
        """Load a sequence (count, height, width) of uint8 images. Raises DeviceError for a wrong size."""

    def show(self, index: int, *, timeout_s: float) -> None:
        """Show image ``index`` of the sequence, or -1 for uniform grey light, and wait until it is stable."""

    def shown(self) -> int:
        """Read back the index of the image shown."""

    def stop(self) -> None:
        """Switch the light off now, from any thread."""
