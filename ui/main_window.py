"""The main window: header, navigation rail, pages, properties and status strip."""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QCloseEvent, QKeySequence, QResizeEvent, QShortcut
from PySide6.QtWidgets import QFileDialog, QMainWindow, QStackedWidget, QWidget

from measureapp.data.length_unit import LengthUnit
from ui.controllers.controllers import Controllers
from ui.controllers.files import FileQuestion, FilesToMeasure
from ui.look.look import Look
from ui.look.wording import part_words, several, storage
from ui.pages.calibration import CalibrationPage
from ui.pages.calibration_chip import calibration_state
from ui.pages.clouds.clouds import CloudsPage
from ui.pages.inspection.inspection import InspectionPage
from ui.pages.operator.shell import Shell
from ui.pages.page import Page
from ui.pages.plan.page import PlanPage
from ui.pages.report import ReportPage
from ui.pages.rig.page import RigPage
from ui.pages.scan.page import ScanPage
from ui.session import Message, Session
from ui.widgets.basic import column, row
from ui.widgets.closing_bar import ClosingBar
from ui.widgets.header import HeaderBar
from ui.widgets.help_dialog import HelpDialog
from ui.widgets.job_strip import JobStrip
from ui.widgets.messages_dialog import MessagesDialog
from ui.widgets.properties_panel import PropertiesPanel
from ui.widgets.rail import Rail
from ui.widgets.unit_dialog import UnitDialog

CLOUDS = "Clouds and meshes (*.ply *.stl *.obj *.pcd *.xyz *.txt *.csv *.asc *.pts)"
REFERENCES = "Nominals and inspection programs (*.stl *.ply *.obj *.step *.stp *.toml)"
PAGES = (RigPage, CalibrationPage, PlanPage, ScanPage, CloudsPage, InspectionPage, ReportPage)
SMALLEST = (1280, 720)
TITLE_BARS = 72  # height of desktop bars on a screen of the smallest size
DISK_INTERVAL_MS = 30_000
DISK_LOW_BYTES = 5e9
CLOSING_WAIT_MS = 20_000
ROOMY_WIDTH = 1500


class MainWindow(QMainWindow):
    """The main window."""

    def __init__(self, look: Look, session: Session, controllers: Controllers) -> None:
        super().__init__()
        self.setWindowTitle("MeasureApp")
        self.setMinimumSize(SMALLEST[0], SMALLEST[1] - TITLE_BARS)
        self.resize(*SMALLEST)
        self.look, self.session, self.controllers = look, session, controllers
        self.header = HeaderBar(look)
        self.properties = PropertiesPanel(look)
        self.strip = JobStrip(look)
        self.closing, self._may_stop = ClosingBar(look), False
        self.pages: dict[str, Page] = {kind.name: kind(look, session, controllers) for kind in PAGES}
        self.rail = Rail(look, {page.name: page.word for page in self.pages.values()})
        self.stack = QStackedWidget()
        self.stack.setObjectName("pages")
        for page in self.pages.values():
            self.stack.addWidget(page)
            page.propertiesChanged.connect(self._show_properties)
            page.propertiesAsked.connect(self._unfold)
        self.messages, self.help = MessagesDialog(look, self), HelpDialog(look, self)
        self._lay_out()
        self._connect()
        self._disk_timer = QTimer(self)
        self._disk_timer.setInterval(DISK_INTERVAL_MS)
        self._disk_timer.timeout.connect(self._show_disk)
        self._disk_timer.start()
        self._show_project()
        self._show_calibration()
        self.show_page("rig")

    @property
    def page(self) -> Page:
        """The workspace shown."""
        shown = self.stack.currentWidget()
        assert isinstance(shown, Page)
        return shown

    def show_page(self, name: str) -> None:
        """Show one workspace."""
        self.stack.setCurrentWidget(self.pages[name])
        self.rail.choose(name)
        self._give_room()
        self._show_properties()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Fold the properties when the page needs the space."""
        super().resizeEvent(event)
        self._give_room()

    def _give_room(self) -> None:
        self.properties.fold(self.page.wants_room and self.width() < ROOMY_WIDTH)

    def closeEvent(self, event: QCloseEvent) -> None:
        """Ask once before a running job is stopped; wait until its thread has ended."""
        running = self.controllers.jobs.queue.running
        if running is not None and not running.quiet and not self._may_stop:
            (self.shell.operator if self.shell.is_operators else self.closing).ask(running.title)
            event.ignore()
            return
        self._disk_timer.stop()
        self.hide()  # before waiting for threads
        self.controllers.end(CLOSING_WAIT_MS)
        for page in self.pages.values():
            page.close_page()
        self.shell.close_views()
        event.accept()

    def _stop_and_close(self) -> None:
        self._may_stop = True
        self.close()

    def _lay_out(self) -> None:
        middle = row(self.rail, self.stack, self.properties, spacing=0)
        middle.setStretch(1, 1)
        whole = column(self.header, self.closing, middle, self.strip, spacing=0)
        whole.setStretch(2, 1)
        centre = QWidget()
        centre.setLayout(whole)
        self.shell = Shell(self, centre, self.look, self.session, self.controllers)
        self.setCentralWidget(self.shell)
        centre.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        centre.setFocus()

    def _connect(self) -> None:
        session, controllers = self.session, self.controllers
        self.rail.chosen.connect(self.show_page)
        self.properties.actionClicked.connect(self._act)
        self.properties.decisionClicked.connect(self._decide)
        self.header.openClicked.connect(self._choose_project)
        self.header.recentAsked.connect(lambda: self.header.show_recent(controllers.project.recent()))
        self.header.recentClicked.connect(controllers.project.open)
        self.header.fileClicked.connect(self._choose_files)
        controllers.files.unitAsked.connect(self._ask_unit)
        controllers.files.measured.connect(lambda: self.show_page("inspection"))
        self.header.helpClicked.connect(self._show_help)
        self.header.stopClicked.connect(controllers.rig.stop)
        self.header.role.valueChanged.connect(self._change_role)
        self.header.operatorSetupClicked.connect(self.shell.set_up)
        self.strip.cancelClicked.connect(controllers.jobs.cancel)
        self.strip.messagesClicked.connect(self._show_messages)
        controllers.jobs.progressed.connect(self._show_progress)
        self.closing.closeClicked.connect(self._stop_and_close)
        session.busyChanged.connect(self._show_busy)
        session.messageAdded.connect(self._show_message)
        session.projectChanged.connect(self._show_project)
        session.calibrationChanged.connect(self._show_calibration)
        session.rigChanged.connect(self._show_devices)
        session.cellChanged.connect(self._show_devices)
        scan = self.pages["scan"]
        assert isinstance(scan, ScanPage)
        scan.next_step.clicked.connect(self._go_on)
        inspection = self.pages["inspection"]
        assert isinstance(inspection, InspectionPage)
        inspection.see_report.clicked.connect(lambda: self.show_page("report"))
        session.appearanceChanged.connect(self._show_role)
        inspection.measure_file.clicked.connect(self._choose_files)
        QShortcut(QKeySequence.StandardKey.HelpContents, self, self._show_help)
        QShortcut(QKeySequence.StandardKey.Open, self, self._choose_project)
        self._escape = QShortcut(Qt.Key.Key_Escape, self, controllers.rig.stop)
        self._escape.setEnabled(False)

    def _go_on(self) -> None:
        self.show_page("clouds")

    def _show_properties(self) -> None:
        self.properties.show_properties(self.page.properties)

    def _act(self) -> None:
        self.page.act()

    def _decide(self) -> None:
        self.page.decide()

    def _unfold(self) -> None:
        self.properties.fold(False)

    def _show_busy(self) -> None:
        self.strip.show_job(self.session.busy_with)
        if not self.session.busy_with:
            self.closing.hide()

    def _show_progress(self, share: float, note: str) -> None:
        self.strip.show_progress(share, note, with_time=self.controllers.scanning.left() is None)

    def _show_message(self, message: Message) -> None:
        self.strip.show_message(message.text, message.hint, message.level)
        if self.messages.isVisible():
            self.messages.show_messages(self.session.messages)

    def _show_messages(self) -> None:
        self.messages.show_messages(self.session.messages)
        self.messages.show()
        self.messages.raise_()

    def _show_help(self) -> None:
        self.help.show_page(self.page.name)

    def _show_project(self) -> None:
        session = self.session
        self.header.show_project(session.project_name, f"Part: {part_words(session.part)}" if session.part else "")
        self.setWindowTitle(f"{session.project_name} – MeasureApp" if session.project_name else "MeasureApp")
        self._show_disk()

    def _show_devices(self) -> None:
        rig, cell = self.session.rig, self.session.cell
        can_move = cell.connected or self.session.moving
        self.header.stop.setVisible(can_move)
        self._escape.setEnabled(can_move)
        unready = [device.name for device in cell.devices if not device.status.ready]
        problems = [driver for driver in self.session.drivers if driver.problem and driver.allowed]
        if rig is None:
            self.header.devices.show_state("No rig", "verdict_not_proven")
        elif cell.stopped:
            self.header.devices.show_state("Stopped", "verdict_fail", cell.stopped)
        elif unready:
            self.header.devices.show_state(f"{several(len(unready), 'device')} not ready", "verdict_fail", ", ".join(unready))
        elif problems:
            self.header.devices.show_state(f"{several(len(problems), 'driver')} failed", "verdict_fail", problems[0].problem)
        else:
            words = "Virtual rig" if rig.driver == "virtual_rig" else rig.name
            colour = "verdict_pass" if cell.connected or rig.driver == "virtual_rig" else "soft"
            self.header.devices.show_state(words, colour, f"{rig.name}, {'connected' if cell.connected else 'not connected'}")

    def _show_calibration(self) -> None:
        state = calibration_state(self.session.calibration, self.session.rig, self.session.validity)
        self.header.calibration.show_state(state.words, state.colour, state.tip)

    def _show_disk(self) -> None:
        folder = self.session.folder or Path.home()
        while not folder.exists():
            folder = folder.parent
        free = shutil.disk_usage(folder).free
        self.header.disk.show_state(f"{storage(free)} free", "verdict_fail" if free < DISK_LOW_BYTES else "soft", f"Free space at {folder}")

    def _change_role(self, role: str) -> None:
        roles = self.controllers.roles
        if role == self.session.role:
            return
        (roles.become_operator if role == "operator" else roles.ask_engineer)()

    def _show_role(self) -> None:
        self.header.role.setValue(self.session.role)

    def _choose_files(self) -> None:
        cloud, _ = QFileDialog.getOpenFileName(self, "Choose the cloud or mesh to inspect", str(Path.home()), CLOUDS)
        reference = (
            QFileDialog.getOpenFileName(self, "Choose its nominal or inspection program", str(Path(cloud).parent), REFERENCES)[0]
            if cloud
            else ""
        )
        if reference:
            self.controllers.files.measure(FilesToMeasure(Path(cloud), Path(reference)))

    def _ask_unit(self, asked: FileQuestion) -> None:
        question, kept = asked.question, "unit" if asked.question.what == "points" else "nominal_unit"
        self.unit_dialog = UnitDialog(self.look, question.what, question.finding, LengthUnit(question.unit), parent=self)
        self.unit_dialog.chosen.connect(lambda unit: self.controllers.files.measure(replace(asked.files, **{kept: unit})))
        self.unit_dialog.finished.connect(self.unit_dialog.deleteLater)
        self.unit_dialog.open()

    def _choose_project(self) -> None:
        start = self.session.folder.parent if self.session.folder is not None else Path.home()
        chosen = QFileDialog.getExistingDirectory(self, "Open a project folder", str(start))
        if chosen:
            self.controllers.project.open(Path(chosen))
