"""Values of a calibration with the previous ones and, on the virtual rig, the true ones."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from measureapp.calibrate.draft.estimate import Estimate

DIGITS = {"px": 2, "mm": 3, "°": 4, "": 6}
DISTORTION_DIGITS = 5


@dataclass(frozen=True)
class ValueRow:
    """A value with its true and its previous one, where they are known."""

    estimate: Estimate
    true: float | None = None
    previous: float | None = None

    @property
    def digits(self) -> int:
        """How many decimals are shown."""
        return DISTORTION_DIGITS if self.estimate.label.startswith("Distortion") else DIGITS[self.estimate.unit]


def pair_values(found: Sequence[Estimate], truth: Sequence[Estimate], previous: Sequence[Estimate]) -> tuple[ValueRow, ...]:
    """Return one row per value found; the others are matched by name."""
    true, before = ({one.name: one.value for one in values} for values in (truth, previous))
    return tuple(ValueRow(one, true.get(one.name), before.get(one.name)) for one in found)
