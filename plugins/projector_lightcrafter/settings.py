"""Settings of a LightCrafter 4500."""

from __future__ import annotations

from typing import Literal

from pydantic import Field, model_validator

from measureapp.data.model import Model
from measureapp.data.rig import DriverChoice

from .registers import PATTERNS_PER_IMAGE, SHORTEST_EXPOSURE_US


class FlashedPatterns(Model):
    """A pattern set that was programmed into the projector's flash, three patterns of 8 bits to an image."""

    name: str = Field(min_length=1, description="for messages, such as the name of the pattern set")
    hash: str = Field(pattern=r"^[0-9a-f]{16}$", description="identity of the set, as the driver states it when it does not know the set")
    images: tuple[int, ...] = Field(
        min_length=1, description="numbers of the flash images: the first has patterns 0, 1, 2 in green, red, blue, the second 3, 4, 5 …"
    )

    @model_validator(mode="after")
    def _numbers_are_bytes(self) -> FlashedPatterns:
        if any(not 0 <= image <= 255 for image in self.images):
            raise ValueError("flash images are numbered 0…255")
        return self

    def holds(self, count: int) -> bool:
        """Whether the images are as many as ``count`` patterns need."""
        return len(self.images) == -(-count // PATTERNS_PER_IMAGE)


class LightCrafterSettings(Model):
    """Settings of a LightCrafter 4500."""

    serial: str = Field(default="", description="serial number of the projector's USB interface; empty: the only one connected")
    source: Literal["flash", "video"] = Field(
        default="flash", description="where patterns come from: programmed into its flash, or shown on the screen at its video port"
    )
    flash: tuple[FlashedPatterns, ...] = Field(default=(), description="the pattern sets in its flash (source flash)")
    video: DriverChoice = Field(
        default=DriverChoice(driver="projector_second_screen"), description="driver that shows images at its video port (source video)"
    )
    led: Literal["red", "green", "blue", "white"] = Field(default="blue", description="light of all patterns")
    led_current: int = Field(default=0, ge=0, le=255, description="current of the LEDs in use, 1…255; 0: as the projector is set")
    hold_cycle_us: int = Field(
        default=10_000,
        ge=SHORTEST_EXPOSURE_US[8],
        le=1_000_000,
        description="duration of one cycle of the bit planes while a pattern is held; exposures are whole multiples of it",
    )
    trigger_delay_us: float = Field(
        default=0.0, ge=-20.0, le=2.7, description="rising edge of trigger output 1 after the start of the exposure"
    )
    trigger_inverted: bool = Field(default=False, description="trigger output 1 is low during the exposure")
    reply_timeout_s: float = Field(default=0.5, gt=0, le=5, description="longest wait for a reply of the projector")
    poll_s: float = Field(default=0.01, gt=0, le=1, description="wait between two reads of a state that is to change")
    wake_timeout_s: float = Field(default=10.0, gt=0, le=60, description="longest wait for the projector to leave standby")
