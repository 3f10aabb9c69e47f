"""Heads with any cameras and a projector with a lens, and what their cameras decode of a surface."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import tau

import numpy as np
from scipy.spatial.transform import Rotation

from measureapp.arrays import FloatArray
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration, ProjectorCalibration
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform
from tests.reconstruct.conftest import DISTORTION, Surface

PITCH_PX = 32.0
SIGMA_RAD = 0.012
PROJECTOR_DISTORTION = np.array([-0.12, 0.09, 8e-4, -6e-4, 0.02])
Pose = tuple[tuple[float, float, float], tuple[float, float, float]]  # place in the head, mm; angles XYZ, degrees
HEAD: dict[str, Pose] = {"left": ((-175, 0, 0), (0, 17.6, 0)), "right": ((175, 0, 0), (0, -17.6, 0)), "upper": ((0, -200, 0), (-20, 0, 0))}


def projector_lens(width: int = 1024, height: int = 768, distortion: FloatArray = PROJECTOR_DISTORTION) -> PinholeCamera:
    focal = 1609.0 * width / 1024
    return PinholeCamera(width, height, np.array([[focal, 0, width / 2 + 4], [0, focal, height / 2 - 3], [0, 0, 1]]), distortion)


def head_pose(pose: Pose, name: str) -> RigidTransform:
    return RigidTransform.from_parts(Rotation.from_euler("XYZ", pose[1], degrees=True).as_matrix(), pose[0], "head", name)


def printed(points: FloatArray) -> FloatArray:
    """Grey levels (N,) of a print that goes through the part like the grain of wood."""
    random = np.random.default_rng(11)
    waves = random.normal(0, tau / 25, (12, 3))
    return np.asarray(102 * (1 + 0.04 * np.sin(points @ waves.T + random.uniform(0, tau, 12)).sum(axis=1)))


@dataclass(frozen=True)
class ProjectorHead:
    """Surfaces are given in the frame of the head, in which the projector stands at `projector_pose`."""

    cameras: CameraArrayCalibration
    head_from_reference: RigidTransform

    @property
    def projector(self) -> ProjectorCalibration:
        assert self.cameras.projector is not None
        return self.cameras.projector

    def without_projector(self) -> CameraArrayCalibration:
        return replace(self.cameras, projector=None)

    def phase_maps(
        self,
        surface: Surface,
        noise_seed: int | None = None,
        across: bool = False,
        origin_rad: float = 0.0,
        sigma_rad: float = SIGMA_RAD,
        print_on_part: bool = False,
    ) -> dict[str, PhaseMap]:
        generator = None if noise_seed is None else np.random.default_rng(noise_seed)
        return {
            name: self._phase_map(camera, surface, generator, across, origin_rad, sigma_rad, print_on_part)
            for name, camera in self.cameras.cameras.items()
        }

    def depth_mm(self, name: str, surface: Surface) -> FloatArray:
        """The true depth (H, W) in the camera's frame."""
        points, _ = self._seen(self.cameras.cameras[name], surface)
        camera = self.cameras.cameras[name]
        in_camera = (camera.reference_from_camera.inverse() @ self.head_from_reference.inverse()).apply(points)
        return np.asarray(in_camera[:, 2].reshape(camera.pinhole.height_px, camera.pinhole.width_px))

    def _seen(self, camera: CameraCalibration, surface: Surface) -> tuple[FloatArray, FloatArray]:
        y, x = np.mgrid[0 : camera.pinhole.height_px, 0 : camera.pinhole.width_px]
        head_from_camera = self.head_from_reference @ camera.reference_from_camera
        rays = head_from_camera.rotate(camera.pinhole.rays(np.column_stack([x.ravel(), y.ravel()]).astype(float)))
        origin = head_from_camera.translation_mm
        distance = surface(origin, rays)
        seen = np.isfinite(distance)
        return origin + rays * np.where(seen, distance, 500.0)[:, None], seen

    def _phase_map(
        self,
        camera: CameraCalibration,
        surface: Surface,
        generator: np.random.Generator | None,
        across: bool,
        origin_rad: float,
        sigma_rad: float,
        print_on_part: bool,
    ) -> PhaseMap:
        points, seen = self._seen(camera, surface)
        head_from_projector = self.head_from_reference @ self.projector.reference_from_projector
        light = head_from_projector.translation_mm
        reach = np.linalg.norm(points - light, axis=1)
        seen = seen & (np.abs(surface(light, (points - light) / reach[:, None]) - reach) < 1e-6)
        lens = self.projector.pinhole
        pixels = lens.project(head_from_projector.inverse().apply(points))
        seen &= (pixels > 0).all(axis=1) & (pixels[:, 0] < lens.width_px - 1) & (pixels[:, 1] < lens.height_px - 1)
        shape = (camera.pinhole.height_px, camera.pinhole.width_px)

        def of(axis: int, projector_px: int, other: PhaseMap | None) -> PhaseMap:
            phase = pixels[:, axis] * tau / PITCH_PX + origin_rad
            if generator is not None:
                phase = phase + generator.normal(0, sigma_rad, phase.shape)
            lit = seen.reshape(shape)
            return PhaseMap(
                camera=camera.name,
                viewpoint_id="v",
                phase_rad=np.where(lit, phase.reshape(shape), 0).astype(np.float32),
                sigma_rad=np.where(lit, sigma_rad, 0).astype(np.float32),
                modulation=np.where(lit, 80, 0).astype(np.float32),
                grey=printed(points).reshape(shape).astype(np.float32) if print_on_part else np.full(shape, 102, np.float32),
                state=np.where(lit, PixelState.VALID, PixelState.SHADOW).astype(np.uint8),
                exposure_index=np.zeros(shape, np.int8),
                pitch_px=PITCH_PX,
                projector_px=projector_px,
                details={"origin_rad": origin_rad},
                direction="horizontal" if axis else "vertical",
                orthogonal=other,
            )

        return of(0, lens.width_px, of(1, lens.height_px, None) if across else None)


def make_head(
    poses: Mapping[str, Pose] | None = None,
    projector_pose: Pose = ((0, 0, 0), (0, 0, 0)),
    binning: int = 12,
    lens: PinholeCamera | None = None,
) -> ProjectorHead:
    poses = HEAD if poses is None else poses
    width, height = 2592 // binning, 1944 // binning
    focal = 9000 / 2.2 / binning
    matrix = np.array([[focal, 0, (width - 1) / 2 + 3], [0, focal * 1.001, (height - 1) / 2 - 2], [0, 0, 1]])
    names = list(poses)
    reference = head_pose(poses[names[0]], names[0])
    to_camera = RigidTransform(reference.inverse().matrix, "camera", "head")
    cameras = {
        name: CameraCalibration(name, PinholeCamera(width, height, matrix, DISTORTION), to_camera @ head_pose(pose, name))
        for name, pose in poses.items()
    }
    projector = ProjectorCalibration(lens or projector_lens(), to_camera @ head_pose(projector_pose, "projector"))
    return ProjectorHead(CameraArrayCalibration(names[0], cameras, projector=projector), to_camera.inverse())


def wrong_sign(phase_map: PhaseMap, range_px: float) -> PhaseMap:
    """What heterodyne decoding makes of images with the wrong shift sign: every column is counted from the other end of its range."""
    mirrored = np.float32(range_px * tau / phase_map.pitch_px) - phase_map.phase_rad
    return replace(phase_map, phase_rad=np.where(phase_map.valid, mirrored, 0).astype(np.float32))
