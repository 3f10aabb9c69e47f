"""What a scan has not measured, with causes, and the viewpoints that are expected to measure it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QDialog, QWidget

from ui.look.language.words import tr
from ui.look.look import Look
from ui.look.wording import percent, rough_duration
from ui.widgets.basic import Button, column, label, row
from ui.widgets.checklist import Checklist, Item

if TYPE_CHECKING:
    from measureapp.pipeline.closed_loop.of_project import ClosedLoop

SMALLEST = (560, 440)
LEAST_SHOWN = 0.0005  # share of the surface
NOTHING_PAYS = Item("good", "No viewpoint or exposure within reach is expected to measure more.")


class MissingDialog(QDialog):
    """Lists holes by cause and proposals by gain; one button scans them."""

    scanClicked = Signal()

    def __init__(self, look: Look, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("What is missing"))
        self.setMinimumSize(*SMALLEST)
        self.list = Checklist(look)
        self.scan = Button(
            "Add and scan them", look, "run", "primary", "Add these viewpoints to the plan and take them; stored images are kept"
        )
        self.close_button = Button("Close", look)
        self.scan.clicked.connect(self.accept)
        self.accepted.connect(self.scanClicked)
        self.close_button.clicked.connect(self.reject)
        layout = column(label("What is missing", "heading"), self.list, row(0, self.close_button, self.scan), margin=16, spacing=12)
        layout.setStretch(1, 1)
        self.setLayout(layout)

    def show_found(self, found: ClosedLoop) -> None:
        """Show what was found."""
        self.list.show_items(items_of(found))
        self.scan.setVisible(bool(found.proposals))
        self.show()


def items_of(found: ClosedLoop) -> tuple[Item, ...]:
    """Return measured fraction, holes by cause, and proposals."""
    measured = tr(
        "{sufficient} of the surface is measured, of {accessible} that does not touch the support.",
        sufficient=percent(found.sufficient),
        accessible=percent(found.accessible),
    )
    items = [Item("note", measured, tr("Median standard deviation {median_sigma_mm:.4f} mm.", median_sigma_mm=found.median_sigma_mm))]
    items += [
        Item("warning", tr("{share} is missing: {words}.", share=percent(share), words=words))
        for words, share in found.shares().items()
        if share >= LEAST_SHOWN
    ]
    if not found.proposals:
        return (*items, NOTHING_PAYS)
    items += [
        Item(
            "good",
            tr("{id}: + {share} in {seconds}.", id=one.viewpoint.id, share=percent(one.share), seconds=rough_duration(one.seconds)),
            f"{one.reason[:1].upper()}{one.reason[1:]}.",
        )
        for one in found.proposals
    ]
    return (*items, Item("note", tr("With all of them {expected} are expected.", expected=percent(found.expected))))
