"""In operator mode nothing of the engineer's is reachable: no shortcut, menu, dropped file or other window."""

from __future__ import annotations

from PySide6.QtGui import QAction, QShortcut
from PySide6.QtWidgets import QApplication, QMainWindow, QWidget
from shiboken6 import isValid


class EngineerLock:
    """Disables what leads out of a workspace, and restores it as it was."""

    def __init__(self, window: QMainWindow, workspace: QWidget) -> None:
        self._window, self._workspace = window, workspace
        self._disabled: list[QAction | QShortcut] = []
        self._hidden: list[QWidget] = []
        self._accepted_drops = False
        self.is_locked = False

    def lock(self) -> None:
        """Disable shortcuts and actions of the window, refuse dropped files, and hide the engineer's other windows."""
        if self.is_locked:
            return
        self.is_locked = True
        found = [*self._window.findChildren(QShortcut), *self._window.findChildren(QAction)]
        self._disabled = [one for one in found if one.isEnabled() and not self._is_operators(one)]
        for one in self._disabled:
            one.setEnabled(False)
        self._accepted_drops = self._window.acceptDrops()
        self._window.setAcceptDrops(False)
        self._hidden = [other for other in QApplication.topLevelWidgets() if other is not self._window and self._is_engineers(other)]
        for other in self._hidden:
            other.hide()

    def unlock(self) -> None:
        """Give the engineer back what was disabled and hidden."""
        if not self.is_locked:
            return
        self.is_locked = False
        for one in filter(isValid, self._disabled):
            one.setEnabled(True)
        self._window.setAcceptDrops(self._accepted_drops)
        for other in filter(isValid, self._hidden):  # a job that ended meanwhile may have closed one for good
            other.show()
        self._disabled, self._hidden = [], []

    def _is_operators(self, one: QAction | QShortcut) -> bool:
        parent = one.parent()
        return isinstance(parent, QWidget) and (parent is self._workspace or self._workspace.isAncestorOf(parent))

    def _is_engineers(self, other: QWidget) -> bool:
        return (
            other.isVisible() and other.parentWidget() is not None and other.window() is other and not self._workspace.isAncestorOf(other)
        )
