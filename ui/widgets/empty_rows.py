"""What stands in a table without rows: a sentence that says how it is filled."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import QAbstractItemView, QLabel

from ui.look.language.words import translated

MARGIN = 24


class EmptyRows(QLabel):
    """Shown over a view while its model has no rows."""

    def __init__(self, view: QAbstractItemView, words: str) -> None:
        super().__init__(translated(words), view.viewport())
        self._view = view
        self.setProperty("role", "soft")
        self.setWordWrap(True)
        self.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)  # what is dropped on the view reaches it
        model = view.model()
        for changed in (model.modelReset, model.rowsInserted, model.rowsRemoved, model.layoutChanged):
            changed.connect(self._follow)
        view.viewport().installEventFilter(self)
        self._follow()

    def say(self, words: str) -> None:
        """Say something else."""
        self.setText(translated(words))

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        """Keep the size of the view."""
        if event.type() == QEvent.Type.Resize:
            self._fit()
        return False

    def _follow(self) -> None:
        self.setVisible(self._view.model().rowCount() == 0)
        self._fit()

    def _fit(self) -> None:
        self.setGeometry(self._view.viewport().rect().adjusted(MARGIN, 0, -MARGIN, 0))
