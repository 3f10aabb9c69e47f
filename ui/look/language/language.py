"""The language of the window: which there are, which is chosen, and how it is changed while the window is open."""

from __future__ import annotations

from PySide6.QtCore import QLocale, QObject, Signal

from measureapp.resources import resource
from ui.look.language.catalogue import read_catalogue
from ui.look.language.words import TRANSLATOR

LANGUAGES = {"en": "English", "zh_CN": "简体中文"}  # each in its own words
SYSTEM = "system"


def system_language() -> str:
    """Return the language of the operating system if the window has it, else English."""
    name = QLocale.system().name()
    return next((one for one in LANGUAGES if name.startswith(one.split("_")[0]) and one != "en"), "en")


class Language(QObject):
    """The chosen language; emits ``changed`` after all new texts are in it."""

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.name = "en"

    def choose(self, name: str) -> None:
        """Use a language by its name, or that of the system. Raises InputError where its catalogue is damaged."""
        wanted = system_language() if name == SYSTEM else name if name in LANGUAGES else "en"
        if wanted == self.name:
            return
        TRANSLATOR.catalogue = None if wanted == "en" else read_catalogue(resource(f"languages/measureapp_{wanted}.ts"))
        self.name = wanted
        QLocale.setDefault(QLocale(wanted))
        self.changed.emit()
