"""Part programs: everything that measuring one sort of part needs besides the rig, in one file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from pydantic import Field

from measureapp.data.model import Model
from measureapp.data.plan import ScanPlan
from measureapp.data.raw_policy import RawPolicy


class PartProgramFacts(Model):
    """What identifies a part program, and the checksums of what it contains."""

    schema_version: Literal[1] = 1
    name: str = Field(min_length=1, max_length=200)
    part_number: str = Field(default="", max_length=200)
    remarks: str = Field(default="", max_length=4000)
    raw: RawPolicy | None = Field(default=None, description="what becomes of raw images after a scan; none: as the project states")
    sha256: Mapping[str, str] = Field(default={}, description="of each file by its name")


@dataclass(frozen=True, slots=True, eq=False)
class PartProgram:
    """Scan plan, inspection program with its nominal, report template and a picture of the part; all but the plan may be missing."""

    facts: PartProgramFacts
    plan: ScanPlan
    inspection: bytes | None = None  # an inspection program in TOML
    nominal: tuple[str, bytes] | None = None  # ending such as ".stl", and the file
    report_template: bytes | None = None  # Typst
    picture: bytes | None = None  # PNG
