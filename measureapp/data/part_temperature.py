"""Temperature of a part and the expansion of its material."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from measureapp.data.certificate import COLDEST_C, EXPANSION_SHARE, HOTTEST_C, LARGEST_UNCERTAINTY_K, REFERENCE_C

METAL_SHARE = 0.05  # standard uncertainty of a metal's coefficient
UNSTATED_K = 1.0  # expanded uncertainty of a temperature given without one
LARGEST_EXPANSION_PPM = 200.0
NUMBER = r"[-−+]?\d+(?:[.,]\d+)?"
TEMPERATURE = re.compile(rf"\s*({NUMBER})\s*(?:(?:±|\+/-|\+-)\s*({NUMBER}))?\s*(?:°?\s*C)?\s*")
COEFFICIENT = re.compile(rf"\s*({NUMBER})\s*(?:(?:±|\+/-|\+-)\s*({NUMBER}))?\s*(?:ppm(?:\s*/\s*K)?)\s*")

# ppm/K with relative standard uncertainty; handbook values of technical materials
MATERIALS: Mapping[str, tuple[float, float]] = MappingProxyType(
    {
        "steel": (11.5, METAL_SHARE),
        "stainless steel": (16.5, METAL_SHARE),
        "cast iron": (10.5, METAL_SHARE),
        "aluminium": (23.5, METAL_SHARE),
        "brass": (19.0, METAL_SHARE),
        "titanium": (8.8, METAL_SHARE),
        "inconel 718": (13.0, METAL_SHARE),
        "invar": (1.2, EXPANSION_SHARE),
        "gypsum": (17.0, EXPANSION_SHARE),
        "abs": (90.0, EXPANSION_SHARE),
        "pa12": (110.0, EXPANSION_SHARE),
        "pom": (110.0, EXPANSION_SHARE),
        "pla": (68.0, EXPANSION_SHARE),
        "glass": (9.0, EXPANSION_SHARE),
        "alumina": (7.0, EXPANSION_SHARE),
        "zirconia": (10.0, EXPANSION_SHARE),
    }
)


def read_temperature(text: str) -> tuple[float, float]:
    """Return temperature and expanded uncertainty (k = 2) of a text such as "23±0.5"; ± 1 K where none is given. Raises ValueError.

    >>> read_temperature("23±0.5")
    (23.0, 0.5)
    """
    match = TEMPERATURE.fullmatch(text)
    if match is None:
        raise ValueError(f"{text!r} is not a temperature in °C, such as 23±0.5")
    value, spread = _number(match[1]), UNSTATED_K if match[2] is None else _number(match[2])
    if not COLDEST_C <= value <= HOTTEST_C:
        raise ValueError(f"{value:g} °C is not between {COLDEST_C:g} and {HOTTEST_C:g} °C")
    if not 0 < spread <= LARGEST_UNCERTAINTY_K:
        raise ValueError(f"an uncertainty of {spread:g} K is not between 0 and {LARGEST_UNCERTAINTY_K:g} K")
    return value, spread


def read_material(text: str) -> tuple[float, float]:
    """Return coefficient of expansion and its standard uncertainty, both per kelvin, of a material or of "11.5±0.6 ppm/K" (k = 2).

    Raises ValueError.

    >>> read_material("10±1 ppm/K")
    (1e-05, 5e-07)
    """
    known = MATERIALS.get(" ".join(text.lower().split()))
    if known is not None:
        return known[0] * 1e-6, known[0] * known[1] * 1e-6
    match = COEFFICIENT.fullmatch(text)
    if match is None:
        raise ValueError(
            f"the expansion of {text!r} is not known: choose one of {', '.join(MATERIALS)}, or state it, such as 11.5±0.6 ppm/K"
        )
    value = _number(match[1])
    spread = EXPANSION_SHARE * abs(value) if match[2] is None else abs(_number(match[2])) / 2.0
    if not 0 <= value <= LARGEST_EXPANSION_PPM or spread > LARGEST_EXPANSION_PPM:
        raise ValueError(f"an expansion of {value:g} ppm/K is not between 0 and {LARGEST_EXPANSION_PPM:g} ppm/K")
    return value * 1e-6, spread * 1e-6


@dataclass(frozen=True, slots=True)
class PartTemperature:
    """Temperature of a part during its measurement, and what its lengths do with it."""

    part_c: float
    expanded_k: float  # k = 2
    expansion_per_k: float | None = None  # None: not known, lengths stay as they are
    expansion_sigma_per_k: float = 0.0

    @property
    def factor(self) -> float:
        """Lengths at 20 °C over measured ones; 1 where the expansion is not known."""
        return 1.0 if self.expansion_per_k is None else 1.0 / (1.0 + self.expansion_per_k * (self.part_c - REFERENCE_C))

    @property
    def sigma(self) -> float:
        """Relative standard uncertainty of lengths at 20 °C by the two; 0 where lengths are not corrected."""
        if self.expansion_per_k is None:
            return 0.0
        by_temperature = self.expansion_per_k * self.expanded_k / 2.0
        by_coefficient = self.expansion_sigma_per_k * (self.part_c - REFERENCE_C)
        return float((by_temperature**2 + by_coefficient**2) ** 0.5)

    @property
    def words(self) -> str:
        """What was done, for reports."""
        if self.expansion_per_k is None:
            return f"at {self.part_c:g} ± {self.expanded_k:g} °C, not corrected"
        ppm = self.expansion_per_k * 1e6
        return f"measured at {self.part_c:g} ± {self.expanded_k:g} °C, corrected to {REFERENCE_C:g} °C with {ppm:g} ppm/K"


def part_temperature(temperature: str, material: str = "") -> PartTemperature | None:
    """Return the temperature of a part from the texts a user enters; None where there is none. Raises ValueError."""
    if not temperature.strip():
        if material.strip():
            read_material(material)
        return None
    part_c, expanded_k = read_temperature(temperature)
    if not material.strip():
        return PartTemperature(part_c, expanded_k)
    return PartTemperature(part_c, expanded_k, *read_material(material))


def _number(text: str) -> float:
    return float(text.replace("−", "-").replace(",", "."))
