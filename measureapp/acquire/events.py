"""Events of the engine and the pipeline; `RunEnded` is always the last event of a run and always sent."""

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
    """The exposures were chosen from a probe of the scene."""

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
    """The stack of a viewpoint is stored completely."""

    viewpoint_id: str
    seconds: float


@dataclass(frozen=True, slots=True)
class ViewpointFailed:
    """A viewpoint failed, with the reason; the run continues with the next one if that is safe."""

    viewpoint_id: str
    reason: str


@dataclass(frozen=True, slots=True, eq=False)
class CalibrationReady:
    """The rig is calibrated."""

    calibration: RigCalibration


@dataclass(frozen=True, slots=True, eq=False)
class ViewReady:
    """The cloud of a viewpoint was computed."""

    view: ViewResult


@dataclass(frozen=True, slots=True, eq=False)
class StitchReady:
    """All clouds were stitched."""

    stitched: StitchedCloud


@dataclass(frozen=True, slots=True)
class SurfaceFailed:
    """No surface could be computed; points and dimensions do not need it."""

    reason: str
    remedy: str


@dataclass(frozen=True, slots=True, eq=False)
class InspectionReady:
    """The dimensions were evaluated."""

    inspection: Inspection


@dataclass(frozen=True, slots=True)
class ValidityKnown:
    """Validity of the calibration: its age and temperature before the first move, its drift too after the last image."""

    validity: Validity


@dataclass(frozen=True, slots=True)
class RunEnded:
    """The run ended; always the last event."""

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
