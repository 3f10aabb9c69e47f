"""Work of the generator and of the order, on a job's thread."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from measureapp.errors import PlanError
from ui.look.language.words import tr

if TYPE_CHECKING:
    from measureapp.data.plan import ScanPlan
    from measureapp.data.rig import RigDescription
    from measureapp.geometry.kinematics.arm import ArmModel
    from measureapp.planning.coverage.result import GeneratedPlan
    from ui.controllers.plan_part import PreparedPart
    from ui.workers.job import Job

MOST_ORDERED = 300


@dataclass(frozen=True, eq=False)
class Wanted:
    """What a generated plan has to achieve, and the plan that it replaces."""

    former: ScanPlan | None
    viewpoints: int | None  # None: as many as the coverage needs
    coverage: float  # of what the rig can measure


def generate(wanted: Wanted, rig: RigDescription, part: PreparedPart, job: Job) -> GeneratedPlan:
    """Generate a plan free of collisions, with patterns, exposures and pose of the part of the former one."""
    from measureapp.pipeline.plan_making import PlanContext, make_plan
    from measureapp.planning.generate import GeneratorSettings
    from measureapp.project.geometry.files import read_mesh

    settings = GeneratorSettings(name=part.path.parent.name, viewpoints=wanted.viewpoints, coverage=wanted.coverage)
    former = wanted.former
    context = PlanContext(pose=None if former is None else former.part_pose, like=former)
    return make_plan(read_mesh(part.path), rig, settings, context, job)


def order(plan: ScanPlan, rig: RigDescription, arm: ArmModel | None, job: Job) -> list[str]:
    """Return the names of all viewpoints in the order in which the axes move least. Raises PlanError for too many viewpoints."""
    from measureapp.planning.order import shortest_order
    from measureapp.planning.travel import travel_times_s

    if len(plan) > MOST_ORDERED:
        raise PlanError(
            tr("{count} viewpoints are too many to be ordered.", count=len(plan)),
            tr("Up to {most_ordered} can be.", most_ordered=MOST_ORDERED),
        )
    job.report(0, 2, "Times of the moves")
    viewpoints = tuple(plan)
    times = travel_times_s(viewpoints, rig, arm)
    job.report(1, 2, "Order of the viewpoints")
    return [viewpoints[place].id for place in shortest_order(viewpoints, times)]
