"""The solutions of a rig calibration as rows, each evaluated against the rig's data sheets."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import acos, degrees
from typing import TYPE_CHECKING

from ui.look.language.words import later, tr
from ui.look.wording import millimetres, quantity, sentence_case

if TYPE_CHECKING:
    from measureapp.data.axis_motions import AxisMotions
    from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration, ProjectorCalibration, RigCalibration, RotationAxis
    from measureapp.data.rig import RigDescription

REPROJECTION_LIMIT_PX = 0.3
PROJECTOR_ROW = "Projector"
AXIS_LIMIT_MM = 0.1
ROBOT_LIMIT_MM = 0.5
ADDED_LIMIT_MM = 0.5  # views that are off by more do not register safely
COVERAGE_FACTOR = 2.0
MOTION_WORDS = "Positions of views are corrected for it; what the poses of the calibration did not show of it is in U"
STANDOFF_MM, STROKE_MM, HEIGHT_MM = 550.0, 650.0, 300.0  # where the rig does not say otherwise


@dataclass(frozen=True)
class SolutionRow:
    """One solution: estimate, residual, and whether that is good."""

    name: str
    estimate: str
    deviation: str
    residual: str
    good: bool
    criterion: str


def solution_rows(calibration: RigCalibration, rig: RigDescription | None) -> list[SolutionRow]:
    """Return one row per camera, hand–eye, guide and axis, and those of the error motions of table and guide."""
    motions = calibration.motions
    return [*judged_rows(calibration, rig), *(() if motions is None else motion_rows(motions))]


def judged_rows(calibration: RigCalibration, rig: RigDescription | None) -> list[SolutionRow]:
    """Return the rows that can be poor: one per camera, hand–eye, guide and axis."""
    robot_mm = rig.robot.absolute_accuracy_mm * 2 if rig is not None else ROBOT_LIMIT_MM
    rows = camera_rows(calibration.cameras)
    hand_eye, guide, axis = calibration.hand_eye, calibration.guide, calibration.axis
    place = hand_eye.flange_from_camera.translation_mm
    robot_words = tr("Residual up to {robot_mm}, twice the robot's absolute accuracy", robot_mm=millimetres(robot_mm, 2))
    rows.append(
        SolutionRow(
            "Hand–eye",
            tr("Camera at {vector} mm on the flange", vector=_vector(place, 2)),
            f"± {millimetres(hand_eye.translation_sigma_mm)} · ± {quantity(degrees(hand_eye.rotation_sigma_rad), '°', 4)}",
            millimetres(hand_eye.residual_mm),
            hand_eye.residual_mm <= robot_mm,
            robot_words,
        )
    )
    rows.append(
        SolutionRow(
            "Linear guide",
            tr("Direction {vector}, scale {scale:.6f}", vector=_vector(guide.direction), scale=guide.scale),
            f"± {quantity(degrees(guide.direction_sigma_rad), '°', 4)} · ± {guide.scale_sigma * 1e6:.0f} ppm",
            millimetres(guide.straightness_mm),
            guide.straightness_mm <= robot_mm,
            tr("Straightness up to {robot_mm}, twice the robot's absolute accuracy", robot_mm=millimetres(robot_mm, 2)),
        )
    )
    rows.append(
        SolutionRow(
            "Table axis",
            tr("Through {vector} mm, tilted by {quantity}", vector=_vector(axis.point_mm, 2), quantity=quantity(_tilt_deg(axis), "°", 3)),
            f"± {millimetres(axis.point_sigma_mm)} · ± {quantity(degrees(axis.direction_sigma_rad), '°', 4)}",
            millimetres(axis.residual_mm),
            axis.residual_mm <= AXIS_LIMIT_MM,
            tr("Residual up to {axis_limit_mm}", axis_limit_mm=millimetres(AXIS_LIMIT_MM, 2)),
        )
    )
    return rows


def motion_rows(motions: AxisMotions) -> list[SolutionRow]:
    """Return a row of the table's error motions, and one of the guide's where it was moved; with what they move the board by."""
    share = tr("Board moved by {explained_mm} rms", explained_mm=millimetres(motions.explained_mm))
    named = [("Error motions, table", motions.table_words), ("Error motions, guide", motions.guide_words)]
    return [SolutionRow(name, sentence_case(words), share, "–", True, MOTION_WORDS) for name, words in named if words]


def camera_rows(cameras: CameraArrayCalibration) -> list[SolutionRow]:
    """Return one row per camera, and one of the projector where it is calibrated."""
    projector = () if cameras.projector is None else (_lens_row(PROJECTOR_ROW, cameras.projector),)
    return [*(_lens_row(later("Camera {name}").format(name=name), cameras.cameras[name]) for name in cameras.names), *projector]


def _lens_row(name: str, camera: CameraCalibration | ProjectorCalibration) -> SolutionRow:
    matrix = camera.pinhole.matrix
    sigma = max((value for key, value in camera.standard_deviations.items() if key in {"fx", "fy", "f"}), default=None)
    return SolutionRow(
        name,
        tr(
            "Focal length {matrix:.1f} px, centre ({matrix_2:.1f}, {matrix_3:.1f}) px",
            matrix=matrix[0, 0],
            matrix_2=matrix[0, 2],
            matrix_3=matrix[1, 2],
        ),
        f"± {quantity(sigma, 'px', 2)}" if sigma is not None else "–",
        quantity(camera.rms_px or None, "px", 3),
        camera.rms_px <= REPROJECTION_LIMIT_PX,
        tr("Reprojection up to {reprojection_limit_px} rms", reprojection_limit_px=quantity(REPROJECTION_LIMIT_PX, "px", 1)),
    )


def added_to_length_mm(calibration: RigCalibration, rig: RigDescription | None) -> float:
    """Return what the calibration adds to a length between two views, in mm (k = 2), before registration.

    A calibration of the whole rig states it by its joint covariance. Of one put together from single solutions it is at most this: of
    views from opposite sides the errors of hand–eye and axis point in opposite directions, so each counts twice; those of the guide are
    stated for its whole stroke and count once; the solutions are taken as independent.
    """
    if calibration.view_gaps_mm is not None:
        return calibration.view_gaps_mm
    shares = dict(contributions(calibration, rig)[:-1])
    twice = [value * (1.0 if name.startswith("Guide") else 2.0) for name, value in shares.items()]
    return sum(value**2 for value in twice) ** 0.5


def _vector(values: Iterable[float], digits: int = 4) -> str:
    return "(" + ", ".join(quantity(float(value), "", digits) for value in values) + ")"


def _tilt_deg(axis: RotationAxis) -> float:
    return degrees(acos(min(1.0, abs(float(axis.direction[2])))))


def contributions(calibration: RigCalibration, rig: RigDescription | None) -> list[tuple[str, float]]:
    """Return what each solution contributes to the kinematic position of a point, in mm (k = 2), and their root sum of squares."""
    standoff = rig.standoff_mm if rig is not None else STANDOFF_MM
    stroke = max(abs(limit) for limit in rig.guide.limits_mm) if rig is not None else STROKE_MM
    hand_eye, guide, axis = calibration.hand_eye, calibration.guide, calibration.axis
    deviations = [
        ("Hand–eye, position", hand_eye.translation_sigma_mm),
        (later("Hand–eye, rotation over {standoff:.0f} mm").format(standoff=standoff), hand_eye.rotation_sigma_rad * standoff),
        (later("Guide direction over {stroke:.0f} mm").format(stroke=stroke), guide.direction_sigma_rad * stroke),
        (later("Guide scale over {stroke:.0f} mm").format(stroke=stroke), guide.scale_sigma * stroke),
        ("Table axis, position", axis.point_sigma_mm),
        (later("Table axis, tilt over {height_mm:.0f} mm").format(height_mm=HEIGHT_MM), axis.direction_sigma_rad * HEIGHT_MM),
    ]
    parts = [(name, COVERAGE_FACTOR * value) for name, value in deviations]
    return [*parts, ("Together", sum(value**2 for _, value in parts) ** 0.5)]
