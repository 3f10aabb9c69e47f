"""Settings of the inspection, with their defaults."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from measureapp.data.model import Model

VerdictRule = Literal["iso-14253-1:2017", "guard-band", "simple"]


class AlignmentSettings(Model):
    """How measured points are laid onto a nominal mesh."""

    upright: bool = Field(default=True, description="try turning about z first: the part stands as drawn")
    coarse_points: int = Field(default=700, ge=50)
    fine_points: int = Field(default=20_000, ge=100)
    iterations: int = Field(default=60, ge=1)
    least_overlap: float = Field(default=0.6, ge=0, le=1, description="share of the points that must lie near the nominal")
    near_share: float = Field(default=0.01, gt=0, description="'near' in the overlap, as a share of the nominal's diagonal")
    normals_within_deg: float = Field(default=60.0, gt=0, le=180)
    told_apart_mm: float = Field(
        default=0.01, ge=0, description="positions of a part that repeats about an axis differ when one fits worse by more than this (rms)"
    )


class UncertaintySettings(Model):
    """What is known of errors that the scatter of the points does not show; standard uncertainties, k = 1."""

    correlation_mm: float = Field(default=8.0, gt=0, description="points closer than this may share their errors")
    placement_mm: float = Field(default=0.010, ge=0, description="of a single view after stitching")
    systematic_mm: float = Field(default=0.006, ge=0, description="of the calibration, the same for every length")
    systematic_relative: float = Field(default=4e-5, ge=0, description="of the calibration's scale, per length")
    scale_ppm: float = Field(
        default=0.0, ge=0, description="of the lengths of the calibration board, and of the part by its temperature; 0: exact"
    )


class InspectionSettings(Model):
    """Everything an inspection can be told."""

    alignment: AlignmentSettings = AlignmentSettings()
    uncertainty: UncertaintySettings = UncertaintySettings()
    verdict_rule: VerdictRule = "iso-14253-1:2017"
    least_points: int = Field(default=30, ge=6, description="fewer points than this do not make a feature")
    trim_sigma: float = Field(default=3.5, gt=1, description="points farther from the fit than this many robust σ are left out")
    parallel_within_deg: float = Field(default=3.0, gt=0)
    form_cell_mm: float = Field(default=5.0, gt=0, description="form is taken over the means of cells of this size")
    least_turn: float = Field(default=0.75, gt=0, le=1, description="share of the turn that must be measured for roundness and run-out")
    blade_points: int = Field(
        default=6_000, ge=500, description="a blade section is taken from at most this many of its points, evenly chosen"
    )
    blade_trials: int = Field(default=30, ge=10, description="repetitions with simulated noise from which the uncertainty of a blade comes")
    form_trials: int = Field(default=80, ge=20, description="simulated measurements from which the uncertainty of a form value comes")
    radius_trials: int = Field(default=400, ge=100, description="repetitions with simulated noise of the radius of a small piece")
    fit_points: int = Field(default=30_000, ge=1000, description="a feature is fitted to at most this many of its points, evenly chosen")
