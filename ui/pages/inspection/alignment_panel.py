"""Alignment by clicking: method, elements in their order, lamps for the degrees of freedom, residuals, apply."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QRectF, QSize, Qt, Slot
from PySide6.QtGui import QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QFrame, QVBoxLayout, QWidget

from measureapp.errors import MeasureError
from ui.controllers.creating import CreatingController
from ui.controllers.programming import ProgrammingController
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import millimetres, sentence, sentence_case
from ui.widgets.basic import Button, CalmComboBox, clear, column, label, row, scrolled
from ui.widgets.segments import Segments

if TYPE_CHECKING:
    from measureapp.data.inspection_program import InspectionProgram
    from measureapp.data.measurement import Inspection
    from measureapp.inspection.programming.freedom import Freedom

METHODS = {"best-fit": "Best fit", "datums": "Datums", "3-2-1": "3-2-1", "rps": "RPS", "none": "None"}
ROLES = {"datums": ("A", "B", "C"), "3-2-1": ("Plane", "Line", "Point"), "rps": tuple(str(number) for number in range(1, 13))}
LEAST = {"best-fit": 0, "none": 0, "datums": 1, "3-2-1": 3, "rps": 3}
HOW = {
    "best-fit": "All points as close to the nominal as possible. For comparison only: it spreads defects over the whole part.",
    "none": "The coordinates of the part as they are, without an alignment.",
    "datums": "A, B and C in their order; each fixes what the earlier ones leave free.",
    "3-2-1": "A plane fixes three degrees of freedom, a line or axis two more, a point the last one.",
    "rps": "Reference points, each along its normal; further ones take part by least squares.",
}
LAMP_PX, LAMPS = 14, 6
ADD = "Add a feature…"


class FreedomLamps(QWidget):
    """Six lamps, one for each degree of freedom; those that are fixed are filled."""

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look, self.fixed = look, 0
        self.setFixedSize(QSize(LAMPS * (LAMP_PX + 6), LAMP_PX + 4))
        look.changed.connect(self.update)

    def show_fixed(self, count: int) -> None:
        """Fill this number of lamps."""
        self.fixed = count
        self.setAccessibleName(tr("{count} of 6 degrees of freedom fixed", count=count))
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the lamps."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        accent = self._look.theme.colour("accent")
        for place in range(LAMPS):
            painter.setPen(QPen(accent if place < self.fixed else self._look.theme.colour("faint"), 1.5))
            painter.setBrush(accent if place < self.fixed else Qt.BrushStyle.NoBrush)
            painter.drawEllipse(QRectF(2.0 + place * (LAMP_PX + 6), 2.0, LAMP_PX, LAMP_PX))


class AlignmentPanel(QFrame):
    """Edits the alignment of the program; nothing changes before Apply."""

    def __init__(self, look: Look, programming: ProgrammingController, creating: CreatingController) -> None:
        super().__init__()
        self.setObjectName("card")
        self._look, self._programming = look, programming
        self._names: list[str] = []
        self._shown: object = None  # alignment of the program that was shown last
        self.method = Segments(METHODS, name="Alignment")
        self.how, self.count, self.result = label("", "small", wrap=True), label("", "strong", wrap=True), label("", "soft", wrap=True)
        self.lamps = FreedomLamps(look)
        self.elements = QVBoxLayout()
        self.elements.setSpacing(4)
        self.choice = CalmComboBox()
        self.choice.setAccessibleName(translated(ADD))
        self.choice.activated.connect(self._choose)
        self.pick = Button("Pick faces", look, "grow", "quiet", "Click faces of the CAD model as elements, in their order; Esc ends")
        self.pick.setCheckable(True)
        self.reset = Button("Reset", look, "undo", "quiet", "Return to the alignment of the program")
        self.apply = Button("Apply", look, "", "primary", "Align by these elements and measure everything again; it can be undone")
        self.method.valueChanged.connect(self._change_method)
        self.reset.clicked.connect(self._reset)
        self.apply.clicked.connect(self._apply)
        creating.picked.connect(self._take)
        more = row(self.choice, self.pick, spacing=8)
        more.setStretch(0, 1)
        freedom = row(self.lamps, self.count, spacing=8)
        freedom.setStretch(1, 1)
        chosen = QWidget()
        chosen.setObjectName("clear")
        chosen.setLayout(column(self.how, self.elements, more, freedom, self.result, 0, spacing=8))
        shown = column(row(self.method, 0), scrolled(chosen), row(0, self.reset, self.apply, spacing=8), margin=16, spacing=8)
        shown.setStretch(1, 1)
        self.setLayout(shown)
        programming.changed.connect(self.show_program)

    def value(self) -> dict[str, Any]:
        """Return the alignment as chosen, as the program states it."""
        method = self.method.value()
        if method == "3-2-1":
            return {"method": method, **dict(zip(("plane", "line", "point"), self._names, strict=False))}
        if method == "rps":
            return {"method": method, "points": [{"feature": name} for name in self._names]}
        return {"method": method, "datums": list(self._names)} if method == "datums" else {"method": method}

    @Slot()
    def show_program(self) -> None:
        """Show the alignment of the edited program, unless another one is being chosen."""
        state = self._programming.state
        self.setEnabled(state is not None)
        if state is None:
            return
        if state.program.alignment != self._shown:
            self._reset()
        else:
            self._show()

    def show_inspection(self, inspection: Inspection) -> None:
        """State the residuals of the alignment in use."""
        alignment = inspection.alignment
        words = [tr("In use: {name}, {rms_mm} rms.", name=alignment.name, rms_mm=millimetres(alignment.rms_mm))]
        words += [
            tr("{name}: residual {off}.", name=sentence_case(name), off=millimetres(off)) for name, off in alignment.residuals_mm.items()
        ]
        words += [sentence(tr("not determined: {motion}", motion=motion)) for motion in alignment.undetermined]
        self.result.setText(translated(" ".join((*words, *alignment.notes))))

    def _reset(self) -> None:
        from measureapp.data.alignment_program import alignment_features

        state = self._programming.state
        if state is None:
            return
        self._shown = state.program.alignment
        method = self._shown.method
        self._names = list(alignment_features(self._shown)) if method in ROLES else []
        blocked = self.method.blockSignals(True)
        self.method.setValue(method if method in METHODS else "best-fit")
        self.method.blockSignals(blocked)
        self._show()

    def _change_method(self) -> None:
        self._names = self._names[: len(ROLES.get(self.method.value(), ()))]
        self._show()

    @Slot(str)
    def _take(self, name: str) -> None:
        if self.pick.isChecked():
            self._add(name)

    def _choose(self, place: int) -> None:
        if place > 0:
            self._add(self.choice.itemData(place))

    def _add(self, name: str) -> None:
        if name not in self._names and len(self._names) < len(ROLES.get(self.method.value(), ())):
            self._names.append(name)
        self._show()

    def _remove(self, name: str) -> None:
        self._names.remove(name)
        self._show()

    def _show(self) -> None:
        state, method = self._programming.state, self.method.value()
        if state is None:
            return
        uses = method in ROLES
        self.how.setText(translated(HOW[method]))
        freedom, problem = freedom_of(state.program, method, self._names)
        self._show_elements(method, freedom)
        self._offer(state.program)
        for widget in (self.choice, self.pick):
            widget.setVisible(uses)
        fixed = LAMPS if freedom is None and not uses else 0 if freedom is None else freedom.fixed
        self.lamps.show_fixed(fixed)
        left = "" if freedom is None or not freedom.free else tr("; free: {list}", list=", ".join(map(translated, freedom.free)))
        self.count.setText(translated(problem) or f"{fixed}/6{left}")
        complete = len(self._names) >= LEAST[method] or not uses
        refused = freedom is not None and any(step.refused for step in freedom.steps)
        self.apply.setEnabled(complete and not problem and not refused and self._programming.can_change)

    def _show_elements(self, method: str, freedom: Freedom | None) -> None:
        clear(self.elements)
        steps = {step.element: step for step in freedom.steps} if freedom is not None else {}
        for role, name in zip(ROLES.get(method, ()), self._names, strict=False):
            step = steps.get(name)
            words = "" if step is None or step.problem else tr("fixes {fixed}", fixed=step.fixed)
            remove = Button("", self._look, "remove", "quiet", tr("Remove {name}", name=name))
            remove.clicked.connect(lambda _checked=False, name=name: self._remove(name))
            self.elements.addLayout(row(label(role, "strong"), label(sentence_case(name)), 0, label(words, "soft"), remove, spacing=8))
            if step is not None and step.problem:
                self.elements.addWidget(label(sentence(step.problem), "small", wrap=True))

    def _offer(self, program: InspectionProgram) -> None:
        from measureapp.data.inspection_program import copy_names

        names = [name for one in program.features for name in copy_names(one.name, one.repeat)]
        self.choice.clear()
        self.choice.addItem(translated(ADD))
        for name in (one for one in names if one not in self._names):
            self.choice.addItem(sentence_case(name), name)

    def _apply(self) -> None:
        from measureapp.inspection.programming import edits

        wanted = self.value()
        self.pick.setChecked(False)
        self._programming.edit(lambda program: edits.set_alignment(program, wanted), "Alignment of the program changed.")


def freedom_of(program: InspectionProgram, method: str, names: Sequence[str]) -> tuple[Freedom | None, str]:
    """Return what elements fix, and why that is not known; None for a best fit or without elements."""
    from measureapp.data.alignment_program import ReferencePoint
    from measureapp.inspection.programming.freedom import datums_freedom, points_freedom, three_two_one_freedom

    if method not in ROLES or not names:
        return None, ""
    try:
        if method == "rps":
            return points_freedom(program, [ReferencePoint(feature=name) for name in names]), ""
        return (three_two_one_freedom if method == "3-2-1" else datums_freedom)(program, names), ""
    except MeasureError as error:
        return None, error.message
