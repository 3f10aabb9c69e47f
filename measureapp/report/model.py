"""The report model, from which all documents are written."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from measureapp.data.dimension import Dimension, Verdict
from measureapp.data.measurement import Measurement


@dataclass(frozen=True, slots=True)
class Fact:
    """One line "name: value" of a report."""

    name: str
    value: str


@dataclass(frozen=True, slots=True)
class Section:
    """Facts under a heading."""

    title: str
    facts: tuple[Fact, ...]


@dataclass(frozen=True, slots=True)
class ViewLine:
    """Quality and registration of one view."""

    viewpoint_id: str
    points: int
    noise_mm: float
    completeness: float
    outlier_ratio: float
    distortion_mm: float
    correction_mm: float | None  # None: the view was not registered
    correction_deg: float | None
    residual_mm: float | None
    overlap: float | None
    bound_mm: float | None
    sigma_mm: float | None
    unconstrained_motions: tuple[str, ...]
    used: bool
    verdict: str


@dataclass(frozen=True, slots=True)
class Picture:
    """A picture of the part as PNG."""

    caption: str
    png: bytes


@dataclass(frozen=True, slots=True)
class DeviationSummary:
    """Deviation of the cloud from the nominal, prepared for display."""

    alignment: str
    figures_mm: Mapping[str, float]  # mean, rms, p95, min, max
    unmeasured_share: float
    limit_mm: float  # the colour scale ranges from -limit to +limit
    histogram: tuple[float, ...]  # share of the points in equal bins over the scale; the outer bins include all beyond
    picture: Picture


@dataclass(frozen=True, slots=True, eq=False)
class ReportModel:
    """Contents of a report, independent of the output format."""

    measurement: Measurement
    title: str
    software: str
    verdict: Verdict | None  # None: there are no dimensions
    summary: str  # the verdict in words
    verdict_rule: str
    dimensions: tuple[Dimension, ...]
    views: tuple[ViewLine, ...]
    header: tuple[Fact, ...]
    sections: tuple[Section, ...]  # alignment and cloud, calibration, settings
    pictures: tuple[Picture, ...]
    deviation: DeviationSummary | None
