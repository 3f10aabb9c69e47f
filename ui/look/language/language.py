"""The language of the window: which there are, which is chosen, and how it is changed while the window is open."""

from __future__ import annotations

from PySide6.QtCore import QLibraryInfo, QLocale, QObject, QTranslator, Signal
from PySide6.QtWidgets import QApplication

from measureapp.language.languages import LANGUAGES, catalogue_of
from ui.look.language.retranslating import Retranslation
from ui.look.language.words import TRANSLATOR

SYSTEM = "system"


def system_language() -> str:
    """Return the language of the operating system if the window has it, else English."""
    name = QLocale.system().name()
    return next((one for one in LANGUAGES if name.startswith(one.split("_")[0]) and one != "en"), "en")


class QtTexts(QTranslator):
    """Qt's own texts, such as those of its file dialogs; keys bear the names that keyboards, tooltips and help pages have: Alt+Up."""

    def translate(self, context: str, sourceText: str, disambiguation: str | None = None, n: int = -1) -> str | None:  # type: ignore[override]
        """Return the translation; None: another translator is asked, then the text stays."""
        return sourceText if context == "QShortcut" else super().translate(context, sourceText, disambiguation, n) or None


class Language(QObject):
    """The chosen language; texts made after ``changed`` are in it, those on display follow a little at a time."""

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.name = "en"
        QLocale.setDefault(QLocale("en"))  # fields for numbers then write them as all other texts do
        self._translator = QtTexts(self)
        self.retranslation = Retranslation(self)

    def choose(self, name: str) -> None:
        """Use a language by its name, or that of the system. Raises InputError where its catalogue is damaged."""
        wanted = system_language() if name == SYSTEM else name if name in LANGUAGES else "en"
        if wanted == self.name:
            return
        TRANSLATOR.use(catalogue_of(wanted))
        self.name = wanted
        QLocale.setDefault(QLocale(wanted))
        self._use_qt_texts()
        self.retranslation.begin()
        self.changed.emit()

    def _use_qt_texts(self) -> None:
        application = QApplication.instance()
        if not isinstance(application, QApplication):
            return
        application.removeTranslator(self._translator)
        if self.name == "en":
            return
        if self._translator.load(f"qtbase_{self.name}", QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath)):
            application.installTranslator(self._translator)
