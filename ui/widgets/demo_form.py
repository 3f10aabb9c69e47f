"""Editor of the demo settings: part, resolution, viewpoints, patterns, and the virtual rig with its seed."""

from __future__ import annotations

from pathlib import Path
from typing import cast

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QComboBox, QSpinBox, QWidget

from measureapp.data.length_unit import LengthUnit
from ui.look.demo_settings import DemoSettings, Resolution
from ui.look.language.words import tr, translated
from ui.look.pattern_words import PATTERN_WORDS
from ui.settings.dialogs import choose_file
from ui.widgets.basic import Form, label
from ui.widgets.segments import Segments

PARTS = {"gypsum": "Gypsum cross", "impeller": "Impeller", "gear": "Gear", "sphere_plate": "Sphere plate", "flat": "Flat plate"}
RIGS = {
    "ideal": ("Ideal", "Nothing but noise and what the program's model describes: what the algorithms reach"),
    "good": ("Good", "A well-kept rig in a measuring room: small errors of lenses, axes, board and part"),
    "usual": ("Usual", "A rig as it is found in a workshop: lens errors, glare, run-out, warm-up, a part that is not its drawing"),
    "bad": ("Bad", "A worn rig in a warm hall, with a printed board"),
}
OWN_MESH = "Own mesh file…"
MESH_FILES = "Meshes (*.stl *.ply *.obj)"
VIEWPOINTS = {"impeller": 26}
OTHER_VIEWPOINTS = 8


class DemoForm(QWidget):
    """Edits `DemoSettings`: value(), setValue(settings), valueChanged. A chosen mesh is checked first, then set by `show_mesh`."""

    valueChanged = Signal(object)
    meshChosen = Signal(object)  # Path

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._part = QComboBox()
        for name, words in PARTS.items():
            self._part.addItem(translated(words), name)
        self._part.addItem(translated(OWN_MESH), "")
        self._part.setToolTip(tr("A sample part, or your own closed mesh; its unit is requested unless it is clearly millimetres"))
        self._chosen = 0
        self._units: dict[str, LengthUnit] = {}  # of mesh files
        self._resolution = Segments({"quarter": "Quarter", "half": "Half", "full": "Full"})
        self._patterns, self._pattern_line = QComboBox(), label("", "small", wrap=True)
        for name, (title, line) in PATTERN_WORDS.items():
            self._patterns.addItem(translated(title), name)
            self._patterns.setItemData(self._patterns.count() - 1, line, Qt.ItemDataRole.ToolTipRole)
        self._patterns.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self._patterns.setMinimumContentsLength(16)
        self._viewpoints, self._seed = QSpinBox(), QSpinBox()
        self._viewpoints.setRange(3, 60)
        self._seed.setRange(1, 9999)
        self._rig = QComboBox()
        for name, (words, line) in RIGS.items():
            self._rig.addItem(translated(words), name)
            self._rig.setItemData(self._rig.count() - 1, line, Qt.ItemDataRole.ToolTipRole)
        self._rig.setToolTip(tr("How well the virtual rig and the part are made; uncertainties and verdicts follow from it"))
        self._seed.setToolTip(tr("The seed determines the hidden errors of robot, guide, table and lenses"))
        form = Form(self)
        for words, editor in (
            ("Part", self._part),
            ("Resolution", self._resolution),
            ("Viewpoints", self._viewpoints),
            ("Patterns", self._patterns),
            ("Virtual rig", self._rig),
            ("Seed of the rig", self._seed),
        ):
            form.add(words, editor)
        form.insertRow(form.rowCount() - 2, "", self._pattern_line)
        self.setValue(DemoSettings())
        self._part.activated.connect(self._on_part)
        self._part.currentIndexChanged.connect(self._tell)
        self._resolution.valueChanged.connect(self._tell)
        self._viewpoints.valueChanged.connect(self._tell)
        self._patterns.currentIndexChanged.connect(self._on_patterns)
        self._rig.currentIndexChanged.connect(self._tell)
        self._seed.valueChanged.connect(self._tell)

    def value(self) -> DemoSettings:
        """Return the settings."""
        resolution = cast(Resolution, self._resolution.value())
        patterns = self._patterns.currentData()
        part = self._part.currentData()
        unit = self._units.get(part, LengthUnit.MM)
        return DemoSettings(part, resolution, self._viewpoints.value(), self._seed.value(), patterns, unit, self._rig.currentData())

    def setValue(self, settings: DemoSettings) -> None:
        """Set the settings."""
        self._show_part(settings.part, settings.unit)
        self._resolution.setValue(settings.resolution)
        self._viewpoints.setValue(settings.viewpoints)
        self._seed.setValue(settings.seed)
        self._patterns.setCurrentIndex(self._patterns.findData(settings.patterns))
        self._rig.setCurrentIndex(self._rig.findData(settings.world))
        self._say_patterns()

    def show_mesh(self, path: Path, unit: LengthUnit) -> None:
        """Choose a mesh file with lengths in this unit."""
        self._show_part(str(path), unit)
        self._suggest_viewpoints()
        self._tell()

    def _show_part(self, part: str, unit: LengthUnit) -> None:
        """Choose a part; a mesh file is added as an entry."""
        if self._part.findData(part) < 0:
            self._part.insertItem(self._part.count() - 1, "", part)
        if part not in PARTS:
            self._units[part] = unit
            words = Path(part).name if unit is LengthUnit.MM else tr("{name}, in {words}", name=Path(part).name, words=unit.words)
            self._part.setItemText(self._part.findData(part), translated(words))
        self._chosen = self._part.findData(part)
        self._part.setCurrentIndex(self._chosen)

    def _on_part(self, place: int) -> None:
        if self._part.itemData(place):
            self._chosen = place
            self._suggest_viewpoints()
            return
        self._part.setCurrentIndex(self._chosen)
        path = choose_file(self, "Choose a mesh of the part", MESH_FILES, "nominals")
        if path is not None:
            self.meshChosen.emit(path)

    def _suggest_viewpoints(self) -> None:
        self._viewpoints.setValue(VIEWPOINTS.get(self._part.currentData(), OTHER_VIEWPOINTS))

    def _on_patterns(self) -> None:
        self._say_patterns()
        self._tell()

    def _say_patterns(self) -> None:
        self._pattern_line.setText(translated(PATTERN_WORDS[self._patterns.currentData()].line))

    def _tell(self) -> None:
        if not self._part.currentData():  # the user is about to choose a file
            return
        self.valueChanged.emit(self.value())
