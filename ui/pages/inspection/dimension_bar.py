"""Bar to define a new size: kind, features, nominal and tolerance; tolerance zones have an editor of their own."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QComboBox, QWidget

from ui.look.language.retranslating import GIVEN
from ui.look.language.words import for_name, tr, translated
from ui.look.look import Look
from ui.look.wording import sentence_case
from ui.widgets.basic import Button, column, label, row
from ui.widgets.number_field import NumberField

TIP = (
    "Add a distance, an angle, a diameter or a radius to the inspection program; “Tolerance…” in the list of features adds tolerance zones"
)
HOW = "Choose features here, or click them in the list"
TWICE = "Choose two different features"
UNSET = -1e6  # below every nominal: no value entered yet
LIMIT = 20_000.0


@dataclass(frozen=True)
class Kind:
    """A kind of dimension: label and required input."""

    words: str
    joined: str = ""  # the word before the second feature; empty: there is none
    unit: str = " mm"


KINDS = {
    "distance": Kind("Distance", "to"),
    "angle": Kind("Angle", "to", unit="°"),
    "diameter": Kind("Diameter"),
    "radius": Kind("Radius"),
}


@dataclass(frozen=True)
class NewDimension:
    """A dimension as defined in the bar."""

    name: str
    kind: str
    features: tuple[str, ...]
    nominal: float
    tolerance: float

    @property
    def lines(self) -> str:
        """The lines that define it in an inspection program."""
        from measureapp.project.program_text import format_entry

        what = {"name": self.name, "kind": self.kind, "features": self.features}
        return format_entry(
            "dimensions", {**what, "nominal": self.nominal, "lower_tolerance": -self.tolerance, "upper_tolerance": self.tolerance}
        )


class DimensionBar(QWidget):
    """Chooses a dimension: `value()` is a `NewDimension`; asked when the button is pressed."""

    asked = Signal()

    def __init__(self, look: Look) -> None:
        super().__init__()
        self.button = Button("Dimension", look, "add", "quiet", TIP)
        self.button.setCheckable(True)
        self.button.toggled.connect(self.setVisible)
        self.kind, self.first, self.second = QComboBox(), QComboBox(), QComboBox()
        for box in (self.first, self.second):
            box.setProperty(GIVEN, True)
        for name, kind in KINDS.items():
            self.kind.addItem(translated(kind.words), name)
        for box, words in ((self.kind, "Kind of dimension"), (self.first, "First feature"), (self.second, "Second feature")):
            box.setAccessibleName(translated(words))
            box.setToolTip(translated(f"{words}. {HOW}." if box is not self.kind else words))
            box.setMinimumContentsLength(5)
            box.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.joined = label("to", "soft")
        self.nominal, self.tolerance = _number("Nominal value"), _number("Symmetric tolerance")
        self.nominal.setRange(UNSET, LIMIT)
        self.nominal.setSpecialValueText(tr("Nominal"))
        self.nominal.setValue(UNSET)
        self.tolerance.setRange(0.001, LIMIT)
        self.tolerance.setValue(0.1)
        self.add = Button("Add", look, "", tip="Add it to the inspection program and measure it")
        self.add.clicked.connect(self.asked)
        self.problem = label("", "small", wrap=True)
        above = row(self.kind, self.first, self.joined, self.second, spacing=8)
        above.setStretch(1, 1)
        above.setStretch(3, 1)
        self.setLayout(column(above, row(self.nominal, label("±", "soft"), self.tolerance, 0, self.add, spacing=8), self.problem, margin=8))
        self._names: tuple[str, ...] = ()
        self._next_is_second = False
        self.kind.currentIndexChanged.connect(self._show_kind)
        for box in (self.first, self.second):
            box.currentIndexChanged.connect(self._show_ready)
        self.nominal.valueChanged.connect(self._show_ready)
        self.hide()
        self._show_kind()

    def show_features(self, names: Sequence[str], taken: Sequence[str]) -> None:
        """Offer these features; ``taken`` are the names of existing dimensions."""
        self._names = tuple(taken)
        if names != [self.first.itemText(place) for place in range(self.first.count())]:
            for box in (self.first, self.second):
                chosen = box.currentText()
                box.clear()
                box.addItems(list(names))
                box.setCurrentText(chosen)
            self.second.setCurrentIndex(max(self.second.currentIndex(), min(1, len(names) - 1)))
        self._show_ready()

    def take(self, feature: str) -> None:
        """Select a clicked feature: alternately the first and the second."""
        second = self._next_is_second and bool(self._kind.joined)
        (self.second if second else self.first).setCurrentText(feature)
        self._next_is_second = not second

    def value(self) -> NewDimension:
        """Return the dimension as chosen."""
        kind, name = self._kind, self.kind.currentData()
        taken = {sentence_case(one) for one in self._names}
        names = (f"{for_name(name.replace('_', ' '))} {place}" for place in range(1, len(taken) + 2))
        free = next(one for one in names if sentence_case(one) not in taken)
        others = (self.second.currentText(),) if kind.joined else ()
        features = (self.first.currentText(), *others)
        return NewDimension(free, name, features, self.nominal.value(), self.tolerance.value())

    @property
    def _kind(self) -> Kind:
        return KINDS[self.kind.currentData()]

    def _show_kind(self) -> None:
        kind = self._kind
        self.joined.setText(translated(kind.joined))
        for widget in (self.joined, self.second):
            widget.setVisible(bool(kind.joined))
        for number in (self.nominal, self.tolerance):
            number.setSuffix(kind.unit)
        self._next_is_second = False
        self._show_ready()

    def _show_ready(self) -> None:
        kind = self._kind
        has_features = self.first.count() > (1 if kind.joined else 0)
        is_twice = has_features and bool(kind.joined) and self.first.currentText() == self.second.currentText()
        has_nominal = self.nominal.value() > UNSET
        self.add.setEnabled(has_features and has_nominal and not is_twice)
        unentered = "" if has_nominal else "Enter the nominal value"
        missing = "Too few features: grow some first" if not has_features else TWICE if is_twice else unentered
        self.problem.setText(translated(TWICE) if is_twice else "")
        self.problem.setVisible(is_twice)
        self.add.setToolTip(translated(missing) or tr("Add it to the inspection program and measure it"))


def _number(words: str) -> NumberField:
    made = NumberField()
    made.setDecimals(3)
    made.setFixedWidth(128)
    made.setProperty("plain", True)
    made.setAccessibleName(translated(words))
    made.setToolTip(translated(words))
    return made
