"""Base of pages with a 3-D view: started when graphics are ready, drawn only while visible."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from datetime import date

from PySide6.QtCore import Qt, Slot
from PySide6.QtGui import QKeySequence, QResizeEvent, QShortcut, QShowEvent
from PySide6.QtWidgets import QSplitter, QWidget

from ui.controllers.controllers import Controllers
from ui.look.language.words import tr
from ui.look.look import Look
from ui.pages.clip_bar import ClipBar
from ui.pages.page import Page
from ui.session import Session
from ui.viewport.cloud_view import CloudView
from ui.viewport.layers import CloudLayer, Label, LineLayer, SurfaceLayer
from ui.viewport.point_index import PointIndex, index_points
from ui.viewport.prepared_surface import PreparedSurface, prepare_surface
from ui.viewport.shuffled_cloud import ShuffledCloud, shuffle
from ui.widgets.basic import Button
from ui.widgets.empty_state import EmptyState
from ui.workers.job import Job

ROOM_FOR_WORDS = 1150  # px
LEAST_PICTURE, LEAST_SIDE = 556, 384  # px, the page's margins included
LEAST_SPLIT, SPLITTER_PX = 440, 16


@dataclass(frozen=True, eq=False)
class Picture:
    """Content of the 3-D view."""

    clouds: tuple[CloudLayer, ...] = ()
    surface: SurfaceLayer | None = None
    lines: tuple[LineLayer, ...] | None = None  # None: those shown stay
    labels: tuple[Label, ...] | None = None
    proxy: SurfaceLayer | None = None  # shown in place of the clouds while the camera moves: the surface of the same part


@dataclass(frozen=True, eq=False)
class Prepared:
    """A picture ready to be shown: nothing of it takes long in the window's thread."""

    picture: Picture
    cloud: ShuffledCloud
    surface: PreparedSurface | None
    proxy: PreparedSurface | None


Composer = Callable[[Job], Picture]


class PictureSplitter(QSplitter):
    """A picture with a panel at its side, whose width stays when the window changes; the picture is never the narrower of both."""

    def __init__(self, side_width: int) -> None:
        super().__init__(Qt.Orientation.Horizontal)
        self._wanted = side_width
        self.splitterMoved.connect(self._follow)

    def setSizes(self, sizes: Sequence[int]) -> None:
        """Set both widths, those of a former window too."""
        self._wanted = sizes[1]
        super().setSizes(sizes)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Give the panel its width, as far as there is room for it."""
        room, side = self.width() - self.handleWidth(), self.widget(1)
        side.setMaximumWidth(max(side.minimumWidth(), room // 2))
        super().resizeEvent(event)
        width = max(side.minimumWidth(), min(self._wanted, side.maximumWidth()))
        super().setSizes([room - width, width])

    @Slot()
    def _follow(self) -> None:
        self._wanted = self.sizes()[1]


class ViewportPage(Page):
    """A page with a large 3-D view; a job composes the picture when the page is visible and something changed."""

    def __init__(self, look: Look, session: Session, controllers: Controllers, empty: EmptyState) -> None:
        super().__init__(look, session, controllers, empty)
        self.view = CloudView(look)
        self.view.corner = self._corner
        self.view.pictureFailed.connect(self._say_picture_failed)
        self.clip_bar = ClipBar(look, self.view, self)
        self.is_composing = False
        self._stale = True
        self._indexing: Job | None = None
        self._tool_buttons: tuple[Button, ...] = ()
        self.side: QWidget | None = None  # next to the picture; narrower if the page is narrow
        self.side_width = 0
        self._splitter: PictureSplitter | None = None
        QShortcut(QKeySequence.StandardKey.Undo, self, self.undo_last, context=Qt.ShortcutContext.WidgetWithChildrenShortcut)
        QShortcut(Qt.Key.Key_Escape, self, self._cancel, context=Qt.ShortcutContext.WidgetWithChildrenShortcut)
        session.graphicsChanged.connect(self._use_graphics)
        look.changed.connect(self.redraw)
        session.projectChanged.connect(self.view.hide_picture)
        self._use_graphics()

    @property
    def tool_buttons(self) -> tuple[Button, ...]:
        """The buttons above the picture; icons only if the page is narrow."""
        return self._tool_buttons

    @tool_buttons.setter
    def tool_buttons(self, buttons: tuple[Button, ...]) -> None:
        self._tool_buttons = buttons
        for button in buttons:
            button.allow_compact()

    def composer(self) -> Composer | None:
        """Return the function that composes the picture in a thread from immutable data; None if there is nothing to show."""
        raise TypeError(f"{type(self).__name__} does not draw")

    def undo_last(self) -> None:
        """Undo the last action on this page, if there is one."""

    def end_clicking(self) -> None:
        """End a special use of clicks; they select points again."""

    def _corner(self) -> tuple[str, ...]:
        """Return what is printed in the corner of pictures: part and date."""
        measured = self.session.measurement
        return (*((measured.part,) if measured is not None and measured.part else ()), date.today().isoformat())

    @Slot(str)
    def _say_picture_failed(self, file: str) -> None:
        self.session.tell(tr("{file} cannot be written.", file=file), "Check the path, the free space and the permissions.", "error")

    def _cancel(self) -> None:
        """End a gesture of the mouse; without one, a special use of clicks."""
        if not self.view.cancel():
            self.end_clicking()

    def beside(self, picture: QWidget, side: QWidget) -> QSplitter:
        """Return the picture with a panel at its side, between which the user moves the border; the window remembers where it is."""
        splitter = self._splitter = PictureSplitter(self.side_width)
        splitter.setObjectName(f"{self.name}-side")
        splitter.setHandleWidth(SPLITTER_PX)
        splitter.setChildrenCollapsible(False)
        for part in (picture, side):
            splitter.addWidget(part)
        picture.setMinimumWidth(LEAST_SPLIT)
        side.setMinimumWidth(LEAST_SIDE)
        splitter.setStretchFactor(0, 1)
        splitter.setStretchFactor(1, 0)
        return splitter

    @Slot()
    def redraw(self) -> None:
        """Draw again: now, when the picture being composed is complete, or when the page becomes visible."""
        self._stale = True
        if self.is_composing or not self.isVisible():
            return
        self._stale = False
        composer = self.composer()
        if composer is None:
            self.view.show_picture()
        else:
            self.is_composing = True
            if self._indexing is not None:  # of a picture that is being replaced
                self._indexing.cancel()
            self.controllers.drawing.run(
                "Drawing", lambda job: _prepare(composer, job), self._show_picture, on_stopped=self._stop_composing, quiet=True
            )

    @Slot(object)
    def _show_picture(self, prepared: Prepared) -> None:
        picture = prepared.picture
        self.view.set_surface(picture.surface, prepared.surface)
        self.view.set_clouds(picture.clouds, prepared.cloud)
        self.view.set_cloud_proxy(prepared.proxy)
        if picture.lines is not None:
            self.view.set_lines(picture.lines)
        if picture.labels is not None:
            self.view.set_labels(picture.labels)
        self._stop_composing()
        if self._stale:
            self.redraw()
        elif len(prepared.cloud):
            self._indexing = self.controllers.drawing.run(
                "Preparing picks", lambda job: index_points(prepared.cloud, job.check), self._show_index, quiet=True
            )

    @Slot(object)
    def _show_index(self, index: PointIndex) -> None:
        self.view.set_index(index)

    @Slot()
    def _stop_composing(self) -> None:
        self.is_composing = False
        if not self._stale:
            self.view.show_picture()

    def showEvent(self, event: QShowEvent) -> None:
        """Draw changes that occurred while the page was hidden."""
        super().showEvent(event)
        if self._stale:
            self.redraw()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Reduce the tools to icons where there is too little room, and give the rest to the picture."""
        super().resizeEvent(event)
        if self.side is not None and self._splitter is None:
            self.side.setFixedWidth(max(LEAST_SIDE, min(self.side_width, self.width() - LEAST_PICTURE)))
        for button in self.tool_buttons:
            button.set_compact(self.width() < ROOM_FOR_WORDS)

    def close_page(self) -> None:
        """Release the graphics memory."""
        self.view.close_view()

    def _use_graphics(self) -> None:
        if self.session.graphics == "ready":
            self.view.activate()
        elif self.session.graphics == "failed":
            self.view.explain(self.session.graphics_problem)


def _prepare(composer: Composer, job: Job) -> Prepared:
    """Compose the picture and prepare it for drawing; runs in the thread of a job."""
    picture = composer(job)
    cloud = shuffle(picture.clouds)
    job.check()
    surface = None if picture.surface is None else prepare_surface(picture.surface)
    proxy = None if picture.proxy is None else prepare_surface(picture.proxy)
    return Prepared(picture, cloud, surface, proxy)
