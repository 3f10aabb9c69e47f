"""Choice of the driver of one device, and its settings."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtGui import QStandardItem, QStandardItemModel

from measureapp.data.rig import RECORDED
from measureapp.devices.plugin_loader import PluginKind, PluginOffer
from ui.look.language.words import tr, translated
from ui.look.wording import with_hint
from ui.pages.rig.rig_draft import loaded
from ui.widgets.basic import CalmComboBox, Form, clear, column, label
from ui.widgets.field_editors import FieldEditor, TableEditor
from ui.widgets.model_form import FieldRows

RECORDING = "Recording: there are no devices"
NO_MODEL = "These settings are kept as they are and checked when the rig is connected."


class DriverForm(FieldEditor):
    """Edits {"driver", "settings"}; the settings of a driver that is not loaded are lines of TOML."""

    def __init__(self, kind: PluginKind, offers: Sequence[PluginOffer], choice: dict[str, Any]) -> None:
        super().__init__()
        self._drives, self._offers = kind, offers
        self._remembered = {choice["driver"]: choice["settings"]}  # of drivers chosen before
        self.box = CalmComboBox()
        self.box.setAccessibleName(tr("Driver"))
        self.box.setMinimumContentsLength(24)
        self.box.setSizeAdjustPolicy(CalmComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self._list(choice["driver"])
        self.note, self._problem = label("", "small", wrap=True), label("", "problem", wrap=True)
        self.settings: FieldEditor | None = None
        self._place = column()
        form = Form()
        form.add("Driver", self.box)
        self.setLayout(column(form, self._problem, self.note, self._place, spacing=8))
        self._choose()
        self.box.currentIndexChanged.connect(self._choose_other)

    @property
    def driver(self) -> str:
        """Id of the driver chosen; empty if none is."""
        return str(self.box.currentData() or "")

    def raw(self) -> dict[str, Any]:
        """Return the driver and what was entered as its settings."""
        return {"driver": self.driver, "settings": self.settings.raw() if self.settings is not None else {}}

    def place_problem(self, place: tuple[int | str, ...], words: str) -> bool:
        """Show a problem below the driver or below the setting at ``place``."""
        inner = place[1:] if place[:1] == ("settings",) else ()
        if not (inner and self.settings is not None and self.settings.place_problem(inner, words)):
            self._problem.setText(translated(words))
            self._problem.show()
        return True

    def clear_problems(self) -> None:
        """Show no problem."""
        self._problem.hide()
        if self.settings is not None:
            self.settings.clear_problems()

    def _list(self, chosen: str) -> None:
        """List the fitting drivers; those that are not loaded state why and cannot be chosen, unless they are in use."""
        entries = {offer.row.id: (offer.row.name, offer.row.problem) for offer in self._offers if self._drives in offer.row.kinds}
        if self._drives == "rig":
            entries[RECORDED] = (RECORDING, "")
        if chosen not in entries:
            entries = {chosen: (chosen or "Choose a driver", "There is no such driver." if chosen else "")} | entries
        items = self.box.model()
        assert isinstance(items, QStandardItemModel)
        for name, (words, problem) in entries.items():
            item = QStandardItem(tr("{words} – not loaded", words=words) if problem else translated(words))
            item.setData(name, Qt.ItemDataRole.UserRole)
            item.setToolTip(translated(problem))
            item.setEnabled(not problem or name == chosen)
            items.appendRow(item)
        self.box.setCurrentIndex(self.box.findData(chosen))

    def _choose_other(self) -> None:
        self._choose()
        self.edited.emit()

    def _choose(self) -> None:
        if self.settings is not None:
            self._remembered[self._shown] = self.settings.raw()
        clear(self._place)
        self._shown = self.driver
        self.settings = self._settings_editor()
        if self.settings is not None:
            self.settings.edited.connect(self.edited)
            self._place.addWidget(self.settings)

    def _settings_editor(self) -> FieldEditor | None:
        row = next((offer.row for offer in self._offers if offer.row.id == self.driver), None)
        problem = "" if row is None else with_hint(row.problem, row.hint)
        known = loaded(self._offers, self.driver, self._drives)
        values = self._remembered.get(self.driver, {})
        self.note.setText(with_hint(problem, NO_MODEL) if known is None else "")
        self._problem.hide()
        if known is not None:
            self.note.setText(translated(_unknown(values, known.settings.model_fields)))
        self.note.setVisible(bool(self.note.text()) and self.driver not in ("", RECORDED))
        if self.driver in ("", RECORDED):
            return None
        editor = TableEditor() if known is None else FieldRows(known.settings)
        editor.set_raw(values)
        return editor


def _unknown(values: Any, fields: Any) -> str:
    """Return which settings the driver does not know; they are not saved again."""
    strangers = sorted(set(values) - set(fields)) if isinstance(values, dict) else []
    return tr("The driver has no setting {list}; it is removed when you save.", list=", ".join(strangers)) if strangers else ""
