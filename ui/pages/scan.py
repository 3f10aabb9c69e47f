"""Page Scan: progress of the viewpoints, current images, clouds so far."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QTimer
from PySide6.QtGui import QShowEvent

from ui.controllers.controllers import Controllers
from ui.look.look import Look
from ui.look.wording import counted, exposure, percent, several
from ui.pages.layers import PlacedClouds, placements_of, view_layer
from ui.pages.viewport_page import Composer, Picture, ViewportPage
from ui.session import Session
from ui.widgets.basic import Button, card, clear, column, label, row
from ui.widgets.empty_state import EmptyState
from ui.widgets.image_view import ImageView, grey_image
from ui.widgets.properties_panel import Group, Properties
from ui.widgets.viewpoint_tiles import Tile, ViewpointTiles
from ui.workers.job import Job

if TYPE_CHECKING:
    from measureapp.acquire.events import ImageTaken
    from measureapp.data.measurement import ViewResult

LIVE_INTERVAL_MS = 33
EMPTY = (
    "Nothing scanned yet",
    "A scan moves the rig from viewpoint to viewpoint, projects fringes and takes images. The demo uses the virtual rig.",
)


class ScanPage(ViewportPage):
    """Tiles by viewpoint, current images small, the cloud large."""

    name, word = "scan", "Scan"
    for_operator = True

    def __init__(self, look: Look, session: Session, controllers: Controllers) -> None:
        super().__init__(look, session, controllers, EmptyState(look, "scan", *EMPTY, "Run the demo"))
        self.tiles = ViewpointTiles(look)
        self.images: dict[str, ImageView] = {}
        self._placed = PlacedClouds()
        self._image_column = column(spacing=8)
        self.pictures_title = label("Images", "caption")
        pictures = card(self.pictures_title, self._image_column, 0, margin=12)
        pictures.setFixedWidth(240)
        middle = row(card(self.view, margin=1), pictures, spacing=16)
        middle.setStretch(0, 1)
        layout = column(self.tiles, middle, spacing=16)
        layout.setStretch(1, 1)
        self.body.setLayout(layout)
        self.next_step = Button("See the clouds", look, "clouds", "primary")
        self.again = Button("Recompute", look, "again", "normal", "Recompute everything from the stored images")
        self.again.clicked.connect(controllers.project.process)
        self.action_row.addWidget(self.again)
        self.action_row.addWidget(self.next_step)
        self._timer = QTimer(self)
        self._timer.setInterval(LIVE_INTERVAL_MS)
        self._timer.timeout.connect(self._take_images)
        self.tiles.tileClicked.connect(controllers.stored_images.show)
        controllers.stored_images.imagesReady.connect(self.show_images)
        session.viewpointsChanged.connect(self._show)
        session.cloudsChanged.connect(self.redraw)
        session.rigChanged.connect(self._make_images)
        session.projectChanged.connect(self._make_images)
        session.busyChanged.connect(self._show_busy)
        session.appearanceChanged.connect(self._name_next_step)
        self._make_images()
        self._show()

    def _name_next_step(self) -> None:
        """Name the next step: the dimensions for an operator, the clouds for an engineer."""
        operator = self.session.role == "operator"
        self.next_step.setText("See the dimensions" if operator else "See the clouds")
        self.next_step.set_icon("inspection" if operator else "clouds")

    def _show_busy(self) -> None:
        busy = bool(self.session.busy_with)
        if busy:
            self._timer.start()
            self.empty.say("The rig is being prepared…", "The viewpoints appear here when the scan begins.", offer=False)
        else:
            self._timer.stop()
            self._take_images()
            self.empty.say(*EMPTY)
            if self.isVisible():
                self._show_stored()
        self._show()

    def _show(self) -> None:
        points = self.session.viewpoints
        self.show_filled(bool(points))
        self.again.setVisible(bool(points) and not self.session.busy_with)
        self.next_step.setVisible(bool(self.session.views) and not self.session.busy_with)
        states = [state.status for state in points.values()]
        done, failed = states.count("processed"), states.count("failed")
        words = f"{done} of {several(len(states), 'viewpoint')} processed" if states else "No viewpoint scanned"
        self.state.setText(words + (f", {failed} failed." if failed else "."))
        decoded = {view.viewpoint_id: decoded_share(view) for view in self.session.views}
        self.tiles.show_tiles([Tile(state.id, state.status, state.note, decoded.get(state.id, "")) for state in points.values()])
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

    def showEvent(self, event: QShowEvent) -> None:
        """Show stored images if no image has been shown yet."""
        super().showEvent(event)
        self._show_stored()

    def _show_stored(self) -> None:
        stored = [state.id for state in self.session.viewpoints.values() if state.status in {"stored", "processed"}]
        if stored and not self.session.busy_with and all(image.is_empty for image in self.images.values()):
            self.controllers.stored_images.show(stored[0])

    def _take_images(self) -> None:
        self.show_images(tuple(self.session.images.take_all().values()))

    def show_images(self, events: tuple[ImageTaken, ...]) -> None:
        """Show these images, each in the place of its camera."""
        for event in events:
            if event.camera in self.images:
                self.pictures_title.setText(f"Images of {event.viewpoint_id}")
                self.images[event.camera].show_image(grey_image(event.pixels), f"{event.camera} · {exposure(event.exposure_us)}")

    def composer(self) -> Composer | None:
        """Compose the clouds so far, in kinematic or, after stitching, in registered positions."""
        views, theme, placed_clouds = self.session.views, self.look.theme, self._placed
        placements = placements_of(self.session.stitched)

        def compose(job: Job) -> Picture:
            layers = []
            for index, view in enumerate(views):
                job.check()
                placement = placements.get(view.viewpoint_id)
                layers.append(view_layer(theme, placed_clouds.get(view, placement, fine=True), index, "grey", 1.0))
            return Picture(tuple(layers))

        return compose


def decoded_share(view: ViewResult) -> str:
    """Return the decoded fraction of the images, from the lowest to the highest camera."""
    shares = sorted(float(figures["decoded_ratio"]) for figures in view.decode.values())
    if not shares:
        return ""
    least, most = percent(shares[0], 0), percent(shares[-1], 0)
    return f"{most} decoded" if least == most else f"{least.split(chr(160))[0]}–{most} decoded"
