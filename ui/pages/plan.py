"""Page Plan: viewpoints, patterns and exposures of the scan."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ui.controllers.controllers import Controllers
from ui.look.look import Look
from ui.look.wording import exposure, millimetres, quantity, sentence_case, several
from ui.pages.page import Page
from ui.pages.pattern_prediction import cost, predict
from ui.session import Session
from ui.widgets.basic import card, row
from ui.widgets.data_table import Cell, DataTable, number
from ui.widgets.empty_state import EmptyState
from ui.widgets.plan_drawing import PlanDrawing, Point, Station
from ui.widgets.properties_panel import Group, Properties

if TYPE_CHECKING:
    from measureapp.data.plan import ScanPlan, Viewpoint
    from measureapp.data.rig import RigDescription

EMPTY = (
    "No scan plan yet",
    "A plan defines the viewpoints, patterns and exposures of a scan. The demo makes its own plan.",
)


class PlanPage(Page):
    """The viewpoints as a drawing and a list."""

    name, word = "plan", "Plan"

    def __init__(self, look: Look, session: Session, controllers: Controllers) -> None:
        super().__init__(look, session, controllers, EmptyState(look, "plan", *EMPTY, "Run the demo"))
        self.drawing = PlanDrawing(look)
        self.table = DataTable(look, ["No.", "Viewpoint", "Height", "Guide", "Table"], numeric=(2, 3, 4), stretch=1)
        self.table.setFixedWidth(440)
        self.table.rowSelected.connect(self._select)
        self.drawing.stationClicked.connect(self.table.selectRow)
        layout = row(card(self.drawing, margin=8), self.table, spacing=16)
        layout.setStretch(0, 1)
        self.body.setLayout(layout)
        self._stations: list[Station] = []
        session.planChanged.connect(self._show)
        session.rigChanged.connect(self._show)
        session.viewpointsChanged.connect(self._draw)
        session.busyChanged.connect(self._show_busy)
        self._show()

    def _show_busy(self) -> None:
        if self.session.busy_with and self.session.plan is None:
            self.empty.say("Planning…", "The plan is being made.", offer=False)
        else:
            self.empty.say(*EMPTY)

    def _show(self) -> None:
        plan, rig = self.session.plan, self.session.rig
        self.show_filled(plan is not None and rig is not None)
        if plan is None or rig is None:
            self.state.setText("No scan plan.")
            return
        images = plan.patterns.count * len(plan.bracket.exposures_us) * len(rig.cameras)
        self.state.setText(f"{sentence_case(plan.name)}: {several(len(plan), 'viewpoint')}, {several(images, 'image')} each.")
        self._draw()
        self.table.set_rows([self._cells(place, viewpoint) for place, viewpoint in enumerate(plan)])
        self._select(max(0, self.table.currentIndex().row()))

    def _draw(self) -> None:
        plan, rig = self.session.plan, self.session.rig
        if plan is None or rig is None:
            return
        known = self.session.viewpoints
        self._stations = [station(rig, viewpoint, known[viewpoint.id].status if viewpoint.id in known else "waiting") for viewpoint in plan]
        self.drawing.show_stations(self._stations, rig.table.diameter_mm)

    def _cells(self, place: int, viewpoint: Viewpoint) -> list[Cell]:
        height = self._stations[place].position_mm[2]
        return [
            Cell(str(place + 1)),
            Cell(viewpoint.id, bold=True),
            number(millimetres(height, 0)),
            number(millimetres(viewpoint.guide_mm, 1)),
            number(quantity(viewpoint.table_deg, "°", 1)),
        ]

    def _select(self, place: int) -> None:
        plan, rig = self.session.plan, self.session.rig
        if plan is None or rig is None or not 0 <= place < len(plan):
            return
        self.drawing.choose(place)
        self.show_properties(viewpoint_properties(plan, plan[place], rig))


def viewpoint_properties(plan: ScanPlan, viewpoint: Viewpoint, rig: RigDescription) -> Properties:
    """Return the properties of one viewpoint, with the predicted performance of the patterns."""
    x, y, z = viewpoint.flange.position_mm
    pitches = ", ".join(f"{pitch:.4g} px" for pitch in plan.patterns.pitches_px)
    return Properties(
        viewpoint.id,
        (
            Group(
                "Axes",
                (
                    ("Flange", f"{', '.join(quantity(value, '', 1) for value in (x, y, z))} mm"),
                    ("Guide", millimetres(viewpoint.guide_mm, 1)),
                    ("Table", quantity(viewpoint.table_deg, "°", 1)),
                ),
            ),
            Group(
                "Patterns", (("Set", sentence_case(plan.patterns.name)), ("Images", str(plan.patterns.count)), ("Fringe pitches", pitches))
            ),
            *predict(plan.patterns, rig.projector.width_px, rig.projector.height_px),
            cost(plan, rig),
            Group("Exposures", tuple((f"No. {place + 1}", exposure(value)) for place, value in enumerate(plan.bracket.exposures_us))),
        ),
    )


def station(rig: RigDescription, viewpoint: Viewpoint, status: str) -> Station:
    """Return the position of the head relative to the part, from the nominal rig."""
    import numpy as np

    from measureapp.geometry.transform import rotation_about

    base_from_head = viewpoint.flange.transform() @ rig.flange_from_head.transform("flange", "head")
    turn = rotation_about([0, 0, 1], -np.radians(viewpoint.table_deg))
    position = turn @ (base_from_head.translation_mm + np.array([0.0, viewpoint.guide_mm, 0.0]) - np.array(rig.table.centre_in_guide_mm))
    direction = turn @ base_from_head.rotation[:, 2]
    return Station(viewpoint.id, _point(position), _point(direction), status)


def _point(values: object) -> Point:
    x, y, z = (float(value) for value in values)  # type: ignore[attr-defined]
    return x, y, z
