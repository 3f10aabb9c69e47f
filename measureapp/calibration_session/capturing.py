"""Views of the board taken by a rig, each stored in a session before the next one begins."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from measureapp.acquire.engine import Engine
from measureapp.acquire.events import AcquisitionEvent, ImageTaken, ViewpointRetaken
from measureapp.acquire.motion import checked
from measureapp.acquire.task import Task
from measureapp.acquire.tasks.board import BoardTask
from measureapp.acquire.tasks.board_fringes import BoardFringesTask
from measureapp.arrays import ImageArray
from measureapp.calibrate.cameras.projector_sightings import PROJECTOR
from measureapp.calibration_session.observation import CollectedObservation
from measureapp.calibration_session.session import CalibrationSession
from measureapp.data.board import BoardView
from measureapp.data.fringe import FringeStack
from measureapp.data.pattern_sets import BOTH_DIRECTIONS, make_pattern_sets
from measureapp.data.plan import Viewpoint
from measureapp.devices.rig import Rig
from measureapp.errors import DeviceError
from measureapp.fringe.patterns.draw import pattern_images
from measureapp.planning.collision.build import PartSolid
from measureapp.progress import Progress

OnImage = Callable[[str, str, ImageArray], None]  # viewpoint, camera or projector, newest image
OnView = Callable[[str, CollectedObservation], None]  # viewpoint and what was stored of it


def capture_views(
    rig: Rig, viewpoints: Sequence[Viewpoint], session: CalibrationSession, on_image: OnImage, on_view: OnView, progress: Progress
) -> None:
    """Take the board from these viewpoints one after the other, under fringes where the kind of calibration needs them.

    Raises
    ------
    DeviceError
        From the rig, or viewpoints failed, with the reason of each; what was taken is stored.
    """

    def receive(event: AcquisitionEvent) -> None:
        if isinstance(event, ImageTaken):
            on_image(event.viewpoint_id, event.camera, event.pixels)
        elif isinstance(event, ViewpointRetaken):
            progress.report(0, 1, f"{event.viewpoint_id} is taken again. {event.reason}")

    rig = checked(rig, PartSolid.board_on_stand())
    name = f"calibration: {session.setup.kind.name}"
    if session.setup.kind.uses_fringes:
        failed = Engine(rig).run(name, viewpoints, _fringe_task(rig, session, on_image, on_view), receive, progress)
    else:
        failed = Engine(rig).run(name, viewpoints, _plain_task(session, on_view), receive, progress)
    session.identify_parts()
    if failed:
        raise DeviceError(f"{len(failed)} of {len(viewpoints)} viewpoints failed: {' '.join(failure.reason for failure in failed)}")


def _plain_task(session: CalibrationSession, on_view: OnView) -> Task[BoardView]:
    """One plain image of each camera."""

    def keep(view: BoardView) -> None:
        warm = None if view.conditions is None else view.conditions.temperature_c
        names = dict.fromkeys(view.images, view.viewpoint_id)
        on_view(view.viewpoint_id, session.add(view.images, view.readback, names, warm))

    return BoardTask(keep)


def _fringe_task(rig: Rig, session: CalibrationSession, on_image: OnImage, on_view: OnView) -> Task[FringeStack]:
    """Fringes of both directions."""
    size_px = rig.projector.width_px, rig.projector.height_px
    patterns = make_pattern_sets(*size_px)[BOTH_DIRECTIONS]
    shown = pattern_images(patterns, *size_px)

    def keep(stack: FringeStack) -> None:
        on_image(stack.viewpoint_id, PROJECTOR, shown[0])
        names = dict.fromkeys(session.setup.seeing, stack.viewpoint_id)
        on_view(stack.viewpoint_id, session.add_fringes(stack, names=names))

    return BoardFringesTask(patterns, shown, keep)
