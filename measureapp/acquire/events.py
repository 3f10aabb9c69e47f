"""Events of acquisition; `RunEnded` is always sent and always the last event of a run."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from measureapp.arrays import ImageArray


@dataclass(frozen=True, slots=True)
class RunStarted:
    """The rig is taken hold of and the first move begins."""

    plan: str
    viewpoint_ids: tuple[str, ...]


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
class ViewpointRetaken:
    """The images of a viewpoint were refused, with the reason; they are taken again."""

    viewpoint_id: str
    reason: str


@dataclass(frozen=True, slots=True)
class ViewpointStored:
    """Everything taken from a viewpoint is stored completely."""

    viewpoint_id: str
    seconds: float


@dataclass(frozen=True, slots=True)
class ViewpointFailed:
    """A viewpoint failed, with the reason; the run continues with the next one if that is safe."""

    viewpoint_id: str
    reason: str


@dataclass(frozen=True, slots=True)
class RunEnded:
    """The run ended; always the last event. After anything but "done" all devices were stopped."""

    reason: Literal["done", "cancelled", "failed"]
    message: str = ""


AcquisitionEvent = RunStarted | ViewpointStarted | ImageTaken | ViewpointRetaken | ViewpointStored | ViewpointFailed | RunEnded
