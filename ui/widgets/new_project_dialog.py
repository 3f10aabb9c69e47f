"""Name, part and place of a new project."""

from __future__ import annotations

import unicodedata
from pathlib import Path

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QDialog, QLineEdit, QWidget

from measureapp.project.file_names import safe_file_name
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.widgets.basic import Button, Form, column, label, row
from ui.widgets.path_field import PathField

FORBIDDEN = '<>:"/\\|?*'


class NewProjectDialog(QDialog):
    """Asks for a name; the folder of the project gets it."""

    chosen = Signal(object, str)  # folder (Path), part

    def __init__(self, look: Look, place: Path, rig: str, parent: QWidget | None = None) -> None:
        """``place``: folder in which the project is made; ``rig``: name of the rig that measures, empty: none."""
        super().__init__(parent)
        self.setWindowTitle(tr("New project"))
        self.setMinimumWidth(560)
        self._rig = rig
        self.name, self.part = QLineEdit(), QLineEdit()
        self.name.setPlaceholderText(tr("Such as “Housing 4711”"))
        self.part.setPlaceholderText(tr("Name of the part"))
        self.place = PathField(look, "Choose where the project is made", "Folder of your projects", "projects")
        self.place.setValue(place)
        self.problem = label("", "problem", wrap=True)
        self.create = Button("Create", look, "", "primary", "Make the folder of the project")
        cancel = Button("Cancel", look, "", "normal", "Make nothing")
        form = Form()
        for words, editor in (("Name", self.name), ("Part", self.part), ("In the folder", self.place)):
            form.add(words, editor)
        form.add("Rig", label(rig or "Choose one on the page Rig first.", "body", wrap=True))
        self.setLayout(column(label("New project", "title"), form, self.problem, row(0, cancel, self.create), margin=24, spacing=16))
        for line in (self.name, self.part, self.place.text):
            line.textChanged.connect(self._check)
        self.create.clicked.connect(self._choose)
        self.create.setDefault(True)
        cancel.clicked.connect(self.reject)
        self._check()

    def folder(self) -> Path | None:
        """Return the folder of the project; None while something is missing."""
        name, place = self.name.text().strip(), self.place.value()
        return place / name if name and place is not None and not self._problem() else None

    def _problem(self) -> str:
        name, place = self.name.text().strip(), self.place.value()
        wrong = sorted(set(name) & set(FORBIDDEN))
        if not self._rig:
            return "A project belongs to a rig. Choose one on the page Rig first."
        if wrong or name.endswith("."):
            return tr("A name cannot contain {list}.", list=" ".join(wrong)) if wrong else "A name cannot end with a dot."
        if name and (possible := safe_file_name(name)) != unicodedata.normalize("NFC", name):
            return tr("Not every system takes this name for a folder. Choose another, such as {name}.", name=possible)
        if (
            place is not None
            and name
            and (place / name).exists()
            and any((place / name).iterdir() if (place / name).is_dir() else ("file",))
        ):
            return tr("{value} exists already. Choose another name.", value=place / name)
        return ""

    def _check(self) -> None:
        self.problem.setText(translated(self._problem()))
        self.create.setEnabled(self.folder() is not None)

    def _choose(self) -> None:
        folder = self.folder()
        if folder is not None:
            self.accept()
            self.chosen.emit(folder, self.part.text().strip() or folder.name)
