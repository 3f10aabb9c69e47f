"""Validity of a calibration: warnings, camera drift, and the history of its checks."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

DriftStatus = Literal["good", "watch", "drifted", "unknown"]


@dataclass(frozen=True, slots=True)
class Drift:
    """Camera drift since the calibration, from the images of a scan."""

    status: DriftStatus
    sentence: str  # with its numbers and what to do
    cameras: tuple[str, ...] = ()  # the camera that moved; several if the images do not determine which; none while good
    shift_px: float = 0.0  # rms shift of that camera's image, perpendicular to the fringes
    expected_px: float = 0.0  # residual of the calibration
    error_mm: float = 0.0  # rms depth error of the measured points
    turn_deg: float = 0.0
    undetectable_deg: Mapping[str, Mapping[str, float]] = field(
        default_factory=dict
    )  # camera -> pitch, yaw, roll: smaller rotations are not detected
    undetectable: str = ""  # the largest of them in words: the limit of the check


@dataclass(frozen=True, slots=True)
class Validity:
    """Validity of the calibration of a measurement."""

    warnings: tuple[str, ...] = ()  # age and temperature, each a sentence with effect and remedy
    drift: Drift | None = None  # None: not checked
    temperature_c: float | None = None  # of the head during the scan; None where no device reports one
    axes: str = ""  # doubt about the axes by the views of the scan, a sentence; empty: none

    @property
    def all_warnings(self) -> tuple[str, ...]:
        """All warnings, including those of a drift and of axes that the views contradict."""
        alarmed = self.drift is not None and self.drift.status in ("watch", "drifted")
        return (
            *self.warnings,
            *((self.axes,) if self.axes else ()),
            *((self.drift.sentence,) if self.drift is not None and alarmed else ()),
        )


@dataclass(frozen=True, slots=True)
class CheckRecord:
    """One line of a calibration's history."""

    at: str  # ISO 8601, when the images were taken
    kind: Literal["scan", "board check"]
    calibration: str  # its id
    status: DriftStatus
    sentence: str
    shift_px: float | None = None
    expected_px: float | None = None
    error_mm: float | None = None
    cameras: tuple[str, ...] = ()
    temperature_c: float | None = None
