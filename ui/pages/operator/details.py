"""Details and report of a measured part, to be read only."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QImage, QPixmap, QShowEvent
from PySide6.QtWidgets import QGridLayout, QLabel, QScroller, QWidget

from measureapp.data.verdicts import worst_first
from ui.controllers.controllers import Controllers
from ui.look.language.words import translated
from ui.look.look import Look
from ui.look.verdict_words import loud
from ui.look.wording import dimension_words, quantity
from ui.pages.inspection.dimension_rows import tolerance, unit_of
from ui.pages.operator.big import BigButton, big_card, big_label, short_label
from ui.session import Session
from ui.widgets.basic import clear, column, row, scrolled

if TYPE_CHECKING:
    from measureapp.data.dimension import Dimension
    from measureapp.data.series import SeriesRun, SeriesValue

HEADERS = ("", "Dimension", "Measured", "Nominal", "Tolerance", "U (k = 2)", "Verdict")
MOST_ROWS = 100
PAGE_PX = 960


class ReadScreen(QWidget):
    """A title, something to scroll, and Back."""

    backClicked = Signal()

    def __init__(self, look: Look, title: str) -> None:
        super().__init__()
        self._look = look
        self.title = big_label(title, "title", wrap=True)
        self._sheet = QWidget()
        self._sheet.setObjectName("clear")
        area = scrolled(self._sheet)
        QScroller.grabGesture(area.viewport(), QScroller.ScrollerGestureType.TouchGesture)
        self.back = BigButton("Back", look, "unfold", "primary")
        self.back.setMinimumWidth(240)
        self.back.pressedOnce.connect(self.backClicked)
        layout = column(self.title, area, row(0, self.back), spacing=16)
        layout.setContentsMargins(24, 24, 24, 12)
        layout.setStretch(1, 1)
        self.setLayout(layout)

    def showEvent(self, event: QShowEvent) -> None:
        """Give Back the focus."""
        super().showEvent(event)
        self.back.setFocus()


class DetailsScreen(ReadScreen):
    """All dimensions of a part, the worst first."""

    def __init__(self, look: Look) -> None:
        super().__init__(look, "Dimensions")
        self._grid = QGridLayout()
        self._grid.setHorizontalSpacing(24)
        self._grid.setVerticalSpacing(8)
        card = big_card(self._grid)
        self._sheet.setLayout(column(card, 0))
        self.names: list[str] = []  # in the order shown

    def show_dimensions(self, title: str, dimensions: Sequence[Dimension]) -> None:
        """Show these dimensions."""
        clear(self._grid)
        self.title.setText(translated(title))
        for place, name in enumerate(HEADERS):
            self._grid.addWidget(big_label(name, "soft"), 0, place)
        ordered = worst_first(dimensions)[:MOST_ROWS]
        self.names = [one.name for one in ordered]
        for number, one in enumerate(ordered, 1):
            self._add(number, one)
        self._grid.setColumnStretch(1, 1)

    def _add(self, number: int, one: Dimension) -> None:
        unit, verdict = unit_of(one), str(one.verdict)
        sign = QLabel()
        sign.setPixmap(self._look.icon(verdict, "verdict_" + verdict.replace(" ", "_")).pixmap(QSize(28, 28)))
        words = (
            short_label(dimension_words(one.name), "strong"),
            big_label(quantity(one.measured, unit), "strong"),
            big_label(quantity(one.nominal, unit)),
            big_label(tolerance(one.lower_tolerance, one.upper_tolerance, unit)),
            big_label(quantity(one.round_uncertainty(), unit)),
            big_label(loud(verdict), "strong"),
        )
        self._grid.addWidget(sign, number, 0)
        for place, shown in enumerate(words, 1):
            if place in (2, 3, 4, 5):
                shown.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
            self._grid.addWidget(shown, number, place)


def dimensions_of(run: SeriesRun) -> tuple[Dimension, ...]:
    """Return the dimensions of a stored run."""
    return tuple(_dimension(value) for value in run.values)


def _dimension(value: SeriesValue) -> Dimension:
    from measureapp.data.dimension import Dimension

    return Dimension(
        value.name,
        value.nominal,
        value.measured,
        value.uncertainty,
        value.lower_tolerance,
        value.upper_tolerance,
        value.verdict,
        value.unit,
        value.reason,
        kind=value.kind,
    )


class ReportScreen(ReadScreen):
    """The pages of the report."""

    def __init__(self, look: Look, session: Session, controllers: Controllers) -> None:
        super().__init__(look, "Report")
        self._session, self._documents = session, controllers.documents
        self._pages = column(spacing=16)
        self._sheet.setLayout(self._pages)
        self._ready = False
        session.reportChanged.connect(self._forget)
        controllers.documents.pagesReady.connect(self._show_pages)
        controllers.documents.pagesFailed.connect(self._show_none)
        self._say("The pages are being drawn…")

    def showEvent(self, event: QShowEvent) -> None:
        """Draw the pages when they are first asked for."""
        super().showEvent(event)
        if not self._ready:
            self._documents.preview()

    def _forget(self) -> None:
        self._ready = False
        self._say("The pages are being drawn…")

    def _show_none(self) -> None:
        self._say("The report cannot be shown. It is filed with the part.")

    def _say(self, words: str) -> None:
        clear(self._pages)
        self._pages.addWidget(big_label(words, "soft"))
        self._pages.addStretch(1)

    def _show_pages(self, pages: tuple[QImage, ...]) -> None:
        self._ready = True
        clear(self._pages)
        for image in pages:
            shown = QLabel(alignment=Qt.AlignmentFlag.AlignHCenter)
            shown.setPixmap(QPixmap.fromImage(image.scaledToWidth(PAGE_PX, Qt.TransformationMode.SmoothTransformation)))
            self._pages.addWidget(shown)
        self._pages.addStretch(1)
