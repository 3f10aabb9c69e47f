"""The report model, from which all documents are written."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from measureapp.data.deviation_scale import DeviationScale
from measureapp.data.dimension import Dimension, Verdict
from measureapp.data.identification import Identification
from measureapp.data.measurement import Measurement
from measureapp.data.plan import ScanPlan
from measureapp.inspection.surface.colour_scale import ColourScale
from measureapp.inspection.surface.deviation import Deviation
from measureapp.inspection.surface.statistics import DeviationStatistics
from measureapp.language.languages import ENGLISH
from measureapp.report.template import Template


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
class Flag:
    """A label on a leader line; places are shares of the picture's width and height, from its top left."""

    at: tuple[float, float]
    text: tuple[str, ...]  # one line each
    colour: str
    further: tuple[tuple[float, float], ...] = ()  # other places that belong to it


@dataclass(frozen=True, slots=True)
class Picture:
    """A picture of the part as PNG, and flags on it."""

    caption: str
    png: bytes
    flags: tuple[Flag, ...] = ()


@dataclass(frozen=True, slots=True)
class DimensionPicture:
    """The picture of one dimension that does not pass."""

    name: str
    picture: Picture


@dataclass(frozen=True, slots=True)
class Pictures:
    """All pictures of a report that are drawn from points and surfaces."""

    part: tuple[Picture, ...] = ()
    failing: tuple[DimensionPicture, ...] = ()
    deviation: tuple[Picture, ...] = ()
    cross_sections: tuple[Picture, ...] = ()


@dataclass(frozen=True, slots=True)
class PlanLine:
    """A viewpoint as it was taken: its pose read back, and the exposures of its stored images."""

    viewpoint_id: str
    table_deg: float
    guide_mm: float
    flange_mm: tuple[float, float, float]  # in the robot base
    exposures_us: tuple[int, ...]
    as_planned: bool | None  # whether the exposures are those of the plan; None: there is no plan


@dataclass(frozen=True, slots=True, eq=False)
class DeviationSummary:
    """Deviation of the cloud from the nominal, prepared for display."""

    alignment: str
    statistics: DeviationStatistics  # the numbers of the window's legend
    scale: ColourScale  # of the maps, the sections and the 3-D view
    histogram: tuple[float, ...]  # share of the points in equal bins over the scale; the outer bins include all beyond
    pictures: tuple[Picture, ...] = ()


@dataclass(frozen=True, slots=True)
class Details:
    """What a report states besides the measurement."""

    identification: Identification = field(default_factory=Identification)
    template: Template = field(default_factory=Template)
    plan: ScanPlan | None = None
    exposures_us: Mapping[str, tuple[int, ...]] = field(default_factory=dict)  # by viewpoint, of its stored images
    created_at: str = ""  # ISO 8601; empty: now
    part_program: str = ""  # name, revision and release; empty: none
    deviation_scale: DeviationScale = field(default_factory=DeviationScale)  # of the inspection program
    language: str = ENGLISH  # of the documents that people read: PDF, HTML, XLSX


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
    details: Details = field(default_factory=Details)
    failing: tuple[DimensionPicture, ...] = ()
    cross_sections: tuple[Picture, ...] = ()
    plan_lines: tuple[PlanLine, ...] = ()
    compared: Deviation | None = None  # all points, for the 3-D view
