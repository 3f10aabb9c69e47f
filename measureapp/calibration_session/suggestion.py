"""D-optimal viewpoint of the rig: the reachable next view of the board that adds most information on the cameras."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import degrees

import numpy as np

from measureapp.calibrate.boards.observation import Observation
from measureapp.calibrate.cameras.array import CameraArraySolution
from measureapp.calibrate.draft.advice import Ghost, outlines_px
from measureapp.calibrate.draft.draft import Draft
from measureapp.calibrate.guidance.next_view import candidates, gain_of
from measureapp.data.board import BoardDescription
from measureapp.data.plan import FlangePose, Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.geometry.transform import RigidTransform
from measureapp.planning.collision.build import PartSolid
from measureapp.planning.collision.cell import Cell
from measureapp.planning.reach import limit_violations
from measureapp.project.geometry.robot_file import arm_of

SLIDES_MM = (0.0, -150.0, 150.0, -300.0, 300.0)  # beside the place straight before the table's centre
NEAR_MM, NEAR_RAD = 20.0, float(np.deg2rad(8.0))  # of an existing view: adds no new information
LEAST_GAIN = 0.05  # of ln det of the covariance: below, a view adds too little


@dataclass(frozen=True, slots=True, eq=False)
class Suggestion:
    """A viewpoint to add, and where the board will appear from there."""

    viewpoint: Viewpoint
    ghost: Ghost


def suggest_viewpoint(draft: Draft, rig: RigDescription, name: str) -> Suggestion | None:
    """Return the reachable viewpoint that adds most to the Fisher information of the cameras; None where none adds anything.

    The board pose is that of the last observation with a read-back; the nominal pose of the head on the flange is accurate enough
    to aim. Candidates and gain are those of `best_view`.
    """
    solved = draft.solved
    if solved is None or solved.camera_solution is None:
        return None
    solution = solved.camera_solution
    last = _last_with_readback(draft, solution)
    if last is None:
        return None
    observation, seen = last
    distance = float(np.median([place.apply(solution.board.middle_mm)[2] for place in solution.boards.values()]))
    best: tuple[float, Suggestion] | None = None
    arm = arm_of(rig)
    cell = Cell.of(rig, arm, PartSolid.board_on_stand())
    lenses = draft.setup.lenses
    for place in candidates(solution, distance, lenses):
        if any(_is_near(place, known) for known in solution.boards.values()):
            continue
        viewpoint = _viewpoint(rig, arm, name, place, observation, seen)
        if viewpoint is not None:
            gain = gain_of(solution, place, lenses)
            if gain > (LEAST_GAIN if best is None else best[0]) and not cell.problem_at(viewpoint):
                best = gain, Suggestion(viewpoint, _ghost(solution, place, solution.board))
    return None if best is None else best[1]


def _is_near(place: RigidTransform, known: RigidTransform) -> bool:
    apart = known.inverse() @ place
    return bool(np.linalg.norm(apart.translation_mm) < NEAR_MM and apart.angle_rad < NEAR_RAD)


def _ghost(solution: CameraArraySolution, place: RigidTransform, board: BoardDescription) -> Ghost:
    return Ghost(outlines_px(solution.calibration, place, board))


def _last_with_readback(draft: Draft, solution: CameraArraySolution) -> tuple[Observation, RigidTransform] | None:
    for one in reversed(draft.observations):
        read = one.readback
        known = read.base_from_flange is not None and read.guide_mm is not None and read.table_rad is not None
        if known and one.id in solution.boards:
            return one, solution.boards[one.id]
    return None


def _viewpoint(
    rig: RigDescription,
    arm: ArmModel | None,
    name: str,
    camera_from_board: RigidTransform,
    observation: Observation,
    seen: RigidTransform,
) -> Viewpoint | None:
    """The viewpoint from which the board appears at ``camera_from_board``, with the first slide position from which it can be reached."""
    read = observation.readback.full()
    head_from_camera = rig.camera(rig.reference).head_from_camera.transform("head", "camera")
    flange_from_camera = rig.flange_from_head.transform("flange", "head") @ head_from_camera
    guide_from_board = _slide(read.guide_mm) @ read.base_from_flange @ flange_from_camera @ seen
    guide_from_flange = guide_from_board @ camera_from_board.inverse() @ flange_from_camera.inverse()
    for guide_mm in _slides(guide_from_flange):
        flange = FlangePose.of(_slide(guide_mm).inverse() @ guide_from_flange)
        viewpoint = Viewpoint(id=name, flange=flange, guide_mm=guide_mm, table_deg=degrees(read.table_rad))
        if not limit_violations(viewpoint, rig, arm):
            return viewpoint
    return None


def _slides(guide_from_flange: RigidTransform) -> Iterator[float]:
    """Slide positions to try, that beside the flange first."""
    beside = float(guide_from_flange.translation_mm[1])
    return (round(beside + offset, 1) for offset in SLIDES_MM)


def _slide(guide_mm: float) -> RigidTransform:
    return RigidTransform.from_parts(np.eye(3), np.array([0.0, guide_mm, 0.0]), "guide", "base")
