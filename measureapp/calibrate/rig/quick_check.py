"""Quick check of a calibrated rig with a few views of a board anywhere on the table: deviation per view and the suspect link."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.boards.observation import Observation
from measureapp.calibrate.boards.pose import stated_pose
from measureapp.calibrate.motions.axis_noise import AxisNoise
from measureapp.calibrate.motions.chain import Chain, Free, roots_of
from measureapp.calibrate.motions.chain_state import ChainState
from measureapp.calibrate.poses import invert_poses, median_pose, stack_matrices
from measureapp.data.board import BoardDescription
from measureapp.data.calibration import RigCalibration
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import RigidTransform

LEAST_VIEWS = 3
CAMERA_FACTOR = 3.0  # of the rms residual that the calibration of the cameras left
LEAST_CAMERA_PX = 0.15
BOARD_MM, BOARD_RAD = 0.05, float(np.deg2rad(0.01))
STIFF = AxisNoise(robot_mm=1e-3, robot_rad=2e-6, table_rad=1e-7)  # a link that is off must show in the views, not in the robot's errors
LINKS = {"hand-eye or robot": Free(True, False, False), "guide": Free(False, True, False), "axis": Free(False, False, True)}
LEAST_EXPLAINED = 0.6  # of the mean square deviation
LEAST_TURN_RAD, LEAST_TRAVEL_MM, LEAST_TILT_RAD = np.deg2rad(5.0), 20.0, np.deg2rad(5.0)
CAMERAS, ONE_VIEW, UNCLEAR = "cameras", "one view", "more than one link"


@dataclass(frozen=True, slots=True)
class ViewCheck:
    """Deviation of one view of the board from its predicted pose."""

    name: str
    deviation_mm: float  # rms over the corners, on the part
    deviation_px: float  # the same in the image of the reference camera
    camera_px: float  # rms residual of the board's pose: contradiction between the cameras


@dataclass(frozen=True, slots=True, eq=False)
class QuickCheck:
    """The verdict, and the suspect link of the chain."""

    good: bool
    sentence: str
    views: tuple[ViewCheck, ...]
    limit_mm: float
    suspect: str  # "" where the calibration holds
    explained: Mapping[str, float]  # link -> fraction of the mean square deviation explained by freeing it alone
    not_tested: tuple[str, ...]


def quick_check(
    observations: Sequence[Observation], calibration: RigCalibration, board: BoardDescription, *, limit_mm: float = 0.5
) -> QuickCheck:
    """Compare a few sightings of a board fixed on the table with the calibrated chain.

    The board may stand anywhere: its place is the middle of those that the views give. Only what makes the views contradict each
    other shows, so that they should differ in every axis. A deviation beyond the limit is laid to the link whose freedom alone
    explains most of it; cameras that contradict each other come first, since they spoil every other link.

    Raises
    ------
    CalibrationError
        Fewer than three views.
    """
    if len(observations) < LEAST_VIEWS:
        raise CalibrationError(
            f"{len(observations)} views of the board do not check a calibration.",
            f"Give at least {LEAST_VIEWS}, with different poses of the robot, slide positions and table angles.",
        )
    places = stack_matrices(calibration.part_from_camera(one.axes) @ one.pose.camera_from_board for one in observations)
    middle = median_pose(places)
    views = tuple(_view(one, place, middle, calibration, board) for one, place in zip(observations, places, strict=True))
    not_tested = _not_tested(observations)
    worst = max(views, key=lambda view: view.deviation_mm)
    allowed_px = max(CAMERA_FACTOR * _camera_rms(calibration), LEAST_CAMERA_PX)
    camera_px = float(np.median([view.camera_px for view in views]))
    good = worst.deviation_mm <= limit_mm and camera_px <= allowed_px
    explained = {} if good else _explained_fractions(observations, calibration, middle, not_tested)
    suspect = "" if good else CAMERAS if camera_px > allowed_px else _suspect(views, explained, limit_mm)
    sentence = (
        f"The board lies up to {worst.deviation_mm:.3f} mm (view {worst.name}) from its calibrated position; "
        f"{limit_mm:g} mm are allowed: " + _advice(suspect, worst, camera_px, allowed_px)
    )
    return QuickCheck(good, sentence, views, limit_mm, suspect, explained, not_tested)


def _view(one: Observation, place: FloatArray, middle: FloatArray, calibration: RigCalibration, board: BoardDescription) -> ViewCheck:
    corners = np.column_stack([board.corners_mm, np.ones(len(board.corners_mm))])
    off = (corners @ (place - middle).T)[:, :3]
    predicted = invert_poses(calibration.part_from_camera(one.axes).matrix) @ middle
    reference = calibration.cameras.cameras[calibration.cameras.reference].pinhole
    seen, expected = (reference.project((corners @ pose.T)[:, :3]) for pose in (one.pose.camera_from_board.matrix, predicted))
    return ViewCheck(
        one.id,
        float(np.sqrt(np.mean(np.sum(off**2, axis=1)))),
        float(np.sqrt(np.mean(np.sum((seen - expected) ** 2, axis=1)))),
        one.pose.rms_px,
    )


def _camera_rms(calibration: RigCalibration) -> float:
    return float(np.mean([camera.rms_px for camera in calibration.cameras.cameras.values()]))


def _not_tested(observations: Sequence[Observation]) -> tuple[str, ...]:
    """Return the links that the views do not test, because their axis did not move."""
    reads = [one.axes for one in observations]
    first = reads[0].base_from_flange.inverse()
    tilt = max((first @ read.base_from_flange).angle_rad for read in reads)
    still = {
        "hand-eye or robot": tilt < LEAST_TILT_RAD,
        "guide": np.ptp([read.guide_mm for read in reads]) < LEAST_TRAVEL_MM,
        "axis": np.ptp([read.table_rad for read in reads]) < LEAST_TURN_RAD,
    }
    return tuple(link for link, unmoved in still.items() if unmoved)


def _explained_fractions(
    observations: Sequence[Observation], calibration: RigCalibration, part_from_board: FloatArray, not_tested: Sequence[str]
) -> dict[str, float]:
    """Return the fraction of the mean square deviation that each link, freed alone, explains."""
    start = _state(calibration, part_from_board, len(observations))
    before = _misfit(observations, calibration, Free(False, False, False), start)
    return {
        link: max(0.0, 1.0 - _misfit(observations, calibration, free, start) / max(before, 1e-300))
        for link, free in LINKS.items()
        if link not in not_tested
    }


def _misfit(observations: Sequence[Observation], calibration: RigCalibration, free: Free, start: ChainState) -> float:
    """Return the sum of squares left with ``free`` links, per degree of freedom."""
    count = len(observations)
    poses = [stated_pose(one.pose.camera_from_board, BOARD_RAD, BOARD_MM) for one in observations]
    chain = Chain(
        base_from_flange=stack_matrices(_flange(one, calibration) for one in observations),
        guide_mm=np.array([one.axes.guide_mm for one in observations]),
        table_rad=np.array([one.axes.table_rad for one in observations]),
        camera_from_board=stack_matrices(pose.camera_from_board for pose in poses),
        roots=roots_of(poses),
        robot_group=np.arange(count),
        table_group=np.arange(count),
        noise=STIFF,
        free=free,
    )
    return chain.adjust(replace(start, table_changes=np.zeros(chain.table_angles))).cost / max(chain.freedom(), 1)


def _flange(one: Observation, calibration: RigCalibration) -> RigidTransform:
    """Return where the flange truly stands before the table, the error motions of both axes included."""
    station = calibration.station(one.axes)
    flange = one.axes.base_from_flange if station is None else station.true
    if calibration.motions is None:
        return flange
    guide_from_base = calibration.guide.guide_from_base(one.axes.guide_mm)
    lift = guide_from_base.inverse() @ calibration.motions.table_motion(one.axes.table_rad).inverse() @ guide_from_base
    return lift @ calibration.motions.guide_motion(one.axes.guide_mm) @ flange


def _state(calibration: RigCalibration, part_from_board: FloatArray, count: int) -> ChainState:
    guide_from_board = calibration.table_from_guide.inverse().matrix @ part_from_board
    return ChainState.unchanged(calibration.hand_eye, calibration.guide, calibration.axis, guide_from_board, count)


def _suspect(views: Sequence[ViewCheck], explained: Mapping[str, float], limit_mm: float) -> str:
    if sum(view.deviation_mm > limit_mm for view in views) == 1 and len(views) > LEAST_VIEWS:
        return ONE_VIEW
    likely = max(explained, key=lambda link: explained[link], default="")
    return likely if likely and explained[likely] >= LEAST_EXPLAINED else UNCLEAR


def _advice(suspect: str, worst: ViewCheck, camera_px: float, allowed_px: float) -> str:
    return {
        "": "the calibration holds.",
        CAMERAS: f"the cameras contradict each other by {camera_px:.2f} px ({allowed_px:.2f} px allowed); calibrate the cameras again.",
        ONE_VIEW: f"only view {worst.name} is off; the board or the robot moved there, take it again.",
        UNCLEAR: "no single link explains it; calibrate the whole rig again, and check that the board is fixed on the table.",
        "hand-eye or robot": "the hand-eye transform or the robot looks off (head knocked, robot's zero lost); calibrate hand-eye again.",
        "guide": "the guide looks off; check its reference point and calibrate it again.",
        "axis": "the rotation axis looks off; check that the table did not move and calibrate the axis again.",
    }[suspect]
