"""Editor of a file or folder path."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QLineEdit, QWidget

from ui.look.language.words import translated
from ui.look.look import Look
from ui.settings.dialogs import choose_file, choose_folder
from ui.widgets.basic import Button, row


class PathField(QWidget):
    """`value()` is the path, or None while the field is empty."""

    valueChanged = Signal(object)

    def __init__(self, look: Look, title: str, placeholder: str, purpose: str, *, files: str = "") -> None:
        """``title``: of the dialog; ``purpose``: by which its folder is remembered; ``files``: its filter; empty: choose folders."""
        super().__init__()
        self._title, self._purpose, self._files = title, purpose, files
        self.text = QLineEdit()
        self.text.setPlaceholderText(translated(placeholder))
        self.text.setToolTip(translated(placeholder))
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
        if self._files:
            chosen = choose_file(self, self._title, self._files, self._purpose, self.value())
        else:
            chosen = choose_folder(self, self._title, self._purpose, self.value())
        if chosen is not None:
            self.text.setText(str(chosen))
