"""Calibrate: what is known of the rig's true geometry, and how well."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget

from ui.controllers.controllers import Controllers
from ui.look.look import Look
from ui.look.wording import millimetres, quantity, when
from ui.pages.calibration_rows import SolutionRow, contributions, solution_rows, worst_residual_mm
from ui.pages.page import Page
from ui.session import Session
from ui.widgets.bar_chart import Bar, BarChart
from ui.widgets.basic import card, column, label
from ui.widgets.data_table import Cell, DataTable, number, verdict_cell
from ui.widgets.empty_state import EmptyState
from ui.widgets.properties_panel import Group, Properties

EMPTY_TEXT = (
    "The demo calibrates the virtual rig from simulated images of a board. "
    "For recorded images use “measureapp calibrate cameras”, “axis”, “hand-eye” or “guide” on the command line."
)
SHARES_TEXT = "Root sum of squares, as if the solutions were independent. They are solved together, so a part of it cancels."


class CalibrationPage(Page):
    """The solutions with estimate, standard deviation, residual and verdict."""

    name, word = "calibration", "Calibrate"

    def __init__(self, look: Look, session: Session, controllers: Controllers) -> None:
        empty = EmptyState(look, "calibration", "No calibration yet", EMPTY_TEXT, "Run the demo")
        super().__init__(look, session, controllers, empty)
        self.verdict = label("", "figure")
        self.table = DataTable(look, ["Solution", "Estimate", "Standard deviation", "Residual (rms)", "Verdict"], numeric=(3,), stretch=1)
        self.table.rowSelected.connect(self._select)
        figure = QWidget()
        figure.setLayout(column(self.verdict, label("Largest residual of hand–eye, guide and axis", "small"), spacing=0))
        self.verdict.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.action_row.addWidget(figure)
        self.chart = BarChart(look)
        shares = card(
            label("What the calibration adds to a point placed by the axes (1 σ)", "heading"), label(SHARES_TEXT, "soft"), 8, self.chart
        )
        layout = column(self.table, shares, 0, spacing=16)
        layout.setStretch(1, 1000)
        self.body.setLayout(layout)
        self._rows: list[SolutionRow] = []
        session.calibrationChanged.connect(self._show)
        session.rigChanged.connect(self._show)
        session.busyChanged.connect(self._show_busy)
        self._show()

    def _show_busy(self) -> None:
        if self.session.busy_with and self.session.calibration is None:
            self.empty.say("Calibrating…", "The board is shown to the cameras from many sides. The solutions appear here.", offer=False)
        else:
            self.empty.say("No calibration yet", EMPTY_TEXT)

    def _show(self) -> None:
        calibration = self.session.calibration
        self.show_filled(calibration is not None)
        if calibration is None:
            self.state.setText("The true geometry of the rig is not known yet.")
            return
        self._rows = solution_rows(calibration, self.session.rig)
        bad = [found.name for found in self._rows if not found.good]
        age = when(calibration.provenance.created)
        judgement = f"Look at: {', '.join(bad)}." if bad else "Every solution is as good as the rig allows: scan next."
        self.state.setText(f"Calibrated {age}. {judgement}" if age else judgement)
        self.verdict.setText(millimetres(worst_residual_mm(calibration)))
        self.table.set_rows([self._cells(found) for found in self._rows])
        self.table.setFixedHeight(self.table.fitted_height())
        shares = contributions(calibration, self.session.rig)
        self.chart.show_bars([Bar(name, value, strong=name == "Together") for name, value in shares])
        self._select(max(0, self.table.currentIndex().row()))

    def _cells(self, found: SolutionRow) -> list[Cell]:
        good = verdict_cell("pass", "Good", found.criterion) if found.good else verdict_cell("fail", "Poor", found.criterion)
        return [Cell(found.name, bold=True), Cell(found.estimate), Cell(found.deviation), number(found.residual), good]

    def _select(self, place: int) -> None:
        calibration = self.session.calibration
        if calibration is None or not 0 <= place < len(self._rows):
            return
        found = self._rows[place]
        camera = calibration.cameras.cameras.get(found.name.removeprefix("Camera "))
        deviations = tuple((name, deviation_words(name, value)) for name, value in camera.standard_deviations.items()) if camera else ()
        pairs = tuple((f"{pair} pair", f"{rms:.3f} px") for pair, rms in calibration.cameras.pair_rms_px.items()) if camera else ()
        method = calibration.hand_eye.method if found.name == "Hand–eye" else calibration.provenance.method
        self.show_properties(
            Properties(
                found.name,
                tuple(
                    group
                    for group in (
                        Group(
                            "Result",
                            (("Residual (rms)", found.residual), ("Standard deviation", found.deviation), ("Method", method or "–")),
                        ),
                        Group("Standard deviations", deviations[:12]),
                        Group("Camera pairs", pairs),
                    )
                    if group.rows
                ),
                f"{found.estimate}. Judged by: {found.criterion[0].lower()}{found.criterion[1:]}.",
            )
        )


def deviation_words(name: str, value: float) -> str:
    """Return the standard deviation of a lens parameter: pixels for f and c, plain numbers for distortion."""
    return f"± {quantity(value, 'px', 3)}" if name in {"fx", "fy", "cx", "cy"} else f"± {quantity(value, '', 6)}"
