"""List of all driver plugins, with the reason for those that are not loaded; permission for drivers from outside."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from measureapp.devices.plugin_loader import PluginOffer, PluginRow
from measureapp.resources import user_plugin_folder
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import sentence_case
from ui.widgets.basic import Button, card, column, label, row
from ui.widgets.data_table import Cell, DataTable, verdict_cell

WHERE = "Drivers of your own are folders in {folder}. The computer runs their code: allow only those whose origin you trust."


class DriversList(QWidget):
    """Shows the plugins; `allowAsked` fires when one from outside is to be allowed."""

    allowAsked = Signal(object)  # PluginRow

    def __init__(self, look: Look, offers: Sequence[PluginOffer], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.rows: list[PluginRow] = []
        self.table = DataTable(look, ["Driver", "Version", "Drives", "State"], stretch=0)
        self.table.rowSelected.connect(self._show_row)
        self.name = label("", "heading", wrap=True)
        self.reason = label("", "body", wrap=True)
        self.place = label("", "small", wrap=True)
        self.allow = Button("Allow this driver…", look, tip="Shows its folder and fingerprint, then asks")
        self.allow.clicked.connect(self._ask)
        where = label(tr(WHERE, folder=user_plugin_folder()), "soft", wrap=True)
        self.setLayout(column(where, self.table, card(self.name, self.reason, self.place, row(self.allow, 0)), spacing=16))
        self.set_offers(offers)

    def set_offers(self, offers: Sequence[PluginOffer]) -> None:
        """Show these plugins, those with a problem first."""
        self.rows = sorted((offer.row for offer in offers), key=lambda row: not row.problem)
        self.table.set_rows(
            [
                [
                    Cell(row.name, bold=True, tip=f"{row.name} ({row.id})"),
                    Cell(row.version or "–"),
                    Cell(", ".join(sentence_case(kind.replace("-", " ")) for kind in row.kinds) or "–"),
                    _state(row),
                ]
                for row in self.rows
            ]
        )
        if self.rows:
            self.table.selectRow(0)
        self._show_row(0)

    def selected(self) -> PluginRow | None:
        """Return the plugin selected."""
        place = self.table.currentIndex().row()
        return self.rows[place] if 0 <= place < len(self.rows) else None

    def _show_row(self, _place: int) -> None:
        row = self.selected()
        self.name.setText(translated(row.name) if row is not None else "")
        self.reason.setText("" if row is None else translated(row.problem) or tr("Loaded."))
        self.place.setText(
            "" if row is None else tr("{words} Folder: {folder}", words=row.hint if row.allowed else "", folder=row.folder).strip()
        )
        self.allow.setVisible(row is not None and not row.allowed)

    def _ask(self) -> None:
        row = self.selected()
        if row is not None:
            self.allowAsked.emit(row)


def _state(row: PluginRow) -> Cell:
    if not row.allowed:
        return verdict_cell("not proven", "Not allowed yet", row.problem)
    return verdict_cell("fail", "Not loaded", row.problem) if row.problem else verdict_cell("pass", "Loaded")
