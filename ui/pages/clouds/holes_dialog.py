"""Images and holes: the images of one view, and the state of every pixel with its reason."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QHeaderView, QWidget

from ui.controllers.holes import DrawnImage, Explanation, HolesController
from ui.images.map_view import MapView
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import counted, exposure, percent, point_reason, quantity, sentence_case
from ui.pages.clouds.view_dialog import ViewDialog
from ui.widgets.basic import Button, card, column, label, row
from ui.widgets.data_table import Cell, DataTable, number
from ui.widgets.segments import Segments

if TYPE_CHECKING:
    from measureapp.pipeline.why import Number, PixelAnswer

KINDS = {"grey": "Grey", "reasons": "Reasons", "exposure": "Exposure", "snr": "Signal to noise"}
HEADINGS = {
    "grey": "State of the pixels",
    "reasons": "State of the pixels",
    "exposure": "Longest unsaturated exposure",
    "snr": "Modulation over noise",
}
STAGES = {"point": "Point measured", "decode": "Lost in decoding", "match": "Lost in matching", "clean": "Removed by cleaning"}
NO_LOSS = ("point", "seen by another")
DIGITS = {"grey level": 0, "phase noise": 4, "projector column": 2, "point σ": 3, "cameras": 0}
ASK = "Click a pixel in the picture, or a reason in the list, for an explanation."
WAITING = "The view is recomputed from its stored images."
PATIENCE = "The pixels can be inspected as soon as this is complete."


class HolesDialog(ViewDialog):
    """Shows the state of every pixel of a view."""

    imagesAsked = Signal(str, str, object)  # viewpoint, camera, pixel (row, column) or None

    def __init__(self, look: Look, holes: HolesController, parent: QWidget | None = None) -> None:
        super().__init__(look, holes, WAITING, "Recompute", parent)
        self.holes = holes
        self.setMinimumSize(960, 560)
        self.resize(1240, 680)
        self._explanation: Explanation | None = None
        self._wanted: tuple[str, int, int] | None = None
        self._reasons: list[str] = []
        self._make_parts()
        self._lay_out()
        holes.drawn.connect(self._show_image)

    def _make_parts(self) -> None:
        look = self.look
        self.kind = Segments(KINDS)
        self.kind.valueChanged.connect(self._draw)
        self.picture = MapView(look)
        self.picture.pixelChosen.connect(self._ask)
        self.place, self.stage = label("", "caption"), label("", "heading", wrap=True)
        self.answer, self.figures = label(ASK, "body", wrap=True), label("", "small", wrap=True)
        self.answer.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.heading = label(HEADINGS["reasons"], "caption")
        self.table = DataTable(look, ["Colour", "Share"], numeric=(1,), stretch=0)
        self.table.horizontalHeader().setSectionResizeMode(1, QHeaderView.ResizeMode.ResizeToContents)
        self.table.cellClicked.connect(self._ask_for_reason)
        self.values = Button("Values…", look, "images", "quiet", "Stored images, phase, modulation and σ at this pixel, and profiles")
        self.values.clicked.connect(lambda: self.imagesAsked.emit(self.viewpoint_id, self.cameras.value(), self.picture.cursor_pixel))

    def _lay_out(self) -> None:
        tools = row(self.kind, 0, self.camera_place, self.values)
        said = card(self.place, self.stage, self.answer, self.figures, 0, margin=12, spacing=4)
        said.setMinimumHeight(176)
        side = column(said, self.heading, self.table, spacing=8)
        side.setStretch(2, 1)
        right = QWidget()
        right.setObjectName("clear")
        right.setLayout(side)
        right.setFixedWidth(360)
        middle = row(column(tools, self.picture, spacing=8), right, spacing=16)
        middle.setStretch(0, 1)
        self.lay_out(middle, self.top())

    def open_view(self, viewpoint_id: str, camera: str = "", pixel: tuple[int, int] | None = None) -> None:
        """Show a view, and explain a pixel of one of its cameras if given."""
        self._wanted = None if pixel is None else (camera, *pixel)
        if viewpoint_id != self.viewpoint_id:
            self.viewpoint_id, self._explanation = viewpoint_id, None
            self.picture.clear()
            self.table.set_rows([])
        self.begin(
            tr("Images and holes – {viewpoint_id}", viewpoint_id=viewpoint_id),
            tr("Images and holes: {viewpoint_id}", viewpoint_id=viewpoint_id),
        )

    def shown(self) -> Explanation | None:
        """Return the explanation on display."""
        return self._explanation

    def steering(self) -> tuple[QWidget, ...]:
        """Return the choice of colours, and the way to the values."""
        return self.kind, self.values

    def load(self) -> None:
        """Analyse the view, or show what is known."""
        self._tell("", "", ASK if self._explanation is not None else PATIENCE, "")
        super().load()

    @Slot(str)
    def show_stopped(self, reason: str) -> None:
        """Say why the view was not analysed."""
        self.show_running(False)
        self.state.setText(tr("This view has not been analysed yet."))
        self._tell("", "Analysis failed" if reason else "Cancelled", reason or "Nothing was changed. Recompute to continue.", "")

    def show_found(self, explanation: Explanation) -> None:
        """Show the reasons of the view."""
        new = explanation is not self._explanation
        self._explanation = explanation
        if new:
            self.make_cameras(explanation.view.cameras)
        self.show_running(False)
        self.state.setText(translated(summary(explanation)))
        if self._wanted is not None and self._wanted[0] in explanation.view.cameras:
            camera, line, across = self._wanted
            self.cameras.setValue(camera)
            self._ask(line, across)
        else:
            self._tell("", "", ASK, "")
        if new and self.kind.value() == "grey":
            self.kind.setValue("reasons")  # draws
        else:
            self._draw()

    def change_camera(self) -> None:
        """Show the picture of another camera."""
        self.picture.choose(None)
        self._tell("", "", ASK, "")
        self._draw()

    def _draw(self) -> None:
        if self._explanation is not None:
            self.holes.draw(self.cameras.value(), self.kind.value())

    @Slot(object)
    def _show_image(self, image: DrawnImage) -> None:
        if (image.camera, image.kind) != (self.cameras.value(), self.kind.value()):
            return
        self.picture.show_pixels(image.pixels)
        self.heading.setText(translated(HEADINGS[image.kind]))
        self._reasons = []
        if image.kind in ("exposure", "snr"):
            self.table.set_rows([_legend_cells(entry.words, entry.colour, entry.share) for entry in image.legend])
        else:
            self._show_shares(image.camera)

    def _show_shares(self, camera: str) -> None:
        from measureapp.pipeline.why_pictures import REASON_COLOURS

        shares = {} if self._explanation is None else self._explanation.shares[camera]
        self._reasons = list(shares)
        self.table.set_rows([_legend_cells(reason, REASON_COLOURS[reason], share) for reason, share in shares.items()])

    @Slot(int, int)
    def _ask(self, line: int, across: int) -> None:
        """Explain the state of a pixel."""
        if self._explanation is None:
            return
        answer = self._explanation.view.pixel(self.cameras.value(), line, across)
        self.picture.choose((line, across))
        reason = answer.found.reason
        words = point_reason(reason)
        stage = words if reason in NO_LOSS else f"{STAGES[answer.found.stage]}: {words.lower()}"
        sentence = "" if reason == "point" else answer.found.sentence
        self._tell(tr("Row {line}, column {across}", line=line, across=across), stage, sentence, figures(answer))

    @Slot(int, int)
    def _ask_for_reason(self, place: int, _column: int) -> None:
        """Show an example pixel with this reason."""
        if self._explanation is not None and place < len(self._reasons):
            self._ask(*self._explanation.view.example(self.cameras.value(), self._reasons[place]))

    def _tell(self, place: str, stage: str, answer: str, numbers: str) -> None:
        for shown, words in ((self.place, place), (self.stage, stage), (self.answer, answer), (self.figures, numbers)):
            shown.setText(translated(words))
            shown.setVisible(bool(words))


def summary(explanation: Explanation) -> str:
    """Return the measured share of the view, in a sentence."""
    from measureapp.pipeline.why import NO_HOLES

    measured = {name: sum(shares.get(reason, 0.0) for reason in NO_HOLES) for name, shares in explanation.shares.items()}
    said = ", ".join(f"{name} {percent(share)}" for name, share in measured.items())
    return tr("{counted} points. Pixels with measured surface: {said}.", counted=counted(len(explanation.view.made.cloud)), said=said)


def figures(answer: PixelAnswer) -> str:
    """Return the figures of a pixel with their limits, one per line."""
    return "\n".join(f"{sentence_case(one.what)} {_number(one)}" for one in answer.numbers)


def _number(one: Number) -> str:
    if one.unit == "µs":
        return exposure(round(one.value))
    digits = DIGITS.get(one.what, 1)
    limit = "" if one.least is None else tr(", at least {least:g}", least=one.least)
    limit += "" if one.most is None else tr(", at most {most:g}", most=one.most)
    return quantity(one.value, one.unit, digits) + limit


def _legend_cells(words: str, colour: tuple[int, int, int] | None, share: float | None) -> list[Cell]:
    sign = "eye" if colour is None else QColor(*colour).name()
    percentage = "" if share is None else "< 0.1\u00a0%" if 0 < share < 0.0005 else percent(share)
    return [Cell(point_reason(words), sign=sign), number(percentage)]
