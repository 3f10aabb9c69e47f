"""Page Rig: devices with their state, a drawing to scale or live images, moving by hand, and the demo."""

from __future__ import annotations

import tomllib

from PySide6.QtCore import QSize, QTimer, Slot
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import QComboBox, QFrame, QStackedWidget, QWidget

from measureapp.resources import resource
from ui.controllers.controllers import Controllers
from ui.controllers.demo import MeshQuestion
from ui.images.live_tile import LiveTile
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import exposure, several
from ui.pages.page import Page
from ui.pages.rig.device_rows import HEADERS, device_rows, rig_properties
from ui.pages.rig.editing import Editing
from ui.session import Session
from ui.settings.dialogs import choose_file
from ui.widgets.basic import Button, card, column, label, row, scrolled
from ui.widgets.data_table import DataTable
from ui.widgets.demo_form import DemoForm
from ui.widgets.empty_state import EmptyState
from ui.widgets.jog_pad import JogPad
from ui.widgets.rig_drawing import RigDrawing
from ui.widgets.segments import Segments
from ui.widgets.unit_dialog import UnitDialog

DEMO_WORDS = (
    "Calibrates a virtual rig with hidden errors, scans the part, stitches the clouds, evaluates the dimensions and writes the report."
)
NO_SAFETY = "Hold a button to move on. Stop is no safety function:\nin danger use the emergency stop."
STATE_INTERVAL_MS, LIVE_INTERVAL_MS = 3_000, 33
CARD_WIDTH = 384
OWN_RIG = "Open a rig description…"


class RigPage(Page):
    """Devices and nominal data of the rig, and a hand on it."""

    name, word, wants_room = "rig", "Rig", True

    def __init__(self, look: Look, session: Session, controllers: Controllers) -> None:
        empty = EmptyState(look, "rig", "Loading the rig…", "The rig description is being read.", "Run the demo")
        super().__init__(look, session, controllers, empty)
        self.drawing = RigDrawing(look)
        self.devices = DataTable(look, list(HEADERS), stretch=2)
        self.tiles: dict[str, LiveTile] = {}
        self.unit_dialog: UnitDialog | None = None
        self._add_actions()
        self._lay_out()
        self._connect()

    def _add_actions(self) -> None:
        rig = self.controllers.rig
        self.rigs = QComboBox()
        self.rigs.setMinimumWidth(208)
        self.rigs.setToolTip(tr("The rig to work with: one that comes with the program, or a description of your own (TOML)"))
        for path in sorted(resource("rigs").glob("*.toml")):
            self.rigs.addItem(tomllib.loads(path.read_text(encoding="utf-8"))["name"], path.stem)
        self.rigs.addItem(translated(OWN_RIG), "")
        self.rigs.activated.connect(self._choose_rig)
        self.connect_button = Button("Connect", self.look, "connect", "normal", "Connect every device of this rig; nothing moves")
        self.connect_button.clicked.connect(rig.connect_rig)
        self.disconnect_button = Button("Disconnect", self.look, "disconnect", "normal", "Release every device")
        self.disconnect_button.clicked.connect(rig.disconnect_rig)
        self.editing = Editing(self.look, self.session, self.controllers, self)
        for widget in (self.rigs, self.editing.button, self.connect_button, self.disconnect_button):
            self.action_row.addWidget(widget)

    def _lay_out(self) -> None:
        self.views = Segments({"cell": "Cell", "live": "Live images"}, name="View")
        self.views.valueChanged.connect(self._choose_view)
        self._tile_row = row(spacing=8)
        live = QWidget()
        live.setLayout(self._tile_row)
        self.pictures = QStackedWidget()
        self.pictures.addWidget(self.drawing)
        self.pictures.addWidget(live)
        self.sides = Segments({"demo": "Demo", "move": "Move by hand"}, name="Panel")
        self.sides.valueChanged.connect(self._choose_side)
        self.side = QStackedWidget()
        self.side.setFixedWidth(CARD_WIDTH)
        self.side.addWidget(scrolled(self._demo_card()))
        self.side.addWidget(scrolled(self._move_card()))
        self.stopped = self._stopped_banner()
        self.exposures = QComboBox()
        self.exposures.setToolTip(tr("Exposure of the live images"))
        self.exposures.currentIndexChanged.connect(self._choose_exposure)
        picture = card(row(self.views, 0, self.exposures), self.pictures, margin=8)
        main = column(self.stopped, picture, self.devices, spacing=16)
        main.setStretch(1, 2)
        main.setStretch(2, 3)
        layout = row(main, column(self.sides, self.side, spacing=8), spacing=16)
        layout.setStretch(0, 1)
        self.body.setLayout(layout)

    def _demo_card(self) -> QFrame:
        self.form = DemoForm()
        self.run_demo = Button("Run the demo", self.look, "run", "primary")
        self.run_demo.clicked.connect(self.controllers.demo.run)
        self.run_demo.setIconSize(QSize(20, 20))
        words = label(DEMO_WORDS, "soft", wrap=True)
        return card(label("Demo on the virtual rig", "heading"), words, 8, self.form, 8, self.run_demo, 0, spacing=8)

    def _move_card(self) -> QFrame:
        self.pad = JogPad(self.look)
        self.home = Button("Find references", self.look, "home", "normal", "Guide and table find their reference positions")
        self.home.clicked.connect(self.controllers.rig.find_references)
        self.unmovable = label("Connect the rig to move its axes.", "soft", wrap=True)
        return card(self.unmovable, self.pad, self.home, label(NO_SAFETY, "small"), 0, spacing=8)

    def _stopped_banner(self) -> QFrame:
        self.stop_reason = label("", "strong", wrap=True)
        self.reset = Button("Reset", self.look, "again", "primary", "Let the rig run again, after the cause was removed")
        self.reset.clicked.connect(self.controllers.rig.reset)
        words = row(self.stop_reason, self.reset, spacing=16)
        words.setStretch(0, 1)
        banner = card(words, margin=12)
        banner.hide()
        return banner

    def _connect(self) -> None:
        session, controllers = self.session, self.controllers
        self.form.valueChanged.connect(controllers.demo.choose)
        self.form.meshChosen.connect(controllers.demo.inspect_mesh)
        controllers.demo.meshReady.connect(self.form.show_mesh)
        controllers.demo.unitAsked.connect(self._ask_unit)
        self.pad.stepRequested.connect(controllers.rig.jog)
        controllers.rig.stepped.connect(self.pad.step_ended)
        self.follow(session.rigChanged, self._show)
        self.follow(session.cellChanged, self._show_cell)
        self.follow(session.busyChanged, self._show_busy)
        self.follow(session.appearanceChanged, self._show_cell)
        self.editing.changed.connect(self._show_busy)
        self._state_timer, self._live_timer = QTimer(self), QTimer(self)
        self._state_timer.setInterval(STATE_INTERVAL_MS)
        self._state_timer.timeout.connect(controllers.rig.refresh)
        self._live_timer.setInterval(LIVE_INTERVAL_MS)
        self._live_timer.timeout.connect(self._take_images)

    # what people do

    def _choose_rig(self, place: int) -> None:
        chosen = self.rigs.itemData(place)
        if chosen is None:
            return
        if chosen == "":
            path = choose_file(self, "Open a rig description", "Rig descriptions (*.toml)", "rigs")
            self._name_rig()
            if path is not None:
                self.controllers.rig.choose(path)
        else:
            self.controllers.rig.choose(chosen)

    def _choose_view(self, view: str) -> None:
        self.pictures.setCurrentIndex(1 if view == "live" else 0)
        self.exposures.setVisible(view == "live")
        self.controllers.rig.show_live(view == "live")

    def _choose_exposure(self) -> None:
        self.controllers.rig.live_exposure_us = self.exposures.currentData()

    def _choose_side(self, side: str) -> None:
        self.side.setCurrentIndex(1 if side == "move" else 0)

    @Slot(object)
    def _ask_unit(self, asked: MeshQuestion) -> None:
        finding = tr("{name} has a size of {span:.4g}", name=asked.path.name, span=asked.span)
        dialog = self.unit_dialog = UnitDialog(self.look, "mesh", finding, asked.likely, asked.span, self)
        dialog.chosen.connect(lambda unit: self.form.show_mesh(asked.path, unit))
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()

    # what is shown

    def _show_busy(self) -> None:
        busy = bool(self.session.busy_with)
        self.run_demo.setEnabled(not busy)
        self.empty.button.setEnabled(not busy)
        for widget in (self.connect_button, self.disconnect_button, self.home):
            widget.setEnabled(not busy)
        self.rigs.setEnabled(not busy and self.editing.editor is None)

    def _show(self) -> None:
        rig = self.session.rig
        self.show_filled(rig is not None)
        if rig is None:
            return
        self._name_rig()
        self.drawing.show_rig(rig)
        self._make_tiles()
        if [self.exposures.itemData(place) for place in range(self.exposures.count())] != list(rig.exposures_us):
            self.exposures.clear()
            for exposure_us in rig.exposures_us:
                self.exposures.addItem(exposure(exposure_us), exposure_us)
        self.show_properties(rig_properties(rig, self.session.drivers))
        self._show_cell()

    def _show_cell(self) -> None:
        rig, cell = self.session.rig, self.session.cell
        if rig is None:
            return
        self.editing.button.setVisible(self.session.role == "engineer")
        self.connect_button.setVisible(not cell.connected)
        self.disconnect_button.setVisible(cell.connected)
        self.views.set_available("live", cell.connected and not cell.stopped)
        self.exposures.setVisible(self.views.value() == "live")
        if (not cell.connected or cell.stopped) and self.views.value() == "live":
            self.views.setValue("cell")
        self.state.setText(translated(self._state_words()))
        self.devices.set_rows(device_rows(rig, cell, self.session.drivers))
        self.devices.setMaximumHeight(self.devices.fitted_height())
        self.pad.show_readback(cell.readback)
        movable = cell.connected and not cell.stopped
        self.pad.setEnabled(movable)
        self.home.setVisible(movable)
        self.unmovable.setVisible(not movable)
        self.unmovable.setText(tr("Reset the stop before anything moves.") if cell.stopped else tr("Connect the rig to move its axes."))
        self.stopped.setVisible(bool(cell.stopped))
        self.stop_reason.setText(
            tr("The rig is stopped: {stopped} Remove the cause, check that nothing is in the way, then reset.", stopped=cell.stopped)
        )

    def _state_words(self) -> str:
        rig, cell = self.session.rig, self.session.cell
        assert rig is not None
        if cell.connected:
            unready = sum(not device.status.ready for device in cell.devices)
            return tr("{name}, connected. ", name=rig.name) + (
                tr("{count} not ready.", count=several(unready, "device")) if unready else "All devices are ready."
            )
        problems = [driver for driver in self.session.drivers if driver.problem and driver.allowed]
        words = tr(
            "{name}. {count}, projector, robot, guide and table; not connected.", name=rig.name, count=several(len(rig.cameras), "camera")
        )
        return words + (tr(" {count} could not be loaded.", count=several(len(problems), "driver")) if problems else "")

    def _name_rig(self) -> None:
        """Show the rig of the session in the list of rigs; one that is not listed by its name."""
        rig = self.session.rig
        if rig is None:
            return
        if self.rigs.findText(rig.name) < 0:
            self.rigs.insertItem(0, rig.name, None)  # of a project or a file
        self.rigs.setCurrentIndex(self.rigs.findText(rig.name))

    def _make_tiles(self) -> None:
        rig = self.session.rig
        assert rig is not None
        if list(self.tiles) == [camera.name for camera in rig.cameras]:
            return
        while (item := self._tile_row.takeAt(0)) is not None:
            if item.widget() is not None:
                item.widget().deleteLater()
        self.tiles = {camera.name: LiveTile(self.look, camera.name, camera.saturation) for camera in rig.cameras}
        for tile in self.tiles.values():
            self._tile_row.addWidget(tile)

    def _take_images(self) -> None:
        if not self.session.cell.live:
            return
        for event in self.session.images.take_all().values():
            if event.camera in self.tiles:
                self.tiles[event.camera].show_pixels(event.pixels, event.exposure_us)

    def showEvent(self, event: QShowEvent) -> None:
        """Read the devices while the page is in sight."""
        super().showEvent(event)
        self._state_timer.start()
        self._live_timer.start()

    def hideEvent(self, event: QHideEvent) -> None:
        """Leave the devices alone while another page is in sight."""
        super().hideEvent(event)
        self._state_timer.stop()
        self._live_timer.stop()
        if self.views.value() == "live":
            self.views.setValue("cell")
