"""The settings of the window; every change works at once."""

from __future__ import annotations

from PySide6.QtWidgets import QDialog, QWidget

from ui.look.look import Look
from ui.settings.settings import Settings
from ui.widgets.basic import Button, CalmComboBox, Form, column, label, row
from ui.widgets.segments import Segments

THEMES = {"system": "Like the system", "light": "Light", "dark": "Dark"}
ROLES = {"engineer": "Engineer", "operator": "Operator"}
LANGUAGES = {"en": "English", "zh_CN": "简体中文"}


class SettingsDialog(QDialog):
    """Theme, language, role at the start, sizes of the window."""

    def __init__(self, look: Look, settings: Settings, languages: tuple[str, ...], parent: QWidget | None = None) -> None:
        """``languages``: those that can be chosen."""
        super().__init__(parent)
        self.setWindowTitle("Settings")
        self.setMinimumWidth(560)
        self._settings = settings
        self.theme = Segments(THEMES, name="Theme")
        self.role = Segments(ROLES, name="Role at the start")
        self.language = CalmComboBox()
        for name in languages:
            self.language.addItem(LANGUAGES[name], name)
        self.forget = Button("Forget sizes", look, "again", "normal", "Give window and panels their first sizes at the next start")
        self.forgotten = label("", "small")
        form = Form()
        form.add("Theme", self.theme)
        form.add("Language", self.language)
        form.add("Role at the start", self.role)
        form.add("Window", row(self.forget, self.forgotten, 0))
        kept = label(f"Kept in {settings.file}.", "small", wrap=True)
        close = Button("Close", look, "", "primary", "Close the settings")
        self.setLayout(column(label("Settings", "title"), form, kept, row(0, close), margin=24, spacing=16))
        self.theme.valueChanged.connect(lambda value: settings.set_text("theme", value))
        self.role.valueChanged.connect(lambda value: settings.set_text("role", value))
        self.language.activated.connect(lambda _: settings.set_text("language", self.language.currentData()))
        self.forget.clicked.connect(self._forget)
        close.clicked.connect(self.accept)

    def begin(self) -> None:
        """Show the present settings."""
        self.theme.setValue(self._settings.text("theme"))
        self.role.setValue(self._settings.text("role"))
        self.language.setCurrentIndex(max(0, self.language.findData(self._settings.text("language"))))
        self.forgotten.setText("")
        self.show()
        self.raise_()

    def _forget(self) -> None:
        self._settings.forget_layout()
        self.forgotten.setText("Forgotten.")
