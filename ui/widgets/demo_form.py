"""What the demo measures: part, resolution, viewpoints, seed."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QComboBox, QFormLayout, QSpinBox, QWidget

from ui.look.demo_settings import DemoSettings
from ui.widgets.segments import Segments

PARTS = {"gypsum": "Gypsum cross", "impeller": "Impeller", "gear": "Gear", "sphere_plate": "Sphere plate", "flat": "Flat"}
VIEWPOINTS = {"impeller": 26}
OTHER_VIEWPOINTS = 8


class DemoForm(QWidget):
    """Edits `DemoSettings`: value(), setValue(settings), valueChanged."""

    valueChanged = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._part = QComboBox()
        for name, words in PARTS.items():
            self._part.addItem(words, name)
        self._resolution = Segments({"quarter": "Quarter", "half": "Half", "full": "Full"})
        self._viewpoints, self._seed = QSpinBox(), QSpinBox()
        for spin in (self._viewpoints, self._seed):
            spin.lineEdit().setTextMargins(6, 0, 0, 0)
        self._viewpoints.setRange(3, 60)
        self._seed.setRange(1, 9999)
        self._seed.setToolTip("Another seed is another rig: other hidden errors of robot, guide, table and lenses")
        form = QFormLayout(self)
        form.setContentsMargins(0, 0, 0, 0)
        form.setHorizontalSpacing(16)
        form.setVerticalSpacing(8)
        for words, editor in (
            ("Part", self._part),
            ("Resolution", self._resolution),
            ("Viewpoints", self._viewpoints),
            ("Rig number", self._seed),
        ):
            form.addRow(words, editor)
        self.setValue(DemoSettings())
        self._part.activated.connect(self._suggest_viewpoints)
        self._part.currentIndexChanged.connect(self._tell)
        self._resolution.valueChanged.connect(self._tell)
        self._viewpoints.valueChanged.connect(self._tell)
        self._seed.valueChanged.connect(self._tell)

    def value(self) -> DemoSettings:
        """Return what is set."""
        return DemoSettings(self._part.currentData(), self._resolution.value(), self._viewpoints.value(), self._seed.value())

    def setValue(self, settings: DemoSettings) -> None:
        """Show other settings."""
        self._part.setCurrentIndex(max(0, self._part.findData(settings.part)))
        self._resolution.setValue(settings.resolution)
        self._viewpoints.setValue(settings.viewpoints)
        self._seed.setValue(settings.seed)

    def _suggest_viewpoints(self) -> None:
        self._viewpoints.setValue(VIEWPOINTS.get(self._part.currentData(), OTHER_VIEWPOINTS))

    def _tell(self) -> None:
        self.valueChanged.emit(self.value())
