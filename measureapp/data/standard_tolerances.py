"""Tables of standard tolerances: general tolerances of ISO 2768-1 and tolerance classes of ISO 286, up to 500 mm.

The grades IT5 to IT11 follow from i = 0.45 D^(1/3) + 0.001 D (µm, D the geometric mean of the range in mm), the deviations of d to g and
n from powers of D, those of m from IT7 − IT6, each with the rounding of the standard; the tests compare the tables with these formulas.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Mapping

SIZES_MM = (3, 6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400, 500)  # upper ends of the ranges of ISO 286
GRADES_UM: Mapping[int, tuple[float, ...]] = {
    5: (4, 5, 6, 8, 9, 11, 13, 15, 18, 20, 23, 25, 27),
    6: (6, 8, 9, 11, 13, 16, 19, 22, 25, 29, 32, 36, 40),
    7: (10, 12, 15, 18, 21, 25, 30, 35, 40, 46, 52, 57, 63),
    8: (14, 18, 22, 27, 33, 39, 46, 54, 63, 72, 81, 89, 97),
    9: (25, 30, 36, 43, 52, 62, 74, 87, 100, 115, 130, 140, 155),
    10: (40, 48, 58, 70, 84, 100, 120, 140, 160, 185, 210, 230, 250),
    11: (60, 75, 90, 110, 130, 160, 190, 220, 250, 290, 320, 360, 400),
}
BELOW_UM: Mapping[str, tuple[float, ...]] = {  # upper deviation of a shaft below zero, lower deviation of a hole above it
    "d": (20, 30, 40, 50, 65, 80, 100, 120, 145, 170, 190, 210, 230),
    "e": (14, 20, 25, 32, 40, 50, 60, 72, 85, 100, 110, 125, 135),
    "f": (6, 10, 13, 16, 20, 25, 30, 36, 43, 50, 56, 62, 68),
    "g": (2, 4, 5, 6, 7, 9, 10, 12, 14, 15, 17, 18, 20),
    "h": (0,) * 13,
}
ABOVE_UM: Mapping[str, tuple[float, ...]] = {  # lower deviation of a shaft above zero
    "k": (0, 1, 1, 1, 2, 2, 2, 3, 3, 4, 4, 4, 5),
    "m": (2, 4, 6, 7, 8, 9, 11, 13, 15, 17, 20, 21, 23),
    "n": (4, 8, 10, 12, 15, 17, 20, 23, 27, 31, 34, 37, 40),
    "p": (6, 12, 15, 18, 22, 26, 32, 37, 43, 50, 56, 62, 68),
}
K_GRADES = (5, 6, 7)  # k of a coarser grade has another deviation
CLASSES = ", ".join([*BELOW_UM, "js", *ABOVE_UM, *(name.upper() for name in BELOW_UM), "JS"])

GENERAL_SIZES_MM = (0.5, 3, 6, 30, 120, 400, 1000, 2000, 4000)  # ends of the ranges of ISO 2768-1
GENERAL_MM: Mapping[str, tuple[float | None, ...]] = {
    "f": (0.05, 0.05, 0.1, 0.15, 0.2, 0.3, 0.5, None),
    "m": (0.1, 0.1, 0.2, 0.3, 0.5, 0.8, 1.2, 2.0),
    "c": (0.2, 0.3, 0.5, 0.8, 1.2, 2.0, 3.0, 4.0),
    "v": (None, 0.5, 1.0, 1.5, 2.5, 4.0, 6.0, 8.0),
}


def tolerance_class(letters: str, grade: int, size_mm: float) -> tuple[float, float]:
    """Return lower and upper limit deviation in mm of a tolerance class of ISO 286, such as H7; capital letters are holes.

    Raises
    ------
    ValueError
        The table does not contain this class or size.

    >>> tolerance_class("H", 7, 40.0), tolerance_class("g", 6, 40.0)
    ((0.0, 0.025), (-0.025, -0.009))
    """
    name = f"{letters}{grade}"
    if grade not in GRADES_UM:
        raise ValueError(f"{name} is not available: the grades are IT{min(GRADES_UM)} to IT{max(GRADES_UM)}; enter the limits as numbers")
    if not 0 < size_mm <= SIZES_MM[-1]:
        raise ValueError(f"{name} is defined for sizes up to {SIZES_MM[-1]} mm, not {size_mm:g} mm: enter the limits as numbers")
    place = bisect_left(SIZES_MM, size_mm)
    low, high = _deviations(letters, grade, place)
    return round(low / 1000, 7), round(high / 1000, 7)


def _deviations(letters: str, grade: int, place: int) -> tuple[float, float]:
    width, lower_case = GRADES_UM[grade][place], letters.lower()
    if letters in ("js", "JS"):
        return -width / 2, width / 2
    if letters in BELOW_UM:
        upper = -BELOW_UM[letters][place]
        return upper - width, upper
    if letters.isupper() and lower_case in BELOW_UM:
        lower = BELOW_UM[lower_case][place]
        return lower, lower + width
    if letters in ABOVE_UM and (letters != "k" or grade in K_GRADES):
        lower = ABOVE_UM[letters][place]
        return lower, lower + width
    raise ValueError(f"{letters}{grade} is not available: the classes are {CLASSES}; enter the limits as numbers")


def general_tolerance(name: str, size_mm: float) -> float:
    """Return the general tolerance ± in mm of a linear size by ISO 2768-1, class f, m, c or v.

    Raises
    ------
    ValueError
        The class states none for this size.

    >>> general_tolerance("m", 180.0)
    0.5
    """
    if not GENERAL_SIZES_MM[0] <= size_mm <= GENERAL_SIZES_MM[-1]:
        raise ValueError(f"ISO 2768-{name} is defined for sizes from 0.5 to 4000 mm, not {size_mm:g} mm: enter the limits as numbers")
    found = GENERAL_MM[name][max(bisect_left(GENERAL_SIZES_MM, size_mm) - 1, 0)]
    if found is None:
        raise ValueError(f"ISO 2768-{name} states no tolerance for {size_mm:g} mm: enter the limits as numbers")
    return found
