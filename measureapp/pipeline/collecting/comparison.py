"""A new calibration beside the one before: every estimate, and what the difference amounts to on the part."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from measureapp.calibrate.cameras.array import CameraArraySolution
from measureapp.calibrate.cameras.projector import HeadSolution, as_camera, beside_projector
from measureapp.calibrate.cameras.uncertainty import POSE_NAMES
from measureapp.calibrate.motions.axis_motion import rigid_motion
from measureapp.calibrate.motions.hand_eye import HandEyeSolution
from measureapp.calibrate.poses import change_between
from measureapp.calibrate.projection import intrinsic_names
from measureapp.calibrate.rig.joint_solution import RigSolution
from measureapp.calibrate.sightings import rms
from measureapp.data.calibration import (
    CameraArrayCalibration,
    CameraCalibration,
    HandEye,
    LinearGuide,
    ProjectorCalibration,
    RigCalibration,
    RotationAxis,
)
from measureapp.data.uncertainty import COVERAGE_FACTOR
from measureapp.errors import CalibrationError
from measureapp.pipeline.collecting.collection import Collection
from measureapp.pipeline.collecting.estimates import Calibrated, estimates_of, result_of
from measureapp.pipeline.collecting.on_part import (
    RADIUS_MM,
    few_of,
    fitting_length_mm,
    fitting_together_sigma_mm,
    length_beside_projector,
    length_uncertainty,
    part_points_mm,
    rim_mm,
    shape_difference_mm,
    sideways_difference_mm,
    sideways_sigma_mm,
    volume_of,
)
from measureapp.pipeline.collecting.setup import PURPOSES
from measureapp.pipeline.collecting.solved import Solved
from measureapp.pipeline.collecting.verdict import STROKE_MM, millimetres


@dataclass(frozen=True, slots=True)
class Change:
    """One estimate before and now."""

    name: str
    previous: float
    new: float
    sigma: float  # standard deviation of the difference; 0 where neither calibration states one
    unit: str

    @property
    def difference(self) -> float:
        """New less previous."""
        return self.new - self.previous

    @property
    def within(self) -> bool:
        """Whether the difference is no larger than both promise (k = 2)."""
        return abs(self.difference) <= COVERAGE_FACTOR * self.sigma


@dataclass(frozen=True, slots=True)
class Comparison:
    """A new calibration against the one before."""

    changes: tuple[Change, ...]
    on_part_mm: float  # what the difference moves on the part
    promised_mm: float  # what both leave open there (k = 2)
    what: str  # where on the part, as part of a sentence
    surprise: float = 1.0  # rms of all differences over what both promise of them, with their correlations; about 1 for the same cameras

    @property
    def within(self) -> bool:
        """Whether the difference is no larger than both promise, on the part and in all estimates together."""
        return self.on_part_mm <= self.promised_mm and self.surprise <= COVERAGE_FACTOR

    @property
    def sentence(self) -> str:
        """What it means."""
        start = f"The new calibration moves {self.what} by {millimetres(self.on_part_mm)}"
        promised = f"the {millimetres(self.promised_mm)} (k = 2) that both promise"
        if self.within:
            return f"{start}, within {promised}."
        if self.on_part_mm <= self.promised_mm:
            return (
                f"{start}, within {promised}; but the estimates differ {self.surprise:.1f} times as much as both promise: "
                "the cameras were knocked, refocused or warmed up between them."
            )
        return f"{start}, more than {promised}: something changed between them, or one of them is worse than it says."


def compare(previous: Calibrated, collection: Collection) -> Comparison:
    """Compare the last solution of a collection with an earlier calibration.

    A previous calibration of cameras comes without its covariance; its promise on the part is that of the new one, scaled by the ratio
    of their standard deviations (equal where it states none).

    Raises
    ------
    CalibrationError
        Nothing was solved yet, or the two are calibrations of different things.
    """
    solved = collection.solved
    if solved is None:
        raise CalibrationError("There is no solution yet.", "Solve what was collected first.")
    new = result_of(solved)
    if isinstance(new, ProjectorCalibration) and (before := _projector_of(previous)) is not None:
        return _projector(before, solved, collection)
    if isinstance(new, CameraArrayCalibration) and isinstance(previous, CameraArrayCalibration):
        return _cameras(previous, solved, collection)
    if isinstance(new, RotationAxis) and isinstance(previous, RotationAxis):
        return compare_axes(previous, new)
    if isinstance(new, HandEye) and isinstance(previous, HandEye):
        return _hand_eye(previous, new, _distance_mm(solved))
    if isinstance(new, LinearGuide) and isinstance(previous, LinearGuide):
        return _guide(previous, new)
    if isinstance(new, RigCalibration) and isinstance(previous, RigCalibration):
        return _rig(previous, new, solved, collection)
    raise CalibrationError(
        f"The previous calibration is not one of {PURPOSES[collection.setup.kind]}.", "Name a result of the same kind of calibration."
    )


def _cameras(previous: CameraArrayCalibration, solved: Solved, collection: Collection) -> Comparison:
    solution = solved.camera_solution
    assert solution is not None  # the result is a calibration of cameras
    new = solution.calibration
    if set(new.cameras) != set(previous.cameras) or new.reference != previous.reference:
        raise CalibrationError(
            f"The previous calibration is one of {', '.join(previous.cameras)} with {previous.reference} as reference, "
            f"the new one of {', '.join(new.cameras)} with {new.reference}.",
            "Compare calibrations of the same cameras.",
        )
    changes = tuple(_matching(previous, new))
    volume = volume_of(solution, collection.setup.standoff_mm)
    both = float(np.hypot(1.0, _ratio(previous, new)))
    surprise = _normalised(previous, solution) / both
    if len(new.cameras) == 1:
        lens = new.cameras[new.reference].pinhole
        moved = sideways_difference_mm(lens, previous.cameras[new.reference].pinhole, volume.standoff_mm)
        promised = both * COVERAGE_FACTOR * sideways_sigma_mm(solution, volume.standoff_mm)
        what = f"points {volume.standoff_mm:.0f} mm before the camera (rms, across the line of sight)"
        return Comparison(changes, moved, promised, what, surprise)
    found = length_uncertainty(solution, volume, fitting_length_mm(volume, collection.setup.length_mm))
    moved = shape_difference_mm(new, previous, volume)
    promised = both * COVERAGE_FACTOR * found.shape_rms_mm
    return Comparison(changes, moved, promised, "points of the volume against each other (rms)", surprise)


def _projector_of(previous: Calibrated) -> ProjectorCalibration | None:
    """The projector among what was calibrated before; None where there is none."""
    if isinstance(previous, RigCalibration):
        return previous.cameras.projector
    if isinstance(previous, CameraArrayCalibration):
        return previous.projector
    return previous if isinstance(previous, ProjectorCalibration) else None


def _projector(previous: ProjectorCalibration, solved: Solved, collection: Collection) -> Comparison:
    head = solved.solution
    assert isinstance(head, HeadSolution)  # the result is a projector
    camera = head.calibration.reference
    volume = volume_of(head.solution, collection.setup.standoff_mm)
    found = length_beside_projector(head, camera, volume, fitting_length_mm(volume, collection.setup.length_mm))
    before = replace(head.calibration, projector=replace(previous, name=head.projector.name))
    moved = shape_difference_mm(beside_projector(head.calibration, camera), beside_projector(before, camera), volume)
    alone = [CameraArrayCalibration(one.name, {one.name: as_camera(one)}) for one in (before.projector or previous, head.projector)]
    promised = float(np.hypot(1.0, _ratio(*alone))) * COVERAGE_FACTOR * found.shape_rms_mm
    what = f"points that camera {camera} and the projector measure against each other (rms)"
    return Comparison(tuple(_matching(previous, head.projector)), moved, promised, what)


def _matching(previous: Calibrated, new: Calibrated) -> list[Change]:
    """Return the changes of all estimates that both have."""
    before = {one.name: one for one in estimates_of(previous)}
    return [
        Change(one.name, before[one.name].value, one.value, float(np.hypot(before[one.name].sigma, one.sigma)), one.unit)
        for one in estimates_of(new)
        if one.name in before
    ]


def _normalised(previous: CameraArrayCalibration, solution: CameraArraySolution) -> float:
    """Return the rms difference of all estimates in units of the new calibration's covariance (root of Mahalanobis' distance over their number)."""
    changes: dict[str, float] = {}
    for name, camera in solution.calibration.cameras.items():
        other = previous.cameras[name]
        lens = [np.array(_lens_values(one)) for one in (other, camera)]
        count = min(len(values) for values in lens)
        labels = [f"{name}.{label}" for label in intrinsic_names(len(camera.pinhole.distortion))][:count]
        changes |= dict(zip(labels, (lens[1][:count] - lens[0][:count]).tolist(), strict=True))
        place = change_between(other.reference_from_camera.matrix[None], camera.reference_from_camera.matrix[None])[0]
        changes |= dict(zip((f"{name}.{label}" for label in POSE_NAMES), place.tolist(), strict=True))
    known = [index for index, label in enumerate(solution.parameters) if label in changes]
    step = np.array([changes[solution.parameters[index]] for index in known])
    covariance = solution.covariance[np.ix_(known, known)]
    scale = np.sqrt(np.diag(covariance))
    whitened = step / scale
    return float(np.sqrt(whitened @ np.linalg.solve(covariance / np.outer(scale, scale), whitened) / len(step)))


def _lens_values(camera: CameraCalibration) -> list[float]:
    matrix = camera.pinhole.matrix
    return [float(value) for value in (matrix[0, 0], matrix[1, 1], matrix[0, 2], matrix[1, 2], *camera.pinhole.distortion)]


def _ratio(previous: CameraArrayCalibration, new: CameraArrayCalibration) -> float:
    """Return how many times larger the standard deviations of the previous calibration are; 1 where it states none."""
    ratios = [
        before / after
        for name, camera in new.cameras.items()
        for label, after in camera.standard_deviations.items()
        if (before := previous.cameras[name].standard_deviations.get(label, 0.0)) > 0 and after > 0
    ]
    return float(np.median(ratios)) if ratios else 1.0


def compare_axes(previous: RotationAxis, new: RotationAxis) -> Comparison:
    """Compare a rotation axis with an earlier one. Raises CalibrationError where they are told in different frames."""
    if previous.frame != new.frame:
        raise CalibrationError(
            f"The previous axis is given in frame {previous.frame}, the new one in {new.frame}.", "Compare axes in the same frame."
        )
    rim = rim_mm(new, RADIUS_MM)
    moved = float(np.linalg.norm(new.turned(np.pi).apply(rim) - previous.turned(np.pi).apply(rim), axis=1).max())
    sigmas = [np.hypot(axis.point_sigma_mm, RADIUS_MM * axis.direction_sigma_rad) for axis in (previous, new)]
    return Comparison(
        tuple(_axis_changes(previous, new)),
        moved,
        COVERAGE_FACTOR * 2.0 * float(np.hypot(*sigmas)),  # half a turn doubles an error of the axis
        f"a point {RADIUS_MM:.0f} mm from the axis, between views half a turn apart,",
    )


def _axis_changes(previous: RotationAxis, new: RotationAxis) -> list[Change]:
    """Return the changes of the direction, and how far the new point lies from the previous axis: where along it a point lies is no estimate."""
    away = new.point_mm - previous.point_mm
    gap = float(np.linalg.norm(away - previous.direction * float(previous.direction @ away)))
    directions = [change for change in _matching(previous, new) if change.name.startswith("axis direction")]
    return [*directions, Change("axis, across", 0.0, gap, float(np.hypot(previous.point_sigma_mm, new.point_sigma_mm)), "mm")]


def _hand_eye(previous: HandEye, new: HandEye, distance_mm: float) -> Comparison:
    part = np.array([[0.0, 0.0, distance_mm]])
    moved = rms(new.flange_from_camera.apply(part) - previous.flange_from_camera.apply(part))
    sigmas = [np.hypot(one.translation_sigma_mm, distance_mm * one.rotation_sigma_rad) for one in (previous, new)]
    promised = COVERAGE_FACTOR * float(np.hypot(*sigmas))
    return Comparison(tuple(_matching(previous, new)), moved, promised, f"a point {distance_mm:.0f} mm before the cameras")


def _guide(previous: LinearGuide, new: LinearGuide) -> Comparison:
    moved = STROKE_MM * float(np.linalg.norm(new.scale * new.direction - previous.scale * previous.direction))
    sigmas = [np.hypot(guide.direction_sigma_rad, guide.scale_sigma) for guide in (previous, new)]
    promised = COVERAGE_FACTOR * STROKE_MM * float(np.hypot(*sigmas))
    return Comparison(tuple(_matching(previous, new)), moved, promised, f"a point, between views {STROKE_MM:.0f} mm of the guide apart,")


def _rig(previous: RigCalibration, new: RigCalibration, solved: Solved, collection: Collection) -> Comparison:
    solution = solved.solution
    assert isinstance(solution, RigSolution)  # the result is a calibration of the rig
    changes = [
        *_matching(previous.hand_eye, new.hand_eye),
        *_matching(previous.guide, new.guide),
        *_axis_changes(previous.axis, new.axis),
    ]
    used = few_of([one.readback.full() for one in collection.observations if one.id in solved.used])
    points = part_points_mm(solution)
    there = np.concatenate([points for _ in used])
    seen = [new.part_from_camera(readback).inverse().apply(points) for readback in used]
    placed = np.concatenate([previous.part_from_camera(readback).apply(part) for readback, part in zip(used, seen, strict=True)])
    motion = rigid_motion(placed, there)
    typical, _ = fitting_together_sigma_mm(solution, used)
    moved = rms(placed @ motion[:3, :3].T + motion[:3, 3] - there)
    both = COVERAGE_FACTOR * float(np.hypot(1.0, _hand_eye_ratio(previous.hand_eye, new.hand_eye))) * typical
    return Comparison(tuple(changes), moved, both, "views of one part against each other (rms)")


def _hand_eye_ratio(previous: HandEye, new: HandEye) -> float:
    """Return how many times less certain the previous rig was, by its hand-eye transform; 1 where it does not say."""
    return previous.translation_sigma_mm / new.translation_sigma_mm if previous.translation_sigma_mm and new.translation_sigma_mm else 1.0


def _distance_mm(solved: Solved) -> float:
    assert isinstance(solved.solution, HandEyeSolution)  # the result is a hand-eye transform
    return float(solved.solution.part_in_camera_mm[2])
