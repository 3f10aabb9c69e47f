"""Template of reports: company, logo, header fields, texts and pages."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from pydantic import Field, field_validator

from measureapp.data.identification import FIELDS, Line, Text
from measureapp.data.model import Model

PageName = Literal[
    "summary", "signatures", "table", "failing", "deviation", "sections", "uncertainty", "calibration", "views", "plan", "settings"
]
PAGES: tuple[PageName, ...] = (
    "summary", "signatures", "table", "failing", "deviation", "sections", "uncertainty", "calibration", "views", "plan", "settings",
)  # fmt: skip
HEADER = ("part_number", "drawing", "revision", "serial_number", "order", "customer", "operator", "machine", "location", "temperature_c")
MOST_SIGNATURES = 4


class Balloon(Model):
    """Number and place of a dimension on the part drawing, for first article inspection (AS9102 form 3)."""

    number: Line
    zone: Line = ""
    designator: Line = Field(default="", description="key or critical characteristic")


class ReportTemplate(Model):
    """The file `template.toml` of a template folder; names of files are relative to the folder."""

    schema_version: Literal[1] = 1
    name: Line = "built-in"
    version: Line = Field(default="1", description="printed in every report")
    company: Line = ""
    address: Text = ""
    logo: str = Field(default="", description="PNG, JPEG or SVG")
    title: Line = "Measurement report"
    fields: tuple[str, ...] = Field(default=HEADER, description="fields of the identification in the header, in this order")
    opening: Text = Field(default="", description="text on the first page, below the verdict")
    closing: Text = Field(default="", description="text above the signatures")
    signatures: tuple[Line, ...] = Field(default=("Measured", "Checked", "Released"), max_length=MOST_SIGNATURES)
    pages: tuple[PageName, ...] = PAGES
    layout: str = Field(default="", description="a Typst file in place of the built-in layout")
    balloons: Mapping[str, Balloon] = Field(default={}, description="by the name of a dimension")

    @field_validator("fields")
    @classmethod
    def _fields_exist(cls, fields: tuple[str, ...]) -> tuple[str, ...]:
        for name in fields:
            if name not in FIELDS:
                raise ValueError(f"{name!r} is not a field; fields are {', '.join(FIELDS)}")
        return fields

    @field_validator("logo", "layout")
    @classmethod
    def _inside_the_folder(cls, name: str) -> str:
        if name and (name != name.strip() or "/" in name or "\\" in name or name.startswith(".") or ":" in name):
            raise ValueError("must be the name of a file in the template's folder")
        return name
