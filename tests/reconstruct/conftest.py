from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import tau

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from measureapp.arrays import FloatArray
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform

PITCH_PX, PROJECTOR_PX, PROJECTOR_FOCAL_PX = 32.0, 1024, 1609.0
DISTORTION = np.array([-0.08, 0.05, 2e-4, -3e-4, 0.0])
PLACES = {"left": ((-175, 0, 0), (0, 17.6, 0)), "right": ((175, 0, 0), (0, -17.6, 0)), "upper": ((0, -200, 0), (-20, 0, 0))}

Surface = Callable[
    [FloatArray, FloatArray], FloatArray
]  # origin (3,), rays (N, 3) in the head's frame -> distance along the ray, inf for none


def plane(z_mm: float, slope_x: float = 0.0, slope_y: float = 0.0) -> Surface:
    normal = np.array([-slope_x, -slope_y, 1.0])
    return lambda origin, rays: (z_mm - origin @ normal) / (rays @ normal)


def sphere(centre: tuple[float, float, float], radius: float) -> Surface:
    def hit(origin: FloatArray, rays: FloatArray) -> FloatArray:
        to = origin - np.array(centre)
        b = rays @ to
        root = b**2 - (to @ to - radius**2)
        return np.where(root > 0, -b - np.sqrt(np.maximum(root, 0)), np.inf)

    return hit


def nearest(*surfaces: Surface) -> Surface:
    return lambda origin, rays: np.min([surface(origin, rays) for surface in surfaces], axis=0)


@dataclass(frozen=True)
class Head:
    """The paper's three cameras, binned; the frame of its surfaces is the head's."""

    cameras: CameraArrayCalibration
    head_from_reference: RigidTransform

    def phase_maps(
        self, surface: Surface, sigma_rad: float = 1e-4, noise_seed: int | None = None, shadows: bool = True, horizontal: bool = False
    ) -> dict[str, PhaseMap]:
        """What every camera would decode of the surface; holes where the projector's light does not arrive."""
        random = None if noise_seed is None else np.random.default_rng(noise_seed)
        maps = {}
        for name, camera in self.cameras.cameras.items():
            maps[name] = self._phase_map(camera, surface, sigma_rad, random, shadows, 1 if horizontal else 0)
        return maps

    def _phase_map(
        self,
        camera: CameraCalibration,
        surface: Surface,
        sigma_rad: float,
        random: np.random.Generator | None,
        shadows: bool,
        axis: int = 0,
    ) -> PhaseMap:
        height, width = camera.pinhole.height_px, camera.pinhole.width_px
        y, x = np.mgrid[0:height, 0:width]
        head_from_camera = self.head_from_reference @ camera.reference_from_camera
        rays = head_from_camera.rotate(camera.pinhole.rays(np.column_stack([x.ravel(), y.ravel()]).astype(float)))
        origin = head_from_camera.translation_mm
        distance = surface(origin, rays)
        seen = np.isfinite(distance)
        points = origin + rays * np.where(seen, distance, 500.0)[:, None]
        if shadows:
            reach = np.linalg.norm(points, axis=1)
            seen &= np.abs(surface(np.zeros(3), points / reach[:, None]) - reach) < 1e-6
        column = PROJECTOR_FOCAL_PX * points[:, axis] / points[:, 2] + (PROJECTOR_PX - 1) / 2
        seen &= (column > 0) & (column < PROJECTOR_PX - 1)
        phase = column * tau / PITCH_PX
        if random is not None:
            phase = phase + random.normal(0, sigma_rad, phase.shape)
        shape = (height, width)
        lit = seen.reshape(shape)
        return PhaseMap(
            camera=camera.name,
            viewpoint_id="v",
            phase_rad=np.where(lit, phase.reshape(shape), 0).astype(np.float32),
            sigma_rad=np.where(lit, sigma_rad, 0).astype(np.float32),
            modulation=np.where(lit, 80, 0).astype(np.float32),
            grey=np.full(shape, 102, np.uint16),
            state=np.where(lit, PixelState.VALID, PixelState.SHADOW).astype(np.uint8),
            exposure_index=np.zeros(shape, np.int8),
            pitch_px=PITCH_PX,
            projector_px=PROJECTOR_PX,
        )


def make_head(binning: int, names: tuple[str, ...] = ("left", "right", "upper")) -> Head:
    width, height = 2592 // binning, 1944 // binning
    focal = 9000 / 2.2 / binning
    matrix = np.array([[focal, 0, (width - 1) / 2 + 3], [0, focal * 1.001, (height - 1) / 2 - 2], [0, 0, 1]])
    poses = {}
    for name in names:
        place, angles = PLACES[name]
        poses[name] = RigidTransform.from_parts(Rotation.from_euler("XYZ", angles, degrees=True).as_matrix(), place, "head", name)
    reference = poses[names[0]]
    to_camera = RigidTransform(reference.inverse().matrix, "camera", "head")
    cameras = {
        name: CameraCalibration(name, PinholeCamera(width, height, matrix, DISTORTION), to_camera @ pose) for name, pose in poses.items()
    }
    return Head(CameraArrayCalibration(names[0], cameras), to_camera.inverse())


@pytest.fixture(scope="session")
def head() -> Head:
    return make_head(8)
