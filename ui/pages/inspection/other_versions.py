"""A notice that rows of one table were evaluated by different versions of MeasureApp."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from PySide6.QtWidgets import QFrame

from ui.controllers.program_rows import DimensionRow
from ui.controllers.programming import ProgrammingController
from ui.look.language.words import tr
from ui.look.look import Look
from ui.pages.inspection.dimension_model import OTHER_VERSION
from ui.widgets.basic import Button, label, row

TIP = "Evaluate every dimension with this version; the results are stored when the program is saved"


class OtherVersions(QFrame):
    """Says which rows are older, and offers to measure all again."""

    def __init__(self, look: Look, programming: ProgrammingController) -> None:
        super().__init__()
        self.setObjectName("card")
        self._programming = programming
        self.words = label("", "problem", wrap=True)
        self.again = Button("Measure all", look, "again", "quiet", TIP)
        self.again.clicked.connect(programming.measure_all)
        content = row(self.words, self.again, margin=8, spacing=8)
        content.setStretch(0, 1)
        self.setLayout(content)
        self.hide()

    def show_rows(self, rows: Sequence[DimensionRow], marked: Collection[int]) -> None:
        """Show the notice while rows are marked."""
        versions = sorted({one.found.version for one in rows if one.id in marked and one.found is not None})
        named = ", ".join(version or tr("an earlier version") for version in versions)
        self.words.setText(
            tr(
                "{mark} Evaluated by another version of MeasureApp ({named}): its U may follow another error model than those beside it.",
                mark=OTHER_VERSION,
                named=named,
            )
        )
        self.again.setVisible(self._programming.can_change)
        self.setVisible(bool(marked))
