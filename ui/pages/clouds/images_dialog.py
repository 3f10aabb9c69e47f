"""Images of a view: stored fringe images, maps of what they decode to, profiles, valid pixels of every exposure."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import Slot
from PySide6.QtWidgets import QWidget

from measureapp.errors import MeasureError
from ui.charts.bar_chart import Bar, BarChart
from ui.charts.level_histogram import LevelHistogram
from ui.controllers.images import ImagesController, ViewImages
from ui.images.frame_bar import FrameBar
from ui.images.layers import KINDS, TIPS, Layer, frame_layer, legend_words
from ui.images.map_view import MapView
from ui.images.profile_panel import ProfilePanel
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import exposure, quantity, with_unit
from ui.pages.clouds.view_dialog import ViewDialog
from ui.settings.dialogs import choose_new
from ui.widgets.basic import Button, card, column, label, row
from ui.widgets.segments import Segments

ASK = "Move the mouse over the image, or the arrow keys, to read values."
WAITING = "The images are decoded; the project is not changed."
TOLD = ("phase", "wrapped", "sigma", "modulation", "exposure", "state")
COLUMNS = {"phase": "phase_rad", "wrapped": "wrapped_rad", "sigma": "sigma_rad", "modulation": "modulation_grey"}  # of a saved profile
HIGHEST_PROFILE = 200  # px
NOTHING_DRAWN = (("", ""), (-1, -1))


class ImagesDialog(ViewDialog):
    """Shows stored images and maps of a view."""

    def __init__(self, look: Look, images: ImagesController, parent: QWidget | None = None) -> None:
        super().__init__(look, images, WAITING, "Decode", parent)
        self.setMinimumSize(1120, 680)
        self.resize(1240, 680)
        self.view: ViewImages | None = None
        self._drawn = NOTHING_DRAWN  # viewpoint and camera, exposure and image
        self._make_parts()
        self._lay_out()
        images.forgotten.connect(self._forget)

    def _make_parts(self) -> None:
        look = self.look
        self.kind = Segments(KINDS, name="Map", tips=TIPS)
        self.kind.valueChanged.connect(self._draw)
        self.map = MapView(look)
        self.map.pointed.connect(self._read_out)
        self.map.lineMoved.connect(self._take_line)
        self.frames = FrameBar()
        self.frames.valueChanged.connect(self._draw_frame)
        self.legend = label("", "small", wrap=True)
        self.line = Button("Profile", look, "profile", "quiet", "Values along a line, which the mouse or the numbers move")
        self.line.setCheckable(True)
        self.line.toggled.connect(self._show_line)
        self.whole = Button("Show all", look, "fit", "quiet", "Fit the image into the window")
        self.whole.clicked.connect(self.map.show_all)
        self.panel = ProfilePanel(look)
        self.panel.setMaximumHeight(HIGHEST_PROFILE)
        self.panel.lineEdited.connect(self._edit_line)
        self.panel.saveAsked.connect(self._save)
        self.panel.hide()
        self.pixel, self.values = label("", "heading"), label(ASK, "body", wrap=True)
        self.histogram = LevelHistogram(look)
        self.chart = BarChart(look, "Valid pixels", "%", lambda value: quantity(value, "%", 1), most=100.0)

    def _lay_out(self) -> None:
        tools = row(self.kind, 0, self.line, self.whole, spacing=8)
        left = column(tools, self.map, self.frames, self.legend, self.panel, spacing=8)
        left.setStretch(1, 1)
        said = card(self.pixel, self.values, 0, margin=12, spacing=4)
        said.setMinimumHeight(240)
        side = column(
            self.camera_place,
            said,
            label("Grey levels of the image", "caption"),
            self.histogram,
            label("Valid pixels", "caption"),
            self.chart,
            0,
        )
        right = QWidget()
        right.setObjectName("clear")
        right.setLayout(side)
        right.setFixedWidth(320)
        middle = row(left, right, spacing=16)
        middle.setStretch(0, 1)
        self.lay_out(middle, self.top())

    def open_view(self, viewpoint_id: str, camera: str = "", pixel: tuple[int, int] | None = None) -> None:
        """Show a viewpoint, and point at a pixel of one of its cameras if given."""
        self._wanted = camera, pixel
        if viewpoint_id != self.viewpoint_id:
            self._forget()
            self.viewpoint_id = viewpoint_id
        self.begin(tr("Images – {viewpoint_id}", viewpoint_id=viewpoint_id), tr("Images: {viewpoint_id}", viewpoint_id=viewpoint_id))

    def shown(self) -> ViewImages | None:
        """Return the images on display."""
        return self.view

    def steering(self) -> tuple[QWidget, ...]:
        """Return the choices of map and image."""
        return self.kind, self.frames, self.line, self.whole

    @Slot(str)
    def show_stopped(self, reason: str) -> None:
        """Say why nothing was decoded."""
        self.show_running(False)
        self.state.setText(translated(reason) or tr("Cancelled. Nothing was changed; decode to continue."))

    @Slot()
    def _forget(self) -> None:
        """Show nothing: the project, or the view, is another one."""
        self.view, self._drawn = None, NOTHING_DRAWN
        self.map.clear()
        self.pixel.setText("")
        self.values.setText(translated(ASK))
        self.legend.setText("")
        self.chart.show_bars(())
        self.show_running(False)
        self.state.setText("")

    def show_found(self, view: ViewImages) -> None:
        """Show the images of the view."""
        if view is not self.view:
            self.view = view
            self.make_cameras(tuple(view.maps))
            self.frames.show_stack(view.stack.exposures_us, view.stack.patterns.count)
        self.show_running(False)
        camera, pixel = self._wanted
        if camera in view.maps:
            self.cameras.setValue(camera)
        self._draw()
        if pixel is not None:
            self.map.point_at(*pixel)

    def change_camera(self) -> None:
        """Show the images of another camera."""
        self._draw()

    def _frame(self) -> np.ndarray:
        """Return the chosen stored image (H, W)."""
        assert self.view is not None
        time, image = self.frames.value()
        return self.view.stack.images[self.cameras.value()][time, image]

    def _layer(self, kind: str) -> Layer:
        assert self.view is not None
        return frame_layer(self._frame()) if kind == "fringes" else self.view.layers[self.cameras.value()][kind]

    def _draw_frame(self) -> None:
        if self.view is not None:
            self._draw()

    def _draw(self) -> None:
        if self.view is None:
            return
        kind, layer = self.kind.value(), self._layer(self.kind.value())
        self.map.show_layer(layer, self.view.stack.saturation if kind == "fringes" else None)
        self.legend.setText(
            translated(legend_words(layer)) if layer.categories else tr("Saturated pixels are red.") if kind == "fringes" else ""
        )
        self.legend.setVisible(bool(self.legend.text()))
        of, frame = (self.view.viewpoint_id, self.cameras.value()), self.frames.value()
        if (of, frame) != self._drawn:  # what does not depend on the kind of map
            self.histogram.show_levels(self._frame(), self.view.stack.saturation)
            if of != self._drawn[0]:
                self._show_valid(self.view)
            self._drawn = of, frame
        self.panel.fit(layer.values.shape)
        self._show_profile()
        if self.map.cursor_pixel is not None:
            self._read_out(*self.map.cursor_pixel)

    def _show_valid(self, view: ViewImages) -> None:
        found = view.exposures[self.cameras.value()]
        ours, paper = found.rules["combined"], found.rules["paper"]
        bars = [Bar(exposure(time), 100 * ratio) for time, ratio in zip(found.exposures_us, found.valid_ratios, strict=True)]
        bars += [Bar("Composite", 100 * ours.composite_ratio, strong=True), Bar("Decoded", 100 * ours.decoded_ratio, strong=True)]
        self.chart.show_bars([*bars, Bar("Decoded, brightest", 100 * paper.decoded_ratio)])
        self.state.setText(
            tr(
                "{quantity} decoded from all unsaturated exposures, {quantity_2} from the brightest unsaturated one alone (rule of the paper).",
                quantity=quantity(100 * ours.decoded_ratio, "%", 1),
                quantity_2=quantity(100 * paper.decoded_ratio, "%", 1),
            )
        )

    @Slot(int, int)
    def _read_out(self, line: int, across: int) -> None:
        """Tell all values of a pixel."""
        if self.view is None:
            return
        shape = self._frame().shape
        if not (0 <= line < shape[0] and 0 <= across < shape[1]):
            return
        self.pixel.setText(tr("Row {line}, column {across}", line=line, across=across))
        layers = [self._layer(kind) for kind in TOLD]
        told = [f"{layer.quantity}: {layer.words_at(line, across)}" for layer in layers]
        grey = int(self._frame()[line, across])
        full = ", saturated" if grey >= self.view.stack.saturation else ""
        self.values.setText("\n".join([*told, tr("Grey level at {words}: {grey}{full}", words=self.frames.words, grey=grey, full=full)]))

    def _show_line(self, on: bool) -> None:
        self.panel.setVisible(on)
        self._show_profile()

    @Slot(object)
    def _take_line(self, ends: tuple[tuple[int, int], tuple[int, int]]) -> None:
        """Follow the mouse."""
        self.panel.setValue(ends)
        self._plot_profile()

    @Slot(object)
    def _edit_line(self, _ends: object) -> None:
        """Follow the numbers."""
        self._show_profile()

    def _show_profile(self) -> None:
        on = self.line.isChecked() and self.view is not None
        self.map.show_line(self.panel.value() if on else None)
        if on:
            self._plot_profile()

    def _plot_profile(self) -> None:
        assert self.view is not None
        kind = self.kind.value() if self.kind.value() in COLUMNS else "wrapped"
        layer = self._layer(kind)
        grey = tr("Grey level, {words}", words=self.frames.words)
        layers = {column_name: self._layer(name).values for name, column_name in COLUMNS.items()}
        times = self.view.stack.images[self.cameras.value()]
        image = self.frames.value()[1]
        layers |= {f"grey_{time}us": times[place, image] for place, time in enumerate(self.view.stack.exposures_us)}
        shown = f"grey_{self.view.stack.exposures_us[self.frames.value()[0]]}us"
        words = with_unit(layer.quantity, layer.unit)
        self.panel.show_profile(layers, (COLUMNS[kind], words), (shown, grey), self.view.stack.saturation)

    def _save(self) -> None:
        found = self.panel.profile
        if found is None:
            return
        path = choose_new(self, "Save the profile", f"profile-{self.viewpoint_id}.csv", "profiles", "CSV (*.csv)")
        if path is None:
            return
        try:
            found.save(path)
        except (MeasureError, OSError) as error:
            self.state.setText(tr("The profile was not saved: {error}", error=error))
        else:
            self.state.setText(tr("Saved: {name}", name=path.name))
