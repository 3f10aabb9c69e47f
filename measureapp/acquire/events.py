"""Events of acquisition; `RunEnded` is always sent and always the last event of a run."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from measureapp.acquire.run_states import ViewpointState
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


@dataclass(frozen=True, slots=True)
class ViewpointEntered:
    """A viewpoint entered a state; every transition is sent, in order."""

    viewpoint_id: str
    state: ViewpointState


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
class ViewpointSkipped:
    """A viewpoint was skipped by the user: its images are not stored; those stored before, if any, remain."""

    viewpoint_id: str


@dataclass(frozen=True, slots=True)
class ViewpointQueued:
    """A viewpoint was put at the end of the run: a user wants it taken again, or it failed and is tried once more."""

    viewpoint_id: str
    reason: str


@dataclass(frozen=True, slots=True)
class RunPaused:
    """The run is paused: the projector is dark and nothing moves. Sent again when the cause changes."""

    message: str
    hint: str  # what to do or to press


@dataclass(frozen=True, slots=True)
class RunResumed:
    """The run goes on after a pause."""


@dataclass(frozen=True, slots=True)
class RunEnded:
    """The run ended; always the last event. After anything but "done" all devices were stopped.

    The message of a run that did not finish says the reason, what is kept, and how to go on.
    """

    reason: Literal["done", "cancelled", "failed"]
    message: str = ""
    stored: tuple[str, ...] = ()  # ids of the viewpoints that are stored
    kept: str = ""  # the end of the message: what is kept, what is missing, how to go on; empty where nothing is missing


AcquisitionEvent = (
    RunStarted
    | ViewpointStarted
    | ViewpointEntered
    | ImageTaken
    | ViewpointRetaken
    | ViewpointStored
    | ViewpointFailed
    | ViewpointSkipped
    | ViewpointQueued
    | RunPaused
    | RunResumed
    | RunEnded
)
