"""Settings of registration, merging, and acceptance of clouds."""

from __future__ import annotations

from pydantic import Field

from measureapp.data.model import Model


class StitchSettings(Model):
    """Parameters of registration and merging. The priors are standard deviations of the kinematic positions, per view."""

    fine: bool = Field(default=True, description="register the views; otherwise they stay at their kinematic positions")
    pose_sigma_mm: float = Field(default=0.5, gt=0, description="standard deviation of a station's position")
    pose_sigma_deg: float = Field(default=0.05, gt=0, description="standard deviation of a station's orientation")
    table_sigma_mm: float = Field(default=0.03, gt=0, description="standard deviation between views of one station, by the table")
    table_sigma_deg: float = Field(default=0.006, gt=0, description="the same for orientations")
    weak_sigma_mm: float = Field(default=0.1, gt=0, description="motions the surface determines worse than this are listed")
    bound_sigmas: float = Field(default=3.0, gt=0, description="a view is excluded when its correction exceeds this many deviations")
    registration_voxel_mm: float | None = Field(default=None, gt=0, description="voxel for registration; None: from the point spacing")
    search_mm: float = Field(default=3.0, gt=0, description="largest distance of corresponding points at the start")
    least_overlap: float = Field(default=0.05, gt=0, lt=1, description="least overlap of a pair, as a share of the smaller view's surface")
    neighbours: int = Field(default=8, ge=1, description="pairs per view")
    rounds: int = Field(default=3, ge=1, le=20, description="joint refinements after pairwise registration")
    merge_voxel_mm: float | None = Field(default=None, gt=0, description="voxel of the merged points; None: from the point spacing")
    island_mm2: float = Field(default=15.0, ge=0, description="isolated patches smaller than this are removed")


class QualitySettings(Model):
    """Acceptance limits of a view's cloud for registration (methods sheet, section 8).

    The limits exclude clouds that would spoil a measurement to 0.1 mm. Density: about one point per registration voxel. Noise and
    distortion may slightly exceed 0.1 mm: merging averages noise, and edges of the part with coarse points resemble distortion of
    0.05 mm. A view with less than a twentieth of its visible surface, or with more outliers than wrong fringe orders cause at weak
    contrast, was disturbed.
    """

    least_points: int = Field(default=500, ge=1)
    least_density_per_mm2: float = Field(default=0.3, ge=0)
    largest_noise_mm: float = Field(default=0.15, gt=0)
    largest_outlier_ratio: float = Field(default=0.08, ge=0, le=1)
    largest_distortion_mm: float = Field(default=0.15, gt=0, description="waves of a smooth surface, as wrong phases cause them")
    least_completeness: float = Field(default=0.05, ge=0, le=1)
    plane_radius_mm: float = Field(default=1.5, gt=0, description="radius of the local planes for noise")
