"""Propagation of the covariance of calibrations to the part, in millimetres, and displacement between two calibrations."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.boards.pose import triangulate
from measureapp.calibrate.cameras.array import CameraArraySolution
from measureapp.calibrate.cameras.projector import HeadSolution, pair_with_projector
from measureapp.calibrate.cameras.projector_sightings import PROJECTOR
from measureapp.calibrate.cameras.uncertainty import (
    WorkingVolume,
    observed_volume,
    projection_difference,
    projection_uncertainty,
    volume_points,
    volume_uncertainty,
)
from measureapp.calibrate.motions.axis_motion import perpendicular_basis, rigid_motion
from measureapp.calibrate.motions.hand_eye import HandEyeSolution
from measureapp.calibrate.motions.next_pose import lever_at
from measureapp.calibrate.rig.joint_solution import RigSolution
from measureapp.calibrate.rig.stitch_uncertainty import uncertainty_of, view_uncertainty
from measureapp.calibrate.sightings import rms
from measureapp.data.calibration import CameraArrayCalibration, RotationAxis
from measureapp.data.fringe import AxisReadback
from measureapp.data.uncertainty import VolumeUncertainty
from measureapp.geometry.pinhole import PinholeCamera

LENGTH_SHARE = 0.8  # of the volume's diagonal: the longest length stated for it
RADIUS_MM = 250.0  # radius of the paper's table
PART_MM = 100.0  # from the middle of the part to its sides
MOST_VIEWS = 12
GRID = 12  # points along each side of an image
STEP = 1e-6


def volume_of(solution: CameraArraySolution, standoff_mm: float | None) -> WorkingVolume:
    """Return the volume in which the board was shown."""
    places = np.array([pose.apply(solution.board.middle_mm) for pose in solution.boards.values()])
    return observed_volume(solution.calibration, places, standoff_mm)


def fitting_length_mm(volume: WorkingVolume, wanted_mm: float) -> float:
    """Return the wanted length, or a round one that fits into the volume."""
    diagonal = float(np.linalg.norm([*volume.field_mm, volume.depth_mm]))
    return min(wanted_mm, float(f"{LENGTH_SHARE * diagonal:.1g}"))


def length_uncertainty(solution: CameraArraySolution, volume: WorkingVolume, length_mm: float) -> VolumeUncertainty:
    """Return the uncertainty of points and lengths in the volume. Raises CalibrationError if no two cameras see it."""
    return volume_uncertainty(solution.calibration, solution.parameters, solution.covariance, volume, length_mm)


def length_uncertainty_with_projector(
    head: HeadSolution, camera: str, volume: WorkingVolume, length_mm: float, *, own: bool = False
) -> VolumeUncertainty:
    """Return the uncertainty of points and lengths measured by one camera and the projector.

    Parameters
    ----------
    own : only the contribution of the projector's calibration, with exactly known cameras

    Raises
    ------
    CalibrationError
        The two do not see the volume.
    """
    solution = head.solution
    covariance = _condition_on_cameras(solution) if own else solution.covariance
    return volume_uncertainty(pair_with_projector(head.calibration, camera), solution.parameters, covariance, volume, length_mm)


def _condition_on_cameras(solution: CameraArraySolution) -> FloatArray:
    """The conditional covariance of the projector given exactly known cameras (Schur complement): C_pp − C_pc C_cc⁻¹ C_cp, and zero for the cameras."""
    own = np.array([label.startswith(f"{PROJECTOR}.") for label in solution.parameters])
    mixed = solution.covariance[np.ix_(own, ~own)]
    given = mixed @ np.linalg.pinv(solution.covariance[np.ix_(~own, ~own)], hermitian=True) @ mixed.T
    result = np.zeros_like(solution.covariance)
    result[np.ix_(own, own)] = solution.covariance[np.ix_(own, own)] - given
    return result


def sideways_sigma_mm(solution: CameraArraySolution, range_mm: float) -> float:
    """Return how far a single camera may misplace a point across its line of sight, at worst over its image, one standard deviation."""
    camera = solution.calibration.cameras[solution.calibration.reference]
    worst = projection_uncertainty(camera, solution.parameters, solution.covariance, range_mm).sigma_px.max()
    return float(worst * range_mm / camera.pinhole.matrix[0, 0])


def half_turn_sigma_mm(axis: RotationAxis, covariance: FloatArray, radius_mm: float = RADIUS_MM) -> float:
    """Return how far a point at ``radius_mm`` may be misplaced between two views half a turn of the table apart, one standard deviation.

    Parameters
    ----------
    covariance : (4, 4) of direction (2, rad) and point (2, mm) across the axis
    """
    basis = perpendicular_basis(axis.direction)

    def turned(change: FloatArray) -> FloatArray:
        moved = RotationAxis(axis.point_mm + change[2:] @ basis, axis.direction + change[:2] @ basis, axis.frame)
        return moved.turned(np.pi).apply(circle_about_axis_mm(axis, radius_mm))

    columns = [(turned(step) - turned(-step)) / (2 * STEP) for step in STEP * np.eye(4)]
    jacobian = np.stack(columns, axis=-1)
    return float(np.sqrt(np.linalg.eigvalsh(jacobian @ covariance @ np.swapaxes(jacobian, 1, 2))[:, -1].max()))


def circle_about_axis_mm(axis: RotationAxis, radius_mm: float) -> FloatArray:
    """Return points (8, 3) on a circle about the axis, at the height of its point."""
    angles = np.linspace(0, 2 * np.pi, 8, endpoint=False)
    return np.asarray(axis.point_mm + radius_mm * np.column_stack([np.cos(angles), np.sin(angles)]) @ perpendicular_basis(axis.direction))


def placement_sigma_mm(solution: HandEyeSolution) -> float:
    """Return how far a point at the part may be misplaced against the flange, the largest over all directions."""
    lever = lever_at(solution.part_in_camera_mm, solution.minimum.state)
    return float(np.sqrt(np.linalg.eigvalsh(lever @ solution.covariance @ lever.T)[-1]))


def view_consistency_sigma_mm(solution: RigSolution, readbacks: Sequence[AxisReadback]) -> tuple[float, float]:
    """Return the standard deviation of the gaps between views on the part before registration: rms and worst over views and points.

    Points are the corners of a cube of 200 mm about the board. Errors common to all views are excluded: they move the part as a
    whole and do not deform it.
    """
    chosen = sample_readbacks(readbacks)
    views = view_uncertainty(uncertainty_of(solution), chosen)
    points = part_points_mm(solution)
    gaps = [views.between(0, index, points) for index in range(1, len(chosen))]
    sigma = np.sqrt([np.linalg.eigvalsh(gap)[:, -1] for gap in gaps])
    return float(np.sqrt(np.mean(sigma**2))), float(sigma.max())


def part_points_mm(solution: RigSolution) -> FloatArray:
    """Return the corners (8, 3) of a cube about the board, in the part's frame."""
    part_from_board = solution.calibration.table_from_guide @ solution.guide_from_board
    sides = np.array(np.meshgrid(*[[-PART_MM, PART_MM]] * 3)).reshape(3, -1).T
    return part_from_board.translation_mm + sides


def sample_readbacks(readbacks: Sequence[AxisReadback]) -> list[AxisReadback]:
    """Return a dozen of the read-backs, from the first to the last."""
    chosen = np.unique(np.linspace(0, len(readbacks) - 1, min(len(readbacks), MOST_VIEWS)).round().astype(int))
    return [readbacks[index] for index in chosen]


def shape_difference_mm(one: CameraArrayCalibration, other: CameraArrayCalibration, volume: WorkingVolume) -> float:
    """Return the rms distance of points of the volume as the cameras ``one`` and ``other`` measure them, after the best rigid fit."""
    points = volume_points(one, volume)
    seen = {name: _pixels(one, name, points) for name in one.cameras}
    inside = np.array([_inside(one.cameras[name].pinhole, pixels) for name, pixels in seen.items()]).sum(axis=0) == len(seen)
    if np.count_nonzero(inside) < 4:  # no point is in all images: what the cameras extrapolate is compared then
        inside[:] = True
    measured = triangulate({name: pixels[inside] for name, pixels in seen.items()}, other)
    motion = rigid_motion(measured, points[inside])
    return rms(measured @ motion[:3, :3].T + motion[:3, 3] - points[inside])


def sideways_difference_mm(one: PinholeCamera, other: PinholeCamera, range_mm: float) -> float:
    """Return the rms distance across the line of sight between points by two lenses of one camera, after removal of a rigid motion."""
    x, y = np.linspace(0, one.width_px - 1, GRID), np.linspace(0, one.height_px - 1, GRID)
    pixels = np.stack(np.meshgrid(x, y), -1).reshape(-1, 2)
    return rms(projection_difference(one, other, pixels, range_mm)) * range_mm / float(one.matrix[0, 0])


def _pixels(cameras: CameraArrayCalibration, name: str, points_mm: FloatArray) -> FloatArray:
    camera = cameras.cameras[name]
    return camera.pinhole.project(camera.reference_from_camera.inverse().apply(points_mm))


def _inside(pinhole: PinholeCamera, pixels: FloatArray) -> FloatArray:
    size = np.array([pinhole.width_px, pinhole.height_px])
    return np.asarray(np.all((pixels >= -0.5) & (pixels <= size - 0.5), axis=1))
