"""Dialog for the header of a report: part, order, operator, climate; and this user's company and logo."""

from __future__ import annotations

from pathlib import Path

from pydantic import ValidationError
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QDialog, QFrame, QLineEdit, QScrollArea, QWidget

from measureapp.data.identification import FIELDS, LABELS, LONGEST_LINE, LONGEST_TEXT, Identification
from measureapp.data.model import first_problem
from ui.look.look import Look
from ui.widgets.basic import Button, Form, column, label, row
from ui.widgets.path_field import PathField

WIDTH, HEIGHT = 600, 640
NUMBERS = ("temperature_c", "humidity_percent")
ABOUT = "Printed in the header of every document, and kept with the results of a series. Empty fields are not printed."


class HeaderDialog(QDialog):
    """Edits the identification of the part, the company and its logo; `chosen` is emitted with them, unless it is cancelled."""

    chosen = Signal(object, str, object)  # Identification, company, Path of the logo or None

    def __init__(self, look: Look, identification: Identification, company: str, logo: Path | None, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle("Report header")
        form = Form()
        self.fields = {name: QLineEdit(_text(getattr(identification, name))) for name in FIELDS}
        for name, field in self.fields.items():
            field.setMaxLength(LONGEST_TEXT if name == "remarks" else LONGEST_LINE)
            field.setAccessibleName(LABELS[name])
            form.add(LABELS[name], field)
        self.company = QLineEdit(company)
        self.company.setMaxLength(LONGEST_LINE)
        self.company.setAccessibleName("Company")
        self.logo = PathField(look, "Logo", "PNG, JPEG or SVG", files="Pictures (*.png *.jpg *.jpeg *.svg)")
        self.logo.setValue(logo)
        form.add("Company", self.company)
        form.add("Logo", self.logo)
        self.problem = label("", "error", wrap=True)
        self.problem.hide()
        self.accept_button = Button("Save", look, "", "primary")
        self.accept_button.setDefault(True)
        self.accept_button.clicked.connect(self._accept)
        cancel = Button("Cancel", look, "", "normal", "Change nothing")
        cancel.clicked.connect(self.reject)
        inner = QWidget()
        inner.setLayout(form)
        scroll = QScrollArea()
        scroll.setFrameShape(QFrame.Shape.NoFrame)
        scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        scroll.setWidgetResizable(True)
        scroll.setWidget(inner)
        self.setLayout(column(label(ABOUT, "soft", wrap=True), scroll, self.problem, row(0, cancel, self.accept_button), margin=24))
        self.resize(WIDTH, HEIGHT)
        self.setModal(True)

    def value(self) -> Identification:
        """Return the identification. Raises ValidationError for a number that is none."""
        entered: dict[str, object] = {name: field.text() for name, field in self.fields.items()}
        for name in NUMBERS:
            words = str(entered[name]).strip().replace(",", ".").replace("\u2212", "-")
            entered[name] = words or None
        return Identification.model_validate(entered)

    def _accept(self) -> None:
        try:
            identification = self.value()
        except ValidationError as error:
            self.problem.setText(first_problem(error, "the header"))
            self.problem.show()
            return
        self.accept()
        self.chosen.emit(identification, self.company.text().strip(), self.logo.value())


def _text(value: object) -> str:
    if isinstance(value, float):
        return f"{value:g}"
    return "" if value is None else str(value).replace("\n", " ")
