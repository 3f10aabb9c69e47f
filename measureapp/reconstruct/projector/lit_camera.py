"""One camera and a calibrated projector that measure together."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import BoolArray, FloatArray
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration, ProjectorCalibration
from measureapp.data.cloud import PROJECTOR_BIT, PointCloud
from measureapp.data.phase import PhaseMap
from measureapp.errors import ReconstructError
from measureapp.reconstruct.blur import correct_blur
from measureapp.reconstruct.cleaning.clean import CleanDepth, Partner, clean
from measureapp.reconstruct.cleaning.uncertainty_limit import uncertainty_limit_mm
from measureapp.reconstruct.discontinuities import exclude_discontinuities
from measureapp.reconstruct.part_blur import with_blur_of_part
from measureapp.reconstruct.projector.depth import ProjectorDepth, triangulate_with_projector
from measureapp.reconstruct.rectification.rectifier import Rectifier
from measureapp.reconstruct.settings import ReconstructSettings

MAX_RELATIVE_SIGMA = 3.0  # of a point, relative to the median


@dataclass(frozen=True, slots=True, eq=False)
class LitCamera:
    """The phases of one camera, its calibration and that of the projector."""

    phase_map: PhaseMap
    camera: CameraCalibration
    projector: ProjectorCalibration
    number: int  # of the camera among those of the calibration
    rays: FloatArray  # (H, W, 2) float32, see `Rectifier.rays`
    settings: ReconstructSettings

    @classmethod
    def of(
        cls,
        phase_map: PhaseMap,
        cameras: CameraArrayCalibration,
        settings: ReconstructSettings | None = None,
        rectifier: Rectifier | None = None,
    ) -> LitCamera:
        """Exclude discontinuities and correct blur of a phase map, and find its calibrations.

        Parameters
        ----------
        settings : None for the defaults
        rectifier : of ``cameras``, to share its rays; None: a new one

        Raises
        ------
        ReconstructError
            The projector or the camera is not calibrated.
        """
        if cameras.projector is None:
            raise ReconstructError("The projector is not calibrated.", "Give cameras.json a projector, or use two cameras.")
        name = phase_map.camera
        if name not in cameras.cameras:
            raise ReconstructError(
                f"Camera {name!r} is not in the calibration of {', '.join(cameras.names)}.",
                "Use the calibration of the cameras that took the images.",
            )
        rays, settings = (rectifier or Rectifier(cameras)).rays(name), settings or ReconstructSettings()
        seeing = with_blur_of_part({name: phase_map}, cameras)
        inner = exclude_discontinuities({name: phase_map}, seeing)
        corrected = correct_blur(inner, seeing, settings.max_phase_step_rad)[name]
        return cls(corrected, cameras.cameras[name], cameras.projector, cameras.names.index(name), rays, settings)

    def triangulate(self) -> ProjectorDepth:
        """Triangulate every pixel, see `triangulate_with_projector`. Raises ReconstructError for images of another size."""
        return triangulate_with_projector(self.phase_map, self.camera, self.projector, self.settings, self.rays)

    def clean(self, depth_mm: FloatArray, sigma_mm: FloatArray, of_projector: BoolArray) -> CleanDepth:
        """Clean a depth map (H, W) whose pixels ``of_projector`` (H, W) the projector took part in.

        A projector close to its camera measures depth less precisely than two cameras far apart: a point is too uncertain beyond three
        times the median, where that is more than the settings allow.
        """
        settings = self.settings.model_copy(update={"max_sigma_mm": self.max_sigma_mm(sigma_mm)})
        camera_from_reference = self.camera.reference_from_camera.inverse()
        centre = camera_from_reference.apply(np.array(self.projector.reference_from_projector.translation_mm))
        spacing = 1.0 / float(self.camera.pinhole.matrix[0, 0])
        return clean(depth_mm, sigma_mm, self.rays, spacing, [Partner(centre, of_projector)], settings)

    def max_sigma_mm(self, sigma_mm: FloatArray) -> float:
        """Return the standard deviation above which a point is too uncertain; ``sigma_mm`` (H, W) is 0 where there is none."""
        known = sigma_mm[sigma_mm > 0]
        least = MAX_RELATIVE_SIGMA * float(np.median(known)) if len(known) else 0.0
        return uncertainty_limit_mm(sigma_mm, self.phase_map.sigma_rad, self.settings, least)

    def make_cloud(self, cleaned: CleanDepth, sigma_mm: FloatArray, keep: BoolArray) -> PointCloud:
        """Return the pixels ``keep`` (H, W) of a cleaned depth map as a cloud in frame ``camera``, marked as the projector's."""
        reference_from_camera, phase_map = self.camera.reference_from_camera, self.phase_map
        flat = np.column_stack([self.rays[keep].astype(np.float64), np.ones(int(keep.sum()))])
        depth = cleaned.depth_mm[keep].astype(np.float64)
        return PointCloud(
            points_mm=reference_from_camera.apply(flat * depth[:, None]),
            normals=reference_from_camera.rotate(cleaned.normals[keep]),
            sigma_mm=sigma_mm[keep] * np.linalg.norm(flat, axis=1),
            grey=np.clip(phase_map.grey[keep] / phase_map.saturation, 0.0, 1.0),
            pixel=np.argwhere(keep),
            cameras=np.full(len(flat), (1 << self.number) | PROJECTOR_BIT, np.uint8),
            frame="camera",
            viewpoint_id=phase_map.viewpoint_id,
        )
