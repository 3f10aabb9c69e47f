"""Page Rig: devices of the rig, a drawing to scale, and the demo."""

from __future__ import annotations

from PySide6.QtCore import QSize, Slot

from ui.controllers.controllers import Controllers
from ui.controllers.demo import MeshQuestion
from ui.look.look import Look
from ui.look.wording import exposure, millimetres, quantity, sentence_case, several
from ui.pages.page import Page
from ui.session import Session
from ui.widgets.basic import Button, card, column, label, row
from ui.widgets.data_table import Cell, DataTable, verdict_cell
from ui.widgets.demo_form import DemoForm
from ui.widgets.empty_state import EmptyState
from ui.widgets.properties_panel import Group, Properties
from ui.widgets.rig_drawing import RigDrawing
from ui.widgets.unit_dialog import UnitDialog

DEMO_WORDS = (
    "Calibrates a virtual rig with hidden errors, scans the part, stitches the clouds, evaluates the dimensions and writes the report."
)


class RigPage(Page):
    """Devices and nominal data of the rig."""

    name, word, wants_room = "rig", "Rig", True
    for_operator = True

    def __init__(self, look: Look, session: Session, controllers: Controllers) -> None:
        empty = EmptyState(look, "rig", "Loading the rig…", "The rig description is being read.", "Run the demo")
        super().__init__(look, session, controllers, empty)
        self.drawing = RigDrawing(look)
        self.devices = DataTable(look, ["Device", "Model", "Properties", "Driver"], stretch=2)
        self.form = DemoForm()
        self.unit_dialog: UnitDialog | None = None
        self.form.valueChanged.connect(controllers.demo.choose)
        self.form.meshChosen.connect(controllers.demo.inspect_mesh)
        controllers.demo.meshReady.connect(self.form.show_mesh)
        controllers.demo.unitAsked.connect(self._ask_unit)
        self.run_demo = Button("Run the demo", look, "run", "primary")
        self.run_demo.clicked.connect(controllers.demo.run)
        self.run_demo.setIconSize(QSize(20, 20))
        demo = card(
            label("Demo on the virtual rig", "heading"), label(DEMO_WORDS, "soft", wrap=True), 8, self.form, 8, self.run_demo, 0, spacing=8
        )
        demo.setFixedWidth(352)
        main = column(card(self.drawing, margin=8), self.devices, spacing=16)
        main.setStretch(0, 2)
        main.setStretch(1, 3)
        layout = row(main, demo, spacing=16)
        layout.setStretch(0, 1)
        self.body.setLayout(layout)
        session.rigChanged.connect(self._show)
        session.busyChanged.connect(self._show_busy)
        self._show()

    def _show_busy(self) -> None:
        self.run_demo.setEnabled(not self.session.busy_with)
        self.empty.button.setEnabled(not self.session.busy_with)

    @Slot(object)
    def _ask_unit(self, asked: MeshQuestion) -> None:
        finding = f"{asked.path.name} has a size of {asked.span:.4g}"
        dialog = self.unit_dialog = UnitDialog(self.look, "mesh", finding, asked.likely, asked.span, self)
        dialog.chosen.connect(lambda unit: self.form.show_mesh(asked.path, unit))
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()

    def _show(self) -> None:
        rig = self.session.rig
        self.show_filled(rig is not None)
        if rig is None:
            return
        problems = [driver for driver in self.session.drivers if driver.problem]
        self.state.setText(
            f"{rig.name}. {several(len(rig.cameras), 'camera')}, projector, robot, guide and table."
            + (f" {several(len(problems), 'driver')} could not be loaded." if problems else "")
        )
        self.drawing.show_rig(rig)
        self.devices.set_rows(self._rows())
        self.devices.setMaximumHeight(self.devices.fitted_height())
        self.show_properties(self._properties())

    def _rows(self) -> list[list[Cell]]:
        rig = self.session.rig
        assert rig is not None
        driver = self._driver_cell(rig.driver)
        rows = [
            [
                Cell(f"Camera {camera.name}", bold=True),
                Cell(camera.model),
                Cell(f"{camera.width_px} × {camera.height_px} px · {camera.focal_mm:g} mm lens · {camera.bit_depth} bit"),
                driver,
            ]
            for camera in rig.cameras
        ]
        low, high = rig.guide.limits_mm
        others = (
            ("Projector", rig.projector.model, f"{rig.projector.width_px} × {rig.projector.height_px} px"),
            ("Robot", rig.robot.model, f"Reach {rig.robot.max_reach_mm:.0f} mm · repeatability {millimetres(rig.robot.repeatability_mm)}"),
            (
                "Linear guide",
                rig.guide.model,
                f"{quantity(low, '', 0)} … {quantity(high, '', 0)} mm · repeatability {millimetres(rig.guide.repeatability_mm)}",
            ),
            ("Rotary table", rig.table.model, f"⌀ {rig.table.diameter_mm:.0f} mm · accuracy {rig.table.accuracy_arcsec:g}″"),
        )
        return rows + [[Cell(name, bold=True), Cell(model), Cell(words), driver] for name, model, words in others]

    def _driver_cell(self, wanted: str) -> Cell:
        found = next((driver for driver in self.session.drivers if driver.name == wanted), None)
        if found is None:
            return Cell(sentence_case(wanted))
        if found.problem:
            return verdict_cell("fail", sentence_case(found.name), found.problem)
        return verdict_cell("pass", sentence_case(found.name), f"Version {found.version}")

    def _properties(self) -> Properties:
        rig = self.session.rig
        assert rig is not None
        drivers = tuple((sentence_case(driver.name), driver.problem or driver.version) for driver in self.session.drivers)
        return Properties(
            rig.name,
            (
                Group(
                    "Measuring head",
                    (
                        ("Reference camera", rig.reference),
                        ("Standoff", millimetres(rig.standoff_mm, 0)),
                        ("Exposures", ", ".join(exposure(value) for value in rig.exposures_us)),
                    ),
                ),
                Group(
                    "Robot",
                    (
                        ("Absolute accuracy", millimetres(rig.robot.absolute_accuracy_mm)),
                        ("Repeatability", millimetres(rig.robot.repeatability_mm)),
                        ("Reach", f"{rig.robot.min_reach_mm:.0f} … {rig.robot.max_reach_mm:.0f} mm"),
                    ),
                ),
                *([Group("Drivers", drivers)] if drivers else []),
            ),
            "Nominal values from data sheets. Calibration determines the true values.",
        )
