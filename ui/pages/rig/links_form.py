"""Links of a rig: what several drivers share, each with a name and settings."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLineEdit, QWidget

from measureapp.devices.plugin_loader import LoadedDriver
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.widgets.basic import Button, Form, card, clear, column, label, row
from ui.widgets.field_editors import FieldEditor, TableEditor
from ui.widgets.model_form import FieldRows

NONE_YET = "A link is what several drivers share: a serial line, a gateway, a simulated rig. Drivers name it in their setting “Link”."


class LinksForm(FieldEditor):
    """Edits the tables of settings by name; a link that a driver in use names has the form of this driver."""

    def __init__(self, look: Look, links: Mapping[str, Any], models: Mapping[str, LoadedDriver]) -> None:
        super().__init__()
        self._look, self._models = look, models
        self._rows: list[tuple[QLineEdit, FieldEditor]] = []
        self._column = column(spacing=16)
        self._problem = label("", "problem", wrap=True)
        self._problem.hide()
        self.add = Button("Add a link", look, "add")
        self.add.clicked.connect(self._append)
        self.setLayout(column(label(NONE_YET, "soft", wrap=True), self._column, self._problem, row(self.add, 0), spacing=16))
        self.set_raw(links)

    def raw(self) -> dict[str, Any]:
        """Return the tables by name; of two with the same name the later one, see `names_problem`."""
        return {name.text().strip(): settings.raw() for name, settings in self._rows}

    def names_problem(self) -> str:
        """Return what is wrong with the names; empty if nothing is."""
        names = [name.text().strip() for name, _ in self._rows]
        if "" in names:
            return "Enter a name for each link."
        twice = next((name for name in names if names.count(name) > 1), "")
        return tr("Two links have the name {twice}.", twice=twice) if twice else ""

    def set_raw(self, value: Any) -> None:
        """Show tables by name."""
        clear(self._column)
        self._rows = []
        for name, table in dict(value or {}).items():
            self._show(name, table)

    def place_problem(self, place: tuple[int | str, ...], words: str) -> bool:
        """Show a problem inside the link that it concerns."""
        for name, settings in self._rows:
            if place and name.text().strip() == place[0] and settings.place_problem(place[1:], words):
                return True
        self._problem.setText(translated(words))
        self._problem.show()
        return True

    def clear_problems(self) -> None:
        """Show no problem."""
        self._problem.hide()
        for _, settings in self._rows:
            settings.clear_problems()

    def _append(self) -> None:
        used = self.raw()
        numbered = (f"link{number}" for number in range(1, len(used) + 2))
        self._show(next(name for name in (*self._models, *numbered) if name not in used), {})
        self.edited.emit()

    def _show(self, name: str, table: Any) -> None:
        line = QLineEdit(name)
        line.setAccessibleName(tr("Name of the link"))
        known = self._models.get(name)
        settings = TableEditor() if known is None or known.link is None else FieldRows(known.link)
        settings.set_raw(table)
        remove = Button("Remove", self._look, "remove", tip=tr("Remove the link {name}", name=name))
        entry = (line, settings)
        remove.clicked.connect(lambda: self._remove(entry))
        form = Form()
        form.add("Name", line)
        heading = QWidget()
        heading.setLayout(form)
        framed = card(row(heading, remove, spacing=16), settings)
        framed.layout().setAlignment(Qt.AlignmentFlag.AlignTop)
        line.textEdited.connect(self.edited)
        settings.edited.connect(self.edited)
        self._rows.append(entry)
        self._column.addWidget(framed)

    def _remove(self, entry: tuple[QLineEdit, FieldEditor]) -> None:
        kept = [(name.text(), settings.raw()) for name, settings in self._rows if (name, settings) != entry]
        self.set_raw({})
        for name, table in kept:  # two may have the same name
            self._show(name, table)
        self.edited.emit()
