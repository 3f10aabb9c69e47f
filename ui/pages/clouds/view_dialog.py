"""What the windows of one view have in common: title, progress with Cancel, the cameras of the view."""

from __future__ import annotations

from abc import abstractmethod

from PySide6.QtCore import Slot
from PySide6.QtGui import QCloseEvent
from PySide6.QtWidgets import QDialog, QHBoxLayout, QProgressBar, QWidget

from ui.controllers.view_work import OfView, ViewWorkController
from ui.look.language.words import translated
from ui.look.look import Look
from ui.look.wording import sentence_case
from ui.widgets.basic import Button, column, label, row
from ui.widgets.segments import Segments


class ViewDialog(QDialog):
    """A non-modal window beside the main window, of what is computed of one view; subclasses show it."""

    def __init__(self, look: Look, work: ViewWorkController, waiting: str, again: str, parent: QWidget | None = None) -> None:
        """``waiting``: a sentence while it is computed; ``again``: label of the button that begins anew."""
        super().__init__(parent)
        self.look, self.work, self.viewpoint_id = look, work, ""
        self._waiting = waiting
        self.title, self.state = label("", "title"), label("", "soft")
        self.cameras = Segments({"": "Camera"})
        self.camera_place = row(self.cameras)
        self.cameras.hide()  # until the cameras of the view are known
        self.progress, self.note = QProgressBar(), label("", "soft")
        self.progress.setTextVisible(False)
        self.progress.setRange(0, 1000)
        self.progress.setFixedWidth(160)
        self.cancel = Button("Cancel", look, "cancel")
        self.cancel.clicked.connect(work.cancel)
        self.again = Button(again, look, "again", "primary")
        self.again.clicked.connect(self.load)
        work.found.connect(self._take)
        work.progressed.connect(self._show_progress)
        work.stopped.connect(self.show_stopped)

    @abstractmethod
    def shown(self) -> OfView | None:
        """Return what is on display; None while there is nothing."""

    @abstractmethod
    def steering(self) -> tuple[QWidget, ...]:
        """Return what can be used only while something is on display."""

    @abstractmethod
    def show_found(self, found: OfView) -> None:
        """Show what was computed."""

    @abstractmethod
    def show_stopped(self, reason: str) -> None:
        """Say that nothing was computed, and why; without a reason it was cancelled."""

    @abstractmethod
    def change_camera(self) -> None:
        """Show another camera."""

    def lay_out(self, left: QHBoxLayout | QWidget, top: QHBoxLayout) -> None:
        """Put the content below the line with title and progress."""
        layout = column(top, left, margin=16, spacing=12)
        layout.setStretch(1, 1)
        self.setLayout(layout)

    def top(self) -> QHBoxLayout:
        """Return the line with title and progress."""
        return row(column(self.title, self.state, spacing=0), 0, self.note, self.progress, self.cancel, self.again, spacing=12)

    def begin(self, window: str, title: str) -> None:
        """Open with these titles and compute."""
        self.setWindowTitle(window)
        self.title.setText(title)
        self.show()
        self.raise_()
        self.load()

    def load(self) -> None:
        """Compute, or show what is known."""
        self.show_running(True)
        self.state.setText(translated(self._waiting))
        self.work.find(self.viewpoint_id)

    def closeEvent(self, event: QCloseEvent) -> None:
        """Cancel computations for this window only."""
        self.work.cancel()
        super().closeEvent(event)

    def show_running(self, running: bool) -> None:
        """Show progress, or the button that begins anew."""
        there = self.shown() is not None
        for part in (self.progress, self.note, self.cancel):
            part.setVisible(running)
        self.again.setVisible(not running and not there)
        for part in (*self.steering(), self.cameras):
            part.setEnabled(there)

    def make_cameras(self, names: tuple[str, ...]) -> None:
        """Offer the cameras of the view."""
        self.camera_place.removeWidget(self.cameras)
        self.cameras.deleteLater()
        self.cameras = Segments({name: sentence_case(name) for name in names}, name="Camera")
        self.cameras.valueChanged.connect(self.change_camera)
        self.camera_place.addWidget(self.cameras)

    @Slot(object)
    def _take(self, found: OfView) -> None:
        if found.viewpoint_id == self.viewpoint_id:
            self.show_found(found)

    @Slot(float, str)
    def _show_progress(self, share: float, note: str) -> None:
        self.progress.setValue(round(1000 * share))
        self.note.setText(translated(sentence_case(note)))
