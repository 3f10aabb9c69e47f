"""Settings of stitching and of the choice of clouds."""

from __future__ import annotations

from pydantic import Field

from measureapp.data.model import Model


class StitchSettings(Model):
    """How views are registered and merged. The priors are one standard deviation per view."""

    fine: bool = Field(default=True, description="register finely; otherwise the views stay where the axes say")
    pose_sigma_mm: float = Field(default=0.5, gt=0, description="how well the axes know a station's position")
    pose_sigma_deg: float = Field(default=0.05, gt=0, description="how well the axes know a station's direction")
    table_sigma_mm: float = Field(default=0.03, gt=0, description="how well views of one station fit each other by the table alone")
    table_sigma_deg: float = Field(default=0.006, gt=0, description="the same for directions")
    weak_sigma_mm: float = Field(default=0.1, gt=0, description="motions that the surface leaves open by more than this are named")
    bound_sigmas: float = Field(default=3.0, gt=0, description="a view moved further than this is left out")
    registration_voxel_mm: float | None = Field(default=None, gt=0, description="thinning for registration; None: from the point spacing")
    search_mm: float = Field(default=3.0, gt=0, description="furthest distance of corresponding points at the start")
    least_overlap: float = Field(default=0.05, gt=0, lt=1, description="share of a view's surface that a pair must have in common")
    neighbours: int = Field(default=8, ge=1, description="pairs per view")
    rounds: int = Field(default=3, ge=1, le=20, description="joint refinements after the pairwise registration")
    merge_voxel_mm: float | None = Field(default=None, gt=0, description="grid of the merged points; None: from the point spacing")
    island_mm2: float = Field(default=15.0, ge=0, description="connected patches smaller than this are dropped")


class QualitySettings(Model):
    """When a view's cloud may be stitched (methods sheet, section 8).

    The limits keep out what would spoil a measurement to 0.1 mm: a surface needs a point per voxel of registration in reach; noise may
    exceed that figure a little, since stitching averages it; so may waves, because the edges of a part look like waves of 0.05 mm where
    points are coarse; a view with less than a twentieth of what it should see, or more outliers than wrong fringe orders leave at weak
    contrast, was disturbed.
    """

    least_points: int = Field(default=500, ge=1)
    least_density_per_mm2: float = Field(default=0.3, ge=0)
    largest_noise_mm: float = Field(default=0.15, gt=0)
    largest_outlier_ratio: float = Field(default=0.08, ge=0, le=1)
    largest_distortion_mm: float = Field(default=0.15, gt=0, description="waves of a smooth surface, such as wrong phases leave")
    least_completeness: float = Field(default=0.05, ge=0, le=1)
    plane_radius_mm: float = Field(default=1.5, gt=0, description="radius of the local planes that noise is judged by")
