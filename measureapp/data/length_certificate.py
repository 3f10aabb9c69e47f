"""Certificate of a length that is measured with the part: of a ball bar, a gauge block, or the part itself on a better machine."""

from __future__ import annotations

from dataclasses import dataclass

from pydantic import Field, field_validator

from measureapp.data.certificate import REFERENCE_C
from measureapp.data.model import Model
from measureapp.data.part_temperature import PartTemperature, read_material


@dataclass(frozen=True, slots=True)
class KnownLength:
    """A length beside which others are measured, mm, and its standard uncertainty."""

    length_mm: float
    sigma_mm: float


class LengthCertificate(Model):
    """What a certificate states beside the length at 20 °C, which is the nominal of its dimension."""

    uncertainty_mm: float = Field(gt=0, le=1.0, description="expanded uncertainty (k = 2) of the length")
    number: str = Field(default="", max_length=100, description="of the certificate")
    material: str = Field(
        default="",
        description="steel, zirconia, … or its expansion such as 11.5±0.6 ppm/K; empty: that of the part, so that both have the same expansion",
    )

    @field_validator("material")
    @classmethod
    def _material_is_known(cls, given: str) -> str:
        if given.strip():
            read_material(given)
        return given

    def known_length(self, length_mm: float, temperature: PartTemperature | None) -> KnownLength:
        """Return the length as the measurement should find it, with all lengths corrected to 20 °C as the part requires.

        A standard of another material than the part has another length then: L (1 + α (T − 20 °C)) at the temperature T of the part,
        times the part's factor (ISO/TR 16015). Where T is not stated, both are taken to be at 20 °C.
        """
        sigma_mm = self.uncertainty_mm / 2.0
        if temperature is None or not self.material.strip():
            return KnownLength(length_mm, sigma_mm)
        own, own_sigma = read_material(self.material)
        above_k = temperature.part_c - REFERENCE_C
        more = own - (temperature.expansion_per_k or 0.0)
        by_heat = length_mm * ((more * temperature.expanded_k / 2.0) ** 2 + (own_sigma * above_k) ** 2) ** 0.5
        return KnownLength(length_mm * (1.0 + own * above_k) * temperature.factor, (sigma_mm**2 + by_heat**2) ** 0.5)
