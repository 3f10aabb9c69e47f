"""Set-ups of one part: which projects are joined, how, and the result."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Literal

from pydantic import Field, model_validator

from measureapp.data.model import Model
from measureapp.geometry.transform import RigidTransform

JoinMethod = Literal["overlap", "spheres", "nominal"]
Angle = Annotated[float, Field(ge=-360, le=360)]


class SetUpSource(Model):
    """One set-up: a project of its own, and the results of it that were joined."""

    name: str = Field(min_length=1)
    path: str = Field(min_length=1, description="folder of its project, relative to the joined one where possible")
    measured_at: str = Field(description="when the joined results were computed, ISO 8601")
    sha256: Mapping[str, str] = Field(description="checksum of every file of results that was joined")
    turned_deg: tuple[Angle, Angle, Angle] | None = Field(
        default=None, description="rough rotation of the part about x, then y, then z, from the first set-up to this one"
    )


class SetUps(Model):
    """Set-ups that are joined into one measurement; the first one defines the part frame."""

    schema_version: Literal[1] = 1
    method: JoinMethod = "overlap"
    sphere_diameter_mm: float | None = Field(default=None, gt=0)
    sources: tuple[SetUpSource, ...] = Field(min_length=2)

    @model_validator(mode="after")
    def _names_are_unique(self) -> SetUps:
        names = [source.name for source in self.sources]
        if len(set(names)) < len(names):
            raise ValueError("the names of the set-ups are not unique")
        if self.method == "spheres" and self.sphere_diameter_mm is None:
            raise ValueError("the method spheres needs sphere_diameter_mm")
        return self


@dataclass(frozen=True, slots=True, eq=False)
class JoinedSetUp:
    """Position of one set-up in the joined measurement."""

    name: str
    part_from_setup: RigidTransform
    method: str  # "reference" for the first one
    sigma_mm: float  # standard deviation of its centroid by the joint, in its worst direction
    sigma_deg: float
    residual_mm: float  # rms distance of corresponding surfaces, or of the spheres' centres
    overlap: float  # share of the smaller set-up that fits the other
