"""Parts seen by a camera: true surfaces, sampled by ray casting with stated noise, at poses known to be slightly wrong."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest

from measureapp.data.cloud import PointCloud
from measureapp.geometry.transform import RigidTransform, rotation_about

STANDOFF_MM = 450.0


@dataclass(frozen=True)
class Scan:
    """Clouds in their camera's frame, the true poses and the ones the axes tell."""

    clouds: list[PointCloud]
    truth: list[RigidTransform]
    kinematic: list[RigidTransform]
    stations: list[int]
    scene: Any

    def distances_mm(self, points_mm: np.ndarray) -> np.ndarray:
        """Distance of points in the part's frame from the true surface."""
        import open3d as o3d

        return self.scene.compute_distance(o3d.core.Tensor(points_mm.astype(np.float32))).numpy()


def box(size: tuple[float, float, float], centre: tuple[float, float, float]) -> Any:
    import trimesh

    return trimesh.creation.box(size, RigidTransform.from_parts(np.eye(3), centre, "part", "part").matrix)


def cross() -> Any:
    """A cross-shaped block 120 mm wide."""
    import trimesh

    return trimesh.util.concatenate([box((120, 40, 50), (0, 0, 25)), box((40, 120, 50), (0, 0, 25)), box((40, 40, 90), (0, 0, 45))])


def impeller(blades: int = 7) -> Any:
    """A hub with twisted blades 4 mm thick on a disc: rotationally symmetric but for a blade's pitch."""
    import trimesh

    parts = [trimesh.creation.cylinder(70, 8, sections=180), trimesh.creation.cylinder(20, 60, sections=120)]
    blade = trimesh.creation.box((48, 4, 40))
    blade = blade.subdivide_to_size(4)
    turn = (blade.vertices[:, 2] + 20) / 40 * 0.6
    twisted = blade.vertices.copy()
    twisted[:, 0] += 42
    x, y = twisted[:, 0].copy(), twisted[:, 1].copy()
    twisted[:, 0], twisted[:, 1] = x * np.cos(turn) - y * np.sin(turn), x * np.sin(turn) + y * np.cos(turn)
    twisted[:, 2] += 22
    for k in range(blades):
        turned = twisted @ rotation_about([0, 0, 1], 2 * np.pi * k / blades).T
        parts.append(trimesh.Trimesh(turned, blade.faces))
    return trimesh.util.concatenate(parts)


def _look_at(elevation: float, distance_mm: float) -> RigidTransform:
    """guide_from_camera of a camera that looks at the middle of the part from the side of +x."""
    target = np.array([0.0, 0.0, 25.0])
    position = target + distance_mm * np.array([np.cos(elevation), 0, np.sin(elevation)])
    z = (target - position) / np.linalg.norm(target - position)
    x = np.array([0.0, 1.0, 0.0])
    return RigidTransform.from_parts(np.column_stack([x, np.cross(z, x), z]), position, "guide", "camera")


def seen(scene: Any, part_from_camera: RigidTransform, step_mm: float, noise_mm: float, rng: np.random.Generator, name: str) -> PointCloud:
    """Cast one ray per pixel; what turns away by more than 75° is not seen, and normals err by 2°."""
    import open3d as o3d

    half = int(90 / step_mm)
    v, u = np.mgrid[-half : half + 1, -half : half + 1]
    rays = np.column_stack([u.ravel() * step_mm, v.ravel() * step_mm, np.full(u.size, STANDOFF_MM)])
    rays /= np.linalg.norm(rays, axis=1, keepdims=True)
    turned = part_from_camera.rotate(rays)
    origins = np.broadcast_to(part_from_camera.translation_mm, turned.shape)
    hits = scene.cast_rays(o3d.core.Tensor(np.hstack([origins, turned]).astype(np.float32)))
    distance, normals = hits["t_hit"].numpy().astype(float), hits["primitive_normals"].numpy().astype(float)
    seen = np.isfinite(distance) & (-np.einsum("ij,ij->i", normals, turned) > 0.26)
    points = rays[seen] * (distance[seen] + rng.normal(0, noise_mm, int(seen.sum())))[:, None]
    found = part_from_camera.inverse().rotate(normals[seen]) + rng.normal(0, 0.035, (int(seen.sum()), 3))
    found /= np.linalg.norm(found, axis=1, keepdims=True)
    count = len(points)
    pixel = np.column_stack([v.ravel(), u.ravel()])[seen] + half
    return PointCloud(points, found, np.full(count, noise_mm), np.full(count, 0.5), pixel, np.ones(count), "camera", name)


@pytest.fixture(scope="session")
def scanned() -> Callable[..., Scan]:
    """scanned(mesh, angles_deg, elevations_deg, …): one view per table angle and elevation (a station each)."""

    def scan(
        mesh: Any,
        angles_deg: list[float],
        elevations_deg: list[float],
        *,
        station_mm: float = 0.4,
        station_deg: float = 0.03,
        table_mm: float = 0.02,
        noise_mm: float = 0.04,
        step_mm: float = 0.45,
        seed: int = 1,
    ) -> Scan:
        import open3d as o3d

        rng = np.random.default_rng(seed)
        scene = o3d.t.geometry.RaycastingScene()
        scene.add_triangles(o3d.core.Tensor(np.asarray(mesh.vertices, np.float32)), o3d.core.Tensor(np.asarray(mesh.faces, np.uint32)))
        made = Scan([], [], [], [], scene)
        for station, elevation in enumerate(elevations_deg):
            guide_from_camera = _look_at(np.radians(elevation), STANDOFF_MM)
            wrong = _small(rng, station_mm, station_deg)
            for angle in angles_deg:
                part_from_guide = RigidTransform.from_parts(rotation_about([0, 0, 1], -np.radians(angle)), np.zeros(3), "part", "guide")
                truth = part_from_guide @ guide_from_camera
                made.clouds.append(seen(scene, truth, step_mm, noise_mm, rng, f"v{len(made.clouds):02d}"))
                made.truth.append(truth)
                made.kinematic.append(truth @ wrong @ _small(rng, table_mm, 0.002))
                made.stations.append(station)
        return made

    return scan


def _small(rng: np.random.Generator, shift_mm: float, turn_deg: float) -> RigidTransform:
    """An error whose shift and turn are as large as told, in a random direction."""
    shift, turn = rng.normal(size=3), rng.normal(size=3)
    shift *= shift_mm / np.linalg.norm(shift)
    turn *= np.radians(turn_deg) / np.linalg.norm(turn)
    return RigidTransform.from_vector(turn, shift, "camera", "camera")


@pytest.fixture(scope="session")
def cross_mesh() -> Any:
    return cross()


@pytest.fixture(scope="session")
def impeller_mesh() -> Any:
    return impeller()
