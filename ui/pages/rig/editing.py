"""Opens the editor of the rig and connects it with its controller; one editor at a time, not in operator mode."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot
from PySide6.QtWidgets import QWidget

from ui.controllers.controllers import Controllers
from ui.look.look import Look
from ui.session import Session
from ui.widgets.basic import Button

if TYPE_CHECKING:
    from measureapp.devices.plugin_loader import PluginOffer, PluginRow
    from ui.pages.rig.rig_editor import RigEditor


class Editing(QObject):
    """The button “Edit rig…” and its editor; the other pages stay usable, and Stop in sight."""

    changed = Signal()  # the editor was opened or closed

    def __init__(self, look: Look, session: Session, controllers: Controllers, parent: QWidget) -> None:
        super().__init__(parent)
        self._look, self._session, self._page = look, session, parent
        self._rig, self._stopping = controllers.rig_editing, controllers.rig
        self.editor: RigEditor | None = None
        self._wanted = False
        self.button = Button("Edit rig…", look, tip="Drivers, settings, motion rules and nominal values of this rig")
        self.button.clicked.connect(self.open)
        self._rig.offered.connect(self._offer)
        self._rig.permissionAsked.connect(self._ask)
        self._rig.saved.connect(self._close)
        self._rig.refused.connect(self._refuse)
        session.appearanceChanged.connect(self._show)
        session.rigChanged.connect(self._show)
        session.busyChanged.connect(self._show)

    @Slot()
    def open(self) -> None:
        """Open the editor as soon as the drivers are listed."""
        self._wanted = True
        self.button.setEnabled(False)
        self._rig.list_drivers()

    @Slot(object)
    def _offer(self, offers: Sequence[PluginOffer]) -> None:
        if self.editor is not None:
            self.editor.set_offers(offers)
        elif self._wanted and self._session.rig is not None:
            self._open(offers)

    def _open(self, offers: Sequence[PluginOffer]) -> None:
        from ui.pages.rig.rig_editor import RigEditor

        assert self._session.rig is not None
        self._wanted = False
        editor = self.editor = RigEditor(self._look, self._session.rig, self._session.rig_file, offers, self._page)
        editor.saveAsked.connect(self._rig.save)
        editor.allowAsked.connect(self._rig.ask_permission)
        editor.allowed.connect(self._rig.allow)
        editor.escapePressed.connect(self._stop)
        editor.finished.connect(self._forget)
        editor.show()
        self._show()

    @Slot(object, str)
    def _ask(self, row: PluginRow, seen: str) -> None:
        if self.editor is not None:
            self.editor.ask_permission(row, seen)

    @Slot(object)
    def _close(self, _path: Path) -> None:
        if self.editor is not None:
            self.editor.accept()

    @Slot(str)
    def _refuse(self, words: str) -> None:
        self._wanted = False
        if self.editor is not None:
            self.editor.show_refusal(words)
        self._show()

    @Slot()
    def _stop(self) -> None:
        if self._session.cell.connected or self._session.moving:
            self._stopping.stop()

    @Slot()
    def _forget(self) -> None:
        if self.editor is not None:
            self.editor.deleteLater()
        self.editor = None
        self._show()

    @Slot()
    def _show(self) -> None:
        engineer = self._session.role == "engineer"
        self.button.setVisible(engineer and self._session.rig is not None)
        self.button.setEnabled(self.editor is None and not self._session.busy_with)
        if not engineer and self.editor is not None:
            self.editor.reject()
        self.changed.emit()
