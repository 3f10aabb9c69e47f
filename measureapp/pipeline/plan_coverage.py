"""What the viewpoints of a plan are predicted to measure of the nominal."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace

import numpy as np

from measureapp.arrays import BoolArray, IntArray
from measureapp.data.mesh import Mesh
from measureapp.data.part_pose import PartPose
from measureapp.data.plan import ScanPlan
from measureapp.data.rig import RigDescription
from measureapp.planning.coverage.extent import standing
from measureapp.planning.coverage.head import Head
from measureapp.planning.coverage.limits import VisibilityLimits
from measureapp.planning.coverage.samples import SurfaceSamples, sample_surface
from measureapp.planning.coverage.scene import PartScene
from measureapp.planning.coverage.unreachable import ORDER, UNKNOWN, find_causes
from measureapp.planning.coverage.visibility import Unseen, seen_by
from measureapp.progress import Progress

SAMPLES = 5000
REASONS = {
    Unseen.FIELD: "outside the images or the depth of field",
    Unseen.INCIDENCE: "too oblique, or facing away",
    Unseen.LIGHT: "near the mirror direction",
    Unseen.HIDDEN: "hidden by the part, the table or a fixture",
}


@dataclass(frozen=True, slots=True, eq=False)
class PlanCoverage:
    """Shares of the surface, and how often each of N samples is seen."""

    counts: IntArray  # (N,), by how many viewpoints a sample is seen
    nearest: IntArray  # (N,), the condition at which the best viewpoint fails, an `Unseen`
    seen: BoolArray  # (V, N)
    samples: SurfaceSamples
    cause: IntArray  # (N,), what prevents a sample from being seen from anywhere, an index in `ORDER`, or `UNKNOWN`

    @classmethod
    def of(cls, reasons: IntArray, samples: SurfaceSamples, blocked: BoolArray) -> PlanCoverage:
        """Build from the reasons (V, N) of `Visibility`; viewpoints that cannot be scanned, ``blocked`` (V,), measure nothing."""
        seen = (reasons == Unseen.SEEN) & ~blocked[:, None]
        nearest = np.where(seen.any(axis=0), np.uint8(Unseen.SEEN), reasons.max(axis=0))
        return cls(np.count_nonzero(seen, axis=0), nearest, seen, samples, np.full(len(samples), UNKNOWN))

    def share(self, which: BoolArray) -> float:
        """Return the share of the surface for which some samples (N,) stand."""
        return float(self.samples.areas_mm2[which].sum() / self.samples.area_mm2)

    @property
    def predicted(self) -> float:
        """Share of the surface that some viewpoint measures."""
        return self.share(self.counts > 0)

    @property
    def twice(self) -> float:
        """Share of the surface that two viewpoints or more measure."""
        return self.share(self.counts > 1)

    def unseen(self) -> dict[str, float]:
        """Return why other viewpoints are needed for a part of the rest, in words, with its shares: the condition at which the best one fails."""
        open_ = (self.counts == 0) & (self.cause == UNKNOWN)
        return self._shares({words: open_ & (self.nearest == reason) for reason, words in REASONS.items()})

    def unmeasurable(self) -> dict[str, float]:
        """Return what prevents every viewpoint from measuring a part of the rest, in the words of the generator, with its shares."""
        return self._shares({str(cause): (self.counts == 0) & (self.cause == place) for place, cause in enumerate(ORDER)})

    def _shares(self, which: Mapping[str, BoolArray]) -> dict[str, float]:
        return {words: self.share(samples) for words, samples in which.items() if samples.any()}


def place_on_table(nominal: Mesh, pose: PartPose | None = None) -> Mesh:
    """Return a nominal in the frame `part`; without a pose upright in the middle of the table, as the generator places it."""
    return nominal.seen_from(standing(nominal, pose))


def predict_coverage(plan: ScanPlan, part: Mesh, rig: RigDescription, blocked: Collection[str], progress: Progress) -> PlanCoverage:
    """Predict what a plan measures of a part, given in the frame `part`; ``blocked`` names viewpoints that cannot be scanned."""
    scene = PartScene.of(part, rig)
    samples = sample_surface(scene, SAMPLES)
    viewpoints = tuple(plan)
    found = seen_by(viewpoints, samples, rig, scene, progress=progress)
    coverage = PlanCoverage.of(found.reason, samples, np.array([viewpoint.id in blocked for viewpoint in viewpoints]))
    unseen = np.flatnonzero(coverage.counts == 0)
    cause = coverage.cause.copy()
    if len(unseen):
        cause[unseen] = find_causes(samples.subset(unseen), Head.of(rig), scene, VisibilityLimits(), None, progress)
    return replace(coverage, cause=cause)
