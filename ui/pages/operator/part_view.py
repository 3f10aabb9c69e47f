"""A 3-D view of the part in operator mode: composed by a job while it is visible."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Slot
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QMenu, QWidget

from ui.controllers.jobs import JobRunner
from ui.look.look import Look
from ui.pages.viewport_page import Composer, Picture
from ui.session import Session
from ui.viewport.cloud_view import CloudView
from ui.viewport.layers import Label, LineLayer
from ui.viewport.shuffled_cloud import ShuffledCloud, shuffle
from ui.widgets.basic import column
from ui.workers.job import Job


class PartView(QWidget):
    """Shows what ``composer`` returns, with lines and labels over it; ``nothing``: words in place of an empty picture."""

    def __init__(self, look: Look, session: Session, drawing: JobRunner, *, nothing: str = "") -> None:
        super().__init__()
        self._session, self._drawing, self._nothing = session, drawing, nothing
        self.view = CloudView(look)
        self.view.menuOpening.connect(_without_dialogs)
        self._composer: Composer | None = None
        self._busy, self._stale = False, False
        layout = column(self.view)
        self.setLayout(layout)
        session.graphicsChanged.connect(self._use_graphics)
        self._use_graphics()

    def compose(self, composer: Composer | None) -> None:
        """Show another picture, now or as soon as the widget is visible; None: an empty one."""
        self._composer, self._stale = composer, True
        self._redraw()

    def mark(self, lines: Sequence[LineLayer], labels: Sequence[Label]) -> None:
        """Show lines and labels over the part."""
        self.view.set_lines(lines)
        self.view.set_labels(labels)

    def clear(self) -> None:
        """Show nothing, so that no part is taken for the one before."""
        self._composer, self._stale = None, False
        self.view.set_surface(None)
        self.view.set_clouds(())
        self.mark((), ())

    def look_from(self, direction: tuple[float, float, float]) -> None:
        """Show everything from a direction."""
        self.view.frame(None, direction)
        self.view.reset_camera()

    def showEvent(self, event: QShowEvent) -> None:
        """Draw what changed while the widget was hidden."""
        super().showEvent(event)
        self._redraw()

    def close_view(self) -> None:
        """Release the graphics memory."""
        self.view.close_view()

    def _redraw(self) -> None:
        if self._busy or not self._stale or not self.isVisible():
            return
        self._stale = False
        composer = self._composer
        if composer is None:
            self._show((Picture(), shuffle(())))
            if self._nothing:
                self.view.hide_picture(self._nothing)
            return
        self._busy = True
        self._drawing.run("Drawing", lambda job: _prepare(composer, job), self._show, on_stopped=self._end, quiet=True)

    @Slot(object)
    def _show(self, prepared: tuple[Picture, ShuffledCloud]) -> None:
        picture, cloud = prepared
        self.view.set_surface(picture.surface)
        self.view.set_clouds(picture.clouds, cloud)
        self.view.show_picture()
        self._end()
        self._redraw()

    @Slot()
    def _end(self) -> None:
        self._busy = False

    def _use_graphics(self) -> None:
        if self._session.graphics == "ready":
            self.view.activate()
        elif self._session.graphics == "failed":
            self.view.explain(self._session.graphics_problem)


def _prepare(composer: Composer, job: Job) -> tuple[Picture, ShuffledCloud]:
    picture = composer(job)
    return picture, shuffle(picture.clouds)


def _without_dialogs(menu: QMenu, _pick: object) -> None:
    """Remove from the view's menu what opens a dialog: the files of the computer are not an operator's."""
    for action in menu.actions():
        if action.text().partition("\t")[0].endswith("…"):
            menu.removeAction(action)
