"""Part programs: everything that measuring one sort of part needs besides the rig, in one file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from pydantic import Field

from measureapp.data.board import AnyBoard
from measureapp.data.model import Model
from measureapp.data.plan import ScanPlan
from measureapp.data.raw_policy import RawPolicy
from measureapp.data.rig import RigDescription


class CalibrationReference(Model):
    """Where the calibration of a template's rig is."""

    folder: str  # of the project that has it
    id: str = Field(max_length=64, description="of the calibration when the template was made")


class PartProgramFacts(Model):
    """What identifies a part program, and the checksums of what it contains."""

    schema_version: Literal[1] = 1
    name: str = Field(min_length=1, max_length=200)
    part_number: str = Field(default="", max_length=200)
    remarks: str = Field(default="", max_length=4000)
    raw: RawPolicy | None = Field(default=None, description="what becomes of raw images after a scan; none: as the project states")
    calibration: CalibrationReference | None = Field(default=None, description="of the template's rig; none: not named")
    board: AnyBoard | None = Field(default=None, description="that new projects are calibrated with; none: the usual one")
    sha256: Mapping[str, str] = Field(default={}, description="of each file by its name")


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
    rig: RigDescription | None = None  # None: chosen for every scan
