"""Settings of the inspection, with their defaults."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from measureapp.data.model import Model
from measureapp.data.part_temperature import PartTemperature

VerdictRule = Literal["iso-14253-1:2017", "guard-band", "simple"]


class AlignmentSettings(Model):
    """Parameters of the best fit to a nominal mesh."""

    upright: bool = Field(default=True, description="try rotations about z first: the part is upright as in its nominal")
    coarse_points: int = Field(default=700, ge=50)
    fine_points: int = Field(default=20_000, ge=100)
    iterations: int = Field(default=60, ge=1)
    least_overlap: float = Field(default=0.6, ge=0, le=1, description="least share of the points near the nominal")
    near_share: float = Field(default=0.01, gt=0, description="limit of 'near', as a share of the nominal's diagonal")
    normals_within_deg: float = Field(default=60.0, gt=0, le=180)
    told_apart_mm: float = Field(
        default=0.01, ge=0, description="positions of a cyclic part are distinguishable if their fits differ by more than this (rms)"
    )


class UncertaintySettings(Model):
    """Standard uncertainties (k = 1) of errors that the scatter of the points does not show."""

    correlation_mm: float = Field(default=8.0, gt=0, description="correlation length of the errors of points")
    placement_mm: float = Field(default=0.010, ge=0, description="of the position of a single view after registration")
    systematic_mm: float = Field(default=0.006, ge=0, description="of the calibration, constant part of a length")
    systematic_relative: float = Field(default=4e-5, ge=0, description="of the calibration, proportional part of a length")
    scale_ppm: float = Field(default=0.0, ge=0, description="of the length scale: calibration board; 0: exact")
    scale_source: str = Field(default="calibration board", description="where `scale_ppm` comes from, in words")


class InspectionSettings(Model):
    """Parameters of an inspection."""

    alignment: AlignmentSettings = AlignmentSettings()
    uncertainty: UncertaintySettings = UncertaintySettings()
    temperature: PartTemperature | None = Field(default=None, description="of the part; none: lengths are those at its temperature")
    verdict_rule: VerdictRule = "iso-14253-1:2017"
    least_points: int = Field(default=30, ge=6, description="least number of points of a feature")
    trim_sigma: float = Field(default=3.5, gt=1, description="points further from the fit than this many robust σ are rejected")
    parallel_within_deg: float = Field(default=3.0, gt=0)
    form_cell_mm: float = Field(default=5.0, gt=0, description="edge of the cells whose means are used for form")
    least_turn: float = Field(default=0.75, gt=0, le=1, description="least measured share of the circumference for roundness and run-out")
    blade_points: int = Field(default=6_000, ge=500, description="greatest number of points of a blade section, evenly chosen")
    blade_trials: int = Field(default=30, ge=10, description="Monte Carlo trials for the uncertainty of a blade")
    form_trials: int = Field(default=80, ge=20, description="Monte Carlo trials for the uncertainty of a form value")
    radius_trials: int = Field(default=400, ge=100, description="Monte Carlo trials for the radius of a small segment")
    fit_points: int = Field(default=30_000, ge=1000, description="greatest number of points of a fit, evenly chosen")
