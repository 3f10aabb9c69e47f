"""The generator of scan plans: viewpoints around a nominal, chosen by what they are predicted to measure."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from pydantic import Field

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.mesh import Mesh
from measureapp.data.model import Model
from measureapp.data.pattern_sets import DEFAULT_NAME, make_pattern_sets
from measureapp.data.plan import ExposureBracket, ScanPlan, StationPose, Viewpoint, ViewpointGroup
from measureapp.data.rig import RigDescription
from measureapp.data.scan_cost import stack_bytes, viewpoint_time_s
from measureapp.errors import PlanError
from measureapp.geometry.transform import RigidTransform
from measureapp.planning.coverage.aimed import aimed_candidates
from measureapp.planning.coverage.candidates import MOST_CANDIDATES, Candidates, checked_grid, free_of_contact
from measureapp.planning.coverage.extent import extent_on_table, standing
from measureapp.planning.coverage.greedy import Goal, choose
from measureapp.planning.coverage.head import Head
from measureapp.planning.coverage.improve import components, improve
from measureapp.planning.coverage.limits import VisibilityLimits
from measureapp.planning.coverage.result import GeneratedPlan
from measureapp.planning.coverage.samples import SurfaceSamples, sample_surface
from measureapp.planning.coverage.scene import PartScene
from measureapp.planning.coverage.unreachable import UnreachableArea, as_areas, find_causes, touches_support
from measureapp.planning.coverage.value import Problem
from measureapp.planning.coverage.visibility import seen_from
from measureapp.planning.feasibility import Feasibility
from measureapp.planning.order import path_time_s, shortest_order
from measureapp.planning.travel import speeds_note, travel_times_s
from measureapp.progress import NoProgress, PartOf, Progress

BLOCKED_S = 1e4  # added to a way that is not free
REROUTES = 8
MOST_PAIRS = 60_000_000  # of candidates and samples: about 0.6 GB


class GeneratorSettings(Model):
    """What a generated plan has to achieve, and how thoroughly it is searched."""

    name: str = "generated"
    coverage: float = Field(default=0.98, gt=0, le=1, description="of what some feasible viewpoint measures")
    viewpoints: int | None = Field(default=None, ge=1, description="exactly that many, with the best coverage; none: as many as needed")
    sigma_mm: float | None = Field(
        default=None, gt=0, description="required of a point, coverage is then of information 1/σ²; none: it is measured"
    )
    views: int = Field(default=2, ge=1, le=10, description="that see each place where candidates allow: overlap joins the clouds")
    overlap: float = Field(default=0.2, ge=0, le=1, description="share of its area that a viewpoint has in common with others")
    samples: int = Field(default=5000, ge=50, le=50_000, description="of the surface")
    candidates: int = Field(default=MOST_CANDIDATES, ge=24, le=20_000)
    seed: int = Field(default=1, ge=0)
    patterns: str = DEFAULT_NAME
    limits: VisibilityLimits = VisibilityLimits()


def generate_plan(
    nominal: Mesh,
    cell: Feasibility,
    settings: GeneratorSettings | None = None,
    *,
    part_from_nominal: RigidTransform | None = None,
    fixtures: Sequence[Mesh] = (),
    like: ScanPlan | None = None,
    progress: Progress | None = None,
) -> GeneratedPlan:
    """Plan viewpoints that measure a part: the fewest for a share of what is measurable, or the best of a given number.

    Candidates are stations of the robot with many angles of the table and a few places of the guide, and poses aimed at what these miss. What
    each measures is predicted by `seen_from`. A lazy greedy cover with a price on every new robot pose chooses among them; exchanges remove
    what is redundant; the order spares motion and visits each robot pose once. The same arguments give the same plan.

    Parameters
    ----------
    cell : the rig, and what is feasible on it; `Feasibility.checked` includes collisions
    nominal : in mm; may have holes and triangles wound the wrong way
    part_from_nominal : pose of the part on the table (frame `part`: `head.part_from_head`); None: upright in the middle
    fixtures : meshes in frame `part` that turn with the table, such as clamps; they hide, but are not to be measured
    like : plan whose name, patterns, exposures and settling time are kept; None: those of ``settings`` and the rig
    progress : also the cancellation point

    Raises
    ------
    PlanError
        The part is too small or too large for the rig, the search too large, or no feasible viewpoint sees any of it.
    Cancelled
        From ``progress``.
    """
    settings, progress = settings or GeneratorSettings(), progress or NoProgress()
    if settings.samples * settings.candidates > MOST_PAIRS:
        raise PlanError(
            f"{settings.samples} samples and {settings.candidates} candidates need too much memory.",
            f"Their product may be {MOST_PAIRS:.0e} at most.",
        )
    part = nominal.seen_from(part_from_nominal or standing(nominal))
    extent = extent_on_table(part, cell.rig)
    scene = PartScene.of(part, cell.rig, fixtures)
    samples = sample_surface(scene, settings.samples, settings.seed)
    search = _Search(cell, scene, samples, settings)
    grid, free = checked_grid(extent, cell.rig, cell.arm, cell.is_free, PartOf(progress, 0.0, 0.2), settings.candidates)
    found = _with_aimed(search, grid, grid.subset(free), PartOf(progress, 0.2, 0.6))
    chosen, problem = _chosen(search, found, PartOf(progress, 0.6, 0.85))
    picked = found.free.subset(np.array(chosen))
    order, moves_s, blocked = _ordered(picked.viewpoints, search)
    plan = _as_plan([picked.viewpoints[step] for step in order], cell.rig, settings, like)
    areas = _unreachable(search, found, PartOf(progress, 0.85, 1.0))
    information = np.nansum(1.0 / np.square(found.sigma_mm[chosen].astype(float)), axis=0)
    progress.report(1, 1, f"{len(plan)} viewpoints")
    return GeneratedPlan(
        plan=plan,
        samples=samples,
        seen=np.isfinite(found.sigma_mm[np.array(chosen)[order]]),
        sigma_mm=np.where(information > 0.0, 1.0 / np.sqrt(np.maximum(information, 1e-300)), np.nan),
        allowed=np.asarray(np.isfinite(found.sigma_mm).any(axis=0)),
        unreachable=areas,
        candidates=len(found.free),
        moves_s=moves_s,
        images_s=sum(viewpoint_time_s(plan, viewpoint, cell.rig) for viewpoint in plan),
        bytes=sum(stack_bytes(plan, viewpoint, cell.rig) for viewpoint in plan),
        problems=(*_shortfalls(problem, chosen, settings), *blocked),
        note=speeds_note(cell.rig, cell.arm),
    )


@dataclass(frozen=True, slots=True, eq=False)
class _Search:
    """What every step of the search needs."""

    cell: Feasibility
    scene: PartScene
    samples: SurfaceSamples
    settings: GeneratorSettings

    def sigma_mm(self, candidates: Candidates, progress: Progress) -> FloatArray:
        head = Head.of(self.cell.rig)
        return seen_from(candidates.heads, self.samples, head, self.scene, self.settings.limits, progress).sigma_mm


@dataclass(frozen=True, slots=True, eq=False)
class _Found:
    """Candidates within reach, those of them that touch nothing, and what the latter measure."""

    reachable: Candidates
    free: Candidates
    sigma_mm: FloatArray  # (V, N)


def _with_aimed(search: _Search, grid: Candidates, free: Candidates, progress: Progress) -> _Found:
    """Return what the grid of candidates sees, and candidates aimed at the rest."""
    cell = search.cell
    sigma = search.sigma_mm(free, PartOf(progress, 0.0, 0.8))
    unseen = ~np.isfinite(sigma).any(axis=0) & ~touches_support(search.samples, search.scene)
    missed = search.samples.subset(np.flatnonzero(unseen))
    aimed = aimed_candidates(missed, cell.rig, cell.arm, search.scene, search.settings.limits, PartOf(progress, 0.8, 0.9))
    aimed_free = aimed.subset(free_of_contact(aimed, cell.is_free, PartOf(progress, 0.9, 0.95)))
    more = search.sigma_mm(aimed_free, PartOf(progress, 0.95, 1.0))
    found = _Found(grid.joined(aimed), free.joined(aimed_free), np.concatenate([sigma, more]))
    if not np.isfinite(found.sigma_mm).any():
        raise PlanError(
            f"{cell.rig.name} cannot measure any of the part: none of {len(found.free)} feasible viewpoints sees it.",
            "Check the pose of the part on the table and the rig's limits.",
        )
    return found


def _chosen(search: _Search, found: _Found, progress: Progress) -> tuple[list[int], Problem]:
    settings = search.settings
    areas_mm2, station = search.samples.areas_mm2, found.free.station
    if settings.views > 1 and settings.sigma_mm is None:
        problem = Problem.of_views(found.sigma_mm, areas_mm2, station, settings.views)
    else:
        problem = Problem.of(found.sigma_mm, areas_mm2, station, settings.sigma_mm)
    most = problem.covered_area(problem.information(np.arange(len(found.free))))
    goal = Goal(settings.coverage * most, settings.viewpoints, settings.overlap)
    chosen = choose(problem, goal, PartOf(progress, 0.0, 0.4))
    return improve(problem, chosen, goal, PartOf(progress, 0.4, 1.0)), problem


def _ordered(viewpoints: Sequence[Viewpoint], search: _Search) -> tuple[list[int], float, tuple[str, ...]]:
    """Return the order, the time of all moves, and the moves that are not free although others were tried."""
    cell = search.cell
    times = travel_times_s(viewpoints, cell.rig, cell.arm)
    penalised, blocked = times.copy(), {}
    for _ in range(REROUTES):
        order = shortest_order(viewpoints, penalised)
        blocked = _blocked(viewpoints, order, cell.problem_between)
        if not blocked:
            break
        for pair in blocked:
            penalised[pair] = times[pair] + BLOCKED_S
    sentences = tuple(f"The move from place {start + 1} to {end + 1} is not free: {why}" for (start, end), why in blocked.items())
    return order, path_time_s(order, times), sentences


def _blocked(
    viewpoints: Sequence[Viewpoint], order: Sequence[int], problem_between: Callable[[Viewpoint, Viewpoint], str] | None
) -> dict[tuple[int, int], str]:
    if problem_between is None:
        return {}
    found = {(start, end): problem_between(viewpoints[start], viewpoints[end]) for start, end in pairwise(order)}
    return {pair: why for pair, why in found.items() if why}


def _as_plan(ordered: Sequence[Viewpoint], rig: RigDescription, settings: GeneratorSettings, like: ScanPlan | None) -> ScanPlan:
    """Return the plan, with one group for every place of robot and guide."""
    sets = make_pattern_sets(rig.projector.width_px, rig.projector.height_px)
    if settings.patterns not in sets:
        raise PlanError(f"There is no pattern set {settings.patterns!r}.", f"Choose one of {', '.join(sets)}.")
    runs: list[tuple[StationPose, list[float]]] = []
    for viewpoint in ordered:
        pose = StationPose(flange=viewpoint.flange, guide_mm=viewpoint.guide_mm)
        if not runs or runs[-1][0] != pose:
            runs.append((pose, []))
        runs[-1][1].append(viewpoint.table_deg)
    groups = tuple(
        ViewpointGroup(id=f"view{number:02d}", poses=(pose,), table_deg=tuple(angles)) for number, (pose, angles) in enumerate(runs, 1)
    )
    if like is not None:
        return like.model_copy(update={"viewpoints": (), "groups": groups})
    bracket = ExposureBracket(exposures_us=tuple(rig.exposures_us))
    return ScanPlan(name=settings.name, groups=groups, patterns=sets[settings.patterns], bracket=bracket)


def _unreachable(search: _Search, found: _Found, progress: Progress) -> tuple[UnreachableArea, ...]:
    unseen: IntArray = np.flatnonzero(~np.isfinite(found.sigma_mm).any(axis=0))
    if not len(unseen):
        return ()
    poses = (found.reachable.heads, found.free.heads)
    some, head = search.samples.subset(unseen), Head.of(search.cell.rig)
    cause = find_causes(some, head, search.scene, search.settings.limits, poses, progress)
    return as_areas(unseen, cause, search.samples)


def _shortfalls(problem: Problem, chosen: list[int], settings: GeneratorSettings) -> tuple[str, ...]:
    found = []
    if settings.viewpoints is not None and len(chosen) < settings.viewpoints:
        found.append(f"{settings.viewpoints} viewpoints were requested; no more than {len(chosen)} add anything.")
    groups = components(problem, chosen, settings.overlap)
    if groups > 1:
        found.append(
            f"The viewpoints form {groups} groups without {settings.overlap:.0%} of common area: registration cannot connect them."
        )
    return tuple(found)
