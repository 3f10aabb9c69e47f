"""Load screen: how to clamp the part, a confirmation that is held, then Start."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QImage, QPixmap, QResizeEvent, QShowEvent
from PySide6.QtWidgets import QLabel, QSizePolicy, QWidget

from ui.controllers.operator import OperatorController
from ui.look.language.words import translated
from ui.look.look import Look
from ui.pages.operator.big import BigButton, HoldButton, big_card, big_label
from ui.widgets.basic import column, row

NO_TEXT = "Put the part on the table as the engineer has shown you, and clamp it."
SAFETY = "The program's Stop is not an emergency stop: in danger press the emergency stop of the machine."
CONFIRM = "Hold for 1 s: part clamped, cell clear"
CONFIRMED = "Confirmed: part clamped, cell clear"


class LoadScreen(QWidget):
    """Picture, text, confirmation, Start; what prevents the start stands beside it."""

    backClicked = Signal()
    startClicked = Signal()
    callClicked = Signal()

    def __init__(self, look: Look, controller: OperatorController) -> None:
        super().__init__()
        self._look, self._controller = look, controller
        self._image = QImage()
        self.picture = QLabel(alignment=Qt.AlignmentFlag.AlignCenter)
        self.picture.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Ignored)
        self.title, self.text = big_label("Put the part in", "title"), big_label("", "strong", wrap=True)
        self.text.setAlignment(Qt.AlignmentFlag.AlignTop)
        self.part = big_label("", "soft", wrap=True)
        self.safety = big_label(SAFETY, "soft", wrap=True)
        self.confirm = HoldButton(CONFIRM, look, "person")
        self.confirm.setProperty("tall", True)
        self.start = BigButton("Start", look, "run", "primary")
        self.start.setProperty("tall", True)
        self.back = BigButton("Back", look, "unfold")
        self.call = BigButton("Call the engineer", look, "person")
        self.why = big_label("", "error", wrap=True)
        words = big_card(self.title, self.part, self.text, 0, self.safety)
        picture = big_card(self.picture)
        middle = row(picture, words, spacing=16)
        middle.setStretch(0, 1)
        middle.setStretch(1, 1)
        buttons = row(self.back, self.call, 0, self.confirm, self.start, spacing=16)
        buttons.setStretch(3, 2)
        buttons.setStretch(4, 2)
        layout = column(middle, self.why, buttons, spacing=16)
        layout.setContentsMargins(24, 24, 24, 16)
        layout.setStretch(0, 1)
        self.setLayout(layout)
        self.back.pressedOnce.connect(self.backClicked)
        self.start.pressedOnce.connect(self.startClicked)
        self.call.pressedOnce.connect(self.callClicked)
        self.confirm.held.connect(self._show)
        self.confirm.held.connect(self.start.setFocus)
        controller.obstaclesChanged.connect(self._show)

    def showEvent(self, event: QShowEvent) -> None:
        """Ask for the confirmation anew for every part."""
        super().showEvent(event)
        self.confirm.restore()
        facts, card = self._controller.facts, self._controller.chosen
        entered = self._controller.entered
        if facts is not None and card is not None and card.program is not None:
            self.text.setText(translated(facts.remarks) or translated(NO_TEXT))
            self.part.setText(translated(" · ".join(filter(None, (facts.name, entered.serial)))))
            self._image = QImage() if card.program.picture is None else QImage.fromData(card.program.picture)
        self._fit()
        self._show()
        self.confirm.setFocus()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Fit the picture."""
        super().resizeEvent(event)
        self._fit()

    def _fit(self) -> None:
        if self._image.isNull():
            self.picture.setPixmap(self._look.icon("file", "faint").pixmap(QSize(160, 160)))
            return
        ratio = self.devicePixelRatioF()
        size = self.picture.size().expandedTo(QSize(64, 64)) * ratio
        fitted = self._image.scaled(size, Qt.AspectRatioMode.KeepAspectRatio, Qt.TransformationMode.SmoothTransformation)
        fitted.setDevicePixelRatio(ratio)
        self.picture.setPixmap(QPixmap.fromImage(fitted))

    def _show(self) -> None:
        if not self.isVisible():
            return
        why = self._controller.why_not()
        self.confirm.setText(translated(CONFIRMED) if self.confirm.done else translated(CONFIRM))
        self.start.setEnabled(not why and self.confirm.done)
        self.why.setProperty("op", "strong" if self._controller.is_checking else "error")  # it is no fault that it takes a moment
        self.why.style().polish(self.why)
        self.why.setText(translated("\n".join(why)))
        self.why.setVisible(bool(why))
