"""Part programs: everything that measuring one sort of part needs besides the rig, in one file."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from pydantic import Field, field_validator

from measureapp.data.board import AnyBoard
from measureapp.data.identification import Identification
from measureapp.data.model import Model
from measureapp.data.plan import ScanPlan
from measureapp.data.raw_policy import RawPolicy
from measureapp.data.rig import RigDescription


class CalibrationReference(Model):
    """Where the calibration of a template's rig is."""

    folder: str  # of the project that has it
    id: str = Field(max_length=64, description="of the calibration when the template was made")


class Release(Model):
    """Release of a part program for operators: by whom, when, and of exactly which contents."""

    by: str = Field(min_length=1, max_length=200)
    at: str = Field(description="ISO 8601")
    digest: str = Field(max_length=64, description="of the contents; others are not released")


class ProgramRecord(Model):
    """Which part program a project was begun with."""

    schema_version: Literal[1] = 1
    name: str
    revision: int = Field(default=0, ge=0, description="0: it was not released")
    by: str = ""
    at: str = ""
    sha256: str = Field(max_length=64, description="of inspection program and nominal as they were stored")


CODE_GROUPS = ("part", "serial", "order")
AskedField = Literal["serial", "order", "remarks"]


class PartProgramFacts(Model):
    """What identifies a part program and a part to be measured with it, and the checksums of what it contains."""

    schema_version: Literal[1, 2, 3] = 3
    name: str = Field(min_length=1, max_length=200)
    part_number: str = Field(default="", max_length=200)
    version: str = Field(default="", max_length=200, description="printed in reports, and kept with every result")
    remarks: str = Field(default="", max_length=4000, description="how to clamp the part, and what else an operator should know")
    code_pattern: str = Field(
        default="", max_length=500, description="regular expression of the part's bar code, with the groups part, serial and order"
    )
    required: tuple[AskedField, ...] = Field(default=("serial",), description="what an operator must state before the measurement")
    identification: Identification = Field(default=Identification(), description="what is the same for every part: drawing, customer, …")
    raw: RawPolicy | None = Field(default=None, description="what becomes of raw images after a scan; none: as the project states")
    calibration: CalibrationReference | None = Field(default=None, description="of the template's rig; none: not named")
    board: AnyBoard | None = Field(default=None, description="that new projects are calibrated with; none: the usual one")
    revision: int = Field(default=0, ge=0, description="of the last release; each release has the next one")
    release: Release | None = Field(default=None, description="only released programs are offered to operators")
    sha256: Mapping[str, str] = Field(default={}, description="of each file by its name")

    @field_validator("code_pattern")
    @classmethod
    def _is_a_pattern(cls, pattern: str) -> str:
        try:
            groups = set(re.compile(pattern).groupindex)
        except re.error as error:
            raise ValueError(f"{pattern!r} is not a regular expression: {error}") from error
        strangers = sorted(groups - set(CODE_GROUPS))
        if strangers or (pattern and not groups):
            raise ValueError(f"name the groups of {pattern!r} {', '.join(CODE_GROUPS)}" + (f", not {strangers[0]}" if strangers else ""))
        return pattern


@dataclass(frozen=True, slots=True, eq=False)
class PartProgram:
    """Scan plan, inspection program with its nominal, report template and a picture of the part; all but the plan may be missing.

    With a rig it is a template of projects: everything that a new one starts with.
    """

    facts: PartProgramFacts
    plan: ScanPlan
    inspection: bytes | None = None  # an inspection program in TOML
    nominal: tuple[str, bytes] | None = None  # ending such as ".stl", and the file
    report_template: bytes | None = None  # Typst
    picture: bytes | None = None  # PNG
    template_folder: bytes | None = None  # ZIP of a template folder of reports
    rig: RigDescription | None = None  # None: chosen for every scan
