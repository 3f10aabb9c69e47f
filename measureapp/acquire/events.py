"""What the engine and the pipeline tell while they work. Views watch these; `RunEnded` is always the last of a run and always sent."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from measureapp.arrays import ImageArray
from measureapp.data.calibration import RigCalibration
from measureapp.data.cloud import StitchedCloud
from measureapp.data.measurement import Inspection, ViewResult
from measureapp.data.validity import Validity


@dataclass(frozen=True, slots=True)
class RunStarted:
    """The plan was checked and the first move begins."""

    plan: str
    viewpoint_ids: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class ExposuresChosen:
    """A probe of the scene has chosen the exposures."""

    exposures_us: tuple[int, ...]
    decodable_share: float  # predicted, of the lit pixels
    planned_share: float  # predicted for the exposures of the plan
    note: str


@dataclass(frozen=True, slots=True)
class ViewpointStarted:
    """The axes move to a viewpoint."""

    viewpoint_id: str


@dataclass(frozen=True, slots=True, eq=False)
class ImageTaken:
    """A preview of one image; sent for the first pattern of every exposure only."""

    viewpoint_id: str
    camera: str
    exposure_us: int
    pixels: ImageArray


@dataclass(frozen=True, slots=True)
class ViewpointStored:
    """The stack lies complete on disk."""

    viewpoint_id: str
    seconds: float


@dataclass(frozen=True, slots=True)
class ViewpointFailed:
    """A viewpoint gave nothing, and why; the run goes on with the next where that is safe."""

    viewpoint_id: str
    reason: str


@dataclass(frozen=True, slots=True, eq=False)
class CalibrationReady:
    """The rig is calibrated."""

    calibration: RigCalibration


@dataclass(frozen=True, slots=True, eq=False)
class ViewReady:
    """The stack of a viewpoint became a cloud."""

    view: ViewResult


@dataclass(frozen=True, slots=True, eq=False)
class StitchReady:
    """All views lie in one cloud."""

    stitched: StitchedCloud


@dataclass(frozen=True, slots=True)
class SurfaceFailed:
    """There is no surface; the points and the dimensions do without."""

    reason: str
    remedy: str


@dataclass(frozen=True, slots=True, eq=False)
class InspectionReady:
    """The dimensions are known."""

    inspection: Inspection


@dataclass(frozen=True, slots=True)
class ValidityKnown:
    """What is known about the calibration's validity: before the first move its age and temperature, after the last image its drift too."""

    validity: Validity


@dataclass(frozen=True, slots=True)
class RunEnded:
    """The last event."""

    reason: Literal["done", "cancelled", "failed"]
    message: str = ""


Event = (
    RunStarted
    | ExposuresChosen
    | ViewpointStarted
    | ImageTaken
    | ViewpointStored
    | ViewpointFailed
    | CalibrationReady
    | ViewReady
    | StitchReady
    | SurfaceFailed
    | InspectionReady
    | ValidityKnown
    | RunEnded
)
