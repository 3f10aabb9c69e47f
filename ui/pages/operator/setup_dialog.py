"""Set-up of operator mode, for the engineer: PIN, folders, shifts, and after how long without input the role ends."""

from __future__ import annotations

from pydantic import ValidationError
from PySide6.QtWidgets import QDialog, QLineEdit, QWidget

from measureapp.errors import MeasureError
from measureapp.project.operator_settings import OperatorSettings, operator_file, read_operator_settings
from ui.controllers.operator import OperatorController
from ui.controllers.operator_roles import RoleController
from ui.look.field_words import problem_sentence
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import with_hint
from ui.pages.operator.releases import Releases
from ui.widgets.basic import Button, Form, column, label, row
from ui.widgets.number_field import NumberField
from ui.widgets.path_field import PathField

WIDTH = 1120
PIN_SET = "A PIN is set. Type a new one twice to change it."
NO_PIN = "No PIN is set: anyone can leave operator mode. Type one twice, 4 or more characters."
FORGOTTEN = "If it is forgotten: measureapp gui --reset-engineer-pin"


class OperatorSetupDialog(QDialog):
    """Edits the settings of operator mode, and sets the PIN."""

    def __init__(self, look: Look, operator: OperatorController, roles: RoleController, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Operator mode"))
        self.setFixedWidth(WIDTH)
        self._operator, self._roles = operator, roles
        self._settings = OperatorSettings()
        self.programs = PathField(look, "Folder of the part programs", "MeasureApp/programs in your home", "part programs")
        self.parts = PathField(look, "Folder of the measured parts", "MeasureApp/parts in your home", "parts")
        self.releases = Releases(look, operator.stock)
        self.shifts, self.minutes = QLineEdit(), NumberField()
        self.shifts.setPlaceholderText("06:00, 14:00, 22:00")
        self.minutes.setRange(1.0, 1440.0)
        self.minutes.setDecimals(0)
        self.minutes.setSuffix("\u00a0min")
        self.pin, self.again = QLineEdit(), QLineEdit()
        for field in (self.pin, self.again):
            field.setEchoMode(QLineEdit.EchoMode.Password)
        self.state, self.problem = label("", "soft", wrap=True), label("", "problem", wrap=True)
        self.save = Button("Save", look, "", "primary")
        self.close_button = Button("Close", look)
        self._lay_out()
        self.save.clicked.connect(self._save)
        self.close_button.clicked.connect(self.reject)
        roles.pinStored.connect(self.accept)
        roles.pinNotStored.connect(self.problem.setText)

    def _lay_out(self) -> None:
        form = Form()
        form.add("Part programs", self.programs)
        form.add("Measured parts", self.parts)
        form.add("Shifts begin at", self.shifts)
        form.add("Engineer's role ends after", self.minutes)
        form.add("New PIN or password", self.pin)
        form.add("Once more", self.again)
        buttons = row(0, self.close_button, self.save)
        settings = column(form, self.state, label(FORGOTTEN, "small", wrap=True), self.problem, 0, spacing=16)
        both = row(settings, self.releases, spacing=32)
        both.setStretch(0, 1)
        both.setStretch(1, 1)
        self.setLayout(column(both, buttons, margin=24, spacing=16))

    def open(self) -> None:
        """Show the present settings."""
        self.problem.setText("")
        try:
            self._settings = read_operator_settings(operator_file())
        except MeasureError as error:
            self.problem.setText(with_hint(error.message, error.hint))
        self.programs.setValue(self._settings.programs_folder)
        self.parts.setValue(self._settings.parts_folder)
        self.shifts.setText(", ".join(self._settings.shift_starts))
        self.minutes.setValue(self._settings.idle_minutes)
        self._operator.stock.reload()
        self.pin.clear()
        self.again.clear()
        self.state.setText(translated(PIN_SET) if self._roles.has_pin else translated(NO_PIN))
        super().open()

    def value(self) -> OperatorSettings:
        """Return what is entered. Raises ValidationError."""
        programs, parts = self.programs.value(), self.parts.value()
        default = OperatorSettings()
        entered = {
            "programs": "" if programs in (None, default.programs_folder) else str(programs),
            "parts": "" if parts in (None, default.parts_folder) else str(parts),
            "shift_starts": tuple(filter(None, (start.strip() for start in self.shifts.text().split(",")))),
            "idle_minutes": self.minutes.value(),
        }
        return OperatorSettings.model_validate({**self._settings.model_dump(), **entered})

    def _save(self) -> None:
        try:
            settings = self.value()
        except ValidationError as error:
            self.problem.setText(translated(problem_sentence(error.errors(include_url=False)[0])))
            return
        pin = self.pin.text()
        if pin != self.again.text():
            self.problem.setText(tr("The two PINs differ."))
            return
        self._operator.stock.store_settings(settings)
        self._roles.set_idle_minutes(settings.idle_minutes)
        if pin:
            self._roles.set_pin(pin)
        else:
            self.accept()
