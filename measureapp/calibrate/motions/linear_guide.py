"""Linear guide: direction in the base frame and scale, by a straight-line fit to observations of a fixed board."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from measureapp.arrays import FloatArray
from measureapp.calibrate.boards.observation import Observation, camera_jacobians_of, flanges_of, slides_of
from measureapp.calibrate.motions.chain import poses_of
from measureapp.data.calibration import HandEye, LabelledCovariance, LinearGuide
from measureapp.errors import CalibrationError

LEAST_POSITIONS = 3
SHORTEST_STROKE_MM = 10.0
ADVISED_STROKE_MM = 100.0
LARGEST_RESIDUAL_MM = 0.2  # of a good guide
LARGEST_SKEW_DEG = 10.0  # guides are mounted along an axis of the base
LARGEST_TURN_RAD = np.deg2rad(1.0)
PAPER_DIRECTION = np.array([0.0, 1.0, 0.0])
SCALE_RANGE = (0.5, 2.0)
SCALE_TOLERANCE = 0.01  # scale errors of guides are some 1e-4


@dataclass(frozen=True, slots=True, eq=False)
class GuideProblem:
    """Observations of a stationary board from several guide positions, with the hand-eye transform."""

    observations: tuple[Observation, ...]  # with pose, robot pose and guide position
    hand_eye: HandEye
    camera_prior: LabelledCovariance | None = None  # covariance of the camera parameters


@dataclass(frozen=True, slots=True, eq=False)
class GuideSolution:
    """Direction and scale, with the residuals."""

    guide: LinearGuide
    straightness_mm: FloatArray  # (N,), distance of the slide from its straight line
    along_mm: FloatArray  # (N,), signed error of the position along it
    turn_rad: FloatArray  # (N,), apparent turn of the board against its mean: pitch, yaw and roll of the slide
    stroke_mm: float
    paper_mm: FloatArray  # (N,), error against the first position had pure +Y and scale 1 been assumed
    paper_cost_mm: float  # error at the end of the stroke had pure +Y and scale 1 been assumed
    warnings: tuple[str, ...] = ()


def shortfalls(observations: Sequence[Observation]) -> tuple[str, ...]:
    """Say what observations of a stationary board still lack to determine the guide well."""
    missing = []
    if len(observations) < LEAST_POSITIONS:
        missing.append(f"{LEAST_POSITIONS - len(observations)} more guide positions are needed.")
    stroke = _stroke(observations)
    if stroke < ADVISED_STROKE_MM:
        missing.append(f"The positions span {stroke:.0f} mm; {ADVISED_STROKE_MM:.0f} mm or more give a better direction.")
    return tuple(missing)


def solve(problem: GuideProblem) -> GuideSolution:
    """Fit the straight line of the robot's travel past a fixed board.

    The board's place in the base frame, b_i = base_from_flange_i · X · camera_from_board_i, moves by -scale · direction
    per displayed millimetre; direction and scale follow by linear least squares over all positions.

    Raises
    ------
    CalibrationError
        Fewer than three positions, a stroke that is too short, positions in another unit, or a board that turned.
    """
    count, stroke = len(problem.observations), _stroke(problem.observations)
    if count < LEAST_POSITIONS or stroke < SHORTEST_STROKE_MM:
        raise CalibrationError(
            f"{count} slide positions over {stroke:.1f} mm do not determine the guide.",
            f"Give at least {LEAST_POSITIONS} positions over {ADVISED_STROKE_MM:.0f} mm or more.",
        )
    robot = flanges_of(problem.observations)
    camera = poses_of([observation.pose for observation in problem.observations])
    boards = robot @ problem.hand_eye.flange_from_camera.matrix @ camera
    slide = slides_of(problem.observations)
    turn = _turns(boards)
    return _fit(boards[:, :3, 3], slide, turn, stroke, _by_cameras(problem, robot, slide))


def _by_cameras(problem: GuideProblem, robot: FloatArray, slide: FloatArray) -> FloatArray:
    """Return the covariance (3, 3) of the travel per displayed millimetre that the cameras' own uncertainty adds."""
    camera_jacobian = camera_jacobians_of(problem.observations)
    if camera_jacobian is None or problem.camera_prior is None:
        return np.zeros((3, 3))
    turned = robot[:, :3, :3] @ problem.hand_eye.flange_from_camera.rotation @ camera_jacobian[:, 3:]  # (N, 3, C)
    away = slide - slide.mean()
    travel = -np.tensordot(away, turned, 1) / float(away @ away)
    return np.asarray(travel @ problem.camera_prior.covariance @ travel.T)


def _fit(boards_mm: FloatArray, slide: FloatArray, turn: FloatArray, stroke: float, camera_jacobian: FloatArray) -> GuideSolution:
    away = slide - slide.mean()
    travel = -(away @ (boards_mm - boards_mm.mean(axis=0))) / float(away @ away)
    scale = float(np.linalg.norm(travel))
    if not SCALE_RANGE[0] < scale < SCALE_RANGE[1]:
        raise CalibrationError(
            f"The robot moved {scale:.4g} mm per displayed millimetre of the guide.",
            "Check that guide positions and poses are in mm, in the same order, and that the board did not move.",
        )
    direction = travel / scale
    residual = boards_mm - boards_mm.mean(axis=0) + away[:, None] * travel
    along = -residual @ direction
    aside = np.linalg.norm(residual + along[:, None] * direction, axis=1)
    freedom = 3 * len(slide) - 6
    sigma = float(np.sqrt(np.sum(residual**2) / freedom / float(away @ away)))
    across = np.eye(3) - np.outer(direction, direction)
    turned = float(np.linalg.eigvalsh(across @ camera_jacobian @ across)[-1])  # variance of the direction in which it is least certain
    stretched = float(direction @ camera_jacobian @ direction)
    guide = LinearGuide(
        direction,
        scale,
        float(np.sqrt(sigma**2 + turned)) / scale,
        float(np.sqrt(sigma**2 + stretched)),
        float(np.sqrt(np.mean(aside**2))),
    )
    warnings = [] if stroke >= ADVISED_STROKE_MM else [f"The positions span only {stroke:.0f} mm: spread them over more of the stroke."]
    if turn.max() > LARGEST_TURN_RAD:
        warnings.append(
            f"The board seems to turn by up to {np.rad2deg(turn.max()):.2f}°: it moved, or the hand-eye transform is wrong. Take the positions again."
        )
    off = float(np.sqrt(np.mean(aside**2 + along**2)))
    if off > LARGEST_RESIDUAL_MM:
        warnings.append(
            f"The positions lie {off:.2f} mm off an even, straight travel: fix the board and take them again, or check the guide."
        )
    if np.rad2deg(np.arccos(np.abs(direction).max())) > LARGEST_SKEW_DEG:
        warnings.append(
            f"The guide runs {np.rad2deg(np.arccos(np.abs(direction).max())):.0f}° away from every axis of the robot's base: check that the robot poses are "
            "base_from_flange, not flange_from_base, and that the hand-eye transform is the one of these cameras."
        )
    if abs(scale - 1) > SCALE_TOLERANCE:
        warnings.append(
            f"The robot moved {scale:.3f} mm per displayed millimetre of the guide: check the stated size of the board's squares."
        )
    paper = paper_error_mm(direction, scale) * np.abs(slide - slide[0])
    return GuideSolution(guide, aside, along, turn, stroke, paper, paper_error_mm(direction, scale) * stroke, tuple(warnings))


def paper_error_mm(direction: FloatArray, scale: float) -> float:
    """Return the error per mm of travel if the guide is assumed to run along +Y with scale 1, as in the paper."""
    return float(np.linalg.norm(scale * direction - PAPER_DIRECTION))


def _stroke(observations: Sequence[Observation]) -> float:
    return float(np.ptp(slides_of(observations))) if observations else 0.0


def _turns(boards: FloatArray) -> FloatArray:
    rotations = Rotation.from_matrix(boards[:, :3, :3])
    return (rotations.mean().inv() * rotations).magnitude()
