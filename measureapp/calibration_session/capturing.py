"""Views of the board taken by a rig, each stored in a session before the next one begins."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from measureapp.acquire.board_fringes import capture_board_fringes
from measureapp.acquire.capture import capture_board
from measureapp.acquire.events import Event, ImageTaken
from measureapp.arrays import ImageArray
from measureapp.calibrate.cameras.projector_sightings import PROJECTOR
from measureapp.calibration_session.observation import CollectedObservation
from measureapp.calibration_session.session import CalibrationSession
from measureapp.data.pattern_sets import BOTH_DIRECTIONS, make_pattern_sets
from measureapp.data.plan import Viewpoint
from measureapp.devices.rig import Rig
from measureapp.fringe.patterns.draw import pattern_images
from measureapp.progress import PartOf, Progress

OnImage = Callable[[str, str, ImageArray], None]  # viewpoint, camera or projector, newest image
_TakeOne = Callable[[Viewpoint, Progress], CollectedObservation]


def capture_views(
    rig: Rig, viewpoints: Sequence[Viewpoint], session: CalibrationSession, on_image: OnImage, progress: Progress
) -> Iterator[tuple[Viewpoint, CollectedObservation]]:
    """Take the board from these viewpoints one after the other, under fringes where the kind of calibration needs them.

    Raises
    ------
    DeviceError
        From the rig; what was taken before is stored.
    """
    rig.place_on_table("board")
    take_one = _fringe_capture(rig, session, on_image) if session.setup.kind.uses_fringes else _plain_capture(rig, session, on_image)
    for done, viewpoint in enumerate(viewpoints):
        progress.report(done, len(viewpoints), f"Taking {viewpoint.id}")
        yield viewpoint, take_one(viewpoint, PartOf(progress, done / len(viewpoints), (done + 1) / len(viewpoints)))
    session.identify_parts()


def _plain_capture(rig: Rig, session: CalibrationSession, on_image: OnImage) -> _TakeOne:
    """One plain image of each camera."""

    def take_one(viewpoint: Viewpoint, progress: Progress) -> CollectedObservation:
        view = capture_board(rig, viewpoint)
        for camera, pixels in view.images.items():
            on_image(viewpoint.id, camera, pixels)
        progress.report(0.5, 1, f"Detecting the board in {viewpoint.id}")
        warm = None if view.conditions is None else view.conditions.temperature_c
        return session.add(view.images, view.readback, dict.fromkeys(view.images, viewpoint.id), warm)

    return take_one


def _fringe_capture(rig: Rig, session: CalibrationSession, on_image: OnImage) -> _TakeOne:
    """Fringes of both directions, which are loaded into the projector once."""
    size_px = rig.projector.width_px, rig.projector.height_px
    patterns = make_pattern_sets(*size_px)[BOTH_DIRECTIONS]
    shown = pattern_images(patterns, *size_px)
    rig.projector.load(shown)

    def take_one(viewpoint: Viewpoint, progress: Progress) -> CollectedObservation:
        def happened(event: Event) -> None:
            if isinstance(event, ImageTaken):
                on_image(viewpoint.id, event.camera, event.pixels)
                on_image(viewpoint.id, PROJECTOR, shown[0])

        stack = capture_board_fringes(rig, viewpoint, patterns, happened, PartOf(progress, 0.0, 0.6))
        names = dict.fromkeys(session.setup.seeing, viewpoint.id)
        return session.add_fringes(stack, names=names, progress=PartOf(progress, 0.6, 1.0))

    return take_one
