"""The closed loop of a project: its coverage, its holes with their causes, and the views that pay."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.data.plan import ScanPlan
from measureapp.errors import InputError, PlanError
from measureapp.pipeline.closed_loop.causes import Cause, Explained, Hole, explain_holes, holes_of, shares_by_cause
from measureapp.pipeline.closed_loop.coverage import MeasuredCoverage, measure_coverage
from measureapp.pipeline.closed_loop.next_views import NextViewsSettings, Proposal, ScanCell, extended, propose
from measureapp.pipeline.why import ExplainedView, explain_view
from measureapp.progress import NoProgress, PartOf, Progress
from measureapp.project.folder import ProjectFolder
from measureapp.project.geometry.files import read_mesh
from measureapp.project.geometry.robot_file import arm_of


@dataclass(frozen=True, slots=True, eq=False)
class ClosedLoop:
    """Coverage of a scan, its holes, and proposals for them."""

    coverage: MeasuredCoverage
    explained: Explained
    proposals: tuple[Proposal, ...]
    plan: ScanPlan  # with the proposed viewpoints

    @property
    def measured(self) -> float:
        """Share of the surface that is measured."""
        return self.coverage.share(self.coverage.measured)

    @property
    def sufficient(self) -> float:
        """Share of the surface that is measured as well as required."""
        return self.coverage.share(self.coverage.sufficient)

    @property
    def accessible(self) -> float:
        """Share of the surface that does not touch the support."""
        return 1.0 - self.coverage.share(self.explained.of(Cause.SUPPORT))

    @property
    def expected(self) -> float:
        """Share of the surface that is expected to be sufficient with all proposals."""
        return self.sufficient + sum(one.share for one in self.proposals)

    @property
    def median_sigma_mm(self) -> float:
        """Median standard deviation of the measured samples; 0 where there are none."""
        known = self.coverage.sigma_mm[self.coverage.measured]
        return float(np.median(known)) if len(known) else 0.0

    def holes(self) -> tuple[Hole, ...]:
        """Return the connected areas that are missing, the largest first."""
        return holes_of(self.explained, self.coverage.samples)

    def shares(self) -> dict[str, float]:
        """Return the missing share of the surface for each cause, the largest first."""
        return shares_by_cause(self.explained, self.coverage)


def find_next_views(
    project: ProjectFolder,
    settings: NextViewsSettings | None = None,
    progress: Progress | None = None,
    *,
    required_mm: float | None = None,
    from_images: bool = True,
) -> ClosedLoop:
    """Compare a project's scan with its nominal and propose viewpoints and exposures for what is missing; nothing is written.

    Parameters
    ----------
    required_mm : standard deviation required of a point; None: that it is measured
    from_images : find causes in the images of the views that lost most, which are decoded again

    Raises
    ------
    InputError
        The project has no measurement or no nominal.
    PlanError
        It has no scan plan, or its part does not fit the rig.
    """
    progress = progress or NoProgress()
    measurement, plan = project.measurement(), project.plan()
    if measurement is None:
        raise InputError(f"{project.path} has no results.", "Scan the part, or compute them: measureapp process PROJECT.")
    if plan is None:
        raise PlanError(f"{project.path} has no scan plan.", "Recordings of other rigs have none; plan a new scan.")
    if project.nominal is None:
        raise InputError(f"{project.path} has no nominal.", "Add it on the page Inspect.")
    nominal, rig = read_mesh(project.nominal, "nominal"), project.rig()
    coverage = measure_coverage(measurement, plan, nominal, rig, PartOf(progress, 0.0, 0.2), required_mm=required_mm)
    cameras = measurement.calibration.cameras
    pinhole = cameras.cameras[cameras.reference].pinhole

    def explain(viewpoint_id: str) -> ExplainedView:
        return explain_view(project, viewpoint_id)

    explained = explain_holes(coverage, pinhole, explain if from_images else None, PartOf(progress, 0.2, 0.6))
    proposals = propose(coverage, explained, plan, ScanCell(rig, arm_of(rig)), settings, PartOf(progress, 0.6, 1.0))
    return ClosedLoop(coverage, explained, proposals, extended(plan, proposals))
