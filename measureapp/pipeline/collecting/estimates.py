"""The estimates of a calibration by name, each with its standard deviation: what a table of results shows."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.cameras.projector import HeadSolution, as_camera
from measureapp.calibrate.cameras.uncertainty import POSE_NAMES
from measureapp.calibrate.motions.hand_eye import HandEyeSolution
from measureapp.calibrate.motions.linear_guide import GuideSolution
from measureapp.calibrate.motions.rotation_axis import AxisSolution
from measureapp.calibrate.projection import intrinsic_names
from measureapp.data.calibration import (
    CameraArrayCalibration,
    CameraCalibration,
    HandEye,
    LinearGuide,
    ProjectorCalibration,
    RigCalibration,
    RotationAxis,
)
from measureapp.pipeline.collecting.solved import Solved

Calibrated = CameraArrayCalibration | ProjectorCalibration | RotationAxis | HandEye | LinearGuide | RigCalibration
DEGREES = float(np.rad2deg(1.0))


@dataclass(frozen=True, slots=True)
class Estimate:
    """One number of a calibration."""

    name: str
    value: float
    sigma: float  # standard deviation; 0 where none is stated
    unit: str  # "px", "°", "mm" or "" for a pure number


def result_of(solved: Solved) -> Calibrated:
    """Return the calibration that a solution gives."""
    solution = solved.solution
    if isinstance(solution, AxisSolution):
        return solution.best.axis
    if isinstance(solution, HeadSolution):
        return solution.projector
    if isinstance(solution, HandEyeSolution):
        return solution.hand_eye
    return solution.guide if isinstance(solution, GuideSolution) else solution.calibration


def estimates_of(result: Calibrated) -> tuple[Estimate, ...]:
    """Return the estimates of a calibration in a fixed order; equal names mean equal things."""
    if isinstance(result, CameraArrayCalibration):
        return tuple(one for name in result.names for one in _camera(result.cameras[name], name == result.reference))
    if isinstance(result, ProjectorCalibration):
        return tuple(_camera(as_camera(result), False))
    if isinstance(result, RotationAxis):
        return (
            *_vector("axis direction", result.direction, result.direction_sigma_rad, ""),
            *_vector("axis point", result.point_mm, result.point_sigma_mm, "mm"),
        )
    if isinstance(result, HandEye):
        turn = DEGREES * result.flange_from_camera.rotation_vector
        return (
            *_vector("camera on the flange, rotation", turn, DEGREES * result.rotation_sigma_rad, "°"),
            *_vector("camera on the flange, place", result.flange_from_camera.translation_mm, result.translation_sigma_mm, "mm"),
        )
    if isinstance(result, LinearGuide):
        scale = Estimate("guide scale", result.scale, result.scale_sigma, "")
        return (*_vector("guide direction", result.direction, result.direction_sigma_rad, ""), scale)
    return tuple(one for part in (result.cameras, result.hand_eye, result.guide, result.axis) for one in estimates_of(part))


def _camera(camera: CameraCalibration, is_reference: bool) -> Iterable[Estimate]:
    matrix, distortion = camera.pinhole.matrix, camera.pinhole.distortion
    values = [matrix[0, 0], matrix[1, 1], matrix[0, 2], matrix[1, 2], *distortion]
    for name, value, unit in zip(intrinsic_names(len(distortion)), values, ["px"] * 4 + [""] * len(distortion), strict=True):
        yield Estimate(f"{camera.name} {name}", float(value), camera.standard_deviations.get(name, 0.0), unit)
    if is_reference:
        return
    place = [*camera.reference_from_camera.rotation_vector, *camera.reference_from_camera.translation_mm]
    for name, value in zip(POSE_NAMES, place, strict=True):
        factor, unit = (DEGREES, "°") if name.endswith("_rad") else (1.0, "mm")
        sigma = factor * camera.standard_deviations.get(name, 0.0)
        yield Estimate(f"{camera.name} {name.rpartition('_')[0].replace('_', ' ')}", factor * float(value), sigma, unit)


def _vector(name: str, values: FloatArray, sigma: float, unit: str) -> Iterable[Estimate]:
    return (Estimate(f"{name} {axis}", float(value), sigma, unit) for axis, value in zip("xyz", values, strict=True))
