"""Clouds page: every view with its quality, before and after registration."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QHBoxLayout

from measureapp.data.surroundings import SURROUNDINGS, SURROUNDINGS_KEPT
from measureapp.errors import InputError
from ui.controllers.controllers import Controllers
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import counted, millimetres, several
from ui.pages.clicked_distance import DistanceTool
from ui.pages.clouds.cloud_picture import CloudPicture
from ui.pages.clouds.holes_dialog import HolesDialog
from ui.pages.clouds.images_dialog import ImagesDialog
from ui.pages.clouds.scales import Scales
from ui.pages.clouds.view_table import TABLE_WIDTH, ViewTable
from ui.pages.clouds.view_words import choice_for, view_properties
from ui.pages.layers import ColourBy, placements_of, rgb
from ui.pages.picked_point import PickedPoint, point_properties
from ui.pages.viewport_page import Composer, ViewportPage
from ui.session import Session
from ui.viewport.layers import Label
from ui.widgets.basic import Button, card, column, label, row
from ui.widgets.empty_state import EmptyState
from ui.widgets.filter_form import FilterForm
from ui.widgets.properties_panel import Properties
from ui.widgets.segments import Segments

if TYPE_CHECKING:
    import numpy as np

    from measureapp.data.cloud import StitchedCloud, ViewPlacement
    from ui.viewport.overlay.legend import Legend

EMPTY = (
    "No clouds yet",
    "Each viewpoint gives a point cloud; registration aligns them. The demo creates some in one or two minutes.",
)
UNDO_FILTER = "Undo the last filter"
UNDO_SCALE = "Undo the last change of the colour scale"
UNDO_CHOICE, UNDO_DISTANCE = "Undo the last choice of a view", "Undo the last measured point or distance"
STAGES = {"before": "Kinematic", "after": "Registered", "merged": "Merged", "filtered": "Filtered"}
STAGE_TIPS = {
    "before": "Clouds placed by robot, guide and table",
    "after": "Clouds after registration to their neighbours",
    "merged": "Weighted mean of all registered clouds",
    "filtered": "Merged cloud after filtering",
}
COLOURS = {"view": "View", "sigma": "σ", "grey": "Grey", "residual": "Residual"}
COLOUR_TIPS = {
    "view": "One colour per view",
    "sigma": "Standard deviation of each point, in mm",
    "grey": "Brightness in the images",
    "residual": "Distance from the merged surface, in mm",
}
ACTION = "Images and holes"


class CloudsPage(ViewportPage):
    """List of the views with visibility, and the clouds in 3-D."""

    name, word, wants_room = "clouds", "Clouds", True
    shows_results = True

    def __init__(self, look: Look, session: Session, controllers: Controllers) -> None:
        super().__init__(look, session, controllers, EmptyState(look, "clouds", *EMPTY, "Run the demo"))
        self.stage = Segments(STAGES, name="Clouds shown", tips=STAGE_TIPS)
        self.colour_by = Segments(COLOURS, name="Colour by", tips=COLOUR_TIPS)
        self.scales = Scales()
        self.table = ViewTable(look)
        self.side, self.side_width = self.table, TABLE_WIDTH
        self.picture = CloudPicture(look, session, self.table.hidden)
        self._asked: tuple[str, int, tuple[int, int] | None] = ("", 0, None)  # view, index of the camera, pixel
        self.holes = Button("Images and holes", look, "holes", tip="The images of the selected view, and why pixels have no point")
        self.holes.clicked.connect(self.act)
        self.action_row.addWidget(self.holes)
        self.images = Button(
            "Images…", look, "images", tip="Stored images, phase, modulation, σ and exposures of the selected view, and profiles"
        )
        self.images.clicked.connect(self.show_images)
        self.action_row.addWidget(self.images)
        self.undo = Button("Undo", look, "undo", "quiet")
        self.undo.clicked.connect(self._undo)
        self.action_row.insertWidget(0, self.undo)
        controllers.view_choices.undoChanged.connect(self._show_undo)
        self.surroundings = Button("Keep surroundings", look, "filter", "quiet")
        self.surroundings.clicked.connect(lambda: controllers.view_choices.keep_surroundings(not self._surroundings_kept))
        self.action_row.insertWidget(1, self.surroundings)
        self._extent_of: StitchedCloud | None = None  # cloud of the initial filter limits
        self._seen_filtered: StitchedCloud | None = None
        self._seen_stitched = self._surroundings_kept = False
        self._point: Label | None = None  # of the last clicked point
        self._traced_place: np.ndarray | None = None  # (3,), of the point whose source is being found
        tools = self._tools(look)
        layout = column(tools, self.beside(card(self.view, self.filters, self.clip_bar, margin=1, spacing=4), self.table), spacing=12)
        layout.setStretch(1, 1)
        self.body.setLayout(layout)
        self.stage.valueChanged.connect(self.redraw)
        self.colour_by.valueChanged.connect(self.redraw)
        self.table.rowSelected.connect(self._select)
        self.table.hiddenChanged.connect(self._show)
        self.view.pointPicked.connect(self._show_point)
        self.view.legendEdited.connect(self._edit_scale)
        self.stage.valueChanged.connect(self._forget_point)
        session.projectChanged.connect(self.table.hidden.clear)
        self.follow(session.cloudsChanged, self._show, self._forget_distances)
        self.follow(session.busyChanged, self._show_busy)

    @cached_property
    def dialog(self) -> HolesDialog:
        """The window that says why pixels have no point; it is made when first opened, so that the program starts sooner."""
        made = HolesDialog(self.look, self.controllers.holes, self)
        made.imagesAsked.connect(self._open_images)
        return made

    @cached_property
    def images_dialog(self) -> ImagesDialog:
        """The window of images and maps of a view; likewise."""
        return ImagesDialog(self.look, self.controllers.images, self)

    def _open_images(self, viewpoint_id: str, camera: str, pixel: tuple[int, int] | None) -> None:
        self.images_dialog.open_view(viewpoint_id, camera, pixel)

    def _tools(self, look: Look) -> QHBoxLayout:
        """Return the tool bar above the picture."""
        self.filters = FilterForm(look)
        self.filters.asked.connect(self._filter)
        self.filters.hide()
        self.filter_button = Button("Filter", look, "filter", "quiet", "Crop and clean the merged cloud; the stitched cloud is kept")
        self.filter_button.setCheckable(True)
        self.filter_button.toggled.connect(self._show_filters)
        self.distance = DistanceTool(look, self)
        self.distance.changed.connect(self._show_distances)
        fit = Button("Show all", look, "fit", "quiet", "Show everything from the front")
        fit.clicked.connect(self.view.reset_camera)
        self.hint = label("", "soft")
        self.action_row.insertWidget(0, self.hint)
        self.tool_buttons = (self.filter_button, self.distance.button, fit)
        return row(self.stage, 12, label("Colour by", "soft"), self.colour_by, 0, *self.tool_buttons)

    def _show_busy(self) -> None:
        if self.session.busy_with and not self.session.views:
            self.say_running("No clouds yet", "The first cloud appears when the first viewpoint is processed.")
        else:
            self.empty.say(*EMPTY)
        self.filters.button.setEnabled(not self.session.busy_with)
        self._show_undo()
        self._show_surroundings()
        if self._asked[2] is None:  # no point is picked whose properties are being read
            self._select(max(0, self.table.currentIndex().row()))

    def _show_undo(self) -> None:
        choices, filtering = self.controllers.view_choices, self.controllers.filtering
        can_undo = choices.can_undo or self.distance.can_undo or filtering.can_undo or self.scales.can_undo
        self.undo.setVisible(bool(self.session.views) and can_undo)
        steps = ((self.scales.can_undo, UNDO_SCALE), (self.distance.can_undo, UNDO_DISTANCE), (filtering.can_undo, UNDO_FILTER))
        self.undo.setToolTip(translated(next((words for possible, words in steps if possible), UNDO_CHOICE)))

    def _show_surroundings(self) -> None:
        """Offer to keep what was excluded around the part, or to exclude what was kept; nothing where nothing was seen."""
        measurement = self.session.measurement
        said = "" if measurement is None else measurement.settings.get(SURROUNDINGS, "")
        self._surroundings_kept = said == SURROUNDINGS_KEPT
        self.surroundings.setVisible(bool(said) and self.controllers.view_choices.can_choose)
        words = "Exclude surroundings" if self._surroundings_kept else "Keep surroundings"
        self.surroundings.setText(f"\u2009{translated(words)}")
        self.surroundings.setToolTip(translated(said))

    def undo_last(self) -> None:
        """Undo the step that the button names."""
        if self.undo.isVisible() and self.undo.isEnabled():
            self._undo()

    def end_clicking(self) -> None:
        """Stop measuring by clicking."""
        self.distance.button.setChecked(False)

    def _undo(self) -> None:
        """Undo the last change of the scale; without one the last distance, the last filter, the last choice of a view."""
        if self.scales.can_undo:
            self.scales.undo()
            self._show_undo()
            self.redraw()
        elif self.distance.can_undo:
            self.distance.undo()
        elif self.controllers.filtering.can_undo:
            self.controllers.filtering.undo()
        else:
            self.controllers.view_choices.undo()

    def placements(self) -> dict[str, ViewPlacement]:
        """Return the placements of the views, as far as registered."""
        return placements_of(self.session.stitched)

    def _show(self) -> None:
        views, stitched = self.session.views, self.session.stitched
        self.show_filled(bool(views))
        for button in (self.holes, self.images):
            button.setVisible(bool(views) and self.controllers.holes.can_find)
        self._show_undo()
        self._show_surroundings()
        filtered = self.session.filtered
        for name in ("after", "merged"):
            self.stage.set_available(name, stitched is not None)
        self.stage.set_available("filtered", filtered is not None)
        self.filter_button.setEnabled(stitched is not None)
        if stitched is not None and stitched is not self._extent_of:
            self.filters.show_extent(stitched.points_mm)
        if filtered is not self._seen_filtered:
            self.stage.setValue("merged" if filtered is None and stitched is not None else "filtered" if filtered is not None else "before")
        self._extent_of, self._seen_filtered = stitched, filtered
        self.colour_by.set_available("residual", stitched is not None)
        if stitched is None and self.colour_by.value() == "residual":
            self.colour_by.setValue("view")
        if stitched is None and self.stage.value() != "before":
            self.stage.setValue("before")
        elif stitched is not None and self.stage.value() == "before" and not self._seen_stitched:
            self.stage.setValue("merged")
        self._seen_stitched = stitched is not None
        total = sum(len(view.cloud) for view in views)
        words = tr("{count}, {total} points", count=several(len(views), "view"), total=counted(total))
        merged = "" if stitched is None else tr("{words}; merged {counted}", words=words, counted=counted(len(stitched)))
        left = "" if filtered is None else tr(", filtered {counted}", counted=counted(len(filtered)))
        summary = tr("{words:stopped}", words=merged + left) if stitched is not None else tr("{words}, kinematic positions.", words=words)
        self.state.setText(translated(summary) if views else tr("No views yet."))
        self.table.show_views(views, self.placements())
        self._select(max(0, self.table.currentIndex().row()))
        self.redraw()

    def _select(self, place: int) -> None:
        if 0 <= place < len(self.session.views):
            view = self.session.views[place]
            self._asked = (view.viewpoint_id, 0, None)
            placement = self.placements().get(view.viewpoint_id)
            shown = self._with_action(view_properties(view, placement))
            can_choose = self.session.stitched is not None and self.controllers.view_choices.can_choose
            self.show_properties(replace(shown, decision=choice_for(placement)[0]) if can_choose else shown)

    def _with_action(self, properties: Properties) -> Properties:
        return replace(properties, action=ACTION) if self.controllers.holes.can_find else properties

    def act(self) -> None:
        """Show the images of the selected view or point, and the reasons for its holes."""
        name, place, pixel = self._asked
        calibration = self.session.calibration
        cameras = () if calibration is None else calibration.cameras.names
        if name:
            self.dialog.open_view(name, cameras[place] if place < len(cameras) else "", pixel)

    def show_images(self) -> None:
        """Show the images and maps of the selected view or point."""
        name, place, pixel = self._asked
        calibration = self.session.calibration
        cameras = () if calibration is None else calibration.cameras.names
        if name:
            self.images_dialog.open_view(name, cameras[place] if place < len(cameras) else "", pixel)

    def decide(self) -> None:
        """Use the selected view although it was excluded, or exclude it."""
        name = self._asked[0]
        if name:
            self.controllers.view_choices.choose(name, choice_for(self.placements().get(name))[1])

    def _show_filters(self, on: bool) -> None:
        self.filters.setVisible(on)

    def _filter(self) -> None:
        """Apply the chosen filter to the merged cloud, after earlier filters."""
        try:
            self.controllers.filtering.apply(self.filters.value())
        except InputError as error:
            self.session.tell(error.message, error.hint, "warning")

    def _forget_point(self) -> None:
        self._point = None
        self._show_marks()

    def _forget_distances(self) -> None:
        """Discard distances in former clouds."""
        self.distance.keep_for(self.session.stitched or self.session.views)

    def _show_distances(self) -> None:
        """Show the measured distances, and what to click next."""
        self.hint.setText(translated(self.distance.hint))
        self._show_undo()
        if self.distance.is_on or self.distance.distances:
            self._point = None
            self.show_properties(self.distance.properties())
        self._show_marks()

    def _show_marks(self) -> None:
        self.view.set_lines(self.distance.lines(rgb(self.look.theme, "accent")))
        self.view.set_labels([*self.distance.labels(self.look.theme), *([self._point] if self._point is not None else [])])

    def _show_point(self, layer: int, place: int) -> None:
        """Show view, pixel and standard deviation of a picked point; or measure from it."""
        point = self.picture.picked(self.stage.value(), layer, place)
        if self.distance.is_on:
            self.distance.click(self.picture.clicked(self.stage.value(), point))
            return
        self._show_source(point)
        self.propertiesAsked.emit()
        trace = self.picture.tracer(self.stage.value(), place)
        if trace is not None:
            self._traced_place = point.position_mm
            self.controllers.drawing.run("Tracing the point", lambda _job: trace(), self._show_traced, quiet=True)
        words = tr("{view}   sigma {sigma}", view=point.viewpoint_id, sigma=millimetres(point.sigma_mm)).replace("\u00a0", " ")
        theme = self.look.theme
        self._point = Label(words, point.position_mm, rgb(theme, "text"), rgb(theme, "surface"))
        self._show_marks()

    def _show_source(self, point: PickedPoint) -> None:
        self._asked = (point.viewpoint_id, point.camera, point.pixel)
        self.show_properties(self._with_action(point_properties(point)))

    @Slot(object)
    def _show_traced(self, point: PickedPoint) -> None:
        """Complete the properties of the point that was picked last, if they are still shown."""
        if self._point is not None and (point.position_mm == self._traced_place).all() and self.properties.title == "Point":
            self._show_source(point)

    def composer(self) -> Composer | None:
        """Compose the visible views."""
        if not self.session.views:  # a measured file has none
            return None
        colour_by: ColourBy = self.colour_by.value()  # type: ignore[assignment]
        merged = self.picture.merged(self.stage.value())
        legend = self.scales.get(colour_by, [view.cloud for view in self.session.views], self.placements().values(), merged=merged)
        self.view.set_legend(legend)
        return self.picture.composer(self.stage.value(), colour_by, legend)

    @Slot(object)
    def _edit_scale(self, legend: Legend) -> None:
        """Keep an edited colour scale, and colour the points by it."""
        self.scales.edit(legend)
        self._show_undo()
        self.redraw()
