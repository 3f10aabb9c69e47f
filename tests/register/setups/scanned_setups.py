"""Set-ups of a part: true surfaces that stand on the table one way or another, sampled by ray casting with stated noise."""

from __future__ import annotations

from typing import Any

import numpy as np

from measureapp.geometry.transform import RigidTransform, rotation_about
from measureapp.register.settings import StitchSettings
from measureapp.register.setups.setup_cloud import SetUpCloud
from measureapp.register.stitch import stitch
from tests.register.conftest import STANDOFF_MM, _look_at, box, seen

NOISE_MM = 0.03
STEP_MM = 1.0


def bracket() -> Any:
    """A block without any symmetry, 120 mm wide, with a step, a wall and a slanted rib; it can stand on its foot or on its head."""
    import trimesh

    rib = box((60, 10, 12), (0, 0, 0))
    rib.apply_transform(RigidTransform.from_parts(rotation_about([0, 0.2, 1], 0.6), [18, -22, 44], "part", "part").matrix)
    roof = box((90, 60, 40), (0, 0, 0))  # slanted faces, which are visible from above and from below
    roof.apply_transform(RigidTransform.from_parts(rotation_about([0.3, 1, 0], 0.6), [-20, 0, 30], "part", "part").matrix)
    parts = [box((120, 80, 30), (0, 0, 15)), roof, box((14, 40, 40), (48, 12, 50)), rib]
    return trimesh.util.concatenate([part.subdivide_to_size(20) for part in parts])


def drum(radius_mm: float = 50.0) -> Any:
    """A rotationally symmetric part."""
    import trimesh

    parts = [
        trimesh.creation.cylinder(radius_mm, 40, sections=180),
        trimesh.creation.cylinder(radius_mm * 0.7, 70, sections=180),
    ]
    whole = trimesh.util.concatenate(parts)
    whole.apply_translation([0, 0, 25])
    return whole


def put(mesh: Any, turn_deg: tuple[float, float, float], shift_mm: tuple[float, float] = (0.0, 0.0)) -> tuple[Any, RigidTransform]:
    """Return the mesh as it stands on the table after rotations about x, y and z, and part_from_nominal."""
    rotation = np.eye(3)
    for axis, angle in zip(np.eye(3), turn_deg, strict=True):
        rotation = rotation_about(axis, np.radians(angle)) @ rotation
    turned = np.asarray(mesh.vertices) @ rotation.T
    low, high = turned.min(axis=0), turned.max(axis=0)
    shift = [shift_mm[0] - (low[0] + high[0]) / 2, shift_mm[1] - (low[1] + high[1]) / 2, -low[2]]
    pose = RigidTransform.from_parts(rotation, shift, "part", "nominal")
    moved = mesh.copy()
    moved.apply_transform(pose.matrix)
    return moved, pose


def set_up(
    name: str,
    mesh: Any,
    seed: int,
    *,
    elevations_deg: tuple[float, ...] = (20.0, 55.0),
    angles: int = 4,
    noise_mm: float = NOISE_MM,
    step_mm: float = STEP_MM,
) -> SetUpCloud:
    """Scan a mesh that stands on the table, from all sides, at exactly known poses: the part frame has no error."""
    import open3d as o3d

    rng = np.random.default_rng([seed, 17])
    scene = o3d.t.geometry.RaycastingScene()
    scene.add_triangles(o3d.core.Tensor(np.asarray(mesh.vertices, np.float32)), o3d.core.Tensor(np.asarray(mesh.faces, np.uint32)))
    clouds, poses = [], []
    for station, elevation in enumerate(elevations_deg):
        for number in range(angles):
            turn = rotation_about([0, 0, 1], -2 * np.pi * (number + station / 2) / angles)
            part_from_guide = RigidTransform.from_parts(turn, np.zeros(3), "part", "guide")
            poses.append(part_from_guide @ _look_at(np.radians(elevation), STANDOFF_MM))
            clouds.append(seen(scene, poses[-1], step_mm, noise_mm, rng, f"view{len(clouds):02d}"))
    stitched = stitch(clouds, poses, StitchSettings(fine=False))
    return SetUpCloud(name, stitched, tuple(clouds))
