"""Pattern projectors."""

from __future__ import annotations

from typing import Protocol

from measureapp.arrays import ImageArray


class Projector(Protocol):
    """A projector that holds a sequence of images. Every driver must pass ``tests/contracts/test_projector.py``."""

    name: str
    width_px: int
    height_px: int

    def load(self, images: ImageArray) -> None:
        """Take a sequence (count, height, width) of uint8 images. Raises DeviceError for a wrong size."""

    def show(self, index: int, *, timeout_s: float) -> None:
        """Show image ``index`` of the sequence, or -1 for uniform grey light, and wait until it stands."""

    def shown(self) -> int:
        """Read back what is shown."""

    def stop(self) -> None:
        """Go dark now, from any thread."""
