"""The whole rig at once: hand-eye, guide and axis from all sightings of one board fixed on the table."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.board_pose import BoardPose
from measureapp.calibrate.chain import AxisNoise, Chain, ChainState, Free, groups_of, poses_of, roots_of
from measureapp.calibrate.least_squares import Minimum
from measureapp.calibrate.poses import change_between, moved
from measureapp.calibrate.rig import RigStages, stages_of
from measureapp.data.calibration import CameraArrayCalibration, HandEye, LinearGuide, Provenance, RigCalibration, RobotStation, RotationAxis
from measureapp.data.fringe import AxisReadback
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import RigidTransform, orthonormalised
from measureapp.progress import NoProgress, Progress

LEAST_OBSERVATIONS = 6
LEAST_STROKE_MM = 10.0
LEAST_SWEEP_RAD = np.deg2rad(2.0)
SAME_POSE = 1e-4  # robot poses closer than this (mm, rotation matrix) are one pose with one error
SAME_ANGLE_RAD = 1e-7
LEAST_SLIDES = 3
OUTLIER_FACTOR = 6.0  # of the median misfit
MOST_REJECTED = 0.25
REJECTED = "the board was seen far from where all other sightings put it: it moved, or was found wrongly"


@dataclass(frozen=True, slots=True, eq=False)
class RigObservation:
    """One sighting of the board with the read-back of every axis."""

    name: str
    readback: AxisReadback
    board: BoardPose


@dataclass(frozen=True, slots=True, eq=False)
class RigResidual:
    """How far the board was seen from where the chain puts it."""

    name: str
    distance_mm: float
    angle_deg: float
    robot_error_mm: float  # estimated error of the robot's pose
    robot_error_deg: float


@dataclass(frozen=True, slots=True, eq=False)
class RigSolution:
    """The calibrated rig, what the observations left unexplained, and what they could not show."""

    calibration: RigCalibration
    stages: RigStages  # the solution stage by stage, which the joint one started from
    residuals: tuple[RigResidual, ...]
    rejected: dict[str, str]  # observation -> reason
    standard_deviations: dict[str, float]
    parameters: tuple[str, ...]  # rows of `covariance`
    covariance: FloatArray
    sigma_ratio: float  # residuals over what was expected; about 1 where the stated noise is right
    guide_from_board: RigidTransform  # the board's place with the table at 0
    not_observable: tuple[str, ...] = field(default=())


class RigDraft:
    """Collects sightings of the board until they determine the rig."""

    def __init__(self, cameras: CameraArrayCalibration, noise: AxisNoise | None = None) -> None:
        self._cameras = cameras
        self._noise = noise or AxisNoise()
        self._observations: list[RigObservation] = []

    def add(self, observation: RigObservation) -> None:
        """Add one sighting."""
        self._observations.append(observation)

    def remove(self, name: str) -> None:
        """Take a sighting out again."""
        self._observations = [observation for observation in self._observations if observation.name != name]

    def shortfalls(self) -> tuple[str, ...]:
        """Say what is still missing."""
        few = LEAST_OBSERVATIONS - len(self._observations)
        missing = [f"{few} more sightings of the board are needed."] if few > 0 else []
        sweep, stroke = _spans(self._observations)
        if sweep < LEAST_SWEEP_RAD:
            missing.append("Turn the table between sightings, so that its axis shows.")
        if stroke < LEAST_STROKE_MM:
            missing.append("Move the guide between sightings, so that its direction shows.")
        return tuple(missing)

    def solve(self, progress: Progress | None = None) -> RigSolution:
        """Solve what was collected."""
        return solve_rig(self._observations, self._cameras, noise=self._noise, progress=progress)


def solve_rig(
    observations: Sequence[RigObservation],
    cameras: CameraArrayCalibration,
    *,
    noise: AxisNoise | None = None,
    progress: Progress | None = None,
) -> RigSolution:
    """Estimate hand-eye transform, guide, axis and the board's place together from all sightings.

    Minimised are the errors of the board poses, weighted by the information of the corners in all cameras, and the
    errors of robot poses and table angles, weighted by ``noise``. Sightings with equal robot poses share one robot error,
    so that turning the table or moving the guide past a robot that stands still shows their axes without it. The start
    is found stage by stage: Tsai-Lenz, guide line, weighted axis.

    Parameters
    ----------
    observations : sightings of one board that is fixed on the table

    Raises
    ------
    CalibrationError
        Too few sightings, parallel robot motions, or a table that did not turn.
    """
    progress = progress or NoProgress()
    noise = noise or AxisNoise()
    sweep, stroke = _spans(observations)
    if len(observations) < LEAST_OBSERVATIONS or sweep < LEAST_SWEEP_RAD:
        raise CalibrationError(
            f"{len(observations)} sightings of the board over {np.rad2deg(sweep):.1f}° of the table do not determine the rig.",
            f"Give at least {LEAST_OBSERVATIONS} with different robot poses, and turn the table by 60° or more.",
        )
    free_guide = stroke >= LEAST_STROKE_MM
    stages = stages_of(observations, free_guide)
    kept = list(observations)
    rejected: dict[str, str] = {}
    while True:
        progress.report(len(rejected), len(observations), "joint solution of the rig")
        chain = _chain(kept, noise, Free(guide=free_guide))
        minimum = chain.adjusted(_start(stages, chain))
        outlier = _worst_outlier(chain, minimum.state)
        if outlier is None:
            break
        rejected[kept.pop(outlier).name] = REJECTED
        if len(rejected) > MOST_REJECTED * len(observations) or len(kept) < LEAST_OBSERVATIONS or _spans(kept)[0] < LEAST_SWEEP_RAD:
            raise CalibrationError(
                "Too many sightings of the board contradict each other: " + ", ".join(rejected) + ".",
                "Check that the board is fixed on the table, and that tables and images are in the same order.",
            )
    progress.report(1, 1)
    return _solution(chain, minimum, kept, cameras, stages, rejected, () if free_guide else (_UNSEEN_GUIDE,))


_UNSEEN_GUIDE = "direction and scale of the guide: it hardly moved, +Y and 1 are assumed"


def _spans(observations: Sequence[RigObservation]) -> tuple[float, float]:
    if not observations:
        return 0.0, 0.0
    readbacks = [observation.readback for observation in observations]
    return float(np.ptp([one.table_rad for one in readbacks])), float(np.ptp([one.guide_mm for one in readbacks]))


def _chain(observations: Sequence[RigObservation], noise: AxisNoise, free: Free) -> Chain:
    robot = np.array([observation.readback.base_from_flange.matrix for observation in observations])
    table = np.array([observation.readback.table_rad for observation in observations])
    boards = [observation.board for observation in observations]
    return Chain(
        base_from_flange=robot,
        guide_mm=np.array([observation.readback.guide_mm for observation in observations]),
        table_rad=table,
        camera_from_board=poses_of(boards),
        roots=roots_of(boards),
        robot_group=groups_of(robot[:, :3].reshape(-1, 12), SAME_POSE),
        table_group=groups_of(table[:, None], SAME_ANGLE_RAD),
        noise=noise,
        free=free,
    )


def _start(stages: RigStages, chain: Chain) -> ChainState:
    return ChainState(
        flange_from_camera=np.asarray(stages.hand_eye.flange_from_camera.matrix),
        guide_direction=np.asarray(stages.guide.direction),
        guide_scale=stages.guide.scale,
        axis_point_mm=np.asarray(stages.axis.point_mm),
        axis_direction=np.asarray(stages.axis.direction),
        guide_from_board=np.asarray(stages.guide_from_board.matrix),
        robot_changes=np.zeros((chain.robot_poses, 6)),
        table_changes=np.zeros(chain.table_angles),
    )


def _worst_outlier(chain: Chain, state: ChainState) -> int | None:
    """Return the sighting that lies farthest off, where it is far beyond the median; one at a time, since it draws others along."""
    count = len(chain.guide_mm)
    misfit = np.linalg.norm(chain.residuals(state)[: 6 * count].reshape(count, 6), axis=1)
    worst = int(np.argmax(misfit))
    return worst if misfit[worst] > OUTLIER_FACTOR * max(float(np.median(misfit)), np.sqrt(6.0)) else None


def _solution(
    chain: Chain,
    minimum: Minimum[ChainState],
    observations: Sequence[RigObservation],
    cameras: CameraArrayCalibration,
    stages: RigStages,
    rejected: dict[str, str],
    unseen: tuple[str, ...],
) -> RigSolution:
    state = minimum.state
    ratio = float(np.sqrt(minimum.cost / max(chain.freedom(), 1)))
    count = len(chain.labels)
    covariance = minimum.covariance(max(ratio, 1.0) ** 2)[:count, :count]
    deviations = dict(zip(chain.labels, (float(value) for value in np.sqrt(np.diag(covariance))), strict=True))
    change = change_between(chain.camera_from_board, chain.predicted(state))
    distances, angles = np.linalg.norm(change[:, 3:], axis=1), np.linalg.norm(change[:, :3], axis=1)
    robot = state.robot_changes[chain.robot_group]
    residuals = tuple(
        RigResidual(
            observation.name,
            float(distance),
            float(np.rad2deg(angle)),
            float(np.linalg.norm(error[3:])),
            float(np.rad2deg(np.linalg.norm(error[:3]))),
        )
        for observation, distance, angle, error in zip(observations, distances, angles, robot, strict=True)
    )
    hand_eye = HandEye(
        RigidTransform(orthonormalised(state.flange_from_camera), "flange", "camera"),
        rotation_sigma_rad=_largest(deviations, "hand_eye.rotation"),
        translation_sigma_mm=_largest(deviations, "hand_eye.x_mm", "hand_eye.y_mm", "hand_eye.z_mm"),
        residual_mm=float(np.sqrt(np.mean(distances**2))),
        residual_rad=float(np.sqrt(np.mean(angles**2))),
        method="joint calibration of the rig",
    )
    return RigSolution(
        calibration=RigCalibration(
            cameras,
            hand_eye,
            _guide(state, deviations, _straightness(chain, distances)),
            _axis(state, deviations, covariance, chain.labels, distances),
            Provenance(method="joint calibration of the rig"),
            _stations(chain, state),
        ),
        stages=stages,
        residuals=residuals,
        rejected=rejected,
        standard_deviations=deviations,
        parameters=chain.labels,
        covariance=covariance,
        sigma_ratio=ratio,
        guide_from_board=RigidTransform(orthonormalised(state.guide_from_board), "guide", "board"),
        not_observable=unseen,
    )


def _stations(chain: Chain, state: ChainState) -> tuple[RobotStation, ...]:
    """Return every robot pose with its estimated error."""
    firsts = [int(np.flatnonzero(chain.robot_group == number)[0]) for number in range(chain.robot_poses)]
    errors = moved(np.tile(np.eye(4), (chain.robot_poses, 1, 1)), state.robot_changes)
    return tuple(
        RobotStation(
            RigidTransform(chain.base_from_flange[first], "base", "flange"),
            RigidTransform(orthonormalised(chain.base_from_flange[first] @ error), "base", "flange"),
        )
        for first, error in zip(firsts, errors, strict=True)
    )


def _straightness(chain: Chain, distances_mm: FloatArray) -> float:
    """Return the rms distance from the straight line over slides with one robot pose, where its error cannot enter; 0 without such."""
    slid = [
        distances_mm[chain.robot_group == number]
        for number in range(chain.robot_poses)
        if len(np.unique(chain.guide_mm[chain.robot_group == number])) >= LEAST_SLIDES
    ]
    return float(np.sqrt(np.mean(np.concatenate(slid) ** 2))) if slid else 0.0


def _largest(deviations: dict[str, float], *starts: str) -> float:
    return max((value for name, value in deviations.items() if name.startswith(starts)), default=0.0)


def _guide(state: ChainState, deviations: dict[str, float], straightness_mm: float) -> LinearGuide:
    return LinearGuide(
        state.guide_direction,
        state.guide_scale,
        direction_sigma_rad=_largest(deviations, "guide.direction"),
        scale_sigma=_largest(deviations, "guide.scale"),
        straightness_mm=straightness_mm,
    )


def _axis(
    state: ChainState, deviations: dict[str, float], covariance: FloatArray, labels: tuple[str, ...], distances: FloatArray
) -> RotationAxis:
    """Return the axis with its point beside the board, where its place is best known."""
    along = float(state.axis_direction @ (state.guide_from_board[:3, 3] - state.axis_point_mm))
    rows = [labels.index(f"axis.{name}") for name in ("direction_1_rad", "direction_2_rad", "point_1_mm", "point_2_mm")]
    carry = np.hstack([along * np.eye(2), np.eye(2)])
    point_covariance = carry @ covariance[np.ix_(rows, rows)] @ carry.T
    return RotationAxis(
        state.axis_point_mm + along * state.axis_direction,
        state.axis_direction,
        "guide",
        point_sigma_mm=float(np.sqrt(np.linalg.eigvalsh(point_covariance)[-1])),
        direction_sigma_rad=_largest(deviations, "axis.direction"),
        residual_mm=float(np.sqrt(np.mean(distances**2))),
    )
