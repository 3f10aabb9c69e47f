"""Joint calibration of the rig: hand-eye, guide and axis from all sightings of one board fixed on the table."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.calibrate.boards.observation import Observation, camera_jacobians_of
from measureapp.calibrate.motions.axis_noise import SAME_POSE, AxisNoise, number_runs
from measureapp.calibrate.motions.chain import Chain, Free, groups_of, poses_of, roots_of
from measureapp.calibrate.motions.chain_state import ChainState
from measureapp.calibrate.motions.error_motions import motion_model
from measureapp.calibrate.motions.slide_noise import add_place_covariance, slide_covariance, travel_in_camera
from measureapp.calibrate.rig.joint_solution import RigSolution, solution_of
from measureapp.calibrate.rig.motion_scales import refine_motions
from measureapp.calibrate.rig.stages import RigStages, solve_stages
from measureapp.data.calibration import CameraArrayCalibration, LabelledCovariance
from measureapp.data.fringe import AxisReadback
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import RigidTransform
from measureapp.progress import NoProgress, Progress

LEAST_OBSERVATIONS = 6
LEAST_STROKE_MM = 10.0
LEAST_SWEEP_RAD = np.deg2rad(2.0)
SAME_ANGLE_RAD = 1e-7
OUTLIER_FACTOR = 6.0  # of the median misfit
MOST_REJECTED = 0.25
REJECTED = "the board pose contradicts all other observations: the board moved or was detected wrongly"


def number_approaches(poses: Sequence[RigidTransform]) -> tuple[int, ...]:
    """Number the approaches of the robot to poses base_from_flange in the order it went to them.

    To be told with every sighting where places are left out from which the board was not seen: a robot that went there and came back has
    Given with every sighting where positions without a detected board are missing: a robot that returns from there has another error.
    """
    if not poses:
        return ()
    matrices = np.array([pose.matrix for pose in poses])
    return tuple(int(number) for number in number_runs(groups_of(matrices[:, :3].reshape(-1, 12), SAME_POSE)))


def shortfalls(readbacks: Sequence[AxisReadback]) -> tuple[str, ...]:
    """Say what sightings with these read-backs still miss to determine the rig."""
    few = LEAST_OBSERVATIONS - len(readbacks)
    missing = [f"{few} more observations of the board are needed."] if few > 0 else []
    sweep, stroke = _spans(readbacks)
    if sweep < LEAST_SWEEP_RAD:
        missing.append("Turn the table between observations to determine its axis.")
    if stroke < LEAST_STROKE_MM:
        missing.append("Move the guide between observations to determine its direction.")
    return tuple(missing)


def solve_rig(
    observations: Sequence[Observation],
    cameras: CameraArrayCalibration,
    *,
    noise: AxisNoise | None = None,
    camera_prior: LabelledCovariance | None = None,
    free_cameras: bool = False,
    progress: Progress | None = None,
) -> RigSolution:
    """Estimate hand-eye transform, guide, axis and the board's place together from all sightings.

    Minimised are the errors of the board poses, weighted by the information of the corners in all cameras, and the
    errors of robot poses and table angles, weighted by ``noise``, and the error motions of table and guide, whose scales
    the sightings refine (decision 37). Neighbouring sightings with equal robot poses share one
    robot error, so that turning the table or moving the guide with a stationary robot determines their axes without it.
    The start is found stage by stage: Tsai-Lenz, guide line, weighted axis.

    Parameters
    ----------
    observations : sightings of one board that is fixed on the table, in the order they were taken
    camera_prior : covariance of the camera parameters; propagated to the covariance
    free_cameras : estimate the parameters of the cameras as well, from where ``camera_prior`` has them

    Raises
    ------
    CalibrationError
        Too few sightings, parallel robot motions, or a table that did not turn.
    """
    progress = progress or NoProgress()
    noise = noise or AxisNoise()
    _check_determined(observations, camera_prior)
    free_guide = _spans([observation.axes for observation in observations])[1] >= LEAST_STROKE_MM
    stages = solve_stages(observations, free_guide)
    kept = _number_observations(observations)
    rejected: dict[str, str] = {}
    motions = motion_model(noise, stages.axis, stages.guide_from_board.translation_mm, guide=free_guide)
    while True:
        progress.report(len(rejected), len(observations), "joint solution of the rig")
        chain = replace(_chain(kept, noise, stages, Free(guide=free_guide), camera_prior if free_cameras else None), motions=motions)
        minimum = chain.adjust(_start(stages, chain))
        outlier = _worst_outlier(chain, minimum.state, None if free_cameras else camera_prior)
        if outlier is None:
            break
        rejected[kept.pop(outlier).id] = REJECTED
        if (
            len(rejected) > MOST_REJECTED * len(observations)
            or len(kept) < LEAST_OBSERVATIONS
            or _spans([one.axes for one in kept])[0] < LEAST_SWEEP_RAD
        ):
            raise CalibrationError(
                "Too many observations of the board contradict each other: " + ", ".join(rejected) + ".",
                "Check that the board is fixed on the table, and that tables and images are in the same order.",
            )
    chain, minimum = refine_motions(chain, minimum, None if free_cameras else camera_prior)
    progress.report(1, 1)
    names = [observation.id for observation in kept]
    unseen = () if free_guide else (_UNSEEN_GUIDE,)
    return solution_of(chain, minimum, names, cameras, stages, rejected=rejected, not_seen=unseen, camera_prior=camera_prior)


def _check_determined(observations: Sequence[Observation], camera_prior: LabelledCovariance | None) -> None:
    """Raise CalibrationError for too few sightings, too little of the table, or sightings without the derivatives that a camera prior needs."""
    sweep, _ = _spans([observation.axes for observation in observations])
    if camera_prior is not None and any(observation.camera_jacobian is None for observation in observations):
        raise CalibrationError(
            "The derivatives of the board poses with respect to the cameras are missing.",
            "Give the camera Jacobian of every board pose, or no camera prior.",
        )
    if len(observations) < LEAST_OBSERVATIONS or sweep < LEAST_SWEEP_RAD:
        raise CalibrationError(
            f"{len(observations)} observations of the board over {np.rad2deg(sweep):.1f}° of the table do not determine the rig.",
            f"Give at least {LEAST_OBSERVATIONS} with different robot poses, and turn the table by 60° or more.",
        )


_UNSEEN_GUIDE = "direction and scale of the guide: it hardly moved, +Y and 1 are assumed"


def _spans(readbacks: Sequence[AxisReadback]) -> tuple[float, float]:
    if not readbacks:
        return 0.0, 0.0
    return float(np.ptp([one.table_rad for one in readbacks])), float(np.ptp([one.guide_mm for one in readbacks]))


def _chain(observations: Sequence[Observation], noise: AxisNoise, stages: RigStages, free: Free, freed: LabelledCovariance | None) -> Chain:
    robot = np.array([observation.axes.base_from_flange.matrix for observation in observations])
    table = np.array([observation.axes.table_rad for observation in observations])
    slide = np.array([observation.axes.guide_mm for observation in observations])
    boards = [observation.pose for observation in observations]
    approaches = _approaches(observations, robot, noise)
    travel = travel_in_camera(robot, np.asarray(stages.hand_eye.flange_from_camera.matrix), stages.guide.direction)
    added = slide_covariance(noise, approaches, slide, travel)
    return Chain(
        base_from_flange=robot,
        guide_mm=slide,
        table_rad=table,
        camera_from_board=poses_of(boards),
        roots=add_place_covariance(roots_of(boards), added),
        robot_group=approaches,
        table_group=groups_of(table[:, None], SAME_ANGLE_RAD),
        noise=noise,
        free=free,
        camera_jacobian=camera_jacobians_of(observations),
        camera_covariance=None if freed is None else freed.covariance,
        slide=added,
    )


def _number_observations(observations: Sequence[Observation]) -> list[Observation]:
    """Number the approaches before sightings are rejected, where they are not given."""
    if all(observation.approach is not None for observation in observations):
        return list(observations)
    numbers = number_approaches([observation.axes.base_from_flange for observation in observations])
    return [replace(observation, approach=number) for observation, number in zip(observations, numbers, strict=True)]


def _approaches(observations: Sequence[Observation], robot: FloatArray, noise: AxisNoise) -> IntArray:
    """Return the approach of every sighting, without gaps; a robot that repeats its poses exactly approaches each of them only once."""
    if noise.robot_repeat_mm <= 0:
        return groups_of(robot[:, :3].reshape(-1, 12), SAME_POSE)
    return np.unique([observation.approach or 0 for observation in observations], return_inverse=True)[1].astype(np.intp)


def _start(stages: RigStages, chain: Chain) -> ChainState:
    state = ChainState.unchanged(stages.hand_eye, stages.guide, stages.axis, stages.guide_from_board.matrix, chain.robot_poses)
    table, cameras, motions = (np.zeros(count) for count in (chain.table_angles, chain.cameras_freed, len(chain.motion_rows)))
    return replace(state, table_changes=table, camera_changes=cameras, motions=motions)


def _worst_outlier(chain: Chain, state: ChainState, camera_prior: LabelledCovariance | None) -> int | None:
    """Return the sighting with the largest Mahalanobis distance, if far beyond the median; one at a time, since it biases the others.

    The covariance of the cameras is added to that of the corners: a board observed unlike all others, at the border
    of the images or strongly turned, may be off by many times the latter and is no outlier.
    """
    count = len(chain.guide_mm)
    residuals = chain.residuals(state)[: 6 * count].reshape(count, 6)
    covariance = np.broadcast_to(np.eye(6), (count, 6, 6))
    if camera_prior is not None and chain.camera_jacobian is not None:
        moved = chain.roots @ chain.camera_jacobian
        covariance = covariance + moved @ camera_prior.covariance @ np.swapaxes(moved, 1, 2)
    misfit = np.sqrt(np.einsum("ni,ni->n", residuals, np.linalg.solve(covariance, residuals[..., None])[..., 0]))
    worst = int(np.argmax(misfit))
    return worst if misfit[worst] > OUTLIER_FACTOR * max(float(np.median(misfit)), np.sqrt(6.0)) else None
