"""Dialog for the header of a report: part, order, operator, climate; this user's company and logo; and the template."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from pydantic import ValidationError
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QDialog, QFrame, QLineEdit, QScrollArea, QWidget

from measureapp.data.identification import FIELDS, LABELS, LONGEST_LINE, LONGEST_TEXT, Identification
from measureapp.errors import MeasureError
from ui.controllers.report_header import ReportHeader, TemplateChoice, read_choice
from ui.look.field_words import problem_words
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import with_hint
from ui.settings.dialogs import choose_folder
from ui.widgets.basic import Button, CalmComboBox, Form, column, label, row
from ui.widgets.path_field import PathField

WIDTH, HEIGHT = 600, 640
NUMBERS = ("temperature_c", "humidity_percent")
ANOTHER = "Another template…"
OWN_NOTE = "With the company and the logo below, for all your projects."
PROJECT_NOTE = "Kept in this project, with a company and a logo of its own."
ABOUT = "Printed in the header of every document, and kept with the results of a series. Empty fields are not printed."


class HeaderDialog(QDialog):
    """Edits a `ReportHeader`; `chosen` is emitted with it, unless it is cancelled."""

    chosen = Signal(object)  # ReportHeader

    def __init__(self, look: Look, header: ReportHeader, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._header, identification = header, header.identification
        self.setWindowTitle(tr("Report header"))
        form = Form()
        self.company = QLineEdit(header.company)
        self.company.setMaxLength(LONGEST_LINE)
        self.company.setAccessibleName(tr("Company"))
        self.logo = PathField(look, "Logo", "PNG, JPEG or SVG", "logos", files="Pictures (*.png *.jpg *.jpeg *.svg)")
        self.logo.setValue(header.logo)
        self.template, self.note = CalmComboBox(), label("", "small", wrap=True)
        self.template.setAccessibleName(tr("Template"))
        self._offer(header.templates, header.template)
        self.template.activated.connect(self._choose_template)
        form.add("Template", column(self.template, self.note, spacing=4))
        form.add("Company", self.company)
        form.add("Logo", self.logo)
        self.fields = {name: QLineEdit(_text(getattr(identification, name))) for name in FIELDS}
        for name, field in self.fields.items():
            field.setMaxLength(LONGEST_TEXT if name == "remarks" else LONGEST_LINE)
            field.setAccessibleName(translated(LABELS[name]))
            form.add(LABELS[name], field)
        self.problem = label("", "problem", wrap=True)
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

    def _offer(self, templates: Sequence[TemplateChoice], chosen: TemplateChoice) -> None:
        self.template.clear()
        for one in templates:
            self.template.addItem(one.words, one)
        self.template.addItem(translated(ANOTHER))
        self.template.setCurrentIndex(templates.index(chosen))
        self._chosen = chosen
        own = chosen.source is None and not chosen.of_project
        self.company.setEnabled(own)
        self.logo.setEnabled(own)
        self.note.setText(translated(OWN_NOTE) if own else translated(PROJECT_NOTE))

    def _choose_template(self, place: int) -> None:
        choice = self.template.itemData(place)
        known = [self.template.itemData(number) for number in range(self.template.count() - 1)]
        if choice is None:
            folder = choose_folder(self, "Choose the folder of a report template", "report templates")
            choice = self._read(folder)
            if choice is not None:
                known = [one for one in known if one.source is None] + [choice]
        self._offer(known, choice or self._chosen)

    def _read(self, folder: Path | None) -> TemplateChoice | None:
        if folder is None:
            return None
        try:
            found = read_choice(folder)
        except MeasureError as error:
            self._refuse(with_hint(error.message, error.hint))
            return None
        self.problem.hide()
        return found

    def _refuse(self, words: str) -> None:
        self.problem.setText(translated(words))
        self.problem.show()

    def _accept(self) -> None:
        try:
            identification = self.value()
        except ValidationError as error:
            problem = error.errors(include_url=False)[0]
            self._refuse(tr("{field}: {problem}", field=LABELS[str(problem["loc"][0])], problem=problem_words(problem)))
            return
        logo = self.logo.value()
        if logo is not None and not logo.is_file():
            self._refuse(tr("The logo {logo} does not exist.", logo=logo))
            return
        self.accept()
        entered = {"identification": identification, "company": self.company.text().strip(), "logo": logo}
        self.chosen.emit(replace(self._header, template=self._chosen, **entered))


def _text(value: object) -> str:
    if isinstance(value, float):
        return f"{value:g}"
    return "" if value is None else str(value).replace("\n", " ")
