"""Inspection page: the dimensions beside the measured part."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication, QKeySequence, QShortcut, QShowEvent
from PySide6.QtWidgets import QHBoxLayout

from ui.actions.actions import REDO_KEYS
from ui.controllers.controllers import Controllers
from ui.controllers.program_rows import ProgramEntries
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import millimetres, percent, sentence_case, several
from ui.pages.clicked_distance import ClickedPoint
from ui.pages.inspection.clicking import ClickingTools
from ui.pages.inspection.cutting import Cutting
from ui.pages.inspection.deviation_display import NOT_COMPARED, DeviationDisplay
from ui.pages.inspection.dimension_rows import alignment_words, decision_rule, dimension_properties, feature_group, removal_words
from ui.pages.inspection.dimension_side import TABLE_WIDTH, DimensionSide
from ui.pages.inspection.part_picture import SHAPE_TIPS, SHAPES, filled_in, mesh_of, part_composer
from ui.pages.inspection.picture_content import PictureContent
from ui.pages.inspection.probing import Probing
from ui.pages.inspection.program_tools import ProgramTools
from ui.pages.inspection.section_bar import SectionBar
from ui.pages.layers import rgb
from ui.pages.picked_point import merged_point, point_properties
from ui.pages.viewport_page import Composer, ViewportPage
from ui.session import Session
from ui.viewport.layers import Label
from ui.viewport.pick import Pick
from ui.widgets.basic import Button, card, column, label, row
from ui.widgets.empty_state import EmptyState
from ui.widgets.not_measured import NotMeasuredLegend
from ui.widgets.properties_panel import Properties
from ui.widgets.segments import Segments

if TYPE_CHECKING:
    pass

EMPTY = (
    "Nothing measured yet",
    "An inspection program fits features to the measured points and compares their dimensions with the nominal.",
)
UNDO = "Undo the last point, distance, feature or change of the program"
FILLED = "Filled, not measured"


class InspectionPage(ViewportPage):
    """Table of dimensions with verdicts, and the features in 3-D."""

    name, word, wants_room = "inspection", "Inspect", True
    shows_results = True

    def __init__(self, look: Look, session: Session, controllers: Controllers) -> None:
        super().__init__(look, session, controllers, EmptyState(look, "inspection", *EMPTY, "Run the demo"))
        self.measure_file = Button("Measure a file…", look, "file", tip="Measure a cloud or mesh by a nominal or an inspection program")
        self.empty.add_quiet(self.measure_file)
        self.shape = Segments(SHAPES, name="Picture", tips=SHAPE_TIPS)
        self.shape.set_available("deviation", False, NOT_COMPARED)
        self.shape.valueChanged.connect(self.redraw)
        self._entry: tuple[Properties, ProgramEntries] | None = None  # of the program, while its properties are shown
        self.filled = NotMeasuredLegend(look)
        self.filled.setContentsMargins(12, 4, 12, 4)
        self.display = DeviationDisplay(self)
        self.side, self.side_width = DimensionSide(look, self.controllers, self.display), TABLE_WIDTH
        self.content = PictureContent(look, session, self.view, self.side, self.display)
        tools = self._tools(look)
        self.side.selected.connect(self._select)
        self.side.closerAsked.connect(self.content.look_closer)
        picture = card(self.view, self.filled, self.cut, self.grow, self.program.bar, margin=1, spacing=4)
        layout = column(tools, self.beside(picture, self.side), spacing=12)
        layout.setStretch(1, 1)
        self.body.setLayout(layout)
        programming = self.controllers.programming
        for key, act in (
            (QKeySequence.StandardKey.Save, programming.save),
            *((QKeySequence(key), programming.redo) for key in REDO_KEYS),
            (QKeySequence.StandardKey.Find, self.side.filter.search.setFocus),
        ):
            QShortcut(key, self, act, context=Qt.ShortcutContext.WidgetWithChildrenShortcut)
        session.cloudsChanged.connect(self.redraw)
        self.follow(session.inspectionChanged, self._show)
        self.follow(session.cloudsChanged, self._forget_distances)
        self.follow(session.comparisonChanged, self._show_comparison)
        session.projectChanged.connect(self.display.forget)
        look.changed.connect(self.content.show)
        self.view.legendEdited.connect(self.display.take_legend)
        self.display.changed.connect(self._show_display)
        self.follow(session.busyChanged, self._show_busy)
        self.follow(session.appearanceChanged, self._show_undo)

    def _tools(self, look: Look) -> QHBoxLayout:
        """Return the tool bar above the picture."""
        fit = Button("Show all", look, "fit", "quiet", "Show everything from the front")
        fit.clicked.connect(self.view.reset_camera)
        self.labels = Button("Labels", look, "labels", "quiet", "Show the value of every dimension in the picture")
        self.labels.setCheckable(True)
        self.labels.toggled.connect(self._show_all_flags)
        contouring = self.controllers.contouring
        self.clicking = ClickingTools(look, self.controllers.growing, contouring, self.side.contour, self)
        self.follow(contouring.changed, self._show_contour)
        self.distance, self.grow = self.clicking.distance, self.clicking.grow
        self.distance.changed.connect(self._show_distances)
        self.undo = Button("Undo", look, "undo", "quiet", UNDO)
        self.undo.clicked.connect(self._undo)
        self.hint = label("", "soft")
        self.program = ProgramTools(look, self.session, self.controllers, self)
        for widget in (self.hint, self.undo, self.program.text, self.program.nominal):
            self.action_row.addWidget(widget)
        self.follow(self.controllers.programming.changed, self._show_program)
        self.side.deviation.storeAsked.connect(self._store_scale)
        self.cut = SectionBar(look)
        self.cutting = Cutting(self.session, self.cut, self.controllers.drawing, self)
        self.cutting.changed.connect(self.content.show)
        self.probing = Probing(self.session, self.controllers.drawing, self)
        self.probing.changed.connect(self.content.show)
        self.content.use(self.cutting, self.clicking, self.probing)
        self.grow.changed.connect(self._show_grown)
        self.view.pointPicked.connect(self._show_point)
        self.view.picked.connect(self._pick_surface)
        self.tool_buttons = (fit, self.labels, self.distance.button, self.cut.button, self.grow.button, self.program.bar.button)
        return row(self.shape, *self.tool_buttons, 0)

    def _show_busy(self) -> None:
        if self.session.busy_with and self.session.inspection is None:
            self.say_running("Nothing measured yet", "The dimensions appear here when the surface is complete.")
        else:
            self.empty.say(*EMPTY)
        self._show_undo()
        if self._entry is not None:  # its actions depend on whether a job is running
            self._show_entry(*self._entry)
        elif self.grow.is_on:
            self._show_grown()

    def showEvent(self, event: QShowEvent) -> None:
        """Compare with the nominal when the page is first shown."""
        super().showEvent(event)
        self.controllers.comparison.compare()

    def _show_comparison(self) -> None:
        comparison = self.session.comparison
        self.side.show_comparison(comparison)
        self.display.show_comparison(comparison)
        self.cut.show_extent(None if comparison is None or comparison.surface is None else comparison.surface)
        self.shape.set_available("deviation", comparison is not None, NOT_COMPARED)
        if comparison is not None:
            self.shape.setValue("deviation")
        elif self.shape.value() == "deviation":
            self.shape.setValue("surface")
        self.cutting.cut()

    def _show(self) -> None:
        inspection = self.session.inspection
        self.show_filled(inspection is not None)
        self.side.show_inspection(inspection)
        self._show_undo()
        if inspection is None:
            self.state.setText(tr("No inspection yet."))
            return
        if (measurement := self.session.measurement) is not None:
            self.side.show_checks(measurement.consistency)
        alignment = inspection.alignment
        self.state.setText(alignment_words(inspection.program, alignment))
        self.program.show_inspection(inspection)
        self._select()
        if self.isVisible():
            self.controllers.comparison.compare()
        self.redraw()

    def _select(self) -> None:
        self.content.point = None
        inspection, chosen = self.session.inspection, self.side.selection
        dimension, features = chosen.dimension, chosen.features
        if inspection is not None and dimension is not None:
            shown = dimension_properties(dimension, features, inspection.alignment, decision_rule(), self.side.features.constructed)
            self._show_entry(shown, ProgramEntries("dimension", (dimension.name,)))
        elif features:
            title = sentence_case(features[0].name) if len(features) == 1 else several(len(features), "feature")
            groups = tuple(feature_group(one, self.side.features.constructed.get(one.name)) for one in features)
            self._show_entry(Properties(title, groups), self.side.features.program_entries())
            self.program.bar.take(features[-1].name)
        self.content.show()

    def _show_entry(self, properties: Properties, entries: ProgramEntries) -> None:
        """Show entries of the program, with the button that removes them."""
        can_change = self.program.programming.can_change
        self.show_properties(replace(properties, decision=removal_words(entries)) if can_change else properties)
        self._entry = properties, entries

    def show_properties(self, properties: Properties) -> None:
        """Show these properties; `_show_entry` marks entries of the program afterwards."""
        self._entry = None
        super().show_properties(properties)

    def composer(self) -> Composer | None:
        """Compose the part in the nominal's frame."""
        self.shape.set_available("surface", mesh_of(self.session) is not None)
        self.content.is_deviation = self.shape.value() == "deviation"
        self.content.show()
        filled = filled_in(self.session, self.shape.value())
        self.filled.say(tr("{filled}: {filled_2} of the surface", filled=FILLED, filled_2=percent(filled)) if filled else "")
        return part_composer(self.session, self.shape.value(), self.look.theme.shade, self.display)

    def _show_display(self) -> None:
        """Draw the deviations in their present colours."""
        if self.shape.value() == "deviation":
            self.redraw()

    def _show_all_flags(self, shown: bool) -> None:
        self.content.all_flags = shown
        self.content.show()

    def _show_program(self) -> None:
        """Show the rows of the edited program, and select a dimension that was added."""
        self.side.show_rows()
        programming = self.program.programming
        if programming.state is not None:
            self.display.take_stored(programming.state.program.deviation_scale)
        new = self.program.newest(self.side.rows)
        if new is not None:
            self.side.list.setValue("dimensions")
            self.side.table.select(new)
        self.content.show()
        self._show_undo()

    def _store_scale(self) -> None:
        """Store the colour scale with the inspection program, as an edit that can be undone."""
        scale = self.display.scale
        self.program.programming.edit(
            lambda program: program.model_copy(update={"deviation_scale": scale}), "Colour scale stored with the inspection program."
        )

    def _show_undo(self) -> None:
        self.undo.setVisible(self.clicking.can_undo or self.program.programming.can_undo)
        words = "" if self.clicking.can_undo else self.program.programming.stack.undoText()
        self.undo.setToolTip(tr("Undo: {undotext}", undotext=words) if words else tr(UNDO))
        self.program.show_state()
        self.side.deviation.allow_storing(self.program.programming.can_change)
        self.grow.button.setVisible(self.program.is_offered)
        if not self.program.is_offered:
            self.grow.button.setChecked(False)

    def undo_last(self) -> None:
        """Undo the step that the button names."""
        if self.undo.isVisible() and self.undo.isEnabled():
            self._undo()

    def end_clicking(self) -> None:
        """Stop measuring and growing by clicking."""
        self.clicking.end()
        self.side.end_picking()

    def _undo(self) -> None:
        """Undo the last click; without one, the last change of the program."""
        if self.clicking.can_undo:
            self.clicking.undo()
        else:
            self.program.programming.undo()

    def _forget_distances(self) -> None:
        """Discard distances in a former cloud or alignment."""
        inspection, cloud = self.session.inspection, self.session.stitched
        self.distance.keep_for(None if inspection is None else (cloud, inspection.alignment.nominal_from_part.matrix.tobytes()))

    def show_failing(self) -> None:
        """Show the first dimension that does not pass on the part, and the values of all."""
        self.side.select_failing()
        self.labels.setChecked(True)

    def decide(self) -> None:
        """Add the last grown feature to the program, or remove the selected entry."""
        if self._entry is not None:
            self.program.programming.remove(self._entry[1])
        elif self.grow.last is not None:
            self.program.add_feature(self.grow.last)

    def _show_grown(self) -> None:
        """Show the grown features, and what to click next."""
        self._show_undo()
        if self.grow.is_on and not self._has_points:
            self.shape.setValue("points")  # surfaces have no measured points to click
        if self.grow.is_on:
            self.content.point = None
            shown = self.grow.properties()
            self.show_properties(shown if self.program.programming.can_change else replace(shown, decision=""))
        self.content.show()

    def _show_contour(self) -> None:
        """Show the feature in the making, and whether a click of it can be undone."""
        self._show_undo()
        self.content.show()

    def act(self) -> None:
        """Copy the program lines of the last grown feature to the clipboard."""
        if self.grow.last is not None:
            QGuiApplication.clipboard().setText(translated(self.grow.last.entry))
            self.session.tell(
                tr("Lines of {name} copied.", name=sentence_case(self.grow.last.feature.name)),
                "Paste them into an inspection program.",
                "done",
            )

    def _show_distances(self) -> None:
        """Show the measured distances, and what to click next."""
        self.hint.setText(translated(self.distance.hint))
        self._show_undo()
        if self.distance.is_on and not self._has_points:
            self.shape.setValue("points")  # surfaces have no measured points to click
        if self.distance.is_on or self.distance.distances:
            self.content.point = None
            self.show_properties(self.distance.properties())
        self.content.show()

    @property
    def _has_points(self) -> bool:
        """Whether the picture shows measured points."""
        shown = self.shape.value()
        return shown == "points" or (shown == "deviation" and (self.display.on == "points" or self.session.comparison is None))

    def _pick_surface(self, pick: Pick) -> None:
        """Select the face that is clicked, or read the deviation where the coloured CAD model is clicked."""
        if self.side.contour.is_on:
            self.controllers.contouring.click(pick.position_mm)
            return
        is_tool = self.distance.is_on or self.grow.is_on
        if self.side.is_picking and pick.position_mm is not None:
            self.controllers.creating.pick(pick.position_mm)
            return
        if not pick.is_point and pick.position_mm is not None and self.shape.value() == "deviation" and not is_tool:
            self.probing.probe(pick.position_mm)

    def _show_point(self, layer: int, place: int) -> None:
        """Show source and deviation of a picked point; or measure from it, or grow a feature."""
        stitched, inspection, comparison = self.session.stitched, self.session.inspection, self.session.comparison
        if self.side.is_picking or self.side.contour.is_on:  # `_pick_surface` takes the click
            return
        if stitched is None or inspection is None or layer > 0:  # an unmeasured part of the nominal
            return
        point = merged_point(stitched, place, self.session.views)
        position = inspection.alignment.nominal_from_part.apply(point.position_mm[None])[0]
        if self.distance.is_on:
            errors = None if stitched.errors is None else stitched.errors.seen_from(inspection.alignment.nominal_from_part)
            number, scale_ppm = int(stitched.view[place]), self.session.scale_ppm
            self.distance.click(ClickedPoint(position, point.sigma_mm, point.viewpoint_id, number, errors, scale_ppm))
            return
        if self.grow.is_on:
            self.grow.click(position)
            return
        if comparison is not None and comparison.index is not None and self.shape.value() == "deviation":
            self.probing.probe(position)
            self.show_properties(point_properties(replace(point, position_mm=position, deviation_mm=None)))
            return
        off = float(comparison.deviation.distances_mm[place]) if comparison is not None and self.shape.value() == "deviation" else None
        self.show_properties(point_properties(replace(point, position_mm=position, deviation_mm=off)))
        self.propertiesAsked.emit()
        words = (
            tr("{view}   sigma {sigma}", view=point.viewpoint_id, sigma=millimetres(point.sigma_mm))
            if off is None
            else millimetres(off, signed=True)
        )
        words = words.replace("\u00a0", " ").replace("\u2212", "-")
        self.content.point = Label(words, position, rgb(self.look.theme, "text"), rgb(self.look.theme, "surface"))
        self.content.show()
