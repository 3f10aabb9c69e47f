"""Identification of a measured part: the header fields of its report."""

from __future__ import annotations

import unicodedata
from typing import Annotated, Literal

from pydantic import AfterValidator, Field

from measureapp.data.model import Model
from measureapp.data.part_temperature import read_temperature

LONGEST_LINE, LONGEST_TEXT = 200, 4000
ABSOLUTE_ZERO_C, HOTTEST_C = -273.15, 200.0


def one_line(text: str) -> str:
    r"""Return a text in Unicode's composed form on one line; control characters, which bar-code scanners send, become spaces.

    >>> one_line("  M-17\x1dA\n")
    'M-17 A'
    """
    return " ".join(
        "".join(" " if unicodedata.category(letter) == "Cc" else letter for letter in unicodedata.normalize("NFC", text)).split()
    )


def _lines(text: str) -> str:
    return "\n".join(one_line(line) for line in text.splitlines()).strip()


def _temperature(text: str) -> str:
    """Return a text that states a temperature, or nothing. Raises ValueError."""
    if text:
        read_temperature(text)
    return text


Line = Annotated[str, Field(max_length=LONGEST_LINE), AfterValidator(one_line)]
Text = Annotated[str, Field(max_length=LONGEST_TEXT), AfterValidator(_lines)]


class Identification(Model):
    """What identifies a part and its measurement; every field may be empty."""

    schema_version: Literal[1] = 1
    part_name: Line = ""
    part_number: Line = ""
    drawing: Line = ""
    revision: Line = Field(default="", description="of the part drawing")
    serial_number: Line = ""
    order: Line = ""
    customer: Line = ""
    operator: Line = ""
    machine: Line = Field(default="", description="measuring machine; the name of the rig where it is empty")
    location: Line = ""
    temperature_c: float | None = Field(default=None, ge=ABSOLUTE_ZERO_C, le=HOTTEST_C, description="air temperature in °C")
    temperature_source: Line = Field(default="", description="who or what measured the temperature")
    part_temperature: Annotated[Line, AfterValidator(_temperature)] = Field(
        default="", description="of the part in °C with its uncertainty (k = 2), such as 23±0.5: lengths are corrected to 20 °C"
    )
    material: Line = Field(default="", description="of the part, such as steel, or its expansion, such as 11.5±0.6 ppm/K")
    humidity_percent: float | None = Field(default=None, ge=0, le=100, description="relative humidity of the air")
    remarks: Text = ""

    def with_defaults(self, defaults: Identification) -> Identification:
        """Return the identification with its empty fields taken from ``defaults``; a temperature keeps its own source.

        >>> Identification(order="7").with_defaults(Identification(order="1", customer="Works")).customer
        'Works'
        """
        missing = {name for name in FIELDS if getattr(self, name) in ("", None)}
        if self.temperature_c is not None:
            missing.discard("temperature_source")
        return self.model_copy(update={name: getattr(defaults, name) for name in missing})


FIELDS = tuple(name for name in Identification.model_fields if name != "schema_version")
LABELS = {
    "part_name": "Part",
    "part_number": "Part number",
    "drawing": "Drawing",
    "revision": "Revision",
    "serial_number": "Serial number",
    "order": "Order",
    "customer": "Customer",
    "operator": "Operator",
    "machine": "Machine",
    "location": "Location",
    "temperature_c": "Temperature (°C)",
    "temperature_source": "Temperature from",
    "part_temperature": "Part temperature",
    "material": "Material",
    "humidity_percent": "Relative humidity (%)",
    "remarks": "Remarks",
}
