"""Conditions under which images were taken: time, temperature, cameras and lens settings."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class LensSetting:
    """Setting of a lens as reported by the camera; empty for a manual lens."""

    focus_mm: float | None = None  # focus distance
    f_number: float | None = None


@dataclass(frozen=True, slots=True)
class Conditions:
    """When and how images were taken, as the devices reported."""

    taken_at: str  # ISO 8601 with its time zone
    temperature_c: float | None = None  # of the head; None if no device has a thermometer
    serials: Mapping[str, str] = field(default_factory=dict)  # camera -> serial number
    lenses: Mapping[str, LensSetting] = field(default_factory=dict)  # camera -> its setting, if it reports one
