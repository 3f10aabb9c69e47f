"""Scan: the viewpoints as they go, the images, the growing cloud."""

from __future__ import annotations

from PySide6.QtCore import QTimer

from ui.controllers.controllers import Controllers
from ui.look.look import Look
from ui.look.wording import counted, exposure, several
from ui.pages.layers import placed, view_layer
from ui.pages.viewport_page import ViewportPage
from ui.session import Session
from ui.widgets.basic import Button, card, clear, column, label, row
from ui.widgets.empty_state import EmptyState
from ui.widgets.image_view import ImageView, grey_image
from ui.widgets.properties_panel import Group, Properties
from ui.widgets.viewpoint_tiles import Tile, ViewpointTiles

LIVE_INTERVAL_MS = 33
EMPTY = (
    "Nothing scanned yet",
    "The scan moves the rig from viewpoint to viewpoint, projects fringes and takes images. The demo scans on the virtual rig.",
)


class ScanPage(ViewportPage):
    """Tiles by viewpoint, current images small, the cloud large."""

    name, word = "scan", "Scan"
    for_operator = True

    def __init__(self, look: Look, session: Session, controllers: Controllers) -> None:
        super().__init__(look, session, controllers, EmptyState(look, "scan", *EMPTY, "Run the demo"))
        self.tiles = ViewpointTiles(look)
        self.images: dict[str, ImageView] = {}
        self._image_column = column(spacing=8)
        pictures = card(label("Current images", "caption"), self._image_column, 0, margin=12)
        pictures.setFixedWidth(240)
        middle = row(card(self.view, margin=1), pictures, spacing=16)
        middle.setStretch(0, 1)
        layout = column(self.tiles, middle, spacing=16)
        layout.setStretch(1, 1)
        self.body.setLayout(layout)
        self.next_step = Button("See the clouds", look, "clouds", "primary")
        self.again = Button("Compute again", look, "again", "normal", "Compute everything again from the stored images")
        self.again.clicked.connect(controllers.project.process)
        self.action_row.addWidget(self.again)
        self.action_row.addWidget(self.next_step)
        self._timer = QTimer(self)
        self._timer.setInterval(LIVE_INTERVAL_MS)
        self._timer.timeout.connect(self._take_image)
        session.viewpointsChanged.connect(self._show)
        session.cloudsChanged.connect(self.redraw)
        session.rigChanged.connect(self._make_images)
        session.projectChanged.connect(self._make_images)
        session.busyChanged.connect(self._show_busy)
        self._make_images()
        self._show()

    def _show_busy(self) -> None:
        busy = bool(self.session.busy_with)
        if busy:
            self._timer.start()
            self.empty.say("The rig is being prepared…", "The viewpoints appear here when the scan begins.", offer=False)
        else:
            self._timer.stop()
            self._take_image()
            self.empty.say(*EMPTY)
        self._show()

    def _show(self) -> None:
        points = self.session.viewpoints
        self.show_filled(bool(points))
        self.again.setVisible(bool(points) and not self.session.busy_with)
        self.next_step.setVisible(bool(self.session.views) and not self.session.busy_with)
        states = [state.status for state in points.values()]
        done, failed = states.count("processed"), states.count("failed")
        words = f"{done} of {several(len(states), 'viewpoint')} processed" if states else "No viewpoint is scanned"
        self.state.setText(words + (f", {failed} failed." if failed else "."))
        self.tiles.show_tiles([Tile(state.id, state.status, state.note) for state in points.values()])
        self._show_summary()

    def _show_summary(self) -> None:
        rows = tuple((state.id, state.note or state.status) for state in self.session.viewpoints.values() if state.status == "failed")
        total = sum(len(view.cloud) for view in self.session.views)
        groups = [Group("So far", (("Views", str(len(self.session.views))), ("Points", counted(total))))]
        if rows:
            groups.append(Group("Failed viewpoints", rows))
        self.show_properties(Properties("Scan", tuple(groups), "Every viewpoint is stored completely or not at all."))

    def _make_images(self) -> None:
        clear(self._image_column)
        self.images = {}
        if self.session.rig is not None:
            for camera in self.session.rig.cameras:
                self.images[camera.name] = ImageView(self.look, camera.name)
                self._image_column.addWidget(self.images[camera.name])

    def _take_image(self) -> None:
        event = self.session.images.take()
        if event is not None and event.camera in self.images:
            caption = f"{event.camera} · {event.viewpoint_id} · {exposure(event.exposure_us)}"
            self.images[event.camera].show_image(grey_image(event.pixels), caption)

    def draw(self) -> None:
        """Show the clouds so far, placed by the axes, or after fine stitching when that is done."""
        stitched = self.session.stitched
        placements = {placement.viewpoint_id: placement for placement in stitched.placements} if stitched is not None else {}
        layers = []
        for index, view in enumerate(self.session.views):
            placement = placements.get(view.viewpoint_id)
            layers.append(view_layer(self.look.theme, placed(view, placement, fine=True), index, placement, "view", 1.0))
        self.view.set_clouds(layers)
