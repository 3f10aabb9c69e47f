"""What a scan needs before it starts: project, plan, exposures; and what was found before it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QComboBox, QLineEdit, QWidget

from ui.controllers.scan_choices import CheckedScan, ScanChoices
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import rough_duration, several, storage
from ui.session import Session
from ui.widgets.basic import Button, Form, card, label, row, scrolled
from ui.widgets.checklist import Checklist, Item
from ui.widgets.number_field import NumberField
from ui.widgets.path_field import PathField

if TYPE_CHECKING:
    from measureapp.data.raw_policy import RawPolicy

EXPOSURES = {
    "plan": ("As planned", "The exposures of the plan, the same or chosen for every viewpoint there"),
    "once": ("Probe at the first viewpoint", "A probe at the first viewpoint chooses the exposures of all"),
    "each": ("Probe at every viewpoint", "A probe at every viewpoint chooses its exposures; for parts with bright and dark sides"),
}
RAW: dict[RawPolicy | None, tuple[str, str]] = {
    None: ("As the project states", "New projects keep the images as they were taken"),
    "keep": ("Keep", "As they were taken; everything can be computed again"),
    "compress": ("Compress after the scan", "Without loss; everything can be computed again"),
    "drop": ("Drop after the scan", "Once their clouds are stored; clouds cannot be computed again, for example with a new calibration"),
}
NOMINALS = "Nominals (*.stl *.ply *.obj *.step *.stp)"
PROGRAMS = "Inspection programs (*.toml)"
PLANS = "Scan plans (*.toml *.json)"
BEFORE = (
    Item("note", "Fix the part on the table.", "It must not move until the scan has ended."),
    Item("note", "Keep the cell clear.", "Stop (Esc) is no safety function: in danger use the emergency stop."),
)
NOT_CHECKED = Item("note", "Nothing has been checked yet.", "Check connects the rig and lists what prevents the scan; nothing moves.")
NEW_FOLDER = "scan"


class ScanSetup(QWidget):
    """Edits `ScanChoices`: value(), setValue(choices), valueChanged; shows what the check before the scan found."""

    valueChanged = Signal()
    checkClicked = Signal()
    startClicked = Signal()

    def __init__(self, look: Look, session: Session) -> None:
        super().__init__()
        self._session = session
        self.folder = PathField(look, "Folder of the project", "New folder, or an existing project", "projects")
        self.part = QLineEdit()
        self.part.setPlaceholderText(tr("Name of the part"))
        self.nominal = PathField(look, "Nominal of the part", "None: no comparison with CAD", "nominals", files=NOMINALS)
        self.program = PathField(look, "Inspection program", "None: no dimensions", "programs", files=PROGRAMS)
        self.calibrated = PathField(look, "Project with a calibration of this rig", "Project whose calibration is used", "projects")
        self.plan = PathField(look, "Scan plan", "Plan of the page Plan", "plans", files=PLANS)
        self.exposures = QComboBox()
        for name, (words, tip) in EXPOSURES.items():
            self.exposures.addItem(translated(words), name)
            self.exposures.setItemData(self.exposures.count() - 1, translated(tip), Qt.ItemDataRole.ToolTipRole)
        self.seconds = NumberField()
        self.seconds.setRange(0.1, 600.0)
        self.seconds.setDecimals(1)
        self.seconds.setValue(ScanChoices().seconds)
        self.seconds.setSuffix("\u00a0s")
        self.seconds.setToolTip(tr("Time for the exposures of one viewpoint"))
        self.raw = QComboBox()
        for policy, (words, tip) in RAW.items():
            self.raw.addItem(translated(words), policy)
            self.raw.setItemData(self.raw.count() - 1, translated(tip), Qt.ItemDataRole.ToolTipRole)
        self.rig, self.what = label("", "body", wrap=True), label("", "small", wrap=True)
        self.found = Checklist(look)
        self.check = Button("Check", look, "pass", "normal", "Connect the rig and list what prevents the scan; nothing moves")
        self.start = Button("Start the scan", look, "run", "primary", "Check, then scan if nothing prevents it")
        self._lay_out()
        self._connect()
        self.setValue(ScanChoices())

    def _lay_out(self) -> None:
        self._form = form = Form()
        form.add("Rig", self.rig)
        form.add("Project", self.folder)
        form.addRow("", self.what)
        for name, editor in (("Part", self.part), ("Nominal (CAD)", self.nominal), ("Program", self.program)):
            form.add(name, editor)
        form.add("Calibration of", self.calibrated)
        form.add("Plan", self.plan)
        form.add("Exposures", self.exposures)
        form.add("Time for each", self.seconds)
        form.add("Raw images", self.raw)
        choices = card(label("Scan", "heading"), 4, form, 0, margin=16)
        findings = card(label("Before the scan", "heading"), 4, self.found, row(0, self.check, self.start), margin=16)
        both = row(scrolled(choices), findings, spacing=16)
        both.setStretch(0, 1)
        both.setStretch(1, 1)
        self.setLayout(both)

    def _connect(self) -> None:
        for field in (self.folder, self.nominal, self.program, self.calibrated, self.plan):
            field.valueChanged.connect(self._changed)
        self.part.textChanged.connect(self._changed)
        self.exposures.currentIndexChanged.connect(self._changed)
        self.seconds.valueChanged.connect(self._changed)
        self.raw.currentIndexChanged.connect(self._changed)
        self.check.clicked.connect(self.checkClicked)
        self.start.clicked.connect(self.startClicked)
        for signal in (self._session.rigChanged, self._session.cellChanged, self._session.planChanged, self._session.calibrationChanged):
            signal.connect(self.refresh)

    def value(self) -> ScanChoices:
        """Return what is chosen."""
        return ScanChoices(
            self.folder.value(),
            self.part.text().strip(),
            self.nominal.value(),
            self.program.value(),
            self.calibrated.value(),
            self.plan.value(),
            self.exposures.currentData(),
            self.seconds.value(),
            self.raw.currentData(),
        )

    def setValue(self, choices: ScanChoices) -> None:
        """Set what is chosen."""
        for field, path in (
            (self.folder, choices.folder),
            (self.nominal, choices.nominal),
            (self.program, choices.program),
            (self.calibrated, choices.calibrated),
            (self.plan, choices.plan_file),
        ):
            field.setValue(path)
        self.part.setText(translated(choices.part))
        self.exposures.setCurrentIndex(self.exposures.findData(choices.exposures))
        self.seconds.setValue(choices.seconds)
        self.raw.setCurrentIndex(list(RAW).index(choices.raw))
        self._changed()

    def _changed(self) -> None:
        self.found.show_items((NOT_CHECKED, *BEFORE))
        self.refresh()
        self.valueChanged.emit()

    def refresh(self) -> None:
        """Show what is there: rig, plan, project."""
        session, chosen = self._session, self.value()
        rig = session.rig
        self.rig.setText(
            tr("Choose one on the page Rig.")
            if rig is None
            else tr("{name}, connected", name=rig.name)
            if session.cell.connected
            else tr("{name}, connected by Check or Start", name=rig.name)
        )
        plan = session.plan
        self.plan.text.setPlaceholderText(
            tr("None yet: choose a file, or make one on the page Plan")
            if plan is None
            else tr("{name} with {count}", name=plan.name, count=several(len(plan), "viewpoint"))
        )
        self._form.setRowVisible(self.part, not chosen.is_existing)
        for editor in (self.nominal, self.program):
            self._form.setRowVisible(editor, not chosen.has_documents)
        self._form.setRowVisible(self.seconds, chosen.exposures != "plan")
        self.what.setText(translated(_project_words(chosen)))
        ready = rig is not None and chosen.folder is not None and (plan is not None or chosen.plan_file is not None)
        self.start.setEnabled(ready and not session.busy_with)
        self.check.setEnabled(ready and not session.busy_with)
        self.start.setToolTip(
            tr("Check, then scan if nothing prevents it") if ready else tr("Choose a rig, a project folder and a plan first")
        )

    def show_checked(self, checked: CheckedScan) -> None:
        """Show what was found."""
        self.found.show_items(items_of(checked))


def _project_words(chosen: ScanChoices) -> str:
    if chosen.folder is None:
        return tr("For example {value}.", value=Path.home() / "MeasureApp" / NEW_FOLDER)
    return "Existing project: stored viewpoints are kept, missing ones are taken." if chosen.is_existing else "A new project is made here."


def items_of(checked: CheckedScan) -> tuple[Item, ...]:
    """Return the findings of a check: problems first, then warnings, then facts."""
    found: list[Item] = [Item("problem", problem.message, problem.hint) for problem in checked.problems]
    if checked.found is not None:
        found += [Item("warning", warning) for warning in checked.found.warnings]
        if not checked.problems:
            found.append(Item("good", "Nothing prevents the scan."))
        left = checked.planned - checked.stored
        time = (
            ""
            if checked.found.images_s is None
            else tr(", at least {images_s} for the images", images_s=rough_duration(checked.found.images_s))
        )
        found.append(Item("note", f"{several(left, 'viewpoint')}, {storage(checked.found.bytes)}{time}."))
        if checked.stored:
            found.append(
                Item("note", tr("{count} stored already and kept.", count=several(checked.stored, "viewpoint is", "viewpoints are")))
            )
    return (*found, *BEFORE)
