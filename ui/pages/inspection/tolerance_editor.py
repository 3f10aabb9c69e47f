"""Editor of a geometrical tolerance: characteristic, feature, zone and datums are chosen, the frame is drawn meanwhile."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QSize, Qt, Signal, Slot
from PySide6.QtGui import QShortcut
from PySide6.QtWidgets import QFrame, QGridLayout, QWidget

from measureapp.data.control_frame import CHARACTERISTICS
from ui.controllers.creating import CreatingController
from ui.controllers.tolerancing import Tolerancing
from ui.look.language.retranslating import GIVEN
from ui.look.language.words import later, tr, translated
from ui.look.look import Look
from ui.look.wording import sentence_case
from ui.pages.inspection.frame_picture import ICON_PX, FramePicture, symbol_icon
from ui.widgets.basic import Button, CalmComboBox, column, label, row, scrolled
from ui.widgets.number_field import NumberField

WORDS = {
    "straightness": later("Straightness"),
    "flatness": later("Flatness"),
    "roundness": later("Roundness"),
    "cylindricity": later("Cylindricity"),
    "line_profile": later("Line profile"),
    "surface_profile": later("Surface profile"),
    "parallelism": later("Parallelism"),
    "perpendicularity": later("Perpendicularity"),
    "angularity": later("Angularity"),
    "position": later("Position"),
    "concentricity": later("Concentricity"),
    "coaxiality": later("Coaxiality"),
    "circular_runout": later("Circular runout"),
    "total_runout": later("Total runout"),
}
CONDITIONS = {
    "regardless": later("Regardless of size"),
    "maximum": later("Maximum material"),
    "least": later("Least material"),
}
PROFILES = ("line_profile", "surface_profile")
DATUM_ROWS = 3
LIMIT, WIDTH_MM = 1000.0, 0.1  # mm; the width of a new zone


class ToleranceEditor(QFrame):
    """Chooses a frame; nothing changes before Apply."""

    closed = Signal(str)  # name of the dimension that was added or changed; empty: cancelled

    def __init__(self, look: Look, tolerancing: Tolerancing, creating: CreatingController) -> None:
        super().__init__()
        self.setObjectName("card")
        self._look, self._tolerancing = look, tolerancing
        self._former, self._is_filling = "", False
        self.title, self.problem = label("", "strong"), label("", "small", wrap=True)
        self.picture = FramePicture(look)
        self.kind, self.feature = _box("Characteristic"), _box("Toleranced feature", is_given=True)
        self.datums = [_box(words, is_given=True) for words in ("Primary datum", "Secondary datum", "Tertiary datum")]
        self.partners = [_box("Common datum (A-B) with", is_given=True) for _ in self.datums]
        self.condition = _box("Material condition")
        self.width = _number("Width of the zone", 0.001)
        self.offset = _number("Offset of the zone, out of the material", -LIMIT)
        self.least, self.most = _number("Least diameter", 0.0), _number("Greatest diameter", 0.0)
        for kind in CHARACTERISTICS:
            self.kind.addItem(symbol_icon(kind, look), translated(WORDS[kind]), kind)
        self.kind.setIconSize(QSize(ICON_PX, ICON_PX))
        for condition, words in CONDITIONS.items():
            self.condition.addItem(translated(words), condition)
        self.pick = Button(
            "Pick faces", look, "grow", "quiet", "Click faces of the CAD model: first the feature, then its datums; Esc ends"
        )
        self.pick.setCheckable(True)
        self.cancel = Button("Cancel", look, "", "quiet", "Leave the program as it is (Esc)")
        self.apply = Button("Apply", look, "", "primary", "Put the tolerance into the program and measure it; it can be undone")
        self._lay_out()
        for box in (self.kind, self.feature, self.condition, *self.datums, *self.partners):
            box.currentIndexChanged.connect(self._show)
        for number in (self.width, self.offset, self.least, self.most):
            number.valueChanged.connect(self._show)
        self.apply.clicked.connect(self._apply)
        self.cancel.clicked.connect(lambda: self._close(""))
        QShortcut(Qt.Key.Key_Escape, self, self.cancel.click, context=Qt.ShortcutContext.WidgetWithChildrenShortcut)
        creating.picked.connect(self._take)
        look.changed.connect(self._draw_symbols)

    def _lay_out(self) -> None:
        grid = QGridLayout()
        grid.setHorizontalSpacing(8)
        grid.setVerticalSpacing(4)
        grid.setColumnStretch(1, 1)
        self._rows: dict[str, tuple[QWidget, ...]] = {}
        lines: tuple[tuple[str, str, Sequence[QWidget]], ...] = (
            ("kind", "Characteristic", (self.kind,)),
            ("feature", "Feature", (self.feature,)),
            ("width", "Tolerance", (self.width,)),
            ("offset", "Offset (UZ)", (self.offset,)),
            ("condition", "Condition", (self.condition,)),
            ("size", "Diameter", (self.least, self.most)),
            *(
                (f"datum{place}", words, boxes)
                for place, (words, *boxes) in enumerate(zip(("Datum 1", "Datum 2", "Datum 3"), self.datums, self.partners, strict=True))
            ),
        )
        for place, (key, words, fields) in enumerate(lines):
            heading = label(words, "soft")
            grid.addWidget(heading, place, 0)
            if len(fields) == 1:
                grid.addWidget(fields[0], place, 1)
            else:
                grid.addLayout(row(*fields, *(() if key.startswith("datum") else (0,)), spacing=8), place, 1)
            self._rows[key] = (heading, *fields)
        fields = QWidget()
        fields.setObjectName("clear")
        fields.setLayout(column(self.picture, grid, 0, spacing=6))
        area = scrolled(fields)  # not the buttons: Apply stays where it can be reached
        below = row(self.pick, 0, self.cancel, self.apply, spacing=8)
        layout = column(self.title, area, self.problem, below, margin=8, spacing=6)
        layout.setStretch(1, 1)
        self.setLayout(layout)

    @property
    def is_open(self) -> bool:
        """Whether a tolerance is being chosen."""
        return self.isVisibleTo(self.parentWidget())

    def begin(self, features: Sequence[str] = ()) -> None:
        """Choose a new tolerance: of the first of these features, with the others as its datums."""
        self._former = ""
        self.title.setText(tr("New geometrical tolerance"))
        feature, *datums = features or ("",)
        self.width.setValue(WIDTH_MM)
        choice = self._tolerancing.first_choice(feature, datums, WIDTH_MM)
        if choice is None:
            self._fill("flatness", feature, datums)
        else:
            self._fill(choice.kind, feature, choice.datums)

    def edit(self, name: str) -> bool:
        """Change the tolerance of a dimension; return False where it is no geometrical tolerance."""
        choice = self._tolerancing.choice_of(name)
        if choice is None:
            return False
        self._former = name
        self.title.setText(sentence_case(name))
        self._is_filling = True
        self.width.setValue(choice.width_mm)
        self.offset.setValue(choice.zone_offset_mm)
        self.condition.setCurrentIndex(self.condition.findData(choice.condition))
        for number, limit in zip((self.least, self.most), choice.size_limits_mm or (0.0, 0.0), strict=True):
            number.setValue(limit)
        self._fill(choice.kind, choice.feature, choice.datums)
        return True

    def value(self):  # type: ignore[no-untyped-def]
        """Return the `ToleranceChoice` as chosen."""
        from measureapp.inspection.programming.tolerance_frames import ToleranceChoice, takes_datums, takes_material

        kind, feature = self.kind.currentData(), self.feature.currentData() or ""
        pairs = zip(self.datums[: takes_datums(kind)], self.partners, strict=False)
        chosen = [(box.currentData(), partner.currentData() or "") for box, partner in pairs if box.currentData()]
        datums, partners = tuple(name for name, _ in chosen), tuple(partner for _, partner in chosen)
        condition = self.condition.currentData() if takes_material(kind, self._tolerancing.shape(feature)) else "regardless"
        limits = None if condition == "regardless" else (self.least.value(), self.most.value())
        offset = self.offset.value() if kind in PROFILES else 0.0
        return ToleranceChoice(kind, feature, self.width.value(), datums, condition, limits, offset, partners if any(partners) else ())

    def _fill(self, kind: str, feature: str, datums: Sequence[str], partners: Sequence[str] = ()) -> None:
        """Offer characteristics, features and datums, and choose these."""
        self._is_filling = True
        names, letters = self._tolerancing.names(), self._tolerancing.letters()
        self.kind.setCurrentIndex(self.kind.findData(kind))
        _offer(self.feature, [(name, sentence_case(name)) for name in dict.fromkeys((*names, *([feature] if feature else [])))], feature)
        ordered = sorted(dict.fromkeys((*names, *datums)), key=lambda name: (name not in letters, letters.get(name, "")))
        offered = [("", tr("None")), *((name, f"{letters.get(name, '')}  {sentence_case(name)}".strip()) for name in ordered)]
        alone = [("", tr("alone")), *offered[1:]]
        for boxes, items, names in ((self.datums, offered, datums), (self.partners, alone, partners)):
            for place, box in enumerate(boxes):
                _offer(box, items, names[place] if place < len(names) else "")
        self._is_filling = False
        self._show()

    def changeEvent(self, event: QEvent) -> None:
        """Name what stands for no datum in the new language; all other items of these lists are names that people gave."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            for boxes, words in ((self.datums, tr("None")), (self.partners, tr("alone"))):
                for box in boxes:
                    box.setItemText(0, words)

    @Slot()
    def _show(self) -> None:
        """Draw the frame as chosen, and say why it cannot be used."""
        from measureapp.inspection.programming.tolerance_frames import takes_datums, takes_material

        if self._is_filling or self.feature.count() == 0:
            return
        choice = self.value()
        can_have_material = takes_material(choice.kind, self._tolerancing.shape(choice.feature))
        shown = {
            "offset": choice.kind in PROFILES,
            "condition": can_have_material,
            "size": can_have_material and choice.condition != "regardless",
            **{f"datum{place}": place < takes_datums(choice.kind) for place in range(DATUM_ROWS)},
        }
        for key, is_shown in shown.items():
            for widget in self._rows[key]:
                widget.setVisible(is_shown)
        problem = self._tolerancing.refusal(choice, self._former)
        self.picture.show_frame(self._tolerancing.frame(choice, self._former))
        self.problem.setText(translated(problem))
        self.problem.setVisible(bool(problem))
        self.apply.setEnabled(not problem)

    @Slot()
    def _apply(self) -> None:
        name = self._tolerancing.apply(self.value(), self._former)
        if name:
            self._close(name)

    def _close(self, name: str) -> None:
        self.pick.setChecked(False)
        self.closed.emit(name)

    @Slot(str)
    def _take(self, name: str) -> None:
        """Choose a clicked feature: the toleranced one first, then the datums in their order."""
        if not self.pick.isChecked():
            return
        boxes = [self.feature, *(box for box in self.datums if not box.isHidden())]
        focused = next((box for box in boxes if box.hasFocus()), None)
        free = next((box for box in boxes if not box.currentData()), boxes[-1])
        choice = self.value()
        taken = {self.feature: choice.feature, **dict.fromkeys(self.datums, "")}
        chosen = {box: box.currentData() or taken[box] for box in boxes}
        chosen[focused or free] = name
        partners = [box.currentData() or "" for box in self.partners]
        self._fill(choice.kind, chosen[self.feature], [chosen.get(box, "") for box in self.datums], partners)

    @Slot()
    def _draw_symbols(self) -> None:
        for place in range(self.kind.count()):
            self.kind.setItemIcon(place, symbol_icon(self.kind.itemData(place), self._look))


def _offer(box: CalmComboBox, items: Sequence[tuple[str, str]], chosen: str) -> None:
    box.clear()
    for data, words in items:
        box.addItem(words, data)
    box.setCurrentIndex(box.findData(chosen))


def _box(words: str, *, is_given: bool = False) -> CalmComboBox:
    """Return a box; ``is_given``: its items are names that people gave."""
    made = CalmComboBox()
    made.setProperty(GIVEN, is_given)
    made.setAccessibleName(translated(words))
    made.setToolTip(translated(words))
    made.setMinimumContentsLength(8)
    return made


def _number(words: str, least: float) -> NumberField:
    made = NumberField()
    made.setDecimals(3)
    made.setRange(least, LIMIT)
    made.setSingleStep(0.01)
    made.setSuffix(" mm")
    made.setAccessibleName(translated(words))
    made.setToolTip(translated(words))
    return made
