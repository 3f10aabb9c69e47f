"""Noise model of the axes: standard deviations of the robot's pose errors and their correlation between poses, table and slide."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.axis_motions import ARCSEC
from measureapp.data.rig import RigDescription

SAME_POSE = 1e-4  # robot poses closer than this (mm, rotation matrix) are one pose with one error
LEAST_SHARE = 1e-6  # of the variance, uncorrelated, so that the covariance of equal poses stays regular
STRAIGHTNESS_MM = 0.003  # typical of a ground rail over the travel of a calibration
SPAN_OVER_RMS = np.sqrt(8.0)  # of a sine
LEAST_MM, LEAST_RAD = 1e-3, 1e-6  # below what images can show: also an axis described as free of errors keeps its equations regular
USUAL_RADIAL_MM, USUAL_AXIAL_MM, USUAL_TILT_ARCSEC = 0.005, 0.003, 5.0  # of a table with ball bearings, where not stated
USUAL_STRAIGHTNESS_MM, USUAL_ANGLES_ARCSEC = 0.01, 15.0  # of a guide with rails
MOTION_SPREAD = float(np.log(3.0))  # what is stated, or usual, holds within this factor
CORRELATION_MM, CORRELATION_TURN = 300.0, 0.6  # of an articulated robot with a reach of about 0.7 m


@dataclass(frozen=True, slots=True, eq=False)
class AxisNoise:
    """Standard deviations of the axes before any observation.

    A robot's error follows from its link lengths, joint offsets and the bending of its arm. It changes over the reach, not from
    pose to pose: `robot_correlation_mm` and `robot_correlation_turn` (0: every pose has an error of its own) are the distances of the flange,
    and of the tips of its unit axes x and z, over which the correlation falls to exp(-1/2).
    """

    robot_mm: float = 0.3  # repeatable pose error of the robot, per coordinate
    robot_rad: float = float(np.deg2rad(0.02))
    table_rad: float = float(np.deg2rad(10 / 3600))
    robot_repeat_mm: float = 0.0  # scatter at every approach of a pose, per coordinate
    robot_repeat_rad: float = 0.0
    robot_correlation_mm: float = 0.0
    robot_correlation_turn: float = 0.0
    guide_mm: float = 0.0  # departure of the slide from its straight line, at every approach, per coordinate
    guide_along_mm: float = 0.0  # the same along it: how far the slide misses its displayed position
    table_radial_mm: float = 0.0  # half the range of the table's error motions, as data sheets state them; 0: none is estimated
    table_axial_mm: float = 0.0
    table_tilt_rad: float = 0.0
    slide_mm: float = 0.0  # the same of the slide: straightness
    slide_rad: float = 0.0  # pitch, yaw and roll
    slide_from_mm: float = 0.0  # limits of the slide
    slide_to_mm: float = 0.0
    motion_spread: float = MOTION_SPREAD  # of the logarithm of these half ranges, by which the sightings may change them; 0: not at all
    stop_mm: float = 0.0  # scatter of the cameras' place at every stop of any axis, per coordinate, by settling and the like
    drift_mm: float = 0.0  # largest displacement of the flange between calibration and scan by warming up

    def correlation(self, first: FloatArray, second: FloatArray) -> FloatArray:
        """Return the correlation (A, B) of the repeatable errors at poses base_from_flange (A, 4, 4) and (B, 4, 4)."""
        there, here = (_pose_vectors(poses) for poses in (first, second))
        away = there[:, None] - here[None]
        if self.robot_correlation_mm <= 0 or self.robot_correlation_turn <= 0:
            return np.asarray(np.all(np.abs(away) <= SAME_POSE, axis=2), float)
        square = (
            np.sum(away[..., :3] ** 2, axis=2) / self.robot_correlation_mm**2
            + np.sum(away[..., 3:] ** 2, axis=2) / self.robot_correlation_turn**2
        )
        return np.exp(-0.5 * square)

    def robot_covariances(self, poses: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return the covariances (G, G) of one rotation and one translation component of the errors at approached poses (G, 4, 4)."""
        correlation, own = self.correlation(poses, poses), np.eye(len(poses))
        spread = ((self.robot_rad, self.robot_repeat_rad), (self.robot_mm, self.robot_repeat_mm))
        turn, shift = (large**2 * (correlation + LEAST_SHARE * own) + small**2 * own for large, small in spread)
        return turn, shift


def articulated_robot(accuracy_mm: float, accuracy_rad: float, repeatability_mm: float) -> AxisNoise:
    """Return the noise of a six-axis robot whose data sheet states the rms length of its absolute error and its repeatability."""
    share = repeatability_mm / accuracy_mm if accuracy_mm > 0 else 0.0
    per_coordinate = 1 / np.sqrt(3.0)
    return AxisNoise(
        robot_mm=accuracy_mm * per_coordinate,
        robot_rad=accuracy_rad * per_coordinate,
        robot_repeat_mm=repeatability_mm * per_coordinate,
        robot_repeat_rad=accuracy_rad * share * per_coordinate,
        robot_correlation_mm=CORRELATION_MM,
        robot_correlation_turn=CORRELATION_TURN,
    )


def expected_noise(rig: RigDescription) -> AxisNoise:
    """Return the noise that follows from the data sheets of the rig's axes.

    A table's accuracy is the span of its error over a turn; a guide's repeatability (±) is two standard deviations.
    """
    along_mm = rig.guide.repeatability_mm / 2
    table, guide = rig.table, rig.guide
    robot = articulated_robot(
        max(rig.robot.absolute_accuracy_mm, LEAST_MM),
        max(float(np.deg2rad(rig.robot.absolute_accuracy_deg)), LEAST_RAD),
        rig.robot.repeatability_mm,
    )
    return replace(
        robot,
        table_rad=max(float(np.deg2rad(table.accuracy_arcsec / 3600.0)) / SPAN_OVER_RMS, LEAST_RAD),
        guide_mm=float(np.hypot(STRAIGHTNESS_MM, along_mm)),
        guide_along_mm=along_mm,
        table_radial_mm=_stated(table.radial_error_mm, USUAL_RADIAL_MM),
        table_axial_mm=_stated(table.axial_error_mm, USUAL_AXIAL_MM),
        table_tilt_rad=_stated(table.tilt_error_arcsec, USUAL_TILT_ARCSEC) * ARCSEC,
        slide_mm=_stated(guide.straightness_mm, USUAL_STRAIGHTNESS_MM),
        slide_rad=_stated(guide.angular_error_arcsec, USUAL_ANGLES_ARCSEC) * ARCSEC,
        slide_from_mm=guide.limits_mm[0],
        slide_to_mm=guide.limits_mm[1],
        drift_mm=rig.robot.thermal_drift_mm or 0.0,
    )


def _stated(value: float | None, usual: float) -> float:
    return usual if value is None else value


def number_runs(groups: IntArray) -> IntArray:
    """Number the runs of equal neighbours in ``groups`` (N,): sightings in the order they were taken, between which the robot did not move."""
    changed = np.concatenate([[False], np.diff(groups) != 0])
    return np.cumsum(changed).astype(np.intp)


def _pose_vectors(poses: FloatArray) -> FloatArray:
    return np.concatenate([poses[:, :3, 3], poses[:, :3, 2], poses[:, :3, 0]], axis=1)
