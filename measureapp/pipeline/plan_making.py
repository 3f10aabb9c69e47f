"""A scan plan from a nominal: the generator with the noise of the rig's cameras and the pose of the part."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from measureapp.data.mesh import Mesh
from measureapp.data.part_pose import PartPose
from measureapp.data.pattern_sets import make_pattern_sets
from measureapp.data.plan import ScanPlan
from measureapp.data.rig import RigDescription
from measureapp.errors import PlanError
from measureapp.fringe.noise.model import CameraNoise
from measureapp.pipeline.prediction.fringe_noise import fringe_noise
from measureapp.pipeline.prediction.light import PartLight
from measureapp.planning.coverage.extent import extent_on_table, standing
from measureapp.planning.coverage.limits import VisibilityLimits
from measureapp.planning.coverage.result import GeneratedPlan
from measureapp.planning.feasibility import Feasibility
from measureapp.planning.generate import GeneratorSettings, generate_plan
from measureapp.progress import Progress
from measureapp.project.geometry.robot_file import arm_of


@dataclass(frozen=True, slots=True)
class PlanContext:
    """What a plan depends on besides the nominal and the rig."""

    pose: PartPose | None = None  # None: upright in the middle of the table
    like: ScanPlan | None = None  # a plan whose patterns, exposures, settling time and name are kept
    noise: Mapping[str, CameraNoise] = field(default_factory=dict)  # measured, by camera
    light: PartLight | None = None  # None: the part just saturates at the longest exposure


def make_plan(nominal: Mesh, rig: RigDescription, settings: GeneratorSettings, context: PlanContext, progress: Progress) -> GeneratedPlan:
    """Generate a plan free of collisions, which states how the part stands; σ is predicted for its patterns and exposures.

    Raises
    ------
    PlanError
        The part does not fit on the table, or nothing of it can be measured.
    Cancelled
        From ``progress``.
    """
    place = standing(nominal, context.pose)
    part = nominal.seen_from(place)
    extent_on_table(part, rig)
    sets = make_pattern_sets(rig.projector.width_px, rig.projector.height_px)
    if settings.patterns not in sets:
        raise PlanError(f"There is no pattern set {settings.patterns!r}.", f"Choose one of {', '.join(sets)}.")
    like = context.like
    patterns = sets[settings.patterns] if like is None else like.patterns
    exposures_us = tuple(rig.exposures_us) if like is None else like.bracket.exposures_us
    limits: VisibilityLimits = settings.limits.model_copy(
        update={"fringes": fringe_noise(patterns, exposures_us, rig, context.noise, context.light)}
    )
    cell = Feasibility.checked(rig, arm_of(rig), part)
    chosen = settings.model_copy(update={"limits": limits})
    made = generate_plan(nominal, cell, chosen, part_from_nominal=place, like=like, progress=progress)
    return replace(made, plan=made.plan.model_copy(update={"part_pose": context.pose}))
