"""What two views share no more than stray points of does not hold them."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.data.cloud import PointCloud
from measureapp.geometry.transform import RigidTransform, rotation_about
from measureapp.register.pairs.icp import PairMeasurement, measure_pair, register_pair
from measureapp.register.pairs.prepare import prepare

NOISE_MM, VOXEL_MM, OFF_MM = 0.008, 1.0, 0.04
SEEN = rotation_about([1, 0, 0], np.radians(40.0))
ALONG, ACROSS = SEEN[:, 0], SEEN[:, 1]  # the wall


def step(wall_noise_mm: float, rng: np.random.Generator, height_mm: float = 16, wall_tilt_rad: float = 0.01) -> PointCloud:
    """A plane 80 mm wide, 500 mm away and seen at 40°, and a wall beside it, whose points scatter along its normal and whose normals err."""
    u, v = (grid.ravel() for grid in np.meshgrid(np.arange(-40, 40, 0.5), np.arange(-40, 40, 0.5)))
    plane = np.column_stack([u, v, 500 + rng.normal(0, NOISE_MM, u.size)])
    u, w = (grid.ravel() for grid in np.meshgrid(np.arange(-40, 40, 0.5), np.arange(2, 2 + height_mm, 0.5)))
    wall = np.column_stack([u, 45 + rng.normal(0, wall_noise_mm, u.size), 500 - w])
    middle = np.array([0, 0, 500.0])
    points = (np.vstack([plane, wall]) - middle) @ SEEN.T + middle
    sizes = [len(plane), len(wall)]
    faces = np.repeat([[0.0, 0, -1], [0, -1, 0]], sizes, axis=0) @ SEEN.T
    normals = faces + np.repeat([[0.01], [wall_tilt_rad]], sizes, axis=0) * rng.normal(0, 1, faces.shape)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    count = len(points)
    return PointCloud(
        points, normals, np.full(count, NOISE_MM), np.full(count, 0.5), np.zeros((count, 2), np.int32), np.ones(count), "camera", "v"
    )


def start() -> RigidTransform:
    return RigidTransform.from_parts(np.eye(3), OFF_MM * ACROSS, "camera", "camera")


def across_the_wall(found: PairMeasurement) -> float:
    """Return what is known of a shift across the wall were all other motions known, 1/mm²."""
    return float(ACROSS @ found.information[:3, :3] @ ACROSS)


@pytest.mark.parametrize("seed", range(3))
def test_a_wall_holds_the_shift_across_it(seed: int) -> None:
    rng = np.random.default_rng(seed)
    a, b = (prepare(step(NOISE_MM, rng), VOXEL_MM) for _ in range(2))
    found = register_pair(a, b, start(), (0, 1), 3.0)
    shift = (found.target_from_source.apply(found.centre_mm) - found.centre_mm + found.change[:3]) @ ACROSS
    assert across_the_wall(found) > 0.005**-2
    assert abs(shift) < OFF_MM / 10


@pytest.mark.parametrize("seed", range(3))
def test_stray_points_of_a_wall_do_not(seed: int) -> None:
    rng = np.random.default_rng(seed)
    a, b = (prepare(step(12 * NOISE_MM, rng), VOXEL_MM) for _ in range(2))
    found = measure_pair(a, b, start(), (0, 1), 3.0)
    assert found.is_valid
    assert across_the_wall(found) < 0.1**-2
    assert np.linalg.matrix_rank(found.information) == 3  # the plane holds what it can


@pytest.mark.parametrize("seed", [0, 2, 9])
def test_nor_do_a_few_at_an_edge_whose_normals_err_more_than_expected(seed: int) -> None:
    rng = np.random.default_rng(seed)
    a, b = (prepare(step(7.5 * NOISE_MM, rng, 2, 0.05), VOXEL_MM) for _ in range(2))
    found = measure_pair(a, b, start(), (0, 1), 3.0)
    sideways = np.stack([ACROSS, ALONG])
    assert np.linalg.eigvalsh(sideways @ found.information[:3, :3] @ sideways.T)[-1] < 0.3**-2
    assert np.linalg.matrix_rank(found.information) == 3
