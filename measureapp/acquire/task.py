"""What the engine runs at a viewpoint."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol, TypeVar

from measureapp.acquire.events import AcquisitionEvent
from measureapp.acquire.session import RigSession
from measureapp.data.fringe import AxisReadback
from measureapp.progress import Progress

T = TypeVar("T")


@dataclass(frozen=True, slots=True, eq=False)
class Visit:
    """A stay at a viewpoint: its id, the confirmed read-back, the time at which robot and guide were sent there, exposures of its own."""

    viewpoint_id: str
    readback: AxisReadback
    approach: str | None = None
    exposures_us: tuple[int, ...] | None = None


class Task(Protocol[T]):
    """Takes something at every viewpoint of a run; the axes stand still meanwhile."""

    def prepare(self, session: RigSession) -> None:
        """Do what is needed once, before the first move."""

    def take(self, session: RigSession, visit: Visit, on_event: Callable[[AcquisitionEvent], None], progress: Progress) -> T:
        """Take the images.

        Raises
        ------
        FrameError
            They are damaged, and are to be taken again.
        DeviceError
            A device refused.
        """

    def check(self, result: T) -> None:
        """Check what was taken, after the axes were confirmed not to have moved. Raises FrameError where it is to be taken again."""

    def keep(self, result: T) -> None:
        """Accept what was checked. Raises StorageError where it cannot be stored; it is then called again with the same result."""

    def drop(self, viewpoint_id: str) -> None:
        """Forget what was passed on of a viewpoint that failed, or is taken again."""
