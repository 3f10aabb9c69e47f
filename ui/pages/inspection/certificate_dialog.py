"""States that a measured length is certified, so that it corrects the other lengths."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pydantic import Field
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QDialog, QWidget

from measureapp.data.length_certificate import LengthCertificate
from ui.look.language.words import tr
from ui.look.look import Look
from ui.look.wording import sentence_case
from ui.widgets.basic import Button, column, label, row
from ui.widgets.model_form import ModelForm

if TYPE_CHECKING:
    from measureapp.data.dimension_program import DimensionProgram

WIDTH = 560
FIELDS = ("certified_mm", "uncertainty_mm", "number", "material")
USE = (
    "A ball bar, a gauge block, or a length of the part that a better machine has measured. What it is off, the other lengths "
    "are off too, as far as their errors are shared: they are corrected by it, and their uncertainty becomes smaller."
)
CORRECT = "Measure the lengths again, corrected by this one; it can be undone"


class StatedLength(LengthCertificate):
    """A certificate with its length."""

    certified_mm: float = Field(gt=0)


class CertificateDialog(QDialog):
    """Asks for the certified length and its uncertainty; ``chosen`` has the length in mm and the certificate, None: not certified."""

    chosen = Signal(float, object)  # mm, LengthCertificate | None

    def __init__(self, look: Look, entry: DimensionProgram, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Certified length"))
        self._former_mm = entry.nominal
        self.form = ModelForm(StatedLength, FIELDS)
        stated = {} if entry.certificate is None else entry.certificate.model_dump(mode="json")
        self.form.set_raw({**stated, "certified_mm": entry.nominal})
        self.use = Button("Correct by it", look, "", "primary", CORRECT)
        self.use.setDefault(True)
        self.use.clicked.connect(self._use)
        self.remove = Button("Not certified", look, "", "normal", "Correct nothing by this length")
        self.remove.setVisible(entry.certificate is not None)
        self.remove.clicked.connect(self._remove)
        cancel = Button("Cancel", look, "", "normal", "Change nothing")
        cancel.clicked.connect(self.reject)
        self.form.edited.connect(self._show)
        buttons = row(self.remove, 0, cancel, self.use)
        self.setLayout(
            column(label(sentence_case(entry.name), "heading"), label(USE, "small", wrap=True), 8, self.form, 8, buttons, margin=24)
        )
        self.setFixedWidth(WIDTH)
        self.setModal(True)
        self._show()

    def _show(self) -> None:
        problem = self.form.problem()
        self.use.setEnabled(not problem)
        self.use.setToolTip(problem or tr(CORRECT))

    def _use(self) -> None:
        stated = self.form.value()
        certificate = LengthCertificate.model_validate(stated.model_dump(exclude={"certified_mm"}))
        self.accept()
        self.chosen.emit(stated.certified_mm, certificate)  # type: ignore[attr-defined]

    def _remove(self) -> None:
        self.accept()
        self.chosen.emit(self._former_mm, None)
