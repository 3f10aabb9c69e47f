"""Whether a calibration may be used: what stands against it, and what scans and board views said about it since."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

Standing = Literal["good", "watch", "drifted", "unknown"]


@dataclass(frozen=True, slots=True)
class Drift:
    """Whether a camera stands as it was calibrated, from the images of a scan."""

    standing: Standing
    sentence: str  # with its numbers and what to do
    cameras: tuple[str, ...] = ()  # the one that turned; several where the images cannot tell which; none while good
    shift_px: float = 0.0  # root mean square shift of that camera's image, across the fringes
    expected_px: float = 0.0  # what the calibration left
    error_mm: float = 0.0  # root mean square shift of the measured points in depth
    turn_deg: float = 0.0
    unseen_deg: Mapping[str, Mapping[str, float]] = field(default_factory=dict)  # camera -> pitch, yaw, roll: smaller turns raise no alarm
    unseen: str = ""  # the largest of them in words, for what is good is good only as far as it was looked at


@dataclass(frozen=True, slots=True)
class Validity:
    """What is known about the calibration that a measurement rests on."""

    warnings: tuple[str, ...] = ()  # age and temperature, each a sentence with its effect and remedy
    drift: Drift | None = None  # None: not looked for
    temperature_c: float | None = None  # of the head while it was scanned; None where no device reports one

    @property
    def told(self) -> tuple[str, ...]:
        """Everything that a user must read before trusting the result."""
        alarmed = self.drift is not None and self.drift.standing in ("watch", "drifted")
        return (*self.warnings, *((self.drift.sentence,) if self.drift is not None and alarmed else ()))


@dataclass(frozen=True, slots=True)
class CheckRecord:
    """One line of a calibration's history."""

    at: str  # ISO 8601, when the images were taken
    kind: Literal["scan", "board check"]
    calibration: str  # its id
    standing: Standing
    sentence: str
    shift_px: float | None = None
    expected_px: float | None = None
    error_mm: float | None = None
    cameras: tuple[str, ...] = ()
    temperature_c: float | None = None
