"""One 3-D view without its window: scene, furniture, and what the user does with them."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from PySide6.QtCore import QObject, QPoint, QPointF, QTimer, Signal
from PySide6.QtGui import QPainter

from ui.look.language.words import tr
from ui.look.wording import counted
from ui.viewport.clip_box import ClipBox
from ui.viewport.overlay.camera_view import CameraView
from ui.viewport.overlay.furniture import Furniture
from ui.viewport.overlay.legend import Legend
from ui.viewport.overlay.style import OverlayStyle
from ui.viewport.pick import Pick
from ui.viewport.scene import Scene
from ui.viewport.standard_views import STANDARD_VIEWS

REST_MS = 180
MANY_POINTS = 300_000  # from which on it is said how many of them are shown
CLIPPED = "Clipped"


class Stage(QObject):
    """Scene and furniture of one view; places are in logical pixels from the top left corner."""

    refreshWanted = Signal()  # the scene has changed
    paintWanted = Signal()  # only what is painted over it
    restReached = Signal()
    legendEdited = Signal(object)  # Legend
    flagMoved = Signal(str, object)  # key, middle of the box as fractions of the picture
    flagChosen = Signal(str)
    clipChanged = Signal(object)  # ClipBox
    clicked = Signal(object)  # Pick
    menuAsked = Signal(object, QPoint)  # Pick, place on the screen
    legendMenuAsked = Signal(QPoint)
    numberAsked = Signal(str, QPoint)  # handle of the legend whose number is to be typed

    def __init__(self, style: OverlayStyle, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.scene, self.furniture, self.style = Scene(), Furniture(), style
        self.width, self.height = 1.0, 1.0  # logical pixels
        self.box_zoom: tuple[QPointF, QPointF] | None = None  # corners of the rectangle being drawn
        self._rest = QTimer(self)
        self._rest.setSingleShot(True)
        self._rest.setInterval(REST_MS)
        self._rest.timeout.connect(self.come_to_rest)
        self.places_hidden: Callable[[np.ndarray], set[int]] = lambda _places: set()  # set by the window

    @property
    def is_resting(self) -> bool:
        """Whether the camera neither moves nor has moved just now."""
        return not self.scene.is_moving and not self._rest.isActive()

    def resize(self, width: float, height: float) -> None:
        """Take the size of the window."""
        if (width, height) != (self.width, self.height):
            self.width, self.height = max(width, 1.0), max(height, 1.0)
            self.furniture.forget_places()

    def fit_room(self) -> None:
        """Tell the camera which part of the picture the furniture leaves free."""
        self.scene.camera.free = free_fractions(self.furniture, self.width, self.height, self.style)

    def camera_view(self) -> CameraView:
        """Return the camera for the painter."""
        return self.scene.camera.view(self.width, self.height)

    def paint(self, painter: QPainter) -> None:
        """Paint everything over the picture."""
        self.furniture.paint(painter, self.camera_view(), self.style)

    def paint_handles(self, painter: QPainter) -> None:
        """Paint what belongs to a gesture and to the window only: rectangle, centre of rotation, handles of the clip box."""
        from ui.viewport.overlay.handles import paint_box_zoom, paint_centre, paint_clip_handles

        camera = self.camera_view()
        if self.box_zoom is not None:
            paint_box_zoom(painter, *self.box_zoom, self.style)
        if self.scene.is_moving and self.scene.camera.centre_mm is not None:
            paint_centre(painter, camera, self.scene.camera.centre_mm, self.style)
        if self.scene.clip is not None and self.scene.clip.is_on:
            paint_clip_handles(painter, camera, self.scene.clip, self.style)

    def say_progress(self, *, counting: bool = True) -> None:
        """State how many of many points are shown, unless they are not to be counted."""
        scene, total = self.scene, len(self.scene.cloud)
        shown = scene.moving_count if scene.is_moving else scene.picture_points
        if scene.is_moving and not shown and total > MANY_POINTS:
            self.furniture.progress = "Simplified while turning"
        else:
            self.furniture.progress = shown_words(shown, total) if counting and total > MANY_POINTS and shown < total else ""

    def begin_move(self) -> None:
        """Draw what there is time for, until the camera rests."""
        self._rest.start()
        self.scene.camera.keep_framed = False
        self.scene.set_moving(True)
        self.furniture.moving = True

    def hold(self) -> None:
        """Keep moving while a button is pressed."""
        self._rest.stop()

    def end_move(self) -> None:
        """Come to rest soon."""
        if self.scene.is_moving:
            self._rest.start()

    def come_to_rest(self) -> None:
        """Draw everything."""
        self._rest.stop()
        self.scene.set_moving(False)
        self.furniture.moving = False
        self.refreshWanted.emit()
        self.restReached.emit()

    def picture_ready(self) -> None:
        """Find which flags are hidden, when a picture is complete."""
        flags = self.furniture.flags
        if flags and not self.scene.is_moving:
            hidden = self.places_hidden(np.array([flag.anchor_mm for flag in flags], float))
            if hidden != set(self.furniture.hidden):
                self.furniture.hidden = hidden
                self.paintWanted.emit()

    def steer(self, step: Callable[[], None]) -> None:
        """Move the camera by a step and draw."""
        self.begin_move()
        step()
        self.refreshWanted.emit()

    def look_from(self, name: str) -> None:
        """Show a standard view of everything."""
        self.scene.camera.open_from(*STANDARD_VIEWS[name])
        self.furniture.forget_places()
        self.refreshWanted.emit()

    def fit(self) -> None:
        """Show everything, from where the camera is."""
        camera = self.scene.camera
        camera.open_from(tuple(camera.axes[2]), tuple(camera.axes[1]))
        self.refreshWanted.emit()

    def set_parallel(self, parallel: bool) -> None:
        """Change the projection."""
        self.scene.camera.set_parallel(parallel)
        self.refreshWanted.emit()

    def set_centre(self, pick: Pick) -> None:
        """Turn about this place from now on; about the middle of the picture if nothing is there."""
        self.scene.camera.centre_mm = pick.position_mm

    def set_clip(self, clip: ClipBox | None) -> None:
        """Clip by this box."""
        self.scene.set_clip(clip)
        self.furniture.notices = (CLIPPED,) if clip is not None and clip.is_on else ()
        self.refreshWanted.emit()

    def edit_legend(self, legend: Legend, *, done: bool = True) -> None:
        """Show an edited legend; when ``done``, announce it."""
        self.furniture.legend = legend
        self.paintWanted.emit()
        if done:
            self.legendEdited.emit(legend)

    def set_style(self, style: OverlayStyle) -> None:
        """Use other colours."""
        self.style = style
        self.paintWanted.emit()


def free_fractions(furniture: Furniture, width: float, height: float, style: OverlayStyle) -> tuple[float, float, float, float]:
    """Return the room that furniture leaves in a picture: left, bottom, width and height as fractions."""
    left, top, wide, high = furniture.free(CameraView(np.eye(4), np.eye(3), width, height), style)
    return left / width, 1.0 - (top + high) / height, wide / width, high / height


def shown_words(shown: int, total: int) -> str:
    """Return how many points are shown, in words.

    >>> shown_words(600_000, 12_800_000)
    'Showing 0.6 of 12.8 million points'
    """
    if total >= 1_000_000:
        return tr("Showing {value:.1f} of {value_2:.1f} million points", value=shown / 1e6, value_2=total / 1e6)
    return tr("Showing {shown} of {total} points", shown=counted(shown), total=counted(total))
