"""Editor of a rig description: the rig, motion rules, each device with its driver, links, and the drivers there are."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QCloseEvent, QIcon, QKeyEvent, QPixmap
from PySide6.QtWidgets import QDialog, QListWidget, QListWidgetItem, QScrollArea, QStackedWidget, QWidget

from measureapp.data.rig import OTHER_DEVICES, CameraDescription, RigDescription
from measureapp.devices.plugin_loader import PluginOffer, PluginRow
from measureapp.errors import MeasureError
from measureapp.project.rig_file import has_comments
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import sentence_case
from ui.pages.rig.driver_form import DriverForm
from ui.pages.rig.drivers_list import DriversList
from ui.pages.rig.links_form import LinksForm
from ui.pages.rig.rig_draft import DRIVERS, LINKS, MOTION, RIG, RULES, Problem, RigDraft, kind_of
from ui.settings.dialogs import choose_new
from ui.widgets.basic import Button, card, column, label, row
from ui.widgets.field_editors import ChoiceEditor, FieldEditor
from ui.widgets.model_form import FieldRows
from ui.widgets.question_bar import QuestionBar
from ui.widgets.segments import Segments

WIDTH, HEIGHT, LIST_WIDTH, LINE_HEIGHT, ICON = 1040, 640, 192, 34, 18
RIG_FIELDS = ("name", "reference", "exposures_us", "standoff_mm", "head", "flange_from_head")
TITLES = {RIG: "Rig", MOTION: "Motion", RULES: "Calibration rules", LINKS: "Links", DRIVERS: "Drivers"}
DEVICES = {"projector": "Projector", "robot": "Robot", "guide": "Linear guide", "table": "Rotary table"}
MODES = {"whole": "One for the whole rig", "devices": "One for each device"}
COMMENTS = "{name} has comments. Saving writes the file anew and deletes them."
UNSAVED = "What was changed here is not saved yet."
PERMISSION = (
    "Allow the driver {row.name}?\nFolder: {row.folder}\nFingerprint (SHA-256): {seen}\n"
    "Its code runs with your rights on this computer. If any of its files changes, you are asked again."
)
FILES = "Rig descriptions (*.toml)"


class RigEditor(QDialog):
    """Edits a `RigDescription`: value(), problem(); `saveAsked` fires with the description and the file."""

    saveAsked = Signal(object, object)  # RigDescription, Path
    allowAsked = Signal(object)  # PluginRow
    allowed = Signal(object, str)  # PluginRow, the fingerprint that was shown
    escapePressed = Signal()

    def __init__(
        self, look: Look, rig: RigDescription, file: Path | None, offers: Sequence[PluginOffer], parent: QWidget | None = None
    ) -> None:
        """``file``: where the description comes from, if it belongs to the user."""
        super().__init__(parent)
        self.setWindowTitle(tr("Edit rig: {name}", name=rig.name))
        self._look, self._file = look, file
        self.draft = RigDraft.of(rig, offers)
        self.parts: dict[str, dict[str, FieldEditor]] = {}  # of the sections shown so far
        self.question = QuestionBar(look)
        self.list, self.stack = QListWidget(), QStackedWidget()
        self.list.setFixedWidth(LIST_WIDTH)
        self.list.setAccessibleName(tr("Sections"))
        self.list.setIconSize(QSize(ICON, ICON))
        blank = QPixmap(ICON, ICON)
        blank.fill(Qt.GlobalColor.transparent)
        self._blank = QIcon(blank)  # keeps the titles aligned
        self._scrolls: dict[str, QScrollArea] = {}
        cameras = [camera.name for camera in rig.cameras]
        self.sections = (RIG, MOTION, RULES, *cameras, *OTHER_DEVICES, LINKS, DRIVERS)
        for name in self.sections:
            self.list.addItem(translated(TITLES.get(name) or DEVICES.get(name) or "") or tr("Camera {name}", name=name))
            self.list.item(self.list.count() - 1).setSizeHint(QSize(0, LINE_HEIGHT))
            self._scrolls[name] = _scroll()
            self.stack.addWidget(self._scrolls[name])
        self.drivers_list = DriversList(look, offers, self)  # owned also before its section is first shown
        self.drivers_list.hide()
        self.drivers_list.allowAsked.connect(self.allowAsked)
        self._lay_out()
        self.list.currentRowChanged.connect(self._choose)
        self.list.setCurrentRow(0)
        self._check()
        self._unchanged = self._read()

    def _lay_out(self) -> None:
        self.problem_words = label("", "problem", wrap=True)
        self.cancel = Button("Cancel", self._look, "", "normal", "Change nothing")
        self.cancel.clicked.connect(self._leave)
        self.save_as = Button("Save as…", self._look, "", "normal" if self._file is not None else "primary", "Save to another file")
        self.save_as.clicked.connect(self._choose_file)
        self.save = Button("Save", self._look, "", "primary", tr("Save to {file}", file=self._file))
        self.save.setVisible(self._file is not None)
        self.save.clicked.connect(lambda: self._save_to(self._file))
        body = row(self.list, self.stack, spacing=16)
        body.setStretch(1, 1)
        bottom = row(self.problem_words, self.cancel, self.save_as, self.save, spacing=8)
        bottom.setStretch(0, 1)
        layout = column(body, self.question, bottom, margin=16, spacing=16)
        layout.setStretch(0, 1)
        self.setLayout(layout)
        self.resize(WIDTH, HEIGHT)

    # what people do

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Keep the editor open on Escape, which means Stop wherever something can move."""
        if event.key() == Qt.Key.Key_Escape:
            self.escapePressed.emit()
        else:
            super().keyPressEvent(event)

    def closeEvent(self, event: QCloseEvent) -> None:
        """Ask before changes are lost."""
        event.ignore()
        self._leave()

    def _leave(self) -> None:
        if self._read() == self._unchanged:
            self.reject()
        else:
            self.question.ask(UNSAVED, {"Discard changes": self.reject}, back="Keep editing")

    def show_section(self, name: str) -> None:
        """Show a section by its name."""
        self.list.setCurrentRow(self.sections.index(name))

    def value(self) -> RigDescription:
        """Return the description. Raises ValueError when something is invalid; see `problem`."""
        found = self._read()
        if isinstance(found, Problem):
            raise ValueError(found.sentence)
        return found

    def problem(self) -> str:
        """Return the first problem with its section and field; empty if everything is valid."""
        found = self._read()
        return f"{self._title(found.section)}: {found.sentence}" if isinstance(found, Problem) else ""

    def set_offers(self, offers: Sequence[PluginOffer]) -> None:
        """Take another list of drivers, after one was allowed."""
        self._read()
        self.draft.offers = offers
        self.drivers_list.set_offers(offers)
        self._forget(*[name for name in self.parts if "driver" in self.parts[name] or name == LINKS])
        self._check()

    def ask_permission(self, row: PluginRow, seen: str) -> None:
        """Ask whether a driver from outside may run, with its folder and fingerprint."""
        self.question.ask(tr(PERMISSION, row=row, seen=seen), {"Allow": lambda: self.allowed.emit(row, seen)})

    def show_refusal(self, words: str) -> None:
        """State why the description was not saved."""
        self.problem_words.setText(translated(words))

    def _choose(self, place: int) -> None:
        name = self.sections[place]
        if name == LINKS:
            self._read()
            self._forget(LINKS)  # the drivers chosen meanwhile decide about its forms
        self._build(name)
        self.stack.setCurrentWidget(self._scrolls[name])
        self._check()

    def _choose_mode(self, mode: str) -> None:
        self._read()
        self.draft.by_device = mode == "devices"
        self._forget(*[name for name in self.parts if name in self.draft.devices])
        self.parts[RIG]["driver"].setVisible(not self.draft.by_device)
        self._check()

    def _choose_file(self) -> None:
        chosen = choose_new(self, "Save the rig description", "my_rig.toml", "rigs", FILES, self._file)
        if chosen is not None:
            self._save_to(chosen if chosen.suffix else chosen.with_suffix(".toml"))

    def _save_to(self, path: Path | None) -> None:
        found = self._read()
        if path is None or isinstance(found, Problem):
            return
        try:
            commented = has_comments(path)
        except MeasureError as error:
            self.show_refusal(str(error))
            return
        if commented:
            self._warn_of_comments(found, path)
        else:
            self.saveAsked.emit(found, path)

    def _warn_of_comments(self, rig: RigDescription, path: Path) -> None:
        answers = {"Save without comments": lambda: self.saveAsked.emit(rig, path), "Save as…": self._choose_file}
        self.question.ask(tr(COMMENTS, name=path.name), answers)

    # the sections

    def _drivers_section(self) -> tuple[dict[str, FieldEditor], list[QWidget]]:
        self.drivers_list.show()
        return {}, [self.drivers_list]

    def _build(self, name: str) -> None:
        if name in self.parts:
            return
        builders: dict[str, Callable[[], tuple[dict[str, FieldEditor], list[QWidget]]]] = {
            RIG: self._rig_section,
            LINKS: self._links_section,
            DRIVERS: self._drivers_section,
        }
        parts, widgets = builders[name]() if name in builders else self._fields_section(name)
        for part in parts.values():
            part.edited.connect(self._check)
        self.parts[name] = parts
        content = QWidget()
        content.setObjectName("clear")
        content.setLayout(column(label(self._title(name), "title"), *widgets, *([] if name == DRIVERS else [0]), spacing=16))
        content.layout().setContentsMargins(0, 0, 12, 0)
        self._scrolls[name].setWidget(content)

    def _rig_section(self) -> tuple[dict[str, FieldEditor], list[QWidget]]:
        cameras = ChoiceEditor([camera["name"] for camera in self.draft.values["cameras"]])
        fields = FieldRows(RigDescription, RIG_FIELDS, {"reference": cameras})
        fields.set_raw(self.draft.values)
        driver = DriverForm("rig", self.draft.offers, self.draft.whole)
        driver.setVisible(not self.draft.by_device)
        self.mode = Segments(MODES, name="Drivers")
        self.mode.setValue("devices" if self.draft.by_device else "whole")
        self.mode.valueChanged.connect(self._choose_mode)
        drivers = card(label("Drivers", "heading"), row(self.mode, 0), driver)
        return {"fields": fields, "driver": driver}, [card(fields), drivers]

    def _links_section(self) -> tuple[dict[str, FieldEditor], list[QWidget]]:
        links = LinksForm(self._look, self.draft.links, self.draft.link_models())
        return {"link": links}, [links]

    def _fields_section(self, name: str) -> tuple[dict[str, FieldEditor], list[QWidget]]:
        """Build the section of a device, or of rules."""
        model = CameraDescription if name not in RigDescription.model_fields else RigDescription.model_fields[name].annotation
        assert model is not None
        fields = FieldRows(model, [field for field in model.model_fields if model is not CameraDescription or field != "name"])
        fields.set_raw(self._values_of(name))
        parts: dict[str, FieldEditor] = {"fields": fields}
        if name not in self.draft.devices:
            return parts, [card(fields)]
        nominal = card(label("Nominal values", "heading"), fields)
        if not self.draft.by_device:
            return parts, [nominal]
        parts["driver"] = DriverForm(kind_of(name), self.draft.offers, self.draft.devices[name])
        return parts, [card(parts["driver"]), nominal]

    def _values_of(self, name: str) -> dict[str, Any]:
        values = self.draft.values
        found: dict[str, Any] = values[name] if name in values else next(one for one in values["cameras"] if one["name"] == name)
        return found

    def _forget(self, *names: str) -> None:
        """Delete sections, so that they are built anew; the one shown is built at once."""
        for name in names:
            if self.parts.pop(name, None) is not None:
                self._scrolls[name].takeWidget().deleteLater()
        self._build(self.sections[max(0, self.list.currentRow())])

    def _read(self) -> RigDescription | Problem:
        """Take over what was entered; return the description or the first problem."""
        draft = self.draft
        for name, parts in self.parts.items():
            links = parts.get("link")
            if isinstance(links, LinksForm):
                draft.links, draft.link_names_problem = links.raw(), links.names_problem()
            if "driver" in parts and name == RIG:
                draft.whole = parts["driver"].raw()
            elif "driver" in parts:
                draft.devices[name] = parts["driver"].raw()
            if "fields" in parts:
                (draft.values if name == RIG else self._values_of(name)).update(parts["fields"].raw())
        return draft.check()

    def _check(self) -> None:
        """Show the first problem in its section and at the bottom; only a valid description can be saved."""
        found = self._read()
        for parts in self.parts.values():
            for part in parts.values():
                part.clear_problems()
        if isinstance(found, Problem) and found.part in self.parts.get(found.section, {}):
            self.parts[found.section][found.part].place_problem(found.place, found.words)
        self.problem_words.setText(
            tr("{section}: {problem}", section=self._title(found.section), problem=found.sentence) if isinstance(found, Problem) else ""
        )
        for button in (self.save, self.save_as):
            button.setEnabled(not isinstance(found, Problem))
        for place, name in enumerate(self.sections):
            item: QListWidgetItem = self.list.item(place)
            wrong = isinstance(found, Problem) and found.section == name
            item.setIcon(self._look.icon("fail", "verdict_fail") if wrong else self._blank)

    def _title(self, name: str) -> str:
        return self.list.item(self.sections.index(name)).text() if name in self.sections else sentence_case(name)


def _scroll() -> QScrollArea:
    area = QScrollArea()
    area.setWidgetResizable(True)
    area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    return area
