"""Editor of a file or folder path."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QFileDialog, QLineEdit, QWidget

from ui.look.look import Look
from ui.widgets.basic import Button, row


class PathField(QWidget):
    """`value()` is the path, or None while the field is empty."""

    valueChanged = Signal(object)

    def __init__(self, look: Look, title: str, placeholder: str, *, files: str = "") -> None:
        """``title``: of the dialog; ``files``: its filter, such as "Tables (*.csv)"; empty: choose folders."""
        super().__init__()
        self._title, self._files = title, files
        self.text = QLineEdit()
        self.text.setPlaceholderText(placeholder)
        self.text.setToolTip(placeholder)
        self.text.textChanged.connect(lambda _text: self.valueChanged.emit(self.value()))
        self.browse = Button("Browse…", look, "open")
        self.browse.clicked.connect(self._choose)
        layout = row(self.text, self.browse)
        layout.setStretch(0, 1)
        self.setLayout(layout)

    def value(self) -> Path | None:
        """Return the path; None if empty."""
        words = self.text.text().strip()
        return Path(words).expanduser() if words else None

    def setValue(self, path: Path | None) -> None:
        """Set the path."""
        self.text.setText("" if path is None else str(path))
        self.text.setCursorPosition(0)

    def _choose(self) -> None:
        start = self.text.text() or str(Path.home())
        if self._files:
            chosen, _ = QFileDialog.getOpenFileName(self, self._title, start, self._files)
        else:
            chosen = QFileDialog.getExistingDirectory(self, self._title, start)
        if chosen:
            self.text.setText(chosen)
