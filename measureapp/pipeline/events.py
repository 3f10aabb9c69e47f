"""Events of processing: what was computed from the images of a scan. Those of acquisition are another family."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from measureapp.acquire.events import AcquisitionEvent
from measureapp.data.calibration import RigCalibration
from measureapp.data.cloud import StitchedCloud
from measureapp.data.measurement import Inspection, ViewResult
from measureapp.data.validity import Validity


@dataclass(frozen=True, slots=True)
class ExposuresChosen:
    """The exposures were chosen from a probe of the scene: for the whole plan, or for one viewpoint."""

    exposures_us: tuple[int, ...]
    decodable_share: float  # predicted, of the lit pixels
    planned_share: float  # predicted for the exposures of the plan
    note: str
    viewpoint_id: str | None = None


@dataclass(frozen=True, slots=True, eq=False)
class CalibrationReady:
    """The rig is calibrated."""

    calibration: RigCalibration
    objections: tuple[str, ...] = ()  # of a calibration that was solved now, such as marks of the board that are displaced


@dataclass(frozen=True, slots=True, eq=False)
class ViewReady:
    """The cloud of a viewpoint was computed."""

    view: ViewResult


@dataclass(frozen=True, slots=True)
class CloudsKept:
    """Clouds of former results are those that the stored images would give again."""

    count: int
    of: int  # viewpoints that are stored
    placed_anew: bool  # the axes are calibrated differently now, so that the clouds lie elsewhere on the part


@dataclass(frozen=True, slots=True)
class ResultKept:
    """A result is the former one, which would come out again."""

    what: Literal["calibration", "stitched"]  # the stitched cloud, and its surface


@dataclass(frozen=True, slots=True)
class MemoryShort:
    """The board is searched for in fewer images at a time than usual, so that the memory suffices."""

    threads: int
    usual: int
    needed_gib: float  # by as many as usual
    available_gib: float


@dataclass(frozen=True, slots=True)
class ViewFailed:
    """The stored images of a viewpoint yield no cloud, with the reason."""

    viewpoint_id: str
    reason: str
    damaged: bool = False  # they are not what was stored


@dataclass(frozen=True, slots=True)
class PartElsewhere:
    """The first cloud shows that the part is not where the plan assumes it, with what that means."""

    viewpoint_id: str
    sentence: str


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


ProcessingEvent = (
    ExposuresChosen
    | CalibrationReady
    | ViewReady
    | CloudsKept
    | ResultKept
    | MemoryShort
    | ViewFailed
    | PartElsewhere
    | StitchReady
    | SurfaceFailed
    | InspectionReady
    | ValidityKnown
)
Event = AcquisitionEvent | ProcessingEvent
