"""Results of one measurement of one part, as shown in the window and the report."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from measureapp.data.calibration import RigCalibration
from measureapp.data.camera_shift import ShiftEvidence
from measureapp.data.cloud import CloudQuality, PointCloud, StitchedCloud
from measureapp.data.consistency import Consistency
from measureapp.data.dimension import Dimension
from measureapp.data.feature import Feature
from measureapp.data.fringe import AxisReadback
from measureapp.data.mesh import Mesh
from measureapp.data.setups import JoinedSetUp
from measureapp.data.validity import Validity
from measureapp.geometry.transform import RigidTransform


@dataclass(frozen=True, slots=True, eq=False)
class ViewResult:
    """Results of one viewpoint, from images to a placed cloud."""

    viewpoint_id: str
    cloud: PointCloud  # in frame "camera"
    quality: CloudQuality
    part_from_camera: RigidTransform  # kinematic pose
    decode: Mapping[str, Mapping[str, Any]]  # camera -> figures of decoding (JSON-ready)
    pairs: tuple[Mapping[str, Any], ...]  # figures of matching (JSON-ready)
    rejected: Mapping[str, int]  # reason -> count
    readback: AxisReadback
    timings_s: Mapping[str, float] = field(default_factory=dict)  # of a view processed during the scan: "last image to cloud"
    findings: tuple[str, ...] = ()  # suspected problems of the images or the calibration, in words
    shift: ShiftEvidence | None = None  # evidence of camera drift in its phases; None without evidence
    made_from: str = ""  # hash of everything the cloud was computed from, the rig's axes excepted; empty if unknown


@dataclass(frozen=True, slots=True, eq=False)
class Alignment:
    """Alignment of the measured part to its nominal; stated with every result."""

    name: str
    nominal_from_part: RigidTransform
    rms_mm: float
    overlap: float = 1.0  # share of the points near the nominal
    undetermined: tuple[str, ...] = ()  # motions the points do not determine: "translation along x", "rotation about z"
    residuals_mm: Mapping[str, float] = field(default_factory=dict)  # remaining deviation of each feature used, from its nominal position
    notes: tuple[str, ...] = ()  # further information, in sentences
    method: str = ""  # as in the program: "best-fit", "datums", …
    fixed: int = 6  # degrees of freedom that its features fix
    weakest_mm: float | None = None  # expanded uncertainty (k = 2) of the part's corner that its features locate worst
    weakest_direction: tuple[float, ...] = ()  # in which it is, unit, in the nominal's frame

    @property
    def for_comparison_only(self) -> bool:
        """Whether it minimises the deviations, so that it can hide a defect; it belongs to no datum of a drawing."""
        return self.method == "best-fit"


@dataclass(frozen=True, slots=True, eq=False)
class Inspection:
    """Features and dimensions of one inspection program."""

    program: str
    alignment: Alignment
    features: tuple[Feature, ...]  # in the nominal's frame
    dimensions: tuple[Dimension, ...]
    further: Mapping[str, Alignment] = field(default_factory=dict)  # alignments that single dimensions name
    lengths: tuple[str, ...] = ()  # where their scale comes from, at which temperature they hold: sentences


@dataclass(frozen=True, slots=True, eq=False)
class Measurement:
    """One measured part."""

    project: str
    part: str
    rig: str
    measured_at: str  # ISO 8601
    calibration: RigCalibration
    views: tuple[ViewResult, ...]
    stitched: StitchedCloud
    mesh: Mesh | None
    inspection: Inspection | None
    settings: Mapping[str, Any] = field(default_factory=dict)  # patterns, exposures, thresholds (JSON-ready)
    timings_s: Mapping[str, float] = field(default_factory=dict)
    validity: Validity = field(default_factory=Validity)  # of the calibration, for these images
    consistency: Consistency = field(default_factory=Consistency)  # with its error model
    stitched_from: str = ""  # hash of everything the stitched cloud was computed from; empty if unknown
    setups: tuple[JoinedSetUp, ...] = ()  # of a measurement that is joined from several; the calibration is that of the first one
