"""Views that pay: further viewpoints and exposures for what a scan has not measured, with what each is expected to gain."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np
from pydantic import Field

from measureapp.arrays import BoolArray, FloatArray
from measureapp.data.mesh import Mesh
from measureapp.data.model import Model
from measureapp.data.plan import ScanPlan, Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.data.scan_cost import viewpoint_time_s
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.pipeline.closed_loop.causes import CAUSES, Explained
from measureapp.pipeline.closed_loop.coverage import WIDE, MeasuredCoverage, incidence_deg
from measureapp.planning.chances import Chances
from measureapp.planning.collision.build import PartSolid
from measureapp.planning.collision.cell import Cell
from measureapp.planning.coverage.aimed import aimed_candidates
from measureapp.planning.coverage.candidates import grid_candidates
from measureapp.planning.coverage.extent import extent_on_table
from measureapp.planning.coverage.head import heads_at
from measureapp.planning.coverage.visibility import seen_by
from measureapp.planning.next_views import Gain, Holes, between_angles, choose_by_gain, free_id, numbered_id
from measureapp.planning.travel import travel_times_s
from measureapp.progress import NoProgress, PartOf, Progress

Kind = Literal["viewpoint", "exposure"]
NEW_STATION_S, SAME_STATION_S = 6.0, 3.0  # moves to a viewpoint from a new robot pose, and from a known one; exact times follow
OVERLAP_SAMPLES = 600  # of the measured surface, to see what candidates have in common with it
LONGER, SHORTER = 4, 4  # of the longest and shortest exposure, for what is too dark or too bright
LONGEST_US, SHORTEST_US = 500_000, 100
BY_EXPOSURE = 0.7  # chance that another exposure measures what was too dark or too bright
WITHOUT_EXPOSURE = 0.25  # factor of the chance that another viewpoint measures it: light is what it lacks
CHECK_ROUNDS = 8


class NextViewsSettings(Model):
    """What is proposed."""

    most: int = Field(default=6, ge=1, le=100, description="proposals")
    least_share: float = Field(default=0.002, gt=0, lt=1, description="of the surface, that a proposal is expected to add")
    overlap: float = Field(default=0.2, ge=0, le=1, description="share of what a viewpoint sees that is measured already, for registration")
    candidates: int = Field(default=800, ge=24, le=20_000)


@dataclass(frozen=True, slots=True)
class Proposal:
    """A viewpoint to be added, with what it is expected to gain after those before it."""

    viewpoint: Viewpoint
    kind: Kind
    share: float  # of the surface, added
    area_mm2: float
    seconds: float  # images, and the shortest move
    reason: str

    @property
    def per_minute(self) -> float:
        """Share of the surface per minute."""
        return self.share * 60.0 / self.seconds


@dataclass(frozen=True, slots=True, eq=False)
class _Candidates:
    """C viewpoints and the chance that each measures N samples."""

    viewpoints: tuple[Viewpoint, ...]
    kinds: tuple[Kind, ...]
    chance: FloatArray  # (C, N)
    seen_mm2: FloatArray  # (C,), area that it sees
    overlap: FloatArray  # (C,), share of it that is measured already

    def __add__(self, other: _Candidates) -> _Candidates:
        return _Candidates(
            self.viewpoints + other.viewpoints,
            self.kinds + other.kinds,
            np.vstack([self.chance, other.chance]),
            np.concatenate([self.seen_mm2, other.seen_mm2]),
            np.concatenate([self.overlap, other.overlap]),
        )


@dataclass(frozen=True, slots=True)
class ScanCell:
    """Where proposals have to be reached."""

    rig: RigDescription
    arm: ArmModel | None = None


def propose(
    coverage: MeasuredCoverage,
    explained: Explained,
    plan: ScanPlan,
    cell: ScanCell,
    settings: NextViewsSettings | None = None,
    progress: Progress | None = None,
) -> tuple[Proposal, ...]:
    """Propose viewpoints and exposures for the holes of a scan, the most gain for its time first.

    How likely a visible point is measured is learnt from this scan by incidence and grey level; what was visible and is missing nevertheless
    is less likely to be measured again. Points that were too dark or saturated call for another exposure rather than another viewpoint.

    Raises
    ------
    PlanError
        The part does not fit the rig.
    Cancelled
        From ``progress``.
    """
    settings, progress = settings or NextViewsSettings(), progress or NoProgress()
    candidates = _viewpoints(coverage, explained, plan, cell, settings, PartOf(progress, 0.0, 0.8))
    candidates = candidates + _exposures(coverage, explained, plan)
    least_mm2 = settings.least_share * coverage.samples.area_mm2
    areas, missing = coverage.samples.areas_mm2, (~coverage.sufficient).astype(float)
    seconds = _seconds(candidates.viewpoints, plan, cell.rig)
    problem_at = _collisions(coverage, cell)
    overlap = candidates.overlap.copy()
    chosen: tuple[Gain, ...] = ()
    for number in range(CHECK_ROUNDS):
        progress.report(0.8 + 0.2 * number / CHECK_ROUNDS, 1, "choosing")
        holes = Holes(areas, missing, candidates.chance, candidates.seen_mm2, overlap, seconds)
        chosen = choose_by_gain(holes, settings.most, least_mm2, settings.overlap)
        blocked = [one.candidate for one in chosen if problem_at(candidates.viewpoints[one.candidate])]
        if not blocked:
            break
        overlap[blocked] = -1.0
    else:
        chosen = tuple(one for one in chosen if overlap[one.candidate] >= 0)
    progress.report(1, 1, f"{len(chosen)} proposals")
    return _as_proposals(chosen, candidates, coverage, explained, plan, cell)


def extended(plan: ScanPlan, proposals: tuple[Proposal, ...]) -> ScanPlan:
    """Return the plan with the proposed viewpoints added; its own viewpoints are unchanged."""
    return plan.model_copy(update={"viewpoints": (*plan.viewpoints, *(one.viewpoint for one in proposals))})


def _viewpoints(
    coverage: MeasuredCoverage, explained: Explained, plan: ScanPlan, cell: ScanCell, settings: NextViewsSettings, progress: Progress
) -> _Candidates:
    """Return viewpoints within reach, and the chance that each measures what is missing."""
    missing = np.flatnonzero(~coverage.sufficient)
    extent = extent_on_table(coverage.scene.part, cell.rig)
    # collisions are checked for what is chosen, which takes a hundredth of the time
    grid = grid_candidates(extent, cell.rig, cell.arm, PartOf(progress, 0.0, 0.2), settings.candidates)
    own = between_angles(tuple(plan), cell.rig, cell.arm)
    some = coverage.samples.subset(missing)
    pockets = aimed_candidates(some, cell.rig, cell.arm, coverage.scene, WIDE, PartOf(progress, 0.2, 0.5)) if len(missing) else None
    viewpoints = (*own, *grid.viewpoints, *(() if pockets is None else pockets.viewpoints))
    known = np.flatnonzero(coverage.measured)
    known = known[:: max(1, len(known) // OVERLAP_SAMPLES)]
    looked = np.concatenate([missing, known])
    seen = seen_by(viewpoints, coverage.samples.subset(looked), cell.rig, coverage.scene, WIDE, PartOf(progress, 0.5, 1.0)).seen
    chance = np.zeros((len(viewpoints), len(coverage.samples)))
    chance[:, missing] = seen[:, : len(missing)] * _chances(coverage, explained, cell, viewpoints)[:, missing]
    weights = coverage.samples.areas_mm2[known] * float(coverage.samples.areas_mm2[coverage.measured].sum())
    common = seen[:, len(missing) :] @ (weights / max(float(coverage.samples.areas_mm2[known].sum()), 1e-300))
    new = seen[:, : len(missing)] @ coverage.samples.areas_mm2[missing]
    kinds = tuple[Kind, ...]("viewpoint" for _ in viewpoints)
    return _Candidates(viewpoints, kinds, chance, common + new, common / np.maximum(common + new, 1e-300))


def _chances(coverage: MeasuredCoverage, explained: Explained, cell: ScanCell, viewpoints: tuple[Viewpoint, ...]) -> FloatArray:
    """Return the chance (C, N) that viewpoints measure samples which they see."""
    learnt = Chances.learn(coverage.visible, coverage.by_view, coverage.incidence_deg(coverage.viewpoints, cell.rig), coverage.grey)
    for_light = explained.too_dark | explained.too_bright
    failures = (coverage.visible & ~coverage.by_view & ~for_light).sum(axis=0).astype(float)
    chance = learnt.of(incidence_deg(heads_at(viewpoints, cell.rig), coverage.samples), coverage.grey, failures)
    return np.asarray(chance * np.where(for_light.any(axis=0), WITHOUT_EXPOSURE, 1.0))


def _exposures(coverage: MeasuredCoverage, explained: Explained, plan: ScanPlan) -> _Candidates:
    """Return the views of the scan with longer and shorter exposures, for what they lost for lack or excess of light."""
    viewpoints: list[Viewpoint] = []
    chances: list[FloatArray] = []
    numbers: list[int] = []
    for number, viewpoint in enumerate(coverage.viewpoints):
        own = plan.exposures_of(viewpoint)
        longer = tuple(dict.fromkeys(min(factor * own[0], LONGEST_US) for factor in (LONGER, LONGER // 2)))
        shorter = tuple(dict.fromkeys(max(own[-1] // factor, SHORTEST_US) for factor in (SHORTER // 2, SHORTER)))
        for name, bracket, lost in (("longer", longer, explained.too_dark[number]), ("shorter", shorter, explained.too_bright[number])):
            if lost.any() and bracket not in ((own[0],), (own[-1],)):
                changed = {"id": f"{viewpoint.id[:90]}-{name}", "exposures_us": bracket}
                viewpoints.append(viewpoint.model_copy(update=changed))
                chances.append(BY_EXPOSURE * lost)
                numbers.append(number)
    chance = np.array(chances).reshape(len(viewpoints), len(coverage.samples))
    kinds = tuple[Kind, ...]("exposure" for _ in viewpoints)
    seen_mm2 = coverage.visible[numbers] @ coverage.samples.areas_mm2
    return _Candidates(tuple(viewpoints), kinds, chance, seen_mm2, np.ones(len(viewpoints)))


def _seconds(viewpoints: tuple[Viewpoint, ...], plan: ScanPlan, rig: RigDescription) -> FloatArray:
    """Return the approximate time of each viewpoint, (C,)."""
    known = {viewpoint.flange for viewpoint in plan}
    moves = [SAME_STATION_S if viewpoint.flange in known else NEW_STATION_S for viewpoint in viewpoints]
    return np.array([viewpoint_time_s(plan, viewpoint, rig) for viewpoint in viewpoints]) + moves


def _collisions(coverage: MeasuredCoverage, cell: ScanCell) -> Callable[[Viewpoint], str]:
    """Return what prevents the axes from standing at a viewpoint; an empty text where nothing does."""
    part: Mesh = coverage.scene.part
    return Cell.of(cell.rig, cell.arm, PartSolid.of_points(np.asarray(part.vertices_mm, float))).problem_at


def _as_proposals(
    chosen: tuple[Gain, ...], candidates: _Candidates, coverage: MeasuredCoverage, explained: Explained, plan: ScanPlan, cell: ScanCell
) -> tuple[Proposal, ...]:
    taken = {viewpoint.id for viewpoint in plan}
    found = []
    for one in chosen:
        viewpoint, kind = candidates.viewpoints[one.candidate], candidates.kinds[one.candidate]
        name = numbered_id("next", taken) if kind == "viewpoint" else free_id(viewpoint.id, taken)
        taken.add(name)
        moves = travel_times_s((viewpoint, *plan), cell.rig, cell.arm)[1:, 0]
        seconds = viewpoint_time_s(plan, viewpoint, cell.rig) + float(moves.min())
        reason = _reason(candidates.chance[one.candidate] > 0, explained, coverage, kind)
        renamed = viewpoint.model_copy(update={"id": name})
        found.append(Proposal(renamed, kind, one.area_mm2 / coverage.samples.area_mm2, one.area_mm2, seconds, reason))
    return tuple(found)


def _reason(gains: BoolArray, explained: Explained, coverage: MeasuredCoverage, kind: Kind) -> str:
    """State which holes a proposal is for: the cause with the largest area among them."""
    areas = [float(coverage.samples.areas_mm2[gains & (explained.cause == number)].sum()) for number in range(len(CAUSES))]
    words = f"for {max(areas):.0f} mm²: {CAUSES[int(np.argmax(areas))]}"
    return words if kind == "viewpoint" else f"other exposures, {words}"
