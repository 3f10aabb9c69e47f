"""Dialog to edit a rig description: what is common, how it moves, and driver and settings of every device."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import TYPE_CHECKING, Any

import tomli_w
from pydantic import Field, ValidationError
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QComboBox, QDialog, QFileDialog, QListWidget, QPlainTextEdit, QScrollArea, QStackedWidget, QWidget

from measureapp.data.model import Model, first_problem
from measureapp.data.rig import OTHER_DEVICES, HeadRules, MotionRules, RigDescription
from measureapp.errors import MeasureError
from ui.look.look import Look
from ui.widgets.basic import Button, column, label, row
from ui.widgets.model_form import ModelForm

if TYPE_CHECKING:
    from measureapp.devices.plugin_loader import PluginKind, PluginRow

WHOLE = "One driver for the whole rig"
KINDS: dict[str, PluginKind] = {"projector": "projector", "robot": "robot", "guide": "linear-guide", "table": "rotary-table"}
LINK_WORDS = 'What several drivers share, one table each: a serial line, a login. For instance [line1], port = "COM3".'
SIZE = (960, 640)


class Basics(Model):
    """What is common to the whole rig."""

    name: str = Field(min_length=1, description="as shown in the list of rigs")
    reference: str = Field(min_length=1, description="name of the reference camera")
    standoff_mm: float = Field(gt=0, description="distance of the measuring head from the part")
    exposures_us: tuple[int, ...] = Field(
        min_length=1, description="the exposure bracket in µs, from long to short, as a list: [100000, 20000]"
    )


class DriverForm(QWidget):
    """Chooses the driver of one device and edits its settings."""

    changed = Signal()

    def __init__(self, kind: PluginKind, rows: tuple[PluginRow, ...]) -> None:
        super().__init__()
        self._kind = kind
        self.drivers = QComboBox()
        for plugin in rows:
            if kind in plugin.kinds:
                self.drivers.addItem(f"{plugin.name}{' – not loaded' if plugin.problem else ''}", plugin.id)
        self.reason = label("", "small", wrap=True)
        self.place = column(spacing=0)
        self.form: ModelForm | None = None
        self.drivers.currentIndexChanged.connect(lambda: self._make_form({}))
        self.setLayout(column(label("Driver", "caption"), self.drivers, self.reason, 8, label("Settings", "caption"), self.place, 0))
        self._make_form({})

    def show_choice(self, driver: str, settings: dict[str, Any]) -> None:
        """Show a driver with its settings; an unknown one is listed with its id."""
        if self.drivers.findData(driver) < 0 and driver:
            self.drivers.addItem(f"{driver} – not there", driver)
        self.drivers.blockSignals(True)
        self.drivers.setCurrentIndex(max(0, self.drivers.findData(driver)))
        self.drivers.blockSignals(False)
        self._make_form(settings)

    def choice(self) -> tuple[str, dict[str, Any]]:
        """Return the driver's id and its settings."""
        return self.drivers.currentData() or "", {} if self.form is None else self.form.document()

    def problem(self) -> str:
        """Return what does not fit, in words."""
        return self.reason.text() or ("" if self.form is None else self.form.problem())

    def _make_form(self, settings: dict[str, Any]) -> None:
        from measureapp.devices.plugin_loader import load_driver

        if self.form is not None:
            self.form.hide()
            self.form.deleteLater()
            self.form = None
        self.reason.setText("")
        driver = self.drivers.currentData()
        try:
            kind = load_driver(None, driver, self._kind).settings if driver else None
        except MeasureError as error:
            self.reason.setText(str(error))
        else:
            if kind is not None:
                self.form = ModelForm(kind)
                self.form.setValue(settings)
                self.form.valueChanged.connect(self.changed)
                self.place.addWidget(self.form)
        self.reason.setVisible(bool(self.reason.text()))
        self.changed.emit()


class RigEditor(QDialog):
    """Edits a copy of a rig description; `saved` is emitted with the path of the file."""

    saved = Signal(object)  # Path

    def __init__(self, look: Look, rig: RigDescription, rows: tuple[PluginRow, ...], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(f"Edit {rig.name}")
        self.resize(*SIZE)
        self._rig = rig
        self.sections, self.pages = QListWidget(), QStackedWidget()
        self.sections.setFixedWidth(208)
        self.sections.setSpacing(4)
        self.basics, self.motion, self.head = ModelForm(Basics), ModelForm(MotionRules), ModelForm(HeadRules)
        self.way = QComboBox()
        self.way.addItem("A driver for each device", "devices")
        self.way.addItem(WHOLE, "whole")
        self.whole = DriverForm("rig", rows)
        names = [camera.name for camera in rig.cameras]
        self.devices = {name: DriverForm(KINDS.get(name, "camera"), rows) for name in (*names, *OTHER_DEVICES)}
        self.links = QPlainTextEdit()
        self.trouble = label("", "small", wrap=True)
        self.save = Button("Save as…", look, "export", "primary", "Write a rig description (TOML)")
        self.save.clicked.connect(self._save_as)
        cancel = Button("Cancel", look, "", "normal", "Change nothing")
        cancel.clicked.connect(self.reject)
        self._add_sections()
        body = row(self.sections, self.pages, spacing=16)
        body.setStretch(1, 1)
        layout = column(body, self.trouble, row(0, cancel, self.save), margin=24, spacing=16)
        layout.setStretch(0, 1)
        self.setLayout(layout)
        self._show()
        self._connect()
        self._check()

    def description(self) -> RigDescription:
        """Return the rig description as edited. Raises ValidationError, or ValueError for links that are no TOML."""
        whole = self.way.currentData() == "whole"
        driver, settings = self.whole.choice()
        chosen = {name: dict(zip(("driver", "settings"), form.choice(), strict=True)) for name, form in self.devices.items()}
        changes = {
            **self.basics.document(),
            "motion": self.motion.document(),
            "head": self.head.document(),
            "driver": driver if whole else "",
            "driver_settings": settings if whole else {},
            "devices": {} if whole else chosen,
            "links": tomllib.loads(self.links.toPlainText()),
        }
        return RigDescription.model_validate({**self._rig.model_dump(mode="json"), **changes})

    def problem(self) -> str:
        """Return what does not fit, in words; empty if the rig can be saved."""
        forms = {"whole rig": self.whole} if self.way.currentData() == "whole" else self.devices
        for name, form in forms.items():
            if found := form.problem():
                return f"{name.capitalize()}: {found}"
        try:
            self.description()
        except ValidationError as error:
            return f"{first_problem(error, 'the rig')}."
        except tomllib.TOMLDecodeError as error:
            return f"Links: {error}."
        return ""

    def write(self, path: Path) -> None:
        """Write the description and close; a failure is shown in the dialog."""
        from measureapp.project.rig_file import write_rig

        try:
            write_rig(path, self.description())
        except MeasureError as error:
            self.trouble.setText(str(error))
            return
        self.accept()
        self.saved.emit(path)

    def _add_sections(self) -> None:
        for words, form in (("Rig", self.basics), ("Motion", self.motion), ("Measuring head", self.head)):
            self._add(words, form)
        drivers = QWidget()
        drivers.setLayout(column(label("Drivers", "caption"), self.way, 8, self.whole, 0))
        self._add("Drivers", drivers)
        for name, form in self.devices.items():
            self._add(name.capitalize() if name in OTHER_DEVICES else f"Camera {name}", form)
        links = QWidget()
        links.setLayout(column(label(LINK_WORDS, "soft", wrap=True), self.links))
        self._add("Links", links)
        self.sections.currentRowChanged.connect(self.pages.setCurrentIndex)
        self.sections.setCurrentRow(0)

    def _add(self, words: str, page: QWidget) -> None:
        self.sections.addItem(words)
        area = QScrollArea()
        area.setWidgetResizable(True)
        area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        area.setWidget(page)
        self.pages.addWidget(area)

    def _show(self) -> None:
        rig = self._rig
        plain = rig.model_dump(mode="json", exclude_defaults=True, exclude_none=True)
        self.basics.setValue({name: plain[name] for name in Basics.model_fields})
        self.motion.setValue(plain.get("motion", {}))
        self.head.setValue(plain.get("head", {}))
        self.way.setCurrentIndex(self.way.findData("whole" if rig.driver else "devices"))
        self.whole.show_choice(rig.driver, rig.driver_settings)
        for name, choice in rig.devices.items():
            self.devices[name].show_choice(choice.driver, choice.settings)
        self.links.setPlainText(tomli_w.dumps(rig.links))

    def _connect(self) -> None:
        forms: tuple[ModelForm, ...] = (self.basics, self.motion, self.head)
        for form in forms:
            form.valueChanged.connect(self._check)
        for device in (self.whole, *self.devices.values()):
            device.changed.connect(self._check)
        self.way.currentIndexChanged.connect(self._check)
        self.links.textChanged.connect(self._check)

    def _check(self) -> None:
        whole = self.way.currentData() == "whole"
        self.whole.setVisible(whole)
        for place in range(self.sections.count()):
            item = self.sections.item(place)
            if 4 <= place < 4 + len(self.devices):
                item.setHidden(whole)
        problem = self.problem()
        self.trouble.setText(problem)
        self.save.setEnabled(not problem)

    def _save_as(self) -> None:
        path, _ = QFileDialog.getSaveFileName(self, "Save the rig description", str(Path.home() / "rig.toml"), "Rig descriptions (*.toml)")
        if path:
            self.write(Path(path).with_suffix(".toml"))
