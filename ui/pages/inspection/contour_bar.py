"""Below the list of features: a circle, slot, line, edge or hole pattern in the making, with the next step and its values."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from PySide6.QtCore import Slot
from PySide6.QtWidgets import QFrame

from ui.controllers.contouring import PROVE, Contour, ContouringController
from ui.look.language.words import later, tr, translated
from ui.look.look import Look
from ui.look.wording import millimetres, several
from ui.pages.inspection.contour_fields import ContourFields
from ui.pages.inspection.outlines import outline
from ui.pages.layers import cross
from ui.viewport.layers import LineLayer
from ui.widgets.basic import Button, column, label, row

if TYPE_CHECKING:
    from measureapp.data.feature import Feature
    from measureapp.inspection.features.found_feature import FoundFeature

KINDS = {
    "circle": later("Circle"),
    "slot": later("Slot"),
    "line": later("Line"),
    "edge": later("Edge"),
    "pattern": later("Hole pattern"),
}
WORKING = "Measuring…"


class ContourBar(QFrame):
    """Guides the clicks, and shows the values before the feature is created."""

    def __init__(self, look: Look, contouring: ContouringController) -> None:
        super().__init__()
        self.setObjectName("sunken")
        self._contouring = contouring
        self.title, self.words = label("", "strong"), label("", "body", wrap=True)
        self.problem = label("", "problem", wrap=True)
        self.found = label("", "small", wrap=True)
        self.fields = ContourFields()
        self.create = Button("Create", look, "add", "primary", "Add the feature to the program and measure it; it can be undone")
        self.cancel = Button("Cancel", look, "", "quiet", "Leave the program as it is (Esc)")
        self.create.clicked.connect(lambda: contouring.create(self.fields.value()))
        self.cancel.clicked.connect(contouring.cancel)
        self.fields.valueChanged.connect(lambda: contouring.change(self.fields.value()))
        below = row(self.found, self.cancel, self.create, spacing=8)
        below.setStretch(0, 1)
        self.setLayout(column(row(self.title, 0), self.words, self.problem, self.fields, below, margin=8, spacing=6))
        contouring.changed.connect(self.show_contour)
        self.hide()

    @property
    def is_on(self) -> bool:
        """Whether clicks are meant for the feature in the making."""
        return self._contouring.is_on

    @Slot()
    def show_contour(self) -> None:
        """Show what to click next, or the values with what the trial found."""
        contour = self._contouring.contour
        if contour is None:
            return
        self.title.setText(translated(KINDS[contour.kind]))
        self.words.setText(translated(_next_step(contour)))
        self.problem.setText(translated(contour.problem))
        for words in (self.words, self.problem):
            words.setVisible(bool(words.text()))
        self.fields.setVisible(contour.entry is not None)
        if contour.entry is not None:
            self.fields.setValue(contour.entry)
        self.create.setVisible(contour.entry is not None)
        self.create.setEnabled(contour.can_create)
        self.found.setText(found_words(contour))

    def lines(self, colour: tuple[int, int, int]) -> list[LineLayer]:
        """Return crosses at the clicks, and the outlines of what is described."""
        contour = self._contouring.contour
        if contour is None:
            return []
        drawn = [line for place in contour.places for line in cross(place)]
        drawn += [outline(one) for tried in contour.tried if (one := _drawn(tried, contour.entry or {})) is not None]
        return [LineLayer(tuple(np.asarray(line) for line in drawn), colour, 3.0)] if drawn else []


def _next_step(contour: Contour) -> str:
    """Return what to do next."""
    if contour.is_working:
        return WORKING
    if contour.entry is not None:
        return PROVE if contour.can_create else ""
    return contour.steps[len(contour.places)] if contour.steps else ""


def _drawn(tried: FoundFeature, entry: Mapping[str, Any]) -> Feature | None:
    """Return what a trial found, or where it looked."""
    if tried.feature is not None or tried.nominal is None or tried.nominal.shape != "line":
        return tried.feature or tried.nominal
    assert tried.nominal.direction is not None
    half = float(entry["length_mm"]) / 2 * tried.nominal.direction
    return replace(tried.nominal, boundary_mm=np.stack([tried.nominal.point_mm - half, tried.nominal.point_mm + half]))


def found_words(contour: Contour) -> str:
    """Return what the trial found: the size and the number of points, or how many copies."""
    found = contour.found
    if not found:
        return ""
    if len(contour.tried) > 1:
        return tr("Found on the part: {found} of {count}.", found=len(found), count=len(contour.tried))
    one = found[0]
    return tr("Found on the part: {size}, {points}.", size=_size(one), points=several(one.points, "point"))


def _size(feature: Feature) -> str:
    if feature.shape == "slot":
        return tr("{width} × {length}", width=millimetres(2 * (feature.radius_mm or 0.0)), length=millimetres(feature.length_mm or 0.0))
    if feature.radius_mm is not None:
        return tr("diameter {diameter}", diameter=millimetres(2 * feature.radius_mm))
    return tr("form {form}", form=millimetres(feature.form_error_mm))
