"""Under which conditions images were taken: when, how warm, by which cameras."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class LensSetting:
    """How a lens is set, where camera or lens tell; a lens set by hand tells nothing."""

    focus_mm: float | None = None  # distance it is focused at
    f_number: float | None = None


@dataclass(frozen=True, slots=True)
class Conditions:
    """When and how images were taken, as the devices said."""

    taken_at: str  # ISO 8601 with its time zone
    temperature_c: float | None = None  # of the head; None where no device has a thermometer
    serials: Mapping[str, str] = field(default_factory=dict)  # camera -> serial number
    lenses: Mapping[str, LensSetting] = field(default_factory=dict)  # camera -> its setting, of those that tell
