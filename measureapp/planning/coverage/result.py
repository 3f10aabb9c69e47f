"""A generated plan with its prediction."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import BoolArray, FloatArray
from measureapp.data.plan import ScanPlan
from measureapp.planning.coverage.samples import SurfaceSamples
from measureapp.planning.coverage.unreachable import UnreachableArea


@dataclass(frozen=True, slots=True, eq=False)
class GeneratedPlan:
    """Viewpoints in scan order, and what they are predicted to measure of N samples of the surface (frame `part`)."""

    plan: ScanPlan
    samples: SurfaceSamples
    seen: BoolArray  # (P, N), which of the plan's viewpoints sees which sample, in scan order
    sigma_mm: FloatArray  # (N,), standard deviation of all views together, along the rays; NaN: not planned
    allowed: BoolArray  # (N,), what some feasible candidate sees
    unreachable: tuple[UnreachableArea, ...]  # what none sees, and why
    candidates: int  # number of feasible candidates
    moves_s: float  # predicted time of all moves
    images_s: float  # least time of all images, and the waiting before them
    bytes: int  # of all images
    problems: tuple[str, ...]  # that a person should know before the scan
    note: str = ""  # speeds that the time assumes, in a sentence

    @property
    def planned(self) -> BoolArray:
        """What the plan's viewpoints see, (N,)."""
        return np.asarray(self.seen.any(axis=0))

    @property
    def allowed_share(self) -> float:
        """Share of the whole surface that some feasible viewpoint sees."""
        return self._share(self.allowed)

    @property
    def planned_share(self) -> float:
        """Share of the whole surface that the plan sees."""
        return self._share(self.planned)

    @property
    def planned_of_allowed(self) -> float:
        """Share of what some feasible viewpoint sees that the plan sees."""
        return self.planned_share / self.allowed_share if self.allowed_share else 0.0

    @property
    def stations(self) -> int:
        """Number of robot poses."""
        return len({viewpoint.flange for viewpoint in self.plan})

    @property
    def time_s(self) -> float:
        """Predicted time of the scan, without calibration and processing after the last image."""
        return self.moves_s + self.images_s

    def _share(self, which: BoolArray) -> float:
        return float(self.samples.areas_mm2[which].sum()) / self.samples.area_mm2
