"""Editor of what is known about the lengths of a calibration board: its class or certificate, and its temperature."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QComboBox, QLineEdit, QWidget

from measureapp.data.board import AnyBoard
from measureapp.data.certificate import BOARD_CLASSES, BoardClass, BoardLengths
from measureapp.errors import InputError
from ui.look.language.words import tr, translated
from ui.settings.dialogs import choose_file

NOT_STATED, CERTIFICATE, KEPT = "", "certificate", "kept"
WORDS = {
    NOT_STATED: "Not stated",
    "printed": "Printed, ± 0.1 mm on 180 mm",
    "glass": "Film on glass, ± 50 ppm",
    "ceramic": "Chrome on glass or ceramic",
    CERTIFICATE: "Certificate…",
}
TIP = "How well the lengths of the board are known: the scale of everything that is measured with this calibration"
TEMPERATURE_TIP = "Of the board in °C with its uncertainty (k = 2), while the images are taken; empty: not measured"
FILES = "Certificates (*.toml *.csv);;All files (*)"


class BoardLengthsField(QWidget):
    """Two editors for rows of a form: `source` and `temperature`. `apply` puts their values into a board."""

    edited = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.source = QComboBox()
        for value, words in WORDS.items():
            self.source.addItem(translated(words), value)
        self.source.setToolTip(translated(TIP))
        self.source.setAccessibleName(tr("Lengths"))
        self.temperature = QLineEdit()
        self.temperature.setPlaceholderText(tr("not measured; such as 21.5±0.5"))
        self.temperature.setToolTip(translated(TEMPERATURE_TIP))
        self.temperature.setAccessibleName(tr("Temperature of the board"))
        self._file: Path | None = None
        self._kept: dict[str, Any] = {}  # what an earlier board had from its certificate
        self.source.activated.connect(self._ask)
        self.source.currentIndexChanged.connect(self.edited)
        self.temperature.textChanged.connect(self.edited)
        self.hide()

    def apply(self, board: AnyBoard) -> AnyBoard:
        """Return the board with what is stated. Raises ValueError where the certificate or the temperature cannot be used."""
        from measureapp.project.calibration.certificate_file import with_lengths

        chosen = self.source.currentData()
        kind: BoardClass | None = chosen if chosen in BOARD_CLASSES else None
        certificate = self._file if chosen == CERTIFICATE else None
        try:
            known = board.model_validate(board.model_dump() | self._kept) if chosen == KEPT else board
            return with_lengths(known, certificate, kind, self.temperature.text().strip() or None)
        except InputError as error:
            raise ValueError(error.message.removesuffix(".")) from error

    def show_board(self, board: AnyBoard) -> None:
        """Show what a board states."""
        self.blockSignals(True)
        self._forget()
        lengths = board.lengths
        if board.certified_mm is not None or (lengths is not None and lengths.source not in BOARD_CLASSES):
            self._kept = {"lengths": lengths, "certified_mm": board.certified_mm}
            self.source.addItem(_words_of(lengths), KEPT)
            self.source.setCurrentIndex(self.source.count() - 1)
        else:
            self.source.setCurrentIndex(self.source.findData(NOT_STATED if lengths is None else lengths.source))
        measured = lengths is not None and lengths.board_c is not None
        self.temperature.setText(f"{lengths.board_c:g}±{2 * lengths.board_sigma_k:g}" if measured and lengths is not None else "")
        self.blockSignals(False)

    def _ask(self) -> None:
        """Ask for the file where a certificate is chosen; without one, nothing is stated."""
        if self.source.currentData() != CERTIFICATE:
            return
        chosen = choose_file(self.source, "Certificate of the board", FILES, "certificates", self._file)
        if chosen is not None:
            self.read(chosen)
        elif self._file is None:
            self.source.setCurrentIndex(self.source.findData(NOT_STATED))

    def read(self, file: Path) -> None:
        """Take the lengths from a certificate."""
        self._file = file
        place = self.source.findData(CERTIFICATE)
        self.source.setItemText(place, tr("Certificate {name}", name=file.name))
        self.source.setCurrentIndex(place)
        self.edited.emit()

    def _forget(self) -> None:
        self._file, self._kept = None, {}
        self.source.setItemText(self.source.findData(CERTIFICATE), translated(WORDS[CERTIFICATE]))
        place = self.source.findData(KEPT)
        if place >= 0:
            self.source.removeItem(place)


def _words_of(lengths: BoardLengths | None) -> str:
    if lengths is None:
        return "Certified marks"
    return tr("Certificate {number}", number=lengths.number).strip() if lengths.source == "certificate" else "Exact"
