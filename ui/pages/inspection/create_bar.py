"""Below the list of features: pick faces, add a proposed dimension, construct a feature from those selected."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtGui import QAction, QShortcut
from PySide6.QtWidgets import QFrame, QMenu

from ui.controllers.contouring import ContouringController
from ui.controllers.creating import CreatingController
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import millimetres, quantity, sentence_case
from ui.pages.inspection.contour_bar import KINDS
from ui.pages.inspection.feature_table import FeatureTable
from ui.widgets.basic import Button, CalmComboBox, column, label, row
from ui.widgets.number_field import NumberField

if TYPE_CHECKING:
    from measureapp.inspection.programming.proposals import Proposal

HOW = "Select features in the list, pick faces of the CAD model, or create a new feature by clicking. Fitting dimensions are then proposed."
NONE_FITS = "No dimension fits these features together. Select one or two of them, or press Tolerance…"
NONE_FITS_ONE = "No dimension fits this feature alone."
START_MM, LARGEST_MM = 10.0, 10_000.0  # distance of an offset plane or a point on an axis, until another one is entered
CONSTRUCTIONS = {
    "midpoint": "Midpoint",
    "midplane": "Mid-plane",
    "symmetry": "Symmetry",
    "intersection": "Intersection",
    "projection": "Projection of the first onto the second",
    "offset": "Offset plane",
    "point_on_axis": "Point on the axis",
    "best_fit_line": "Line through the points",
    "best_fit_plane": "Plane through the points",
    "best_fit_circle": "Circle through the points",
    "pitch_circle": "Pitch circle",
    "common_datum": "Common datum (A-B)",
}


class CreateBar(QFrame):
    """Creates from the selected features."""

    dimensionAdded = Signal(str)
    previewed = Signal(object)  # Feature that the construction under the pointer would give; None: none is

    def __init__(self, look: Look, creating: CreatingController, contouring: ContouringController, features: FeatureTable) -> None:
        super().__init__()
        self.setObjectName("sunken")
        self._creating, self._features = creating, features
        self._proposals: tuple[Proposal, ...] = ()
        self.pick = Button("Pick faces", look, "grow", "quiet", "Click faces of the CAD model to select them as features; Esc ends")
        self.pick.setCheckable(True)
        self.new = Button("New feature", look, "", "quiet", "Create a circle, slot, line, edge or hole pattern by clicking in the picture")
        kinds = QMenu(self.new)
        for kind, words in KINDS.items():
            kinds.addAction(translated(words), lambda kind=kind: contouring.begin(kind, features.names()))
        self.new.setMenu(kinds)
        self.words = label(HOW, "small", wrap=True)
        self.choice = CalmComboBox()
        self.choice.setAccessibleName(tr("Proposed dimension"))
        self.choice.setMinimumContentsLength(10)
        self.add = Button("Add dimension", look, "add", "normal", "Add the proposed dimension to the program and measure it (Enter)")
        self.construct = Button("Construct", look, "", "quiet", "Construct a feature from those selected")
        self.menu = QMenu(self.construct)
        self.construct.setMenu(self.menu)
        self.tolerance = Button(
            "Tolerance…", look, "", "quiet", "Define a geometrical tolerance of the first selected feature, the others as its datums"
        )
        self.distance = distance_field()
        self.distance.setValue(START_MM)
        self.distance_words = label("Distance", "soft")
        self.menu.hovered.connect(self._preview)
        self.menu.aboutToHide.connect(lambda: self.previewed.emit(None))
        self.add.clicked.connect(self.accept)
        QShortcut(Qt.Key.Key_Return, features, self.accept, context=Qt.ShortcutContext.WidgetShortcut)
        choose = row(self.choice, self.add, spacing=8)
        choose.setStretch(0, 1)
        tools = row(self.pick, self.new, self.construct, self.tolerance, 0)
        self.setLayout(column(tools, row(self.distance_words, self.distance, 0), self.words, choose, margin=8, spacing=8))
        features.chosen.connect(self.show_proposals)
        creating.picked.connect(self._take)
        self.show_proposals()

    @Slot()
    def show_proposals(self) -> None:
        """Propose what fits the selected features."""
        names = self._features.names()
        self._proposals = ()  # Enter never adds what was proposed for other features
        self.choice.clear()
        self._proposals = self._creating.proposals(names)
        self.choice.addItems([proposal_words(one) for one in self._proposals])
        missing = HOW if not names else NONE_FITS_ONE if len(names) == 1 else NONE_FITS
        self.words.setText(", ".join(sentence_case(name) for name in names) if self._proposals else translated(missing))
        for widget in (self.choice, self.add):
            widget.setVisible(bool(self._proposals))
        shapes = self._creating.constructions(names)
        self.menu.clear()
        for shape in shapes:
            self.menu.addAction(translated(CONSTRUCTIONS[shape]), lambda shape=shape: self._construct(shape)).setData(shape)
        self.construct.setVisible(bool(shapes))
        for widget in (self.distance_words, self.distance):
            widget.setVisible(any(map(self._creating.has_distance, shapes)))

    @Slot()
    def accept(self) -> None:
        """Add the chosen dimension."""
        place = self.choice.currentIndex()
        if 0 <= place < len(self._proposals):
            name = self._creating.add(self._proposals[place])
            if name:
                self.dimensionAdded.emit(name)

    @Slot(str)
    def _take(self, name: str) -> None:
        if self.pick.isChecked():
            self._features.toggle(name)

    @Slot(QAction)
    def _preview(self, action: QAction) -> None:
        shape = str(action.data())
        self.previewed.emit(self._creating.preview(shape, self._features.names(), self._distance_of(shape)))

    def _construct(self, shape: str) -> None:
        name = self._creating.construct(shape, self._features.names(), self._distance_of(shape))
        if name:
            self._features.select_names([name])

    def _distance_of(self, shape: str) -> float:
        """Return the distance at which a shape is constructed, 0 where it has none."""
        return self.distance.value() if self._creating.has_distance(shape) else 0.0


def distance_field() -> NumberField:
    """Return an editor of the distance of a constructed feature."""
    made = NumberField()
    made.setAccessibleName(tr("Distance of an offset plane or a point on the axis"))
    made.setToolTip(tr("Distance of an offset plane or a point on the axis"))
    made.setDecimals(3)
    made.setRange(-LARGEST_MM, LARGEST_MM)
    made.setSuffix(" mm")
    made.setProperty("plain", True)
    return made


def proposal_words(proposal: Proposal) -> str:
    """Return a proposal in words: kind and nominal, or the width of the zone."""
    entry = proposal.dimensions[0]
    kind = sentence_case(proposal.kind)
    if "nominal" not in entry:
        return tr("{kind}, width {millimetres}", kind=kind, millimetres=millimetres(float(entry.get("upper_tolerance", 0.1))))
    unit = "°" if proposal.kind in ("angle", "cone_angle") else "mm"
    return tr("{kind} {nominal}", kind=kind, nominal=quantity(float(entry["nominal"]), unit))
