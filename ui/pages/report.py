"""Report page: print preview, and export of documents."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, Qt, QTimer
from PySide6.QtGui import QImage, QResizeEvent, QShowEvent
from PySide6.QtWidgets import QScrollArea, QWidget

from measureapp.language.languages import LANGUAGES
from measureapp.project.file_names import safe_file_name
from ui.controllers.controllers import Controllers
from ui.controllers.documents import FORMATS
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import part_words, sentence_case, when
from ui.pages.page import Page
from ui.session import Session
from ui.settings.dialogs import choose_new
from ui.settings.settings import AS_WINDOW
from ui.widgets.basic import Button, CalmComboBox, card, clear, column, label, row, scrolled
from ui.widgets.empty_state import EmptyState
from ui.widgets.page_picture import PagePicture
from ui.widgets.properties_panel import Group, Properties

if TYPE_CHECKING:
    from ui.controllers.report_header import ReportHeader
    from ui.pages.repeats.dialog import RepeatsDialog
    from ui.pages.series.dialog import SeriesDialog

EMPTY = (
    "No report yet",
    "The report is created when a part has been measured: pictures, dimensions, calibration and settings.",
)
LANGUAGE_CHOICES = {AS_WINDOW: "As the window", **LANGUAGES}
PAGE_WIDTH = 820
SIDE_WIDTH = 304  # px, room for a scroll bar included


class ReportPage(Page):
    """Preview of the PDF pages, and export by format."""

    name, word, wants_room = "report", "Report", True
    shows_results = True

    def __init__(self, look: Look, session: Session, controllers: Controllers) -> None:
        super().__init__(look, session, controllers, EmptyState(look, "report", *EMPTY, "Run the demo"))
        self._sheet = QWidget()
        self._sheet.setObjectName("clear")
        self._pages = column(spacing=16)
        self._sheet.setLayout(self._pages)
        self.pages: list[PagePicture] = []
        self._is_stale = False
        self._scroll = QScrollArea()
        self._scroll.setWidgetResizable(True)
        self._scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._scroll.setWidget(self._sheet)
        self.exports = {kind: self._export_button(kind) for kind in FORMATS}
        self.header_button = Button("Header, template…", look, "labels")
        self.header_button.clicked.connect(controllers.documents.ask_header)
        controllers.documents.headerReady.connect(self._edit_header)
        self.language = CalmComboBox()
        self.language.setAccessibleName(tr("Language of the report"))
        for name, words in LANGUAGE_CHOICES.items():
            self.language.addItem(translated(words), name)
        self._show_language()
        self.language.activated.connect(self._choose_language)
        self._drawn_in = ""  # the language of the pages on display
        folder = Button("Show in folder", look, "open", "quiet")
        folder.clicked.connect(controllers.documents.open_folder)
        side = card(
            self.header_button,
            label("Language of the report", "soft"),
            self.language,
            8,
            label("Export", "heading"),
            *self.exports.values(),
            folder,
            0,
            margin=12,
        )
        layout = row(self._scroll, scrolled(side, SIDE_WIDTH), spacing=16)
        layout.setStretch(0, 1)
        self.body.setLayout(layout)
        self.open_pdf = Button("Open PDF", look, "pdf", "primary")
        self.open_pdf.clicked.connect(controllers.documents.open_pdf)
        self.repeats: RepeatsDialog | None = None
        repeat = self.repeat = Button("Repeats…", look, "again", "normal", "Mean and spread over several measurements of this part")
        repeat.clicked.connect(self.open_repeats)
        self.series_of_parts: SeriesDialog | None = None
        series = self.series = Button("Series…", look, "report", "normal", "Trend and capability over all parts measured by one program")
        series.clicked.connect(self.open_series)
        self.action_row.addWidget(repeat)
        self.action_row.addWidget(series)
        self.action_row.addWidget(self.open_pdf)
        controllers.documents.pagesReady.connect(self.show_pages)
        controllers.documents.pagesFailed.connect(self._show_no_pages)
        self.follow(session.reportChanged, self._show)
        self.follow(session.busyChanged, self._show_busy)

    def _choose_language(self, place: int) -> None:
        """Write and draw the report in another language; ``place`` in the list of choices."""
        if self.controllers.documents.set_language(self.language.itemData(place)):
            self._drawn_in = self.session.report_language
        else:
            self._show_language()

    def _show_language(self) -> None:
        """Show the language that is chosen."""
        self.language.setCurrentIndex(self.language.findData(self.session.settings.text("report_language")))

    def open_repeats(self) -> None:
        """Open the window of repeated measurements; it is made when first used."""
        from ui.pages.repeats.dialog import RepeatsDialog

        if self.repeats is None:
            self.repeats = RepeatsDialog(self.look, self.session, self.controllers.repeats, self)
        self.repeats.begin()

    def open_series(self) -> None:
        """Open the window of a series of parts; it is made when first used."""
        from ui.pages.series.dialog import SeriesDialog

        if self.series_of_parts is None:
            self.series_of_parts = SeriesDialog(self.look, self.session, self.controllers.series, self)
        self.series_of_parts.begin()

    def _export_button(self, kind: str) -> Button:
        made = Button(FORMATS[kind][0] + "…", self.look, "export")
        made.clicked.connect(lambda: self.export(kind))
        return made

    def _show_busy(self) -> None:
        if self.session.busy_with and self.session.measurement is None:
            self.say_running("No report yet", "The report is written when the dimensions have been evaluated.")
        else:
            self.empty.say(*EMPTY)

    def _show(self) -> None:
        measurement = self.session.measurement
        self.show_filled(measurement is not None)
        self.show_pages(())
        if measurement is None:
            self.state.setText(tr("Nothing to report."))
            self._is_stale = False
            return
        documents = self.controllers.documents
        for kind, made in self.exports.items():
            made.setVisible(documents.can_export(kind))
        self.open_pdf.setVisible(documents.can_open_pdf)
        self.state.setText(
            tr(
                "{part_words}, measured {value}.",
                part_words=part_words(measurement.part),
                value=when(measurement.measured_at) or measurement.measured_at,
            )
        )
        rows = (("Project", measurement.project), ("Part", part_words(measurement.part)), ("Rig", measurement.rig))
        times = tuple((sentence_case(name), f"{seconds:.1f} s") for name, seconds in measurement.timings_s.items())
        groups = [Group("Measurement", rows), *([Group("Time", times)] if times else [])]
        self.show_properties(Properties("Report", tuple(groups)))
        self._draw_pages()

    def _draw_pages(self) -> None:
        """Have the pages drawn, or remember it until this page is in sight: drawing takes a second of a processor."""
        self._is_stale = not self.isVisible()
        if not self._is_stale:
            self._drawn_in = self.session.report_language
            self.controllers.documents.preview()

    def show_pages(self, pages: tuple[QImage, ...]) -> None:
        """Show the pages of the report."""
        clear(self._pages)
        self.pages = [PagePicture(page, self._page_width) for page in pages]
        for shown in self.pages:
            self._pages.addWidget(shown)
        if not self.pages and self.session.measurement is not None:
            self._say("Rendering the pages…")
        self._pages.addStretch(1)

    def _show_no_pages(self) -> None:
        clear(self._pages)
        self._say("No preview. Use Open PDF to view the report." if self.open_pdf.isVisibleTo(self) else "No preview.")
        self._pages.addStretch(1)

    def _say(self, words: str) -> None:
        message = label(words, "soft")
        message.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._pages.addWidget(message)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Fit the pages to the available width."""
        super().resizeEvent(event)
        QTimer.singleShot(0, self, self._fit_pages)

    def showEvent(self, event: QShowEvent) -> None:
        """Draw the pages if the measurement is another one, and fit them to the available width."""
        super().showEvent(event)
        if self._is_stale:
            self._draw_pages()
        QTimer.singleShot(0, self, self._fit_pages)

    def changeEvent(self, event: QEvent) -> None:
        """Draw the pages anew where they follow the language of the window."""
        super().changeEvent(event)
        is_language = event.type() == QEvent.Type.LanguageChange
        if is_language and self.session.measurement is not None and self._drawn_in not in ("", self.session.report_language):
            self._draw_pages()

    @property
    def _page_width(self) -> int:
        return min(PAGE_WIDTH, max(320, self._scroll.width() - 24))

    def _fit_pages(self) -> None:
        for shown in self.pages:
            shown.fit(self._page_width)

    def _edit_header(self, header: ReportHeader) -> None:
        from ui.pages.report_header import HeaderDialog

        dialog = HeaderDialog(self.look, header, self)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.chosen.connect(self.controllers.documents.set_header)
        dialog.open()

    def export(self, kind: str) -> None:
        """Ask for a file and export a document or geometry to it."""
        if self.session.refuse_during_job():
            return
        words, ending = FORMATS[kind]
        name = safe_file_name(self.session.project_name or "measurement", f".{ending}")
        chosen = choose_new(self, words, name, "exports", f"*.{ending}")
        if chosen is not None:
            self.controllers.documents.export(kind, chosen.with_suffix(f".{ending}"))
