"""Options that state temperature and material of a part."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated

import typer

from measureapp.errors import InputError

if TYPE_CHECKING:
    from measureapp.data.identification import Identification
    from measureapp.data.part_temperature import PartTemperature


@dataclass(frozen=True, slots=True)
class PartState:
    """Temperature and material of a part, as its options state them."""

    part_temperature: Annotated[
        str, typer.Option("--part-temperature", help="Of the part in °C with its uncertainty (k = 2), such as 23±0.5.")
    ] = ""
    material: Annotated[
        str,
        typer.Option("--material", help="Of the part, such as steel, or its expansion, such as 11.5±0.6 ppm/K: corrects lengths to 20 °C."),
    ] = ""

    def temperature(self) -> PartTemperature | None:
        """Return the temperature; None where it is not stated. Raises InputError for an absurd one, or an unknown material."""
        from measureapp.data.part_temperature import part_temperature

        if self.material.strip() and not self.part_temperature.strip():
            raise InputError("--material corrects nothing without the temperature of the part.", "Give --part-temperature, such as 23±0.5.")
        try:
            return part_temperature(self.part_temperature, self.material)
        except ValueError as error:
            sentence = str(error)
            raise InputError(f"{sentence[0].upper()}{sentence[1:]}.", "See --part-temperature and --material.") from error

    def identification(self) -> Identification | None:
        """Return the header fields with it; None where nothing is stated. Raises InputError."""
        from measureapp.data.identification import Identification

        if self.temperature() is None:
            return None
        return Identification(part_temperature=self.part_temperature, material=self.material)
