"""The settings of the window; every change works at once."""

from __future__ import annotations

from PySide6.QtWidgets import QDialog, QWidget

from measureapp.language.languages import LANGUAGES
from ui.look.language.words import tr
from ui.look.look import Look
from ui.settings.settings import AS_SYSTEM, Settings
from ui.widgets.basic import Button, Form, column, label, row
from ui.widgets.segments import Segments

LANGUAGE_CHOICES = {AS_SYSTEM: "Like the system", **LANGUAGES}
THEMES = {"system": "Like the system", "light": "Light", "dark": "Dark"}


class SettingsDialog(QDialog):
    """Theme, language, and sizes of the window."""

    def __init__(self, look: Look, settings: Settings, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Settings"))
        self.setMinimumWidth(560)
        self._settings = settings
        self.theme = Segments(THEMES, name="Theme")
        self.language = Segments(LANGUAGE_CHOICES, name="Language")
        self.forget = Button("Forget sizes", look, "again", "normal", "Give window and panels their first sizes at the next start")
        self.forgotten = label("", "small")
        form = Form()
        form.add("Theme", self.theme)
        form.add("Language", self.language)
        form.add("Window", row(self.forget, self.forgotten, 0))
        kept = label(tr("Kept in {file}.", file=settings.file), "small", wrap=True)
        close = Button("Close", look, "", "primary", "Close the settings")
        self.setLayout(column(label("Settings", "title"), form, kept, row(0, close), margin=24, spacing=16))
        self.theme.valueChanged.connect(lambda value: settings.set_text("theme", value))
        self.language.valueChanged.connect(lambda value: settings.set_text("language", value))
        self.forget.clicked.connect(self._forget)
        close.clicked.connect(self.accept)

    def begin(self) -> None:
        """Show the present settings."""
        self.theme.setValue(self._settings.text("theme"))
        self.language.setValue(self._settings.text("language"))
        self.forgotten.setText("")
        self.show()
        self.raise_()

    def _forget(self) -> None:
        self._settings.forget_layout()
        self.forgotten.setText(tr("Forgotten."))
