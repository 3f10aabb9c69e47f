"""Inspect: the dimensions beside the measured part."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QWidget

from ui.controllers.controllers import Controllers
from ui.look.look import Look
from ui.look.wording import counted, millimetres, percent, quantity, sentence_case
from ui.pages.deviation_card import DeviationCard, scale_end_mm
from ui.pages.layers import deviation_layers, mesh_layer, points_layer, rgb
from ui.pages.outlines import outline
from ui.pages.viewport_page import Composer, Picture, ViewportPage
from ui.session import Session
from ui.viewport.layers import Label, LineLayer
from ui.widgets.basic import Button, card, column, label, row
from ui.widgets.data_table import Cell, DataTable, number, verdict_cell
from ui.widgets.empty_state import EmptyState
from ui.widgets.properties_panel import Group, Properties
from ui.widgets.segments import Segments
from ui.workers.job import Job

if TYPE_CHECKING:
    from measureapp.data.dimension import Dimension
    from measureapp.data.feature import Feature

EMPTY = (
    "Nothing measured yet",
    "An inspection program fits features to the measured points and compares their distances with the drawing.",
)
HEADERS = ["Dimension", "Nominal", "Measured", "Error", "U", "Verdict"]
UNLIMITED = 16_777_215  # Qt's largest height of a widget
UNITS = "Lengths in mm, U for k = 2"
TABLE_WIDTH, DEVIATION_HEIGHT = 520, 400
SIDE_SHARES = (1000, 500, 1)  # the rest stays empty only when table and histogram have what they can use
OUTLINE = (70, 82, 90)  # seen on the part in both themes
DIGITS = {"mm": 3, "deg": 3, "°": 3}


class InspectionPage(ViewportPage):
    """Nominal, measured, error, uncertainty and verdict; the features in 3-D."""

    name, word, wants_room = "inspection", "Inspect", True
    for_operator = True

    def __init__(self, look: Look, session: Session, controllers: Controllers) -> None:
        super().__init__(look, session, controllers, EmptyState(look, "inspection", *EMPTY, "Run the demo"))
        self.shape = Segments({"surface": "Surface", "points": "Points", "deviation": "Deviation"})
        self.shape.set_available("deviation", False)
        self.shape.valueChanged.connect(self.redraw)
        self.deviation = DeviationCard(look)
        self.summary = {verdict: label("", "strong") for verdict in ("pass", "fail", "not proven", "not measured")}
        self.table = DataTable(look, HEADERS, numeric=(1, 2, 3, 4), stretch=0)
        self.table.rowSelected.connect(self._select)
        fit = Button("Show all", look, "fit", "quiet", "Look at everything from the front")
        fit.clicked.connect(self.view.reset_camera)
        tools = row(self.shape, fit, 0, *self.summary.values(), label(UNITS, "small"), spacing=16)
        side = QWidget()
        side.setFixedWidth(TABLE_WIDTH)
        beside = column(self.table, self.deviation, 0, spacing=16)
        for place, share in enumerate(SIDE_SHARES):
            beside.setStretch(place, share)
        side.setLayout(beside)
        self.deviation.setMaximumHeight(DEVIATION_HEIGHT)
        middle = row(card(self.view, margin=1), side, spacing=16)
        middle.setStretch(0, 1)
        layout = column(tools, middle, spacing=12)
        layout.setStretch(1, 1)
        self.body.setLayout(layout)
        session.inspectionChanged.connect(self._show)
        session.cloudsChanged.connect(self.redraw)
        session.comparisonChanged.connect(self._show_comparison)
        look.changed.connect(self._highlight)
        session.busyChanged.connect(self._show_busy)
        self._show_comparison()
        self._show()

    def _show_busy(self) -> None:
        if self.session.busy_with and self.session.inspection is None:
            self.empty.say("Nothing measured yet", "The dimensions appear here when the surface is complete.", offer=False)
        else:
            self.empty.say(*EMPTY)

    def showEvent(self, event: QShowEvent) -> None:
        """Compare with the drawing when it is first looked at."""
        super().showEvent(event)
        self.controllers.comparison.compare()

    def _show_comparison(self) -> None:
        comparison = self.session.comparison
        self.deviation.show_comparison(comparison)
        self._share_height()
        self.shape.set_available("deviation", comparison is not None)
        if comparison is not None:
            self.shape.setValue("deviation")
        elif self.shape.value() == "deviation":
            self.shape.setValue("surface")

    def _share_height(self) -> None:
        """Give the histogram what the table does not need."""
        fitted = self.table.fitted_height() if self.session.comparison is not None else UNLIMITED
        self.table.setMaximumHeight(fitted)

    def dimensions(self) -> tuple[Dimension, ...]:
        """Return the dimensions known."""
        return () if self.session.inspection is None else self.session.inspection.dimensions

    def _show(self) -> None:
        dimensions = self.dimensions()
        self.show_filled(self.session.inspection is not None)
        if self.session.inspection is None:
            self.state.setText("No inspection program has run.")
            return
        counts = {name: sum(1 for found in dimensions if found.verdict == name) for name in self.summary}
        for name, shown in self.summary.items():
            shown.setText(f"{counts[name]} {name}")
            shown.setStyleSheet(f"color: {self.look.theme.verdict(name).name()}")
            shown.setVisible(counts[name] > 0)
        alignment = self.session.inspection.alignment
        self.state.setText(
            f"{sentence_case(self.session.inspection.program)}. Aligned by {alignment.name}, {millimetres(alignment.rms_mm)} rms."
        )
        self.table.set_rows([dimension_cells(found) for found in dimensions])
        self._share_height()
        if not self.table.currentIndex().isValid() and dimensions:
            self.table.selectRow(0)
        self._select(max(0, self.table.currentIndex().row()))
        if self.isVisible():
            self.controllers.comparison.compare()
        self.redraw()

    def _select(self, place: int) -> None:
        dimensions = self.dimensions()
        if 0 <= place < len(dimensions):
            self.show_properties(dimension_properties(dimensions[place], self._features(dimensions[place])))
            self._highlight()

    def _features(self, dimension: Dimension) -> list[Feature]:
        inspection = self.session.inspection
        known = {} if inspection is None else {feature.name: feature for feature in inspection.features}
        return [known[name] for name in dimension.features if name in known]

    def composer(self) -> Composer | None:
        """Compose the part in the nominal's frame."""
        measurement, inspection, stitched = self.session.measurement, self.session.inspection, self.session.stitched
        if inspection is None or stitched is None:
            return None
        nominal_from_part, comparison = inspection.alignment.nominal_from_part, self.session.comparison
        mesh = measurement.mesh if measurement is not None else None
        self.shape.set_available("surface", mesh is not None)
        shade = (196, 204, 208) if self.look.theme.shade == "light" else (150, 162, 168)
        wanted = self.shape.value()

        def compose(_job: Job) -> Picture:
            if wanted == "deviation" and comparison is not None:
                normals = nominal_from_part.rotate(stitched.normals)
                return Picture(tuple(deviation_layers(comparison, normals, scale_end_mm(comparison))))
            if wanted == "surface" and mesh is not None:
                return Picture(surface=mesh_layer(mesh, nominal_from_part, shade))
            return Picture((points_layer(stitched, nominal_from_part, shade),))

        return compose

    def _highlight(self) -> None:
        """Outline all features quietly; those of the selected dimension stand out and carry its value."""
        inspection, place = self.session.inspection, self.table.currentIndex().row()
        dimensions = self.dimensions()
        if inspection is None:
            return
        chosen = dimensions[place] if 0 <= place < len(dimensions) else None
        mine = self._features(chosen) if chosen is not None else []
        quiet = [outline(feature) for feature in inspection.features if feature not in mine]
        theme = self.look.theme
        layers = [LineLayer(tuple(line for line in quiet if len(line)), OUTLINE, 1.5)]
        labels = []
        if chosen is not None and mine:
            colour = theme.verdict(chosen.verdict)
            strong = (colour.red(), colour.green(), colour.blue())
            lines = [line for line in (outline(feature) for feature in mine) if len(line)]
            centres = np.array([feature.point_mm for feature in mine])
            if len(centres) > 1:
                lines.append(centres)
            layers.append(LineLayer(tuple(lines), strong, 3.5))
            words = f"{dimension_words(chosen.name)} {quantity(chosen.measured, _unit(chosen), 3)}".replace("\u00a0", " ")
            labels.append(Label(words, centres.mean(axis=0), rgb(theme, "text"), rgb(theme, "surface")))
        self.view.set_lines(layers)
        self.view.set_labels(labels)


def _unit(dimension: Dimension) -> str:
    return "°" if dimension.unit == "deg" else dimension.unit


def dimension_words(name: str) -> str:
    """Return the name of a dimension as words; a letter stays as it is in the drawing."""
    return name if len(name) == 1 else sentence_case(name)


def dimension_cells(dimension: Dimension) -> list[Cell]:
    """Return one row of the table."""
    unit = "" if dimension.unit == "mm" else _unit(dimension)
    digits = DIGITS.get(dimension.unit, 3)
    return [
        Cell(dimension_words(dimension.name), bold=True),
        number(quantity(dimension.nominal, unit, digits)),
        number(quantity(dimension.measured, unit, digits)),
        number(quantity(dimension.error, unit, digits, signed=True)),
        number(quantity(dimension.uncertainty, unit, digits)),
        verdict_cell(str(dimension.verdict), tip=dimension.reason),
    ]


def tolerance(lower: float, upper: float, unit: str) -> str:
    """Return a tolerance: ``± 0.100 mm``, or both limits where they differ."""
    if -lower == upper:
        return f"±\u00a0{quantity(upper, unit)}"
    return f"{quantity(lower, '', signed=True)}\u00a0/\u00a0{quantity(upper, unit, signed=True)}"


def dimension_properties(dimension: Dimension, features: list[Feature]) -> Properties:
    """Return what there is to know about one dimension."""
    unit = _unit(dimension)
    values = Group(
        "Result",
        (
            ("Nominal", quantity(dimension.nominal, unit)),
            ("Tolerance", tolerance(dimension.lower_tolerance, dimension.upper_tolerance, unit)),
            ("Measured", quantity(dimension.measured, unit)),
            ("Error", quantity(dimension.error, unit, signed=True)),
            ("Relative error", percent(dimension.relative_error, 3, signed=True)),
            ("Uncertainty (k = 2)", quantity(dimension.uncertainty, unit)),
        ),
    )
    fits = tuple(
        Group(
            f"{sentence_case(feature.name)} ({feature.shape})",
            (
                ("Points", counted(feature.points)),
                ("Left out", counted(feature.left_out)),
                ("Form error", millimetres(feature.form_error_mm)),
                ("Residual (rms)", millimetres(feature.rms_mm)),
                *([("Radius", millimetres(feature.radius_mm))] if feature.radius_mm is not None else []),
            ),
        )
        for feature in features
    )
    return Properties(dimension_words(dimension.name), (values, *fits), dimension.reason)
