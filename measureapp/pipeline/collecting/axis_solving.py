"""Axis, hand-eye, guide and rig from board poses, with observations left out that contradict the others."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.boards.agreement import BoardPlaces, agreeing
from measureapp.calibrate.boards.pose import BoardPose, board_pose
from measureapp.calibrate.motions.axis_circles import LEAST_POSITIONS as LEAST_TABLE_POSITIONS
from measureapp.calibrate.motions.contradictions import guide_places, hand_eye_places
from measureapp.calibrate.motions.hand_eye import LEAST_POSES, HandEyeDraft, HandEyeProblem
from measureapp.calibrate.motions.hand_eye import solve as solve_hand_eye
from measureapp.calibrate.motions.linear_guide import LEAST_POSITIONS as LEAST_SLIDE_POSITIONS
from measureapp.calibrate.motions.linear_guide import GuideDraft, GuideObservation, GuideProblem
from measureapp.calibrate.motions.linear_guide import solve as solve_guide
from measureapp.calibrate.motions.moved_boards import without_moved
from measureapp.calibrate.motions.rotation_axis import AxisDraft, problem_from_poses
from measureapp.calibrate.motions.rotation_axis import solve as solve_axis
from measureapp.calibrate.poses import inverted, mean_pose, stacked
from measureapp.calibrate.rig.joint import RigObservation, solve_rig
from measureapp.calibrate.rig.joint import shortfalls as rig_shortfalls
from measureapp.calibrate.rig.joint_solution import RigSolution
from measureapp.calibrate.sightings import naming_refused
from measureapp.data.board import BoardDescription
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import RigidTransform, orthonormalise
from measureapp.pipeline.collecting.carried import guide_carried
from measureapp.pipeline.collecting.observation import Observation
from measureapp.pipeline.collecting.setup import Setup
from measureapp.pipeline.collecting.solved import Solution, Solved, misfit_mm, misfit_px, sentences
from measureapp.progress import Progress


def board_places(observations: Sequence[Observation], cameras: CameraArrayCalibration, board: BoardDescription) -> BoardPlaces[str]:
    """Find the board's pose in every observation, weighted with the noise that all of them show.

    Raises
    ------
    CalibrationError
        In most observations the images contradict the cameras.
    """
    poses = {
        one.id: board_pose(
            {camera: found.corners_px for camera, found in one.seen.items() if camera in cameras.cameras},
            cameras,
            board,
            ids={camera: found.ids for camera, found in one.seen.items()},
        )
        for one in observations
    }
    return agreeing(poses)


def solve_axes(setup: Setup, observations: Sequence[Observation], progress: Progress) -> Solved:
    """Solve axis, hand-eye, guide or rig with cameras that are known. Raises CalibrationError as the calibration itself."""
    assert setup.cameras is not None  # `Setup` sees to it
    places = board_places(observations, setup.cameras, setup.board)
    kept = [one for one in observations if one.id in places.poses]
    try:
        answer, moved = _without_outliers(setup, kept, places.poses, progress)
    except CalibrationError as error:
        raise naming_refused(error, [(f"observation {name}", reason) for name, reason in places.rejected.items()]) from error
    solved = Solved(
        solution=answer.solution,
        of=tuple(one.id for one in observations),
        used=tuple(answer.predicted),
        board=setup.board,
        cameras=setup.cameras,
        places={name: pose.camera_from_board for name, pose in places.poses.items()},
        reasons={**places.rejected, **moved},
    )
    return _with_residuals(solved, observations, answer.predicted)


def with_rig(rig: RigSolution, observations: Sequence[Observation], cameras: Solved) -> Solved:
    """Return a solved rig together with the cameras calibrated from the same observations."""
    predicted = _rig_places(rig)
    reasons = dict(cameras.reasons)
    for name, reason in rig.rejected.items():
        reasons[name] = sentences(reason, reasons.get(name, ""))
    solved = replace(cameras, solution=rig, used=tuple(predicted), cameras=rig.calibration.cameras, reasons=reasons)
    return _with_residuals(solved, observations, predicted)


def axis_shortfalls(setup: Setup, observations: Sequence[Observation]) -> tuple[str, ...]:
    """Say what the axes still miss."""
    if setup.kind == "rig":
        return rig_shortfalls([one.readback.full() for one in observations])
    assert setup.cameras is not None  # `Setup` sees to it
    try:
        places = board_places(observations, setup.cameras, setup.board).poses
    except CalibrationError as error:
        return (str(error),)
    return _draft(setup, [one for one in observations if one.id in places], places).shortfalls()


@dataclass(frozen=True, slots=True, eq=False)
class _Answer:
    solution: Solution
    predicted: dict[str, RigidTransform]  # observation -> camera_from_board where the solution puts it


Poses = Mapping[str, BoardPose]
_Solver = Callable[[Setup, Sequence[Observation], Poses, Progress], _Answer]


def _without_outliers(setup: Setup, kept: list[Observation], poses: Poses, progress: Progress) -> tuple[_Answer, dict[str, str]]:
    """Solve, and leave out one observation after the other that lies far off, the farthest first."""
    solver, least = _SOLVERS[setup.kind]
    if setup.kind == "rig":
        answer = solver(setup, kept, poses, progress)
        assert isinstance(answer.solution, RigSolution)
        return answer, dict(answer.solution.rejected)  # leaves out what contradicts the others by itself
    marks, by_id = setup.board.corners_mm, {one.id: one for one in kept}

    def solve(names: Sequence[str]) -> tuple[_Answer, dict[str, FloatArray]]:
        answer = solver(setup, [by_id[name] for name in names], poses, progress)
        return answer, {name: place.apply(marks) for name, place in answer.predicted.items()}

    seen = {name: poses[name].camera_from_board.apply(marks) for name in by_id}
    return without_moved(list(by_id), solve, seen, least)


def _axis(setup: Setup, kept: Sequence[Observation], poses: Poses, progress: Progress) -> _Answer:
    angles = [one.readback.table_rad for one in kept]
    names = [one.id for one in kept]
    solution = solve_axis(problem_from_poses([poses[name] for name in names], setup.board, angles, names=names), progress)
    best = solution.best
    motions = np.array([best.axis.turned(float(angle)).matrix for angle in best.angles_rad])
    first = mean_pose(inverted(motions) @ np.array([poses[one.id].camera_from_board.matrix for one in kept]))
    return _Answer(solution, _named(kept, motions @ first))


def _hand_eye(setup: Setup, kept: Sequence[Observation], poses: Poses, progress: Progress) -> _Answer:
    flanges = _flanges(kept)
    solution = solve_hand_eye(HandEyeProblem(flanges, tuple(poses[one.id] for one in kept), setup.noise), progress)
    return _Answer(solution, _named(kept, hand_eye_places(solution, stacked(flanges))))


def _guide(setup: Setup, kept: Sequence[Observation], poses: Poses, progress: Progress) -> _Answer:
    assert setup.hand_eye is not None  # `Setup` sees to it
    seen = [
        GuideObservation(flange, float(one.readback.guide_mm or 0.0), poses[one.id].camera_from_board)
        for one, flange in zip(kept, _flanges(kept), strict=True)
    ]
    progress.report(0, 1, "straight line of the guide")
    found = solve_guide(GuideProblem(tuple(seen), setup.hand_eye))
    solution = replace(found, guide=guide_carried(found.guide, setup.hand_eye, setup.noise))
    return _Answer(solution, _named(kept, guide_places(solution.guide, setup.hand_eye, seen)))


def _rig(setup: Setup, kept: Sequence[Observation], poses: Poses, progress: Progress) -> _Answer:
    assert setup.cameras is not None  # only then this way is taken
    sightings = [RigObservation(one.id, one.readback.full(), poses[one.id], approach=one.approach) for one in kept]
    solution = solve_rig(sightings, setup.cameras, noise=setup.noise, progress=progress)
    return _Answer(solution, _rig_places(solution))


_SOLVERS: Mapping[str, tuple[_Solver, int]] = {
    "axis": (_axis, LEAST_TABLE_POSITIONS),
    "hand-eye": (_hand_eye, LEAST_POSES),
    "guide": (_guide, LEAST_SLIDE_POSITIONS),
    "rig": (_rig, 0),
}
"""How each kind is solved, and from how many observations at least."""


def _flanges(kept: Sequence[Observation]) -> tuple[RigidTransform, ...]:
    return tuple(one.readback.base_from_flange for one in kept if one.readback.base_from_flange is not None)


def _named(kept: Sequence[Observation], poses: FloatArray) -> dict[str, RigidTransform]:
    return {one.id: RigidTransform(orthonormalise(pose), "camera", "board") for one, pose in zip(kept, poses, strict=True)}


def _rig_places(rig: RigSolution) -> dict[str, RigidTransform]:
    names = [residual.name for residual in rig.residuals]
    poses = rig.chain.predicted(rig.state)
    return {name: RigidTransform(orthonormalise(pose), "camera", "board") for name, pose in zip(names, poses, strict=True)}


def _draft(setup: Setup, kept: Sequence[Observation], poses: Poses) -> AxisDraft | HandEyeDraft | GuideDraft:
    if setup.kind == "axis":
        axis = AxisDraft(setup.board)
        for one in kept:
            axis.add(poses[one.id], one.readback.table_rad)
        return axis
    if setup.kind == "hand-eye":
        hand_eye = HandEyeDraft(setup.noise)
        for one, flange in zip(kept, _flanges(kept), strict=True):
            hand_eye.add(flange, poses[one.id])
        return hand_eye
    assert setup.hand_eye is not None  # `Setup` sees to it
    guide = GuideDraft(setup.hand_eye)
    for one, flange in zip(kept, _flanges(kept), strict=True):
        guide.add(GuideObservation(flange, float(one.readback.guide_mm or 0.0), poses[one.id].camera_from_board))
    return guide


def _with_residuals(solved: Solved, observations: Sequence[Observation], predicted: Mapping[str, RigidTransform]) -> Solved:
    by_id = {one.id: one for one in observations}
    return replace(
        solved,
        residuals_px={name: misfit_px(place, by_id[name], solved.cameras, solved.board) for name, place in predicted.items()},
        residuals_mm={name: misfit_mm(place, solved.places[name], solved.board) for name, place in predicted.items()},
    )
