"""Clouds are asked for their unit where another brings them together, and not for lying side by side."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.data.cloud import PointCloud
from measureapp.errors import RegistrationError
from measureapp.geometry.transform import RigidTransform, rotation_about
from measureapp.register.clouds.units import check_unit

STANDOFF_MM, HALF_MM = 500.0, 30.0


def seen(unit_mm: float) -> PointCloud:
    """A square patch before the camera, in a unit of so many millimetres."""
    x, y = np.meshgrid(np.linspace(-HALF_MM, HALF_MM, 9), np.linspace(-HALF_MM, HALF_MM, 9))
    points = np.column_stack([x.ravel(), y.ravel(), np.full(x.size, STANDOFF_MM)]) / unit_mm
    count = len(points)
    normals = np.tile([0.0, 0, -1], (count, 1))
    return PointCloud(
        points, normals, np.full(count, 0.01), np.full(count, 0.5), np.zeros((count, 2), np.int32), np.ones(count), "camera", "v"
    )


def around() -> list[RigidTransform]:
    """Cameras that look at the part's middle from all sides."""
    still = RigidTransform.from_parts(np.column_stack([[0, 1, 0], [0, 0, -1], [-1, 0, 0]]), [STANDOFF_MM, 0, 0], "part", "camera")
    turns = [rotation_about([0, 0, 1], np.radians(angle)) for angle in (0, 60, 120, 180, 240, 300)]
    return [RigidTransform.from_parts(turn, np.zeros(3), "part", "part") @ still for turn in turns]


@pytest.mark.parametrize(("unit_mm", "word"), [(1000.0, "metres"), (25.4, "inches")])
def test_clouds_that_overlap_in_another_unit_require_a_unit(unit_mm: float, word: str) -> None:
    with pytest.raises(RegistrationError, match=f"read as {word}"):
        check_unit([seen(unit_mm)] * 6, around())


def test_clouds_that_overlap_in_millimetres_require_no_unit() -> None:
    check_unit([seen(1.0)] * 6, around())


@pytest.mark.parametrize("lean_deg", [0.0, 2.0])
def test_clouds_far_apart_require_no_unit(lean_deg: float) -> None:
    poses = [
        RigidTransform.from_parts(rotation_about([0, 1, 0], np.radians(lean_deg * np.sign(shift))), [float(shift), 0, 0], "part", "camera")
        for shift in (-1500, -900, -300, 300, 900, 1500)
    ]
    check_unit([seen(1.0)] * 6, poses)


def test_clouds_of_the_inside_or_outside_of_a_wide_part_require_no_unit() -> None:
    for distance_mm in (2000.0, -2000.0):
        moved = [pose @ RigidTransform.from_parts(np.eye(3), [0, 0, distance_mm], "camera", "camera") for pose in around()]
        check_unit([seen(1.0)] * 6, moved)
