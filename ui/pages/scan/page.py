"""Page Scan: set up and check a scan, run it, follow viewpoints, images and clouds, and see what was stored."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QTimer
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QStackedWidget, QWidget

from ui.controllers.controllers import Controllers
from ui.controllers.scan_choices import CheckedScan, ScanChoices, suggested_choices
from ui.controllers.stored_sessions import project_on_disk
from ui.images.camera_images import CameraImages
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import counted, percent, rough_duration, several
from ui.pages.layers import PlacedClouds, placements_of, view_layer
from ui.pages.scan.missing import MissingDialog
from ui.pages.scan.run_bar import RunBar
from ui.pages.scan.setup import ScanSetup
from ui.pages.viewport_page import Composer, Picture, ViewportPage
from ui.session import Session
from ui.widgets.basic import Button, card, column, label, row
from ui.widgets.empty_state import EmptyState
from ui.widgets.properties_panel import Group, Properties
from ui.widgets.viewpoint_tiles import Tile, TileList
from ui.workers.job import Job

if TYPE_CHECKING:
    from measureapp.acquire.events import ImageTaken
    from measureapp.acquire.time_left import TimeLeft
    from measureapp.data.measurement import ViewResult

LIVE_INTERVAL_MS = 66
EMPTY = (
    "Nothing scanned yet",
    "A scan moves the rig from viewpoint to viewpoint, projects fringes and takes images. Choose a project and a plan, or run the demo.",
)
COMPUTING = "All images are taken. The clouds are computed and stitched; Cancel keeps the images."
HAVE_IMAGES = {"stored", "processed"}
PICTURES_WIDTH = 240


class ScanPage(ViewportPage):
    """What a scan needs; then tiles by viewpoint, current images small, the cloud large."""

    name, word, wants_room = "scan", "Scan", True

    def __init__(self, look: Look, session: Session, controllers: Controllers) -> None:
        super().__init__(look, session, controllers, EmptyState(look, "scan", *EMPTY, "Set up a scan"))
        self.setup = ScanSetup(look, session)
        self.tiles = TileList(look)
        self.bar = RunBar(look)
        self.pictures = CameraImages(look)
        self.missing_dialog = MissingDialog(look, self)
        self.pictures_title = label("Images", "caption")
        self._placed = PlacedClouds()
        self._wants_setup = False
        self._lay_out(look)
        self._timer = QTimer(self)
        self._timer.setInterval(LIVE_INTERVAL_MS)
        self._timer.timeout.connect(self._tick)
        self._connect()

    def _lay_out(self, look: Look) -> None:
        pictures = card(self.pictures_title, self.pictures, margin=12)
        pictures.layout().setStretch(1, 1)
        pictures.setFixedWidth(PICTURES_WIDTH)
        middle = row(card(self.view, margin=1), pictures, spacing=16)
        middle.setStretch(0, 1)
        layout = column(self.bar, self.tiles, middle, spacing=12)
        layout.setStretch(2, 1)
        run = QWidget()
        run.setLayout(layout)
        self._places = QStackedWidget()
        self._places.addWidget(self.setup)
        self._places.addWidget(run)
        self.body.setLayout(column(self._places))
        self.demo = Button("Run the demo", look, "run", "normal", "A ready-made scan of a sample part on the virtual rig")
        self.empty.add_quiet(self.demo)
        self.back = Button("Show the scan", look, "scan", "normal", "Back to viewpoints, images and clouds")
        self.new = Button("New scan…", look, "add", "normal", "Choose project, plan and exposures of another scan")
        self.go_on = Button("Resume the scan", look, "run", "primary")
        self.again = Button("Recompute", look, "again", "normal", "Recompute everything from the stored images")
        self.missing = Button("What is missing…", look, "holes", "normal", "Compare with the nominal, and propose the views that pay")
        self.next_step = Button("See the clouds", look, "clouds", "primary")
        for button in (self.back, self.new, self.again, self.missing, self.go_on, self.next_step):
            self.action_row.addWidget(button)

    def _connect(self) -> None:
        session, controllers = self.session, self.controllers
        scanning = controllers.scanning
        self.empty.triggered.disconnect()
        self.empty.triggered.connect(self.set_up)
        self.demo.clicked.connect(controllers.demo.run)
        self.new.clicked.connect(self.set_up)
        self.back.clicked.connect(self.show_run)
        self.go_on.clicked.connect(scanning.take_up)
        self.again.clicked.connect(controllers.project.process)
        self.setup.checkClicked.connect(lambda: scanning.check(self.setup.value()))
        self.setup.startClicked.connect(lambda: scanning.start(self.setup.value()))
        scanning.checked.connect(self._show_checked)
        self.missing.clicked.connect(controllers.extending.look)
        controllers.extending.found.connect(self.missing_dialog.show_found)
        self.missing_dialog.scanClicked.connect(controllers.extending.scan)
        self.bar.pauseClicked.connect(scanning.pause)
        self.bar.resumeClicked.connect(scanning.resume)
        self.bar.skipClicked.connect(self._skip)
        self.bar.retakeClicked.connect(self._retake)
        self.tiles.tileClicked.connect(self._choose)
        controllers.stored_images.imagesReady.connect(self.show_images)
        session.cloudsChanged.connect(self.redraw)
        session.projectChanged.connect(self._forget)
        session.runChanged.connect(self._leave_setup)
        self.follow(session.rigChanged, self._make_images)
        self.follow(session.viewpointsChanged, self._show)
        self.follow(session.runChanged, self._show)
        self.follow(session.busyChanged, self._show_busy)

    # what people do

    def set_up(self) -> None:
        """Show what a scan needs."""
        self._wants_setup = True
        if self.setup.value() == ScanChoices():
            self.setup.setValue(suggested_choices(self.session, self.controllers.planning.part.path))
        self.setup.refresh()
        self._show()

    def show_run(self) -> None:
        """Show viewpoints, images and clouds."""
        self._wants_setup = False
        self._show()

    def _choose(self, viewpoint_id: str) -> None:
        self.tiles.choose(viewpoint_id)
        if self.session.viewpoints[viewpoint_id].status in HAVE_IMAGES:
            self.controllers.stored_images.show(viewpoint_id)
        self._show_bar()

    def _skip(self) -> None:
        chosen = self.session.viewpoints.get(self.tiles.chosen)
        waiting = chosen is not None and chosen.status == "waiting"
        self.controllers.scanning.skip(self.tiles.chosen if waiting else None)

    def _retake(self) -> None:
        self.controllers.scanning.retake(self.tiles.chosen)

    # what is shown

    def _show_checked(self, checked: CheckedScan) -> None:
        self.setup.show_checked(checked)

    def _leave_setup(self) -> None:
        """A run is shown as soon as there is one."""
        if self.session.run.state != "idle":
            self._wants_setup = False

    def _forget(self) -> None:
        self.tiles.choose("")
        self._wants_setup = False
        self._make_images()

    def _show_busy(self) -> None:
        busy = bool(self.session.busy_with)
        if busy:
            self._timer.start()
            self.say_running("The rig is being prepared…", "The viewpoints appear here when the scan begins.")
        else:
            self._timer.stop()
            self._tick()
            self.empty.say(*EMPTY)
            if self.isVisible():
                self._show_stored()
        self.demo.setVisible(not busy)
        self.setup.refresh()
        self._show()

    def _show(self) -> None:
        points, busy = self.session.viewpoints, bool(self.session.busy_with)
        on_disk = project_on_disk(self.session) is not None
        has_run = bool(points) and (busy or on_disk or bool(self.session.views) or self.session.run.state != "idle")
        setting_up = self._wants_setup and self.session.run.state == "idle"
        if self.is_empty == (has_run or setting_up):  # to show and hide all buttons for every event would lay the page out again
            self.show_filled(has_run or setting_up)
        self._places.setCurrentIndex(0 if setting_up or not has_run else 1)
        missing = () if busy else self.controllers.scanning.missing
        idle_run = has_run and not setting_up and not busy
        self.back.setVisible(setting_up and has_run)
        self.new.setVisible(idle_run)
        self.again.setVisible(idle_run and any(state.status in HAVE_IMAGES for state in points.values()))
        self.missing.setVisible(idle_run and self.controllers.extending.can_look)
        self.go_on.setVisible(idle_run and bool(missing))
        self.next_step.setVisible(idle_run and bool(self.session.views) and not missing)
        kept = len(points) - len(missing)
        self.go_on.setToolTip(
            tr(
                "{count} stored and kept, {count_2} missing are taken",
                count=several(kept, "viewpoint is", "viewpoints are"),
                count_2=len(missing),
            )
        )
        self._show_tiles()
        self._show_bar()
        self._show_summary()

    def _show_tiles(self) -> None:
        points = self.session.viewpoints
        states = [state.status for state in points.values()]
        if not states or self._places.currentIndex() == 0:
            self.state.setText(tr("Choose project, plan and exposures.") if self._wants_setup else tr("No viewpoint scanned."))
        else:
            self.state.setText(translated(state_words(states)))
        decoded = {view.viewpoint_id: decoded_share(view) for view in self.session.views}
        self.tiles.show_tiles([Tile(state.id, state.status, state.note, decoded.get(state.id, "")) for state in points.values()])

    def _show_bar(self) -> None:
        run, chosen = self.session.run, self.session.viewpoints.get(self.tiles.chosen)
        running = run.state != "idle"
        closed = chosen is not None and chosen.status in {"stored", "processed", "failed", "skipped"}
        can_retake = closed and (running or (not self.session.busy_with and project_on_disk(self.session) is not None))
        taking = self.controllers.scanning.is_taking
        words = (
            (left_words(self.controllers.scanning.left()) if taking else COMPUTING)
            if running
            else tr("{id} is chosen.", id=chosen.id)
            if chosen is not None
            else ""
        )
        self.bar.setVisible(running or can_retake)
        self.bar.show_run(run, words, can_retake=can_retake and (taking or not running), is_taking=taking)

    def _show_summary(self) -> None:
        points = self.session.viewpoints.values()
        total = sum(len(view.cloud) for view in self.session.views)
        stored = sum(state.status in HAVE_IMAGES for state in points)
        facts = (
            ("Stored", tr("{count} of {total}", count=stored, total=len(points))),
            ("Clouds", str(len(self.session.views))),
            ("Points", counted(total)),
        )
        groups = [Group("So far", facts)]
        for heading, status in (("Failed viewpoints", "failed"), ("Skipped viewpoints", "skipped")):
            rows = tuple((state.id, state.note or state.status) for state in points if state.status == status)
            if rows:
                groups.append(Group(heading, rows))
        self.show_properties(Properties("Scan", tuple(groups), "Every viewpoint is stored completely or not at all."))

    # images and clouds

    def _make_images(self) -> None:
        rig = self.session.rig
        if rig is not None:
            self.pictures.show_cameras({camera.name: camera.saturation for camera in rig.cameras})

    def showEvent(self, event: QShowEvent) -> None:
        """Show stored images if no image has been shown yet."""
        super().showEvent(event)
        self._show_stored()

    def _show_stored(self) -> None:
        stored = [state.id for state in self.session.viewpoints.values() if state.status in HAVE_IMAGES]
        if stored and not self.session.busy_with and self.pictures.is_empty:
            self.controllers.stored_images.show(stored[0])

    def _tick(self) -> None:
        if self.isVisible() and not self.controllers.rig_calibrating.is_running:  # another window shows the images of a calibration
            self._take_images()
        if self.session.run.state == "running":
            self._show_bar()

    def _take_images(self) -> None:
        if self.session.cell.live:  # images of the Rig page
            return
        self.show_images(tuple(self.session.images.take_all().values()))

    def show_images(self, events: tuple[ImageTaken, ...]) -> None:
        """Show these images, each in the place of its camera."""
        for event in events:
            self.pictures_title.setText(tr("Images of {viewpoint_id}", viewpoint_id=event.viewpoint_id))
            self.pictures.show_image(event.camera, event.pixels, event.exposure_us, event.viewpoint_id)

    def composer(self) -> Composer | None:
        """Compose the clouds so far, in kinematic or, after stitching, in registered positions."""
        views, theme, placed_clouds = self.session.views, self.look.theme, self._placed
        placements = placements_of(self.session.stitched)

        def compose(job: Job) -> Picture:
            layers = []
            for index, view in enumerate(views):
                job.check()
                placement = placements.get(view.viewpoint_id)
                layers.append(view_layer(theme, placed_clouds.get(view, placement, fine=True), index, "grey", None))
            return Picture(tuple(layers))

        return compose


def left_words(left: TimeLeft | None) -> str:
    """Return how long a run still takes."""
    if left is None or not left.bound_s:
        return "Choose a viewpoint to see its images, to skip it or to take it again."
    return tr(
        "About {expected_s} left, at most {bound_s}; then the clouds are stitched.",
        expected_s=rough_duration(left.expected_s),
        bound_s=rough_duration(left.bound_s),
    )


def state_words(states: list[str]) -> str:
    """Return how far a scan is, from the states of its viewpoints."""
    done, failed, skipped = states.count("processed"), states.count("failed"), states.count("skipped")
    stored = done + states.count("stored")
    words = tr("{done} of {count} processed", done=done, count=several(len(states), "viewpoint"))
    words += tr(", {stored} stored", stored=stored) if stored > done else ""
    words += tr(", {failed} failed", failed=failed) if failed else ""
    return words + tr(", {skipped} skipped.", skipped=skipped) if skipped else tr("{words:stopped}", words=words)


def decoded_share(view: ViewResult) -> str:
    """Return the decoded fraction of the images, from the lowest to the highest camera."""
    shares = sorted(float(figures["decoded_ratio"]) for figures in view.decode.values())
    if not shares:
        return ""
    least, most = percent(shares[0], 0), percent(shares[-1], 0)
    return tr("{most} decoded", most=most) if least == most else tr("{split}–{most} decoded", split=least.split(chr(160))[0], most=most)
