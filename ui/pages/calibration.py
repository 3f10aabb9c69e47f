"""Page Calibrate: the calibration of the rig and its uncertainty."""

from __future__ import annotations

from functools import partial
from itertools import starmap
from math import degrees
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu, QWidget

from ui.charts.bar_chart import Bar, BarChart
from ui.controllers.controllers import Controllers
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import millimetres, quantity, sentence_case, when
from ui.pages.calibration_rows import PROJECTOR_ROW, SolutionRow, added_to_length_mm, camera_rows, contributions, solution_rows
from ui.pages.page import Page
from ui.session import Session
from ui.widgets.basic import Button, card, column, label
from ui.widgets.data_table import Cell, DataTable, number, verdict_cell
from ui.widgets.empty_state import EmptyState
from ui.widgets.properties_panel import Group, Properties

if TYPE_CHECKING:
    from measureapp.calibrate.draft.draft import Kind
    from measureapp.data.calibration import CameraCalibration, ProjectorCalibration
    from ui.wizards.automatic import AutomaticCalibration
    from ui.wizards.wizard import CalibrationWizard

EMPTY_TEXT = (
    "Fix the calibration board on the table, then calibrate the whole rig in one automatic run. "
    "The cameras alone can be calibrated from recorded images too."
)
ADDED_WORDS = "added to a length between views (k = 2)"
CAMERAS_ONLY = "The cameras are calibrated; hand–eye, linear guide and table axis are not. Calibrate the whole rig next."
SHARES_TEXT = "Root sum of squares, as for independent solutions. They are solved together, so a part of it cancels."


class CalibrationPage(Page):
    """The solutions with estimate, standard deviation, residual and verdict."""

    name, word = "calibration", "Calibrate"

    def __init__(self, look: Look, session: Session, controllers: Controllers) -> None:
        empty = EmptyState(look, "calibration", "No calibration yet", EMPTY_TEXT, "Calibrate the whole rig…")
        super().__init__(look, session, controllers, empty)
        empty.triggered.disconnect(controllers.demo.run)
        empty.triggered.connect(self._open_rig_wizard)
        self.wizards: dict[str, CalibrationWizard] = {}  # by the name of the kind
        self._offers: dict[str, QAction] = {}
        self._make_menus()
        self.verdict = label("", "figure")
        self.table = DataTable(look, ["Solution", "Estimate", "Standard deviation", "Residual (rms)", "Verdict"], numeric=(3,), stretch=1)
        self.table.rowSelected.connect(self._select)
        self.figure = figure = QWidget()
        figure.setLayout(column(self.verdict, label(ADDED_WORDS, "small"), spacing=0))
        self.verdict.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.action_row.addWidget(figure)
        self.action_row.addSpacing(16)
        self.action_row.addWidget(self.calibrate)
        self.chart = BarChart(look, "Contribution, k = 2")
        self.shares = card(
            label("Contribution to the kinematic position of a point (k = 2)", "heading"),
            label(SHARES_TEXT, "soft", wrap=True),
            8,
            self.chart,
            0,
        )
        self.shares.layout().setStretch(self.shares.layout().count() - 2, 1000)  # the chart before the empty end
        layout = column(self.table, self.shares, 0, spacing=16)
        layout.setStretch(0, 1000)  # the table first, as far as it has rows
        layout.setStretch(1, 100)
        self.body.setLayout(layout)
        self._rows: list[SolutionRow] = []
        self.follow(session.calibrationChanged, self._show)
        self.follow(session.rigChanged, self._show)
        self.follow(session.busyChanged, self._show_busy)

    def _make_menus(self) -> None:
        """The wizards as a menu; next to the empty state's button a quiet one for the cameras alone."""
        menu = QMenu(self)
        menu.setToolTipsVisible(True)
        menu.aboutToShow.connect(lambda: self.offers)
        self.calibrate = Button("Calibrate", self.look, "calibration", tip="Calibrate the whole rig again, or one part")
        self.calibrate.setMenu(menu)
        self.automatic_action = menu.addAction(tr("Calibrate automatically…"), self.open_automatic)
        self.automatic_action.setToolTip(tr("The connected rig takes all images of the board itself, and everything is solved together"))
        menu.addSeparator()
        self.automatic: AutomaticCalibration | None = None
        self.cameras_alone = Button("Cameras only…", self.look, "camera", "normal", "Focal length, distortion and pose of every camera")
        self.cameras_alone.clicked.connect(partial(self.open_wizard, "cameras"))
        self.automatically = Button("Calibrate automatically…", self.look, "rig", "normal", self.automatic_action.toolTip())
        self.automatically.clicked.connect(self.open_automatic)
        self.empty.add_quiet(self.automatically)
        self.empty.add_quiet(self.cameras_alone)
        self.last_one = Button("Use the last one", self.look, "undo")
        self.last_one.clicked.connect(self.controllers.recent_calibration.take_up)
        self.empty.add_quiet(self.last_one)

    def _open_rig_wizard(self) -> None:
        self.open_wizard("rig")

    @property
    def offers(self) -> dict[str, QAction]:
        """The menu entries by kind, those enabled that can be calibrated now; made when first needed, as the kinds come with heavy libraries."""
        from measureapp.calibrate.kinds.table import KINDS

        if not self._offers:
            for kind in KINDS.values():
                action = self.calibrate.menu().addAction(translated(f"{kind.words.action}…"), partial(self.open_wizard, kind.name))
                action.setToolTip(translated(kind.words.tip))
                self._offers[kind.name] = action
        there = {"": True, "cameras": self.session.cameras is not None, "rig": self.session.calibration is not None}
        for name, action in self._offers.items():
            action.setEnabled(there[KINDS[name].needs])
        return self._offers

    def open_wizard(self, name: str) -> None:
        """Open the wizard of one kind; it is made when first used."""
        if self.session.refuse_during_job():
            return
        from measureapp.calibrate.kinds.table import find_kind
        from ui.wizards.wizard import CalibrationWizard

        if name not in self.wizards:
            kind: Kind = find_kind(name)
            self.wizards[name] = CalibrationWizard(self.look, kind, self.controllers.calibrating(kind), self)
        self.wizards[name].begin()

    def open_automatic(self) -> None:
        """Open the window of the automatic calibration; it is made when first used."""
        from ui.wizards.automatic import AutomaticCalibration

        if self.automatic is None:
            self.automatic = AutomaticCalibration(self.look, self.session, self.controllers.rig_calibrating, self)
        self.automatic.begin()

    def close_page(self) -> None:
        """Close a wizard that is open; what it collected is kept."""
        for wizard in self.wizards.values():
            wizard.close()
        if self.automatic is not None:
            self.automatic.close()

    def _show_busy(self) -> None:
        if self.session.busy_with and self.session.calibration is None:
            self.say_running("Calibrating…", "The board is recorded from many sides. The solutions appear here.")
        else:
            self.empty.say("No calibration yet", EMPTY_TEXT)

    def _offer_last_one(self) -> None:
        """A calibration accepted without a project is offered again."""
        saved = self.controllers.recent_calibration.saved
        self.last_one.setVisible(bool(saved) and self.session.folder is None)
        age = when(saved) if saved else ""
        self.last_one.setToolTip(tr("Use the calibration that was accepted without a project{words}", words=f" ({age})" if age else ""))

    def _show(self) -> None:
        calibration, cameras = self.session.calibration, self.session.cameras
        self.show_filled(cameras is not None)
        if cameras is None:
            self._offer_last_one()
        for part in (self.figure, self.shares):
            part.setVisible(calibration is not None)
        if calibration is None:
            self._rows = [] if cameras is None else camera_rows(cameras)
            self.state.setText(tr("The true geometry of the rig is not known yet.") if cameras is None else translated(CAMERAS_ONLY))
            self.table.set_rows([self._cells(found) for found in self._rows])
            self.table.setMaximumHeight(self.table.fitted_height())
            self._select(max(0, self.table.currentIndex().row()))
            return
        self._rows = solution_rows(calibration, self.session.rig)
        bad = [found.name for found in self._rows if not found.good]
        age = when(calibration.provenance.created)
        judgement = tr("Poor fit: {list}. Calibrate again.", list=", ".join(bad)) if bad else "All parts fit well: scan next."
        self.state.setText(tr("Calibrated {age}. {judgement}", age=age, judgement=judgement) if age else translated(judgement))
        self.verdict.setText(millimetres(added_to_length_mm(calibration, self.session.rig)))
        self.table.set_rows([self._cells(found) for found in self._rows])
        self.table.setMaximumHeight(self.table.fitted_height())
        shares = contributions(calibration, self.session.rig)
        self.chart.show_bars([Bar(name, value, strong=name == "Together") for name, value in shares])
        self._select(max(0, self.table.currentIndex().row()))

    def _cells(self, found: SolutionRow) -> list[Cell]:
        good = verdict_cell("pass", "Good", found.criterion) if found.good else verdict_cell("fail", "Poor", found.criterion)
        return [Cell(found.name, bold=True), Cell(found.estimate), Cell(found.deviation), number(found.residual), good]

    def _select(self, place: int) -> None:
        calibration, cameras = self.session.calibration, self.session.cameras
        if cameras is None or not 0 <= place < len(self._rows):
            return
        found = self._rows[place]
        camera = cameras.projector if found.name == PROJECTOR_ROW else cameras.cameras.get(found.name.removeprefix("Camera "))
        deviations = tuple(starmap(deviation_words, camera.standard_deviations.items())) if camera else ()
        of_pairs = camera is not None and found.name != PROJECTOR_ROW
        pairs = tuple((tr("Pair {pair}", pair=pair), quantity(rms, "px")) for pair, rms in cameras.pair_rms_px.items()) if of_pairs else ()
        criterion = translated(found.criterion)
        source = cameras.provenance if calibration is None else calibration.provenance
        if found.name == PROJECTOR_ROW and cameras.projector is not None:
            source = cameras.projector.provenance
        method = calibration.hand_eye.method if calibration is not None and found.name == "Hand–eye" else source.method
        self.show_properties(
            Properties(
                found.name,
                tuple(
                    group
                    for group in (
                        Group(
                            "Result",
                            (
                                ("Residual (rms)", found.residual),
                                *_blur(camera),
                                ("Standard deviation", found.deviation),
                                ("Method", sentence_case(method) if method else "–"),
                            ),
                        ),
                        Group("Standard deviations", deviations),
                        Group("Camera pairs", pairs),
                    )
                    if group.rows
                ),
                tr("{estimate}. Criterion: {criterion}.", estimate=found.estimate, criterion=criterion[:1].lower() + criterion[1:]),
            )
        )


def _blur(camera: CameraCalibration | ProjectorCalibration | None) -> tuple[tuple[str, str], ...]:
    """Return the blur of a camera's images, where it was determined."""
    known = 0.0 if camera is None else getattr(camera, "blur_px", 0.0)  # a projector has none
    return (("Blur of its images", quantity(known, "px", 2)),) if known else ()


def deviation_words(name: str, value: float) -> tuple[str, str]:
    """Return name and standard deviation of a camera's parameter: pixels for f and c, plain numbers for distortion, ° and mm for its place."""
    words, _, unit = name.rpartition("_")
    if unit in {"mm", "rad"}:
        in_unit = quantity(value, "mm", 4) if unit == "mm" else quantity(degrees(value), "°", 4)
        return (
            tr("Rotation {axis}", axis=words.rpartition("_")[2]) if unit == "rad" else tr("Position {axis}", axis=words)
        ), f"± {in_unit}"
    return name, f"± {quantity(value, 'px', 3)}" if name in {"fx", "fy", "cx", "cy"} else f"± {quantity(value, '', 6)}"
