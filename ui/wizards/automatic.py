"""Calibrate automatically: what to prepare, the images while the rig takes them, and the verdict."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QTimer
from PySide6.QtGui import QCloseEvent
from PySide6.QtWidgets import QDialog, QProgressBar, QWidget

from measureapp.errors import MeasureError
from ui.controllers.rig_calibrating import RigCalibratingController
from ui.images.camera_images import CameraImages
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import keep_units, several
from ui.session import Session
from ui.widgets.basic import Button, card, column, label, row, scrolled
from ui.widgets.board_form import BoardForm
from ui.widgets.checklist import Checklist, Finding, Item
from ui.widgets.path_field import PathField

if TYPE_CHECKING:
    from measureapp.pipeline.rig_calibration import CalibratedRig

SMALLEST = (1264, 620)
LIVE_INTERVAL_MS = 66
SIDE_WIDTH = 496
PURPOSE = (
    "The rig takes about 70 images of one board from all sides. Cameras, hand–eye, linear guide and table axis are then solved together."
)
PREPARE = (
    Item(
        "note", "Fix the board in the centre of the table, tilted about 45° towards the robot.", "It must not move until the run has ended."
    ),
    Item("note", "Let the cameras warm up.", "A calibration is valid for the temperature at which it was made."),
    Item("note", "Keep the cell clear.", "Stop (Esc) is no safety function: in danger use the emergency stop."),
    Item("note", "A run that was stopped is continued.", "Views stored in the project are not taken again."),
)
LEVELS: dict[str, Finding] = {"good": "good", "usable": "warning", "bad": "problem"}


class AutomaticCalibration(QDialog):
    """One automatic calibration; the main window stays usable, its Stop above all."""

    def __init__(self, look: Look, session: Session, calibrating: RigCalibratingController, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Calibrate automatically"))
        self.setModal(False)
        self.setMinimumSize(*SMALLEST)
        self._session, self._calibrating = session, calibrating
        self._has_board = False  # of the project in the folder
        self._has_outcome = False  # of the last run: calibrated, or failed with a reason
        self.folder = PathField(look, "Folder of the project", "New folder, or an existing project of this rig", "projects")
        self.board, self.board_note = BoardForm(), label("", "small", wrap=True)
        self.found, self.pictures = Checklist(look), CameraImages(look)
        self.state, self.bar = label("", "soft", wrap=True), QProgressBar()
        self.bar.setTextVisible(False)
        self.bar.setRange(0, 1000)
        self.start = Button("Start", look, "run", "primary", "Connect the rig and take the images")
        self.stop = Button("Stop", look, "stop", "stop", "Stop everything that moves; views taken so far are kept")
        self.close_button = Button("Close", look)
        self._lay_out()
        self._timer = QTimer(self)
        self._timer.setInterval(LIVE_INTERVAL_MS)
        self._timer.timeout.connect(self._take_images)
        self._connect()

    def _lay_out(self) -> None:
        settings = card(label("Project", "heading"), self.folder, 8, label("Board", "heading"), self.board_note, self.board, 0, margin=16)
        findings = card(self.found, margin=16)
        images = card(label("Images", "caption"), self.pictures, margin=12)
        images.layout().setStretch(1, 1)
        middle = row(scrolled(settings, SIDE_WIDTH), findings, images, spacing=12)
        middle.setStretch(1, 3)
        middle.setStretch(2, 2)
        footer = row(self.close_button, self.state, self.bar, self.stop, self.start)
        footer.setStretch(1, 1)
        self.bar.setFixedWidth(240)
        title = label("Calibrate automatically", "title")
        layout = column(title, label(PURPOSE, "body", wrap=True), middle, footer, margin=16, spacing=12)
        layout.setStretch(2, 1)
        self.setLayout(layout)

    def _connect(self) -> None:
        calibrating = self._calibrating
        self.folder.valueChanged.connect(self._show_board)
        self.board.edited.connect(self._show_running)
        self.start.clicked.connect(self._start)
        self.stop.clicked.connect(calibrating.stop)
        self.close_button.clicked.connect(self.close)
        calibrating.progressed.connect(self._show_progress)
        calibrating.begun.connect(self._show_running)
        calibrating.ended.connect(self._show_ended)
        calibrating.calibrated.connect(self._show_calibrated)
        calibrating.failed.connect(self._show_failed)
        self._session.busyChanged.connect(self._show_running)

    def begin(self) -> None:
        """Show what is to be prepared."""
        rig = self._session.rig
        if rig is not None:
            self.pictures.show_cameras({camera.name: camera.saturation for camera in rig.cameras})
        if not self._calibrating.is_running:
            self.folder.setValue(self._calibrating.suggested_folder())
            self.found.show_items(PREPARE)
            self.state.setText(tr("No rig is chosen: choose one on the page Rig.") if rig is None else f"{rig.name}.")
        self._show_running()
        self.show()
        self.raise_()

    def _start(self) -> None:
        folder = self.folder.value()
        if folder is not None:
            self.found.show_items(PREPARE)
            self._has_outcome = False
            known = self._calibrating.board_in(folder)
            self._calibrating.start(folder, None if known is not None else self.board.value())  # type: ignore[arg-type]

    def _show_board(self) -> None:
        """Show the board of an existing project, which cannot be changed."""
        known = self._calibrating.board_in(self.folder.value())
        if known is not None:
            self.board.setValue(known)
        self._has_board = known is not None
        self.board_note.setText(tr("A new project is made.") if known is None else tr("The board of this project."))
        self._show_running()

    def _show_running(self) -> None:
        running = self._calibrating.is_running
        self.start.setVisible(not running)
        self.start.setEnabled(
            self._session.rig is not None and self.folder.value() is not None and not self.board.problem() and not self._session.busy_with
        )
        self.stop.setVisible(running)
        self.bar.setVisible(running)
        self.folder.setEnabled(not running)
        self.board.setEnabled(not running and not self._has_board)
        if running:
            self._timer.start()
        else:
            self._timer.stop()
            self._take_images()

    def _show_ended(self) -> None:
        if not self._has_outcome:
            self.state.setText(tr("Stopped. Views taken so far are kept; Start continues."))
        self._show_board()

    def _show_progress(self, share: float, note: str) -> None:
        self.bar.setValue(round(1000 * share))
        if note:
            self.state.setText(translated(note))

    def _show_failed(self, error: MeasureError) -> None:
        self._has_outcome = True
        self.found.show_items((Item("problem", error.message, error.hint),))
        self.state.setText(tr("Not calibrated. Views taken so far are kept; Start continues."))

    def _show_calibrated(self, calibrated: CalibratedRig) -> None:
        self._has_outcome = True
        self.found.show_items(items_of(calibrated))
        self.state.setText(tr("Calibrated and stored in the project."))
        self._show_board()

    def _take_images(self) -> None:
        if self.isVisible() and not self._session.cell.live:
            for event in self._session.images.take_all().values():
                self.pictures.show_image(event.camera, event.pixels, event.exposure_us)

    def closeEvent(self, event: QCloseEvent) -> None:
        """Hide; a run goes on, its Stop is in the main window."""
        self._timer.stop()
        super().closeEvent(event)


def items_of(calibrated: CalibratedRig) -> tuple[Item, ...]:
    """Return the verdict, the objections to it, and the views without the board."""
    solved = calibrated.solved
    verdict = solved.verdict
    found = [Item(LEVELS[verdict.level], keep_units(verdict.sentence), f"{verdict.reason} {verdict.remedy}".strip())]
    found += [Item("warning", reason) for reason in verdict.reasons]
    found += [Item("warning", tr("Not determined: {what}.", what=what)) for what in solved.solution.not_observable]
    found += [
        Item(
            "warning",
            tr("{viewpoint_id} failed: {reason}", viewpoint_id=one.viewpoint_id, reason=one.reason),
            "Start again takes it again.",
        )
        for one in calibrated.failed
    ]
    if calibrated.unseen:
        names = ", ".join(calibrated.unseen)
        reason = next(iter(calibrated.unseen.values()))
        found.append(Item("warning", tr("No camera detects the board from {names}.", names=names), reason))
    taken, kept = len(calibrated.taken), len(calibrated.kept)
    return (*found, Item("note", tr("{count} taken, {kept} stored before.", count=several(taken, "view"), kept=kept)))
