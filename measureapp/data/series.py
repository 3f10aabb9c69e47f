"""Series of parts: what every measured part leaves behind for trend and capability."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from measureapp.data.dimension import Verdict
from measureapp.data.identification import Identification, Line
from measureapp.data.model import Model

Name = Annotated[str, Field(min_length=1, max_length=200)]


class SeriesValue(Model):
    """One dimension of one part; lengths in mm, angles in degrees (`unit` says which)."""

    name: str
    nominal: float
    lower_tolerance: float | None  # deviation from nominal; None: no tolerance
    upper_tolerance: float | None
    measured: float | None  # None: not measured
    uncertainty: float | None  # expanded, k = 2
    verdict: Verdict
    unit: str = "mm"
    kind: str = ""  # "distance", "flatness", …
    reason: str = ""  # why it has no value


class SeriesRun(Model):
    """One measurement of one part by a program."""

    schema_version: Literal[1] = 1
    run_id: str = Field(pattern=r"^[0-9a-f]{32}$")
    program: Name
    version: str = Field(default="", max_length=200)
    identification: Identification
    verdict: Verdict | None  # the most severe of its dimensions; None: it has none
    values: tuple[SeriesValue, ...]
    project: str  # folder
    measured_at: str  # ISO 8601 with zone
    repeat_reason: Line = Field(default="", description="why a part that was measured before is measured again")
