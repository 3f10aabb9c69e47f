"""Uncertainty maps of a camera calibration, in the images and over the working volume."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, IntArray, read_only

COVERAGE_FACTOR = 2.0  # expanded uncertainty, k = 2


@dataclass(frozen=True, slots=True, eq=False)
class ProjectionUncertainty:
    """Standard deviation of a projected point, over the image of one camera."""

    camera: str
    range_mm: float  # distance of the points from the camera
    x_px: FloatArray  # (W,), columns of the grid
    y_px: FloatArray  # (H,), rows of the grid
    sigma_px: FloatArray  # (H, W), in the direction in which it is largest
    total_sigma_px: FloatArray  # (H, W), of both directions together: the expected distance

    def __post_init__(self) -> None:
        object.__setattr__(self, "x_px", read_only(self.x_px, np.float64, (None,)))
        object.__setattr__(self, "y_px", read_only(self.y_px, np.float64, (None,)))
        shape = (len(self.y_px), len(self.x_px))
        object.__setattr__(self, "sigma_px", read_only(self.sigma_px, np.float64, shape))
        object.__setattr__(self, "total_sigma_px", read_only(self.total_sigma_px, np.float64, shape))


@dataclass(frozen=True, slots=True, eq=False)
class VolumeUncertainty:
    """Standard deviation of triangulated points over the working volume, in the reference camera's frame `camera`.

    The common rigid motion of the volume is removed: it changes no length.
    """

    points_mm: FloatArray  # (N, 3)
    covariance_mm2: FloatArray  # (N, 3, 3)
    cameras_seeing: IntArray  # (N,), number of cameras with the point in their field of view
    length_mm: float  # length for which the next two are stated
    length_sigma_mm: float  # root mean square over all directions and positions in the volume
    worst_length_sigma_mm: float
    worst_length_at_mm: FloatArray  # (2, 3), ends of the worst length

    def __post_init__(self) -> None:
        object.__setattr__(self, "points_mm", read_only(self.points_mm, np.float64, (None, 3)))
        object.__setattr__(self, "covariance_mm2", read_only(self.covariance_mm2, np.float64, (len(self.points_mm), 3, 3)))
        object.__setattr__(self, "cameras_seeing", read_only(self.cameras_seeing, np.int64, (len(self.points_mm),)))
        object.__setattr__(self, "worst_length_at_mm", read_only(self.worst_length_at_mm, np.float64, (2, 3)))

    @property
    def sigma_mm(self) -> FloatArray:
        """Standard deviation (N,) of a point's position, all three directions combined."""
        return np.asarray(np.sqrt(np.trace(self.covariance_mm2, axis1=1, axis2=2)))

    @property
    def shape_rms_mm(self) -> float:
        """Expected root mean square of the points' errors after the best rigid fit."""
        return float(np.sqrt(np.mean(self.sigma_mm**2)))


@dataclass(frozen=True, slots=True, eq=False)
class UncertaintyMap:
    """Uncertainty of a camera calibration, in pixels over the images and in millimetres over the working volume."""

    projection: Mapping[str, ProjectionUncertainty]  # by camera
    volume: VolumeUncertainty | None  # None with a single camera, which measures no points

    @property
    def sentence(self) -> str:
        """Its contribution to the uncertainty of a measured length, in words."""
        if self.volume is None:
            worst = max(one.sigma_px.max() for one in self.projection.values())
            return f"Uncertainty of projected points by the calibration: up to {COVERAGE_FACTOR * worst:.3f} px (k = 2)."
        volume = self.volume
        return (
            f"The camera calibration contributes {COVERAGE_FACTOR * volume.length_sigma_mm:.4f} mm (k = 2) to the uncertainty of "
            f"a length of {volume.length_mm:.0f} mm in this volume, {COVERAGE_FACTOR * volume.worst_length_sigma_mm:.4f} mm at worst."
        )
