"""The values of a calibration by name, each with its standard deviation: the rows of a table of results."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.cameras.projector import as_camera
from measureapp.calibrate.cameras.uncertainty import POSE_NAMES
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

Calibrated = CameraArrayCalibration | ProjectorCalibration | RotationAxis | HandEye | LinearGuide | RigCalibration
DEGREES = float(np.rad2deg(1.0))
LENS_LABELS = {"fx": "Focal length x", "fy": "Focal length y", "cx": "Image centre x", "cy": "Image centre y"}
DISTORTION = re.compile(r"[kps]\d")


@dataclass(frozen=True, slots=True)
class Estimate:
    """One value of a calibration."""

    name: str  # unique within a calibration
    value: float
    sigma: float  # standard deviation; 0 where none is stated
    unit: str  # "px", "°", "mm" or "" for a pure number
    group: str = ""  # heading under which a table shows it
    label: str = ""  # its name below that heading


def camera_estimates(cameras: CameraArrayCalibration) -> tuple[Estimate, ...]:
    """Return lens and pose of every camera, the reference first."""
    return tuple(one for name in cameras.names for one in _lens(cameras.cameras[name], f"Camera {name}", name == cameras.reference))


def projector_estimates(projector: ProjectorCalibration) -> tuple[Estimate, ...]:
    """Return lens and pose of the projector."""
    return tuple(_lens(as_camera(projector), "Projector", False))


def axis_estimates(axis: RotationAxis) -> tuple[Estimate, ...]:
    """Return direction and point of the rotation axis."""
    return (
        *_vector("axis direction", "Table axis", "Direction", axis.direction, axis.direction_sigma_rad, ""),
        *_vector("axis point", "Table axis", "Position", axis.point_mm, axis.point_sigma_mm, "mm"),
    )


def hand_eye_estimates(hand_eye: HandEye) -> tuple[Estimate, ...]:
    """Return rotation and position of the reference camera on the flange."""
    pose, group = hand_eye.flange_from_camera, "Hand–eye"
    turn = DEGREES * pose.rotation_vector
    return (
        *_vector("camera on the flange, rotation", group, "Rotation", turn, DEGREES * hand_eye.rotation_sigma_rad, "°"),
        *_vector("camera on the flange, place", group, "Position", pose.translation_mm, hand_eye.translation_sigma_mm, "mm"),
    )


def guide_estimates(guide: LinearGuide) -> tuple[Estimate, ...]:
    """Return direction and scale of the linear guide."""
    group = "Linear guide"
    scale = Estimate("guide scale", guide.scale, guide.scale_sigma, "", group, "Scale")
    return (*_vector("guide direction", group, "Direction", guide.direction, guide.direction_sigma_rad, ""), scale)


def _lens(camera: CameraCalibration, group: str, is_reference: bool) -> Iterator[Estimate]:
    matrix, distortion, sigmas = camera.pinhole.matrix, camera.pinhole.distortion, camera.standard_deviations
    values = [matrix[0, 0], matrix[1, 1], matrix[0, 2], matrix[1, 2], *distortion]
    for name, value, unit in zip(intrinsic_names(len(distortion)), values, ["px"] * 4 + [""] * len(distortion), strict=True):
        label = LENS_LABELS.get(name) or (f"Distortion {name}" if DISTORTION.fullmatch(name) else name)
        yield Estimate(f"{camera.name} {name}", float(value), sigmas.get(name, 0.0), unit, group, label)
    if is_reference:
        return
    place = [*camera.reference_from_camera.rotation_vector, *camera.reference_from_camera.translation_mm]
    for name, value in zip(POSE_NAMES, place, strict=True):
        factor, unit = (DEGREES, "°") if name.endswith("_rad") else (1.0, "mm")
        short = name.rpartition("_")[0].replace("_", " ")
        label = short.capitalize() if unit == "°" else f"Position {short}"
        yield Estimate(f"{camera.name} {short}", factor * float(value), factor * sigmas.get(name, 0.0), unit, group, label)


def _vector(name: str, group: str, label: str, values: FloatArray, sigma: float, unit: str) -> Iterator[Estimate]:
    for axis, value in zip("xyz", values, strict=True):
        yield Estimate(f"{name} {axis}", float(value), sigma, unit, group, f"{label} {axis}")
