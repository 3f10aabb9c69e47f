"""The values of a calibration one by one, beside those of another and, on the virtual rig, beside the true ones."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import degrees
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration, HandEye, LinearGuide, RigCalibration, RotationAxis

LENS_WORDS = {"fx": "Focal length x", "fy": "Focal length y", "cx": "Image centre x", "cy": "Image centre y"}
TURN, SHIFT = ("rotation_x_rad", "rotation_y_rad", "rotation_z_rad"), ("x_mm", "y_mm", "z_mm")


@dataclass(frozen=True)
class Quantity:
    """One estimated value with its standard deviation; None where that is unknown."""

    group: str
    name: str
    unit: str
    digits: int
    value: float
    sigma: float | None = None


@dataclass(frozen=True)
class ValueRow:
    """A quantity beside its true and its earlier value, where they are known."""

    quantity: Quantity
    true: float | None = None
    previous: float | None = None


def rows_beside(found: tuple[Quantity, ...], truth: tuple[Quantity, ...], previous: tuple[Quantity, ...]) -> tuple[ValueRow, ...]:
    """Return one row per quantity found; others are matched by group and name."""
    true, before = _by_name(truth), _by_name(previous)
    return tuple(ValueRow(one, true.get((one.group, one.name)), before.get((one.group, one.name))) for one in found)


def _by_name(quantities: tuple[Quantity, ...]) -> dict[tuple[str, str], float]:
    return {(one.group, one.name): one.value for one in quantities}


def camera_quantities(cameras: CameraArrayCalibration) -> tuple[Quantity, ...]:
    """Return lens and place of every camera, the reference first."""
    return tuple(one for name in cameras.names for one in _camera(cameras.cameras[name], name == cameras.reference))


def _camera(camera: CameraCalibration, is_reference: bool) -> list[Quantity]:
    from measureapp.calibrate.projection import intrinsic_names

    group, lens, sigma = f"Camera {camera.name}", camera.pinhole, camera.standard_deviations
    names = intrinsic_names(len(lens.distortion))
    values = (lens.matrix[0, 0], lens.matrix[1, 1], lens.matrix[0, 2], lens.matrix[1, 2], *lens.distortion)
    rows = [
        Quantity(
            group,
            LENS_WORDS.get(name, f"Distortion {name}"),
            "px" if name in LENS_WORDS else "",
            2 if name in LENS_WORDS else 5,
            float(value),
            sigma.get(name),
        )
        for name, value in zip(names, values, strict=True)
    ]
    place = camera.reference_from_camera
    return rows if is_reference else rows + _pose(group, place.translation_mm, place.rotation_vector, sigma)


def _pose(group: str, shift_mm: np.ndarray, turn_rad: np.ndarray, sigma: Mapping[str, float]) -> list[Quantity]:
    moved = [
        Quantity(group, f"Position {key[0]}", "mm", 3, float(value), sigma.get(key)) for key, value in zip(SHIFT, shift_mm, strict=True)
    ]
    return moved + [
        Quantity(group, f"Rotation {key[9]}", "°", 4, degrees(value), degrees(sigma[key]) if key in sigma else None)
        for key, value in zip(TURN, turn_rad, strict=True)
    ]


def hand_eye_quantities(found: HandEye) -> tuple[Quantity, ...]:
    """Return where the reference camera sits on the flange."""
    place = found.flange_from_camera
    sigma = dict.fromkeys(SHIFT, found.translation_sigma_mm) | dict.fromkeys(TURN, found.rotation_sigma_rad)
    return tuple(_pose("Hand–eye", place.translation_mm, place.rotation_vector, sigma))


def guide_quantities(found: LinearGuide) -> tuple[Quantity, ...]:
    """Return direction and scale of the linear guide."""
    spread = found.direction_sigma_rad
    directions = [
        Quantity("Linear guide", f"Direction {axis}", "", 6, float(found.direction[k]), spread) for k, axis in ((0, "x"), (2, "z"))
    ]
    return (*directions, Quantity("Linear guide", "Scale", "", 6, found.scale, found.scale_sigma))


def axis_quantities(found: RotationAxis, height_mm: float) -> tuple[Quantity, ...]:
    """Return the table's axis: its direction, and where it passes the height ``height_mm`` of its frame."""
    point = found.point_mm + found.direction * (height_mm - found.point_mm[2]) / found.direction[2]
    places = [
        Quantity("Table axis", f"Position {axis}", "mm", 3, float(point[k]), found.point_sigma_mm) for k, axis in ((0, "x"), (1, "y"))
    ]
    spread = found.direction_sigma_rad
    turns = [Quantity("Table axis", f"Direction {axis}", "", 6, float(found.direction[k]), spread) for k, axis in ((0, "x"), (1, "y"))]
    return (*places, *turns)


def rig_quantities(found: RigCalibration, height_mm: float) -> tuple[Quantity, ...]:
    """Return everything that a calibrated rig consists of; ``height_mm`` as for the axis."""
    return (
        *hand_eye_quantities(found.hand_eye),
        *guide_quantities(found.guide),
        *axis_quantities(found.axis, height_mm),
        *camera_quantities(found.cameras),
    )
