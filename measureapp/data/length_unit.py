"""Units of length of files; all lengths inside the program are in millimetres."""

from __future__ import annotations

from enum import StrEnum

_MM = {"mm": 1.0, "inch": 25.4, "m": 1000.0, "cm": 10.0, "um": 0.001}
_WORDS = {"mm": "millimetres", "inch": "inches", "m": "metres", "cm": "centimetres", "um": "micrometres"}


class LengthUnit(StrEnum):
    """A unit as named on the command line and in programs, in order of likelihood.

    >>> LengthUnit.INCH.in_mm, LengthUnit.INCH.words
    (25.4, 'inches')
    """

    MM = "mm"
    INCH = "inch"
    M = "m"
    CM = "cm"
    UM = "um"

    @property
    def in_mm(self) -> float:
        """Millimetres per unit."""
        return _MM[self.value]

    @property
    def words(self) -> str:
        """Name of the unit, in the plural."""
        return _WORDS[self.value]


PLAUSIBLE_MM = (30.0, 1500.0)  # size of parts that such a rig measures


def likely_unit(span: float) -> LengthUnit:
    """Guess the unit of a part from its span (longest side of its bounding box): the first that gives a plausible size.

    >>> [str(likely_unit(span)) for span in (180.0, 7.1, 0.18, 180000.0)]
    ['mm', 'inch', 'm', 'um']
    """
    low, high = PLAUSIBLE_MM
    return next((unit for unit in LengthUnit if low <= span * unit.in_mm <= high), LengthUnit.MM)


OTHER_UNITS = tuple(unit for unit in LengthUnit if unit is not LengthUnit.MM)
