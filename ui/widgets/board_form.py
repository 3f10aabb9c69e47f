"""Editor of the calibration board: kind, marks and sizes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QComboBox, QLabel, QSpinBox, QWidget

from measureapp.data.board import DICTIONARIES, BoardDescription, CharucoDescription, CheckerboardDescription, CirclesDescription
from ui.look.language.words import translated
from ui.widgets.basic import Form, label
from ui.widgets.board_lengths import BoardLengthsField
from ui.widgets.number_field import NumberField
from ui.widgets.segments import Segments

KINDS = {"checkerboard": "Checkerboard", "charuco": "ChArUco", "circles": "Circles"}
MODELS: Mapping[str, type[BoardDescription]] = {
    "checkerboard": CheckerboardDescription,
    "charuco": CharucoDescription,
    "circles": CirclesDescription,
}
LENGTHS = {"checkerboard": ("square_mm",), "charuco": ("square_mm", "marker_mm"), "circles": ("spacing_mm", "diameter_mm")}
WORDS = {"square_mm": "Square", "marker_mm": "Marker", "spacing_mm": "Row distance", "diameter_mm": "Diameter"}
START = {"square_mm": 15.0, "marker_mm": 11.0, "spacing_mm": 10.0, "diameter_mm": 6.0}
CORNERS, CIRCLES = ("Inner corners across", "Inner corners down"), ("Circles in a row", "Rows")


class BoardForm(QWidget):
    """Edits a `BoardDescription`: value(), setValue(board), valueChanged, edited, problem()."""

    valueChanged = Signal(object)
    edited = Signal()  # also while the settings are invalid

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.kind = Segments(KINDS)
        self.columns, self.rows = QSpinBox(), QSpinBox()
        for spin, least in ((self.columns, 2), (self.rows, 3)):
            spin.setRange(least, 200)
        self.lengths = {name: NumberField() for name in WORDS}
        for name, length in self.lengths.items():
            length.setRange(0.01, 1000.0)
            length.setDecimals(3)
            length.setSuffix(" mm")
            length.setValue(START[name])
        self.dictionary = QComboBox()
        self.dictionary.addItems(list(DICTIONARIES))
        self.dictionary.setCurrentText("5X5_250")
        self.known = BoardLengthsField(self)
        self.note = label("", "small", wrap=True)
        self._columns_word, self._rows_word = QLabel(), QLabel()
        self._form = Form(self)
        self._form.add("Kind", self.kind)
        self._form.add(self._columns_word, self.columns)
        self._form.add(self._rows_word, self.rows)
        for name, words in WORDS.items():
            self._form.add(words, self.lengths[name])
        self._form.add("Dictionary", self.dictionary)
        self._form.add("Lengths", self.known.source)
        self._form.add("Board temperature", self.known.temperature)
        self._form.addRow("", self.note)
        self._bow = (0.0, 0.0, 0.0)
        self._legacy = False
        self.setValue(CheckerboardDescription(columns=14, rows=11, square_mm=15.0))
        self.kind.valueChanged.connect(self._show_kind)
        self.dictionary.currentIndexChanged.connect(self._show_kind)
        self.known.edited.connect(self._show_kind)
        for editor in (self.columns, self.rows, *self.lengths.values()):
            editor.valueChanged.connect(self._show_kind)

    def value(self) -> BoardDescription:
        """Return the board. Raises ValueError when the sizes contradict each other; see `problem`."""
        kind = self.kind.value()
        fields: dict[str, Any] = {"kind": kind, "columns": self.columns.value(), "rows": self.rows.value(), "bow_mm": self._bow}
        fields |= {name: self.lengths[name].value() for name in LENGTHS[kind]}
        if kind == "charuco":
            fields |= {"dictionary": self.dictionary.currentText(), "legacy_pattern": self._legacy}
        return self.known.apply(MODELS[kind].model_validate(fields))  # type: ignore[arg-type]

    def setValue(self, board: BoardDescription) -> None:
        """Set the board."""
        values = board.model_dump()
        self.known.show_board(board)  # type: ignore[arg-type]
        kind = next(name for name, model in MODELS.items() if isinstance(board, model))
        self._bow = board.bow_mm
        for editor in (self.columns, self.rows, self.dictionary, *self.lengths.values()):
            editor.blockSignals(True)
        self.columns.setValue(board.columns)
        self.rows.setValue(board.rows)
        for name in LENGTHS[kind]:
            self.lengths[name].setValue(values[name])
        if isinstance(board, CharucoDescription):
            self.dictionary.setCurrentText(board.dictionary)
            self._legacy = board.legacy_pattern
        for editor in (self.columns, self.rows, self.dictionary, *self.lengths.values()):
            editor.blockSignals(False)
        self.kind.setValue(kind)
        self._show_kind()

    def problem(self) -> str:
        """Return the problem of the settings; empty if they are valid."""
        try:
            self.value()
        except ValueError as error:
            return str(error.errors()[0]["msg"]).removeprefix("Value error, ") if hasattr(error, "errors") else str(error)
        return ""

    def _show_kind(self) -> None:
        kind = self.kind.value()
        across, down = CIRCLES if kind == "circles" else CORNERS
        self._columns_word.setText(translated(across))
        self._rows_word.setText(translated(down))
        for name, length in self.lengths.items():
            self._form.setRowVisible(length, name in LENGTHS[kind])
        self._form.setRowVisible(self.dictionary, kind == "charuco")
        problem = self.problem()
        self.note.setText(problem[:1].upper() + problem[1:] + "." if problem else "")
        self._form.setRowVisible(self.note, bool(problem))
        self.edited.emit()
        if not problem:
            self.valueChanged.emit(self.value())
