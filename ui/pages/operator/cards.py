"""Part programs as large cards."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import datetime

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QImage, QPixmap, QResizeEvent
from PySide6.QtWidgets import QGridLayout, QLabel, QScroller, QSizePolicy, QVBoxLayout, QWidget

from ui.controllers.operator_nouns import ProgramCard, verdict_of
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.verdict_words import loud
from ui.look.wording import rough_duration
from ui.pages.operator.big import BigButton, big_label, short_label
from ui.pages.operator.style import CARD_PX
from ui.widgets.basic import clear, row, scrolled

PICTURE_PX, GAP_PX = (300, 168), 16
SIGN_PX = 24


def when_words(iso: str, now: datetime | None = None) -> str:
    """Return when something was measured: the time today, else also the date."""
    then = datetime.fromisoformat(iso).astimezone()
    now = now or datetime.now().astimezone()
    return tr("today {time}", time=f"{then:%H:%M}") if then.date() == now.date() else f"{then:%Y-%m-%d %H:%M}"


class CardButton(BigButton):
    """One part program: picture, name, drawing, last run, time needed; or what is wrong with its file."""

    def __init__(self, card: ProgramCard, look: Look) -> None:
        super().__init__("", look, "", "card")
        self.card = card
        self.setFixedSize(*CARD_PX)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        self.setAccessibleName(translated(card.name))
        self.setToolTip(translated(card.name))
        layout = QVBoxLayout(self)
        layout.setContentsMargins(16, 16, 16, 12)
        layout.setSpacing(4)
        parts = self._problem(look) if card.program is None else self._facts(look)
        for part in parts:
            part.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
            layout.addWidget(part)
        layout.addStretch(1)

    def _facts(self, look: Look) -> list[QWidget]:
        card = self.card
        assert card.program is not None
        facts = card.program.facts
        picture = QLabel(alignment=Qt.AlignmentFlag.AlignCenter)
        picture.setFixedHeight(PICTURE_PX[1])
        if card.program.picture is None:
            picture.setPixmap(look.icon("file", "faint").pixmap(QSize(96, 96)))
        else:
            picture.setPixmap(_fitted(card.program.picture, self.devicePixelRatioF()))
        words: list[QWidget] = [picture, short_label(facts.name, "heading")]
        drawing = facts.identification.drawing
        released = tr("Release {revision}", revision=facts.revision) if facts.revision else ""
        numbers = " · ".join(filter(None, (facts.part_number, drawing and _drawing(drawing, facts.identification.revision), released)))
        words.append(short_label(numbers, "soft"))
        words.append(self._last(look))
        words.append(big_label("" if card.seconds is None else tr("About {seconds}", seconds=rough_duration(card.seconds)), "soft"))
        return words

    def _last(self, look: Look) -> QWidget:
        last = self.card.last
        if last is None:
            return big_label("Not measured yet", "soft")
        sign, verdict = QLabel(), verdict_of(last)
        sign.setPixmap(look.icon(verdict, "verdict_" + verdict.replace(" ", "_")).pixmap(QSize(SIGN_PX, SIGN_PX)))
        line = QWidget()
        line.setLayout(row(sign, big_label(f"{loud(verdict)}, {when_words(last.measured_at)}", "soft"), 0))
        return line

    def _problem(self, look: Look) -> list[QWidget]:
        sign = QLabel(alignment=Qt.AlignmentFlag.AlignCenter)
        sign.setPixmap(look.icon("error", "verdict_fail").pixmap(QSize(56, 56)))
        problem = big_label(self.card.problem, "body", wrap=True)
        problem.setAlignment(Qt.AlignmentFlag.AlignTop)
        return [sign, short_label(self.card.name, "strong"), big_label("This file cannot be used.", "error"), problem]


def _drawing(drawing: str, revision: str) -> str:
    return tr("{drawing} rev. {revision}", drawing=drawing, revision=revision) if revision else drawing


def _fitted(png: bytes, ratio: float) -> QPixmap:
    image = QImage.fromData(png)
    size = QSize(*PICTURE_PX) * ratio
    fitted = image.scaled(size, Qt.AspectRatioMode.KeepAspectRatio, Qt.TransformationMode.SmoothTransformation)
    fitted.setDevicePixelRatio(ratio)
    return QPixmap.fromImage(fitted)


class CardGrid(QWidget):
    """Cards side by side, as many as fit; the rest below, to be scrolled."""

    chosen = Signal(object)  # ProgramCard

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look = look
        self.buttons: list[CardButton] = []
        self._columns = 0
        self._sheet = QWidget()
        self._sheet.setObjectName("clear")
        self._grid = QGridLayout(self._sheet)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setSpacing(GAP_PX)
        self._grid.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)
        self._area = scrolled(self._sheet)
        self._area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        QScroller.grabGesture(self._area.viewport(), QScroller.ScrollerGestureType.TouchGesture)
        self.setLayout(row(self._area))

    def show_cards(self, cards: Sequence[ProgramCard]) -> None:
        """Show these cards."""
        if [button.card for button in self.buttons] == list(cards):
            return
        clear(self._grid)
        self.buttons = [CardButton(card, self._look) for card in cards]
        for button in self.buttons:
            button.pressedOnce.connect(lambda card=button.card: self.chosen.emit(card))
        self._columns = 0
        self._arrange()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Show as many cards side by side as fit."""
        super().resizeEvent(event)
        self._arrange()

    def _arrange(self) -> None:
        columns = max(1, (self._area.width() - 24 + GAP_PX) // (CARD_PX[0] + GAP_PX))
        if columns == self._columns:
            return
        self._columns = columns
        for place, button in enumerate(self.buttons):
            self._grid.addWidget(button, place // columns, place % columns)
