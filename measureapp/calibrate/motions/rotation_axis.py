"""The table's rotation axis in the camera's frame: plain and distance-weighted circle fits, and maximum likelihood."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.boards.pose import BoardPose
from measureapp.calibrate.motions.axis_circles import LEAST_POSITIONS, axis_through_centres
from measureapp.calibrate.motions.axis_diagnostics import AxisDiagnostics, diagnose
from measureapp.calibrate.motions.axis_motion import (
    AXIS_PARAMETERS,
    Turning,
    estimate_turning,
    fit_axis_to_corners,
    fit_axis_to_poses,
    perpendicular_basis,
)
from measureapp.calibrate.poses import apply_changes, stack_matrices
from measureapp.data.board import BoardDescription
from measureapp.data.calibration import LabelledCovariance, RotationAxis
from measureapp.errors import CalibrationError
from measureapp.progress import NoProgress, Progress

DRAWS = 40  # simulated repetitions behind the standard deviations of the circle methods
ANGLE_TOLERANCE_RAD = np.deg2rad(2.0)
CLOSURE_RADIUS_MM = 250.0  # radius of the paper's table
SHORT_SWEEP_RAD = np.deg2rad(30.0)
LARGEST_RATIO, LARGEST_RESIDUAL_MM = 3.0, 0.05  # of positions that agree
METHODS = ("least_squares", "distance_weighted", "maximum_likelihood")


@dataclass(frozen=True, slots=True)
class AxisOptions:
    """How an axis is estimated and evaluated."""

    power: float = 2.0  # p of the distance weighting
    free_angles: bool = False  # estimate the angles, even where they were read back
    closure_radius_mm: float = CLOSURE_RADIUS_MM  # at which the closure is stated


@dataclass(frozen=True, slots=True, eq=False)
class AxisProblem:
    """Corners of a board on the table at several table positions, in one frame."""

    corners_mm: FloatArray  # (n, m, 3)
    angles_rad: FloatArray | None = None  # (n,), as read back
    poses: tuple[BoardPose, ...] = ()  # where the corners come from board poses, these with their information
    options: AxisOptions = field(default_factory=AxisOptions)
    frame: str = "camera"
    camera_jacobian: FloatArray | None = None  # (n, 6, C), change of ``poses`` with the parameters of ``camera_prior``
    camera_prior: LabelledCovariance | None = None  # covariance of the camera parameters
    names: tuple[str, ...] = ()  # of the positions, for messages; empty: their numbers from 0

    @property
    def camera_error_modes(self) -> FloatArray:
        """Changes (K, n, 6) of the poses by one standard deviation of each independent error of the cameras."""
        if self.camera_jacobian is None or self.camera_prior is None:
            return np.empty((0, len(self.poses), 6))
        return np.moveaxis(self.camera_jacobian @ self.camera_prior.root, -1, 0)


@dataclass(frozen=True, slots=True, eq=False)
class AxisEstimate:
    """The axis by one method, with the residuals of the corners."""

    axis: RotationAxis
    radial_mm: FloatArray  # (n,), rms per position of distance to the axis minus the corner's mean distance
    axial_mm: FloatArray  # (n,), rms per position of height along the axis minus the corner's mean height
    angles_rad: FloatArray  # (n,) against the first position


@dataclass(frozen=True, slots=True, eq=False)
class AxisSolution:
    """The axis by every method that has an answer."""

    estimates: Mapping[str, AxisEstimate]
    refused: Mapping[str, str]  # method -> reason
    sweep_rad: float
    power: float
    covariance: FloatArray  # (4, 4) of maximum likelihood: direction (2, rad) and point (2, mm) across the axis
    diagnostics: AxisDiagnostics  # of the axis of maximum likelihood
    warnings: tuple[str, ...] = ()

    @property
    def best(self) -> AxisEstimate:
        """The estimate of maximum likelihood."""
        return self.estimates["maximum_likelihood"]


def shortfalls(problem: AxisProblem) -> tuple[str, ...]:
    """Say what a problem still lacks to determine the rotation axis well."""
    if len(problem.corners_mm) < LEAST_POSITIONS:
        return (f"{LEAST_POSITIONS - len(problem.corners_mm)} more table positions are needed.",)
    try:
        sweep = float(np.ptp(estimate_turning(problem.corners_mm).angles_rad))
    except CalibrationError as error:
        return (str(error),)
    return (f"The table turned by {np.rad2deg(sweep):.0f}°; turn it by 30° or more.",) if sweep < SHORT_SWEEP_RAD else ()


def problem_from_poses(
    poses: Sequence[BoardPose],
    board: BoardDescription,
    angles_rad: Sequence[float | None] = (),
    *,
    options: AxisOptions | None = None,
    names: Sequence[str] = (),
) -> AxisProblem:
    """Return the problem of board poses; angles count only where all of them are known."""
    corners = np.array([pose.camera_from_board.apply(board.corners_mm) for pose in poses]).reshape(len(poses), board.count, 3)
    known = [angle for angle in angles_rad if angle is not None]
    angles = np.array(known) if poses and len(known) == len(poses) else None
    return AxisProblem(corners, angles, tuple(poses), options or AxisOptions(), names=tuple(names))


def solve(problem: AxisProblem, progress: Progress | None = None) -> AxisSolution:
    """Find the axis by circle fits, plain and weighted by distance, and by maximum likelihood.

    The direction is right-handed for growing angles where angles are known, otherwise for growing positions (steps below
    half a turn). Maximum likelihood estimates one axis and one place of the board on the table from all positions; the
    angles are those read back, or free.

    Raises
    ------
    CalibrationError
        Fewer than three positions, a board that hardly turned, or angles that contradict the observed rotation.
    """
    progress = progress or NoProgress()
    corners = np.asarray(problem.corners_mm, float)
    if len(corners) < LEAST_POSITIONS or corners.shape[1] < 3:
        raise CalibrationError(
            f"{len(corners)} table positions with {corners.shape[1]} corners do not determine the axis.",
            f"Give at least {LEAST_POSITIONS} positions of at least 3 corners.",
        )
    start = _start(corners, problem.angles_rad, problem.names)
    free = problem.options.free_angles or problem.angles_rad is None
    progress.report(0, 3, "maximum likelihood")
    likely, covariance, variance = _maximum_likelihood(problem, corners, start, free)
    estimates = {"maximum_likelihood": likely}
    refused = {}
    for done, (method, power) in enumerate((("least_squares", 0.0), ("distance_weighted", problem.options.power)), 1):
        progress.report(done, 3, method)
        try:
            estimates[method] = _fit_circles(problem, corners, power, likely, variance)
        except CalibrationError as error:
            refused[method] = str(error)
    progress.report(3, 3)
    sweep = float(np.ptp(likely.angles_rad))
    short = (f"The arcs span only {np.rad2deg(sweep):.0f}°, which makes their centres uncertain: turn the table further.",)
    ordered = {method: estimates[method] for method in METHODS if method in estimates}
    angles = start.angles_rad if problem.angles_rad is not None else likely.angles_rad
    diagnostics = diagnose(
        likely.axis, corners, angles, angles_were_read=problem.angles_rad is not None, radius_mm=problem.options.closure_radius_mm
    )
    warnings = (*(short if sweep < SHORT_SWEEP_RAD else ()), *_contradictions(problem, likely, variance), *diagnostics.warnings)
    return AxisSolution(ordered, refused, sweep, problem.options.power, covariance, diagnostics, warnings)


def _contradictions(problem: AxisProblem, likely: AxisEstimate, variance: float) -> tuple[str, ...]:
    """Return the warning that positions contradict each other, by more than a table may wobble and by far more than the image noise."""
    ratio, residual = float(np.sqrt(variance)), likely.axis.residual_mm
    if not problem.poses or ratio <= LARGEST_RATIO or residual <= LARGEST_RESIDUAL_MM:
        return ()
    return (
        f"The positions contradict each other by {residual:.2f} mm, {ratio:.0f} times the noise of the images: the board moved on the "
        "table, or the table wobbles. Fix the board and take the positions again; with five or more the one that moved is found.",
    )


def _start(corners: FloatArray, angles_rad: FloatArray | None, names: Sequence[str]) -> Turning:
    seen = estimate_turning(corners)
    if angles_rad is None:
        return seen
    given = np.asarray(angles_rad, float) - angles_rad[0]
    if len(given) != len(corners):
        raise CalibrationError(f"{len(given)} angles do not belong to {len(corners)} table positions.", "Give one angle per position.")
    forwards, backwards = (float(np.sum(np.abs(np.angle(np.exp(1j * (sign * seen.angles_rad - given)))))) for sign in (1, -1))
    if backwards < forwards:
        seen = replace(seen, direction=-seen.direction, angles_rad=-seen.angles_rad)
    wrong = np.abs(np.angle(np.exp(1j * (seen.angles_rad - given))))
    worst = int(np.argmax(wrong))
    if wrong[worst] > ANGLE_TOLERANCE_RAD:
        raise CalibrationError(
            f"Position {names[worst] if names else worst} turned by {np.rad2deg(seen.angles_rad[worst]):.2f}° against the first, "
            f"but its angle says {np.rad2deg(given[worst]):.2f}°.",
            "Check the order of the positions, the unit (degrees) of the angles, and that the board did not move on the table.",
        )
    return replace(seen, angles_rad=given)


def _maximum_likelihood(problem: AxisProblem, corners: FloatArray, start: Turning, free: bool) -> tuple[AxisEstimate, FloatArray, float]:
    if problem.poses:
        poses = stack_matrices(pose.camera_from_board for pose in problem.poses)
        roots = np.array([np.linalg.cholesky(pose.information).T for pose in problem.poses])
        minimum, freedom = fit_axis_to_poses(replace(start, board=poses[0]), poses, roots, free)
    else:
        minimum, freedom = fit_axis_to_corners(start, corners, free)
    variance = minimum.cost / max(freedom, 1)
    covariance = minimum.covariance(variance)[:AXIS_PARAMETERS, :AXIS_PARAMETERS]
    turning = minimum.state
    foot = _foot(turning.point_mm, turning.direction, corners)
    covariance = _shift_covariance(covariance, float(turning.direction @ (foot - turning.point_mm)))
    covariance = covariance + _camera_covariance(problem, turning, foot, free)
    axis = _axis(problem, corners, foot, turning.direction, covariance)
    return _estimate(axis, corners, turning.angles_rad), covariance, variance


def _camera_covariance(problem: AxisProblem, turning: Turning, foot: FloatArray, free: bool) -> FloatArray:
    """Propagate the covariance of the cameras to direction and foot (4, 4) of the axis, by a fit for each of their principal errors."""
    poses = stack_matrices(pose.camera_from_board for pose in problem.poses)
    roots = np.array([np.linalg.cholesky(pose.information).T for pose in problem.poses])
    basis, spread = perpendicular_basis(turning.direction), np.zeros((AXIS_PARAMETERS, AXIS_PARAMETERS))
    for change in problem.camera_error_modes:
        other = fit_axis_to_poses(turning, apply_changes(poses, change), roots, free)[0].state
        other_foot = other.point_mm + other.direction * float(turning.direction @ (foot - other.point_mm))
        shift = np.concatenate([basis @ other.direction, basis @ (other_foot - foot)])
        spread += np.outer(shift, shift)
    return spread


def _fit_circles(problem: AxisProblem, corners: FloatArray, power: float, likely: AxisEstimate, variance: float) -> AxisEstimate:
    def fitted(points: FloatArray) -> tuple[FloatArray, FloatArray]:
        point, direction = axis_through_centres(points, power)
        direction = direction * np.sign(direction @ likely.axis.direction)
        return _foot(point, direction, corners), direction

    point, direction = fitted(corners)
    basis = perpendicular_basis(direction)
    generator = np.random.default_rng(0)
    scatter = []
    for _ in range(DRAWS):
        drawn_point, drawn_direction = fitted(_resample_corners(problem, corners, variance, generator))
        scatter.append(np.concatenate([basis @ drawn_direction, basis @ (drawn_point - point)]))
    axis = _axis(problem, corners, point, direction, np.cov(np.array(scatter).T))
    return _estimate(axis, corners, likely.angles_rad)


def _resample_corners(problem: AxisProblem, corners: FloatArray, variance: float, generator: np.random.Generator) -> FloatArray:
    """Draw the corners of another run with the same noise (parametric bootstrap)."""
    if not problem.poses:
        return corners + generator.normal(scale=np.sqrt(variance), size=corners.shape)
    result = []
    modes = problem.camera_error_modes
    common = np.tensordot(generator.normal(size=len(modes)), modes, 1)
    for pose, points, shared in zip(problem.poses, corners, common, strict=True):
        covariance = variance * np.linalg.inv(pose.information)
        origin = pose.camera_from_board.translation_mm
        change = apply_changes(np.eye(4), shared + generator.multivariate_normal(np.zeros(6), covariance, method="cholesky"))
        result.append((points - origin) @ change[:3, :3].T + origin + change[:3, 3])
    return np.array(result)


def _foot(point: FloatArray, direction: FloatArray, corners: FloatArray) -> FloatArray:
    """Return the point of the axis nearest to the middle of all corners."""
    return point + direction * float(direction @ (corners.reshape(-1, 3).mean(axis=0) - point))


def _shift_covariance(covariance: FloatArray, distance_mm: float) -> FloatArray:
    """Transform the covariance of (direction, point) to a point further along the axis."""
    shift = np.eye(AXIS_PARAMETERS)
    shift[2:, :2] = distance_mm * np.eye(2)
    return shift @ covariance @ shift.T


def _axis(problem: AxisProblem, corners: FloatArray, point: FloatArray, direction: FloatArray, covariance: FloatArray) -> RotationAxis:
    radial, axial = _residuals(point, direction, corners)
    return RotationAxis(
        point,
        direction,
        problem.frame,
        point_sigma_mm=float(np.sqrt(np.linalg.eigvalsh(covariance[2:, 2:])[-1])),
        direction_sigma_rad=float(np.sqrt(np.linalg.eigvalsh(covariance[:2, :2])[-1])),
        residual_mm=float(np.sqrt(np.mean(radial**2 + axial**2))),
    )


def _residuals(point: FloatArray, direction: FloatArray, corners: FloatArray) -> tuple[FloatArray, FloatArray]:
    away = corners - point
    height = away @ direction
    distance = np.linalg.norm(away - height[..., None] * direction, axis=2)
    return distance - distance.mean(axis=0), height - height.mean(axis=0)


def _estimate(axis: RotationAxis, corners: FloatArray, angles_rad: FloatArray) -> AxisEstimate:
    radial, axial = _residuals(axis.point_mm, axis.direction, corners)
    return AxisEstimate(axis, np.sqrt(np.mean(radial**2, axis=1)), np.sqrt(np.mean(axial**2, axis=1)), angles_rad)
