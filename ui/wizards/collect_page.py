"""Second step: the live image with its overlay, the guidance, and the views collected so far."""

from __future__ import annotations

from math import floor
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QTimer, Signal
from PySide6.QtWidgets import QPushButton, QWidget

from measureapp.calibrate.cameras.projector_sightings import PROJECTOR, device_title
from ui.controllers.collecting import CollectingController
from ui.controllers.collecting_nouns import CollectedView
from ui.images.board_view import BoardView, Overlay
from ui.look.language.words import tr
from ui.look.look import Look
from ui.look.wording import quantity, sentence_case, several
from ui.widgets.basic import Button, clear, column, label, row
from ui.widgets.gauges import Level
from ui.widgets.segments import Segments
from ui.widgets.thumbnail_strip import Thumbnail, ThumbnailStrip
from ui.wizards.guidance_panel import GuidancePanel

if TYPE_CHECKING:
    from measureapp.calibrate.draft.advice import Gauge

LAYERS = {"corners": "Corners", "coverage": "Coverage", "ghost": "Show next"}
LAYER_TIPS = {
    "corners": "Detected corners; rejected ones in red",
    "coverage": "Where corners were detected so far; the darker, the more often",
    "ghost": "Where the board should appear in the next view",
}
LIVE_MS = 33
CELLS = (12, 9)  # of the coverage, across and down
NOTHING_YET = "The images appear here as they are taken."


class CollectPage(QWidget):
    """Watches a `CollectingController`; a click on a thumbnail shows its image, the newest one is live."""

    chosenChanged = Signal()

    def __init__(self, look: Look, collecting: CollectingController) -> None:
        super().__init__()
        self._look, self._collecting = look, collecting
        self.cameras = Segments({"": "Camera"})
        self._camera_place = row(self.cameras)
        self._layer_place = row(spacing=4)
        self.layers: dict[str, QPushButton] = {}
        for name, words in LAYERS.items():
            button = Button(words, look, role="quiet", tip=LAYER_TIPS[name])
            button.setCheckable(True)
            button.setChecked(True)
            button.toggled.connect(self._show_layers)
            self.layers[name] = button
            self._layer_place.addWidget(button)
        self.live = Button("Back to live", look, "scan", "normal", "Show the newest image again")
        self.live.clicked.connect(lambda: self.choose(""))
        self.picture = BoardView(look)
        self.picture.clear(NOTHING_YET)
        self.guidance = GuidancePanel(look)
        self.count = label("", "caption")
        self.remove = Button("Remove", look, "remove", "quiet", "Remove the chosen view (Delete)")
        self.undo = Button("Undo", look, "undo", "quiet", "Undo the last change (Ctrl+Z)")
        self.redo = Button("Redo", look, "redo", "quiet", "Redo the change (Ctrl+Y)")
        self.remove.clicked.connect(self.remove_chosen)
        self.undo.clicked.connect(collecting.undo)
        self.redo.clicked.connect(collecting.redo)
        self.strip = ThumbnailStrip(look)
        self.strip.chosen.connect(self.choose)
        self._camera_names: tuple[str, ...] = ()
        self._lay_out()
        self._timer = QTimer(self)
        self._timer.setInterval(LIVE_MS)
        self._timer.timeout.connect(self._take_live)
        collecting.changed.connect(self.refresh)

    def _lay_out(self) -> None:
        tools = row(self._camera_place, 0, self.live, self._layer_place, spacing=8)
        listing = row(self.count, 0, self.remove, self.undo, self.redo, spacing=4)
        middle = column(tools, self.picture, listing, self.strip, spacing=6)
        middle.setStretch(1, 1)
        layout = row(middle, self.guidance, spacing=16)
        layout.setStretch(0, 1)
        self.setLayout(layout)

    @property
    def chosen(self) -> CollectedView | None:
        """The chosen view; None while the newest image is shown."""
        return next((view for view in self._collecting.views if view.id == self.strip.current), None)

    def begin(self) -> None:
        """Watch the live image."""
        self._timer.start()
        self.refresh()

    def end(self) -> None:
        """Stop watching."""
        self._timer.stop()

    def choose(self, id_: str) -> None:
        """Show one view; with an empty id the newest image."""
        self.strip.choose(id_)
        self._show_chosen()
        self.chosenChanged.emit()

    def remove_chosen(self) -> None:
        """Remove the chosen view."""
        if self.chosen is not None:
            self._collecting.remove(self.chosen.id)

    def refresh(self) -> None:
        """Show the views, guidance and the present verdict."""
        collecting = self._collecting
        self._offer_cameras(collecting.cameras)
        self.strip.show_thumbnails([self._thumbnail(view) for view in collecting.views])
        out = sum(view.verdict in {"fail", "not measured"} for view in collecting.views)
        self.count.setText(several(len(collecting.views), "view") + (tr(", {out} not used", out=out) if out else ""))
        self.undo.setEnabled(collecting.can_undo)
        self.redo.setEnabled(collecting.can_redo)
        self._show_guidance()
        self._show_chosen()

    def _show_guidance(self) -> None:
        """Show guidance; the gauges are those of the camera shown."""
        interim = self._collecting.solver.interim
        if interim is not None:
            camera = self.cameras.value()
            shown = [gauge for gauge in interim.advice.gauges if gauge.camera in {"", camera}]
            self.guidance.show_guidance(
                interim.advice.sentences, [Level(one.name, one.value / one.target, gauge_words(one)) for one in shown]
            )
            self.guidance.show_verdict(interim.verdict.sentence if interim.verdict else "", str(interim.error) if interim.error else "")
        elif not self._collecting.solver.is_running:
            self.guidance.show_guidance((), ())
            self.guidance.show_verdict("", "")

    def _offer_cameras(self, names: tuple[str, ...]) -> None:
        if names == self._camera_names or not names:
            return
        self._camera_names = names
        clear(self._camera_place)
        self.cameras = Segments({name: sentence_case(name) for name in names})
        self.cameras.valueChanged.connect(self._change_camera)
        self._camera_place.addWidget(self.cameras)

    def _change_camera(self) -> None:
        self._show_guidance()
        self.strip.show_thumbnails([self._thumbnail(view) for view in self._collecting.views])
        self._show_chosen()

    def _show_layers(self) -> None:
        self.picture.show_layers([name for name, button in self.layers.items() if button.isChecked()])

    def _take_live(self) -> None:
        if self._collecting.images.take_live() and self.chosen is None:
            self._show_chosen()

    def _show_chosen(self) -> None:
        """Draw the chosen view, or the newest image with where the board should appear next."""
        collecting, camera = self._collecting, self.cameras.value()
        chosen = self.chosen
        view = chosen or (collecting.views[-1] if collecting.views else None)
        self.live.setVisible(chosen is not None and collecting.capture.rig is not None)
        self.remove.setEnabled(chosen is not None and not chosen.removed)
        newest = collecting.images.newest(camera)
        if chosen is None and newest is not None:
            overlay = Overlay(None, None, None, self._coverage(camera))
            self._draw(
                newest.pixels,
                overlay,
                f"{device_title(camera)}, {newest.view}: {'shows fringes' if camera == PROJECTOR else 'looking for the board'}",
            )
        elif view is not None:
            pixels = collecting.image(view.id, camera)
            overlay = Overlay(
                view.corners_px.get(camera), view.rejected_px.get(camera), None if chosen else self._ghost(camera), self._coverage(camera)
            )
            self._draw(pixels, overlay, f"{view.name}: {self._caption(view, camera)}")
        else:
            self.picture.clear(NOTHING_YET)

    def _draw(self, pixels: np.ndarray | None, overlay: Overlay, caption: str) -> None:
        if pixels is None:
            self.picture.clear(tr("{caption}\nThere is no image of this view.", caption=caption))
        else:
            self.picture.show_board(pixels, overlay, caption)

    def _ghost(self, camera: str) -> np.ndarray | None:
        interim = self._collecting.solver.interim
        ghost = None if interim is None else interim.advice.ghost if interim.suggestion is None else interim.suggestion.ghost
        return None if ghost is None else ghost.outlines_px.get(camera)

    def _coverage(self, camera: str) -> np.ndarray | None:
        """How often each cell of the image holds corners of the views in use."""
        snapshot = self._collecting.now
        size = None if snapshot is None else snapshot.size_px(camera)
        seen = [view.corners_px[camera] for view in self._collecting.views if view.verdict == "pass" and camera in view.corners_px]
        if size is None or not seen:
            return None
        corners = np.concatenate(seen)
        counts, _, _ = np.histogram2d(corners[:, 1], corners[:, 0], bins=CELLS[::-1], range=((0, size[1]), (0, size[0])))
        return counts

    def _caption(self, view: CollectedView, camera: str) -> str:
        reason = view.reasons.get(camera, "") or (view.reason if view.verdict == "fail" else "")
        residual = view.residuals_px.get(camera)
        figure = tr("residual {residual}", residual=quantity(residual, "px", 3)) if residual is not None else ""
        if camera not in view.corners_px:
            return reason or "No board found"
        corners = several(len(view.corners_px[camera]), "corner")
        return ", ".join(part for part in (corners, figure, reason) if part)

    def _thumbnail(self, view: CollectedView) -> Thumbnail:
        camera = self.cameras.value()
        residual = view.residuals_px.get(camera)
        found = camera in view.corners_px
        verdict = "not measured" if view.removed else view.verdict if found or view.verdict == "fail" else "not proven"
        figure = (
            "Removed" if view.removed else quantity(residual, "px", 3) if residual is not None else "Not used yet" if found else "No board"
        )
        reason = view.reasons.get(camera, "") or (view.reason if view.verdict == "fail" else "")
        return Thumbnail(view.id, view.pictures.get(camera, view.empty), figure, verdict, view.name, reason, view.removed)


def gauge_words(gauge: Gauge) -> str:
    """Return how much there is, and of how much while that is not enough: ``12 of 15``, ``24°``; what is not enough is never rounded up."""
    if gauge.reached:
        return quantity(gauge.value, gauge.unit, 0)
    return tr("{count} of {total}", count=quantity(floor(gauge.value), gauge.unit, 0), total=quantity(gauge.target, gauge.unit, 0))
