"""The main window: header, navigation rail, pages, properties and status strip."""

from __future__ import annotations

from functools import cached_property
from pathlib import Path

from PySide6.QtCore import QDateTime, Qt, QTimer, Slot
from PySide6.QtGui import QCloseEvent, QResizeEvent, QShortcut
from PySide6.QtWidgets import QMainWindow, QStackedWidget, QWidget

from ui.actions.actions import Actions
from ui.actions.palette import CommandPalette
from ui.actions.shortcut_list import ShortcutList
from ui.controllers.controllers import Controllers
from ui.look.language.words import tr
from ui.look.look import Look
from ui.messages import MOMENT, Message
from ui.pages.calibration import CalibrationPage
from ui.pages.clouds.clouds import CloudsPage
from ui.pages.inspection.inspection import InspectionPage
from ui.pages.operator.shell import Shell
from ui.pages.page import Page
from ui.pages.pages import Pages
from ui.pages.plan.page import PlanPage
from ui.pages.report import ReportPage
from ui.pages.rig.page import RigPage
from ui.pages.scan.page import ScanPage
from ui.session import Session
from ui.settings.dialogs import choose_new
from ui.settings.layout import keep_window, remember_splitters, restore_window
from ui.settings.settings import Settings
from ui.shell.commands import register_commands
from ui.shell.drops import DropActions, DropTarget
from ui.shell.header_state import HeaderState
from ui.shell.next_frame import NextFrame
from ui.shell.project_menu import ProjectMenu
from ui.shell.support_log import save_support_log, support_lines
from ui.shell.tour import Tour
from ui.shell.unsaved import UnsavedQuestion
from ui.widgets.basic import column, row
from ui.widgets.closing_bar import ClosingBar
from ui.widgets.header import HeaderBar
from ui.widgets.help_dialog import HelpDialog
from ui.widgets.job_strip import JobStrip
from ui.widgets.messages_dialog import MessagesDialog
from ui.widgets.properties_panel import PropertiesPanel
from ui.widgets.rail import Rail
from ui.widgets.settings_dialog import SettingsDialog
from ui.widgets.tour_bar import TourBar

PAGES = (RigPage, CalibrationPage, PlanPage, ScanPage, CloudsPage, InspectionPage, ReportPage)
SMALLEST = (1280, 720)
TITLE_BARS = 72  # height of desktop bars on a screen of the smallest size
CLOSING_WAIT_MS = 20_000
ROOMY_WIDTH = 1500
PAGES_APART_MS = 50  # for what happens meanwhile


class MainWindow(QMainWindow):
    """The main window."""

    def __init__(self, look: Look, session: Session, controllers: Controllers, settings: Settings) -> None:
        super().__init__()
        self.setWindowTitle(tr("MeasureApp"))
        self.setMinimumSize(SMALLEST[0], SMALLEST[1] - TITLE_BARS)
        self.resize(*SMALLEST)
        self.look, self.session, self.controllers, self.settings = look, session, controllers, settings
        self.header = HeaderBar(look)
        self.properties = PropertiesPanel(look)
        self.strip = JobStrip(look)
        self.closing, self._may_stop = ClosingBar(look), False
        self.next_frame = NextFrame(self)
        self.pages = Pages(PAGES, self._make_page)
        self.rail = Rail(look, self.pages.words)
        self.stack = QStackedWidget()
        self.stack.setObjectName("pages")
        self._add_commands()
        self._lay_out()
        self._connect()
        self.header_state = HeaderState(session, self.header, self)
        restore_window(self, settings)
        kept = settings.text("page")
        self.show_page(kept if kept in self.pages else "rig")

    def _make_page(self, kind: type[Page]) -> Page:
        page = kind(self.look, self.session, self.controllers)
        self.stack.addWidget(page)
        page.propertiesChanged.connect(self._follow_properties)
        page.propertiesAsked.connect(self._unfold)
        if isinstance(page, ScanPage):
            page.next_step.clicked.connect(self._go_on)
        elif isinstance(page, InspectionPage):
            page.measure_file.clicked.connect(self.project_menu.inspect_files)
        return page

    @Slot()
    def make_pages(self) -> None:
        """Make the pages that are missing, one after the other while nothing else is to be done: the first click on each is answered at once."""
        made = self.isVisible() and not self.shell.is_operators and self.pages.make_next()
        self.controllers.startup.is_window_filling = made
        if made:
            QTimer.singleShot(PAGES_APART_MS, self, self.make_pages)

    def _add_commands(self) -> None:
        self.actions_ = Actions(self, lambda: self.session.role == "engineer")
        self.project_menu = ProjectMenu(self.look, self.session, self.controllers, self.settings, self)
        self.tour = Tour(self, TourBar(self.look), self)
        register_commands(self.actions_, self)
        programming = self.controllers.programming
        self.drops = DropTarget(
            self.look,
            DropActions(
                open_project=self.controllers.project.open,
                inspect=self.project_menu.inspect,
                set_nominal=self.controllers.nominal.use,
                set_program=self.project_menu.use_program,
                open_plan=lambda path: (self.show_page("plan"), self.controllers.planning.open(path)),
                open_rig=lambda path: (self.show_page("rig"), self.controllers.rig.choose(path)),
                running=lambda: self.session.busy_with,
                is_engineer=lambda: self.session.role == "engineer",
                is_measured=lambda: programming.can_change,
            ),
            self,
        )

    @cached_property
    def messages(self) -> MessagesDialog:
        """The message centre; as all dialogs it is made when first opened, so that the window is there sooner."""
        made = MessagesDialog(self.look, self.session.messages, self._words_of, self)
        made.remedyAsked.connect(self.actions_.perform)
        made.logAsked.connect(self.save_log)
        return made

    @cached_property
    def help(self) -> HelpDialog:
        """The help pages."""
        made = HelpDialog(self.look, self)
        made.tourClicked.connect(self.tour.begin)
        return made

    @cached_property
    def settings_dialog(self) -> SettingsDialog:
        """The settings."""
        return SettingsDialog(self.look, self.settings, self)

    @cached_property
    def palette_(self) -> CommandPalette:
        """The command palette."""
        return CommandPalette(self.look, self.actions_, self.pages.words, self, lambda: (self.page.name, self.page))

    @cached_property
    def shortcuts(self) -> ShortcutList:
        """The list of shortcuts."""
        return ShortcutList(self.look, self.actions_, self.pages.words, self)

    def _words_of(self, id_: str) -> str:
        action = self.actions_.action(id_)
        return "" if action is None else action.text

    @property
    def page(self) -> Page:
        """The workspace shown."""
        shown = self.stack.currentWidget()
        assert isinstance(shown, Page)
        return shown

    def show_page(self, name: str) -> None:
        """Show one workspace."""
        remember_splitters(self.pages[name], self.settings)
        self.stack.setCurrentWidget(self.pages[name])
        self.rail.choose(name)
        self.settings.set_text("page", name)
        if self._lacks_room:
            self._give_room()
            self._show_properties()
        else:  # those of the page before are not laid out once more when they are unfolded
            self._show_properties()
            self._give_room()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Fold the properties when the page needs the space."""
        super().resizeEvent(event)
        self._give_room()

    @property
    def _lacks_room(self) -> bool:
        return self.page.wants_room and self.width() < ROOMY_WIDTH

    def _give_room(self) -> None:
        self.properties.fold(self._lacks_room)

    def closeEvent(self, event: QCloseEvent) -> None:
        """Ask once before a running job is stopped; wait until its thread has ended."""
        running = self.controllers.jobs.queue.running
        if running is not None and not running.quiet and not self._may_stop:
            (self.shell.operator if self.shell.is_operators else self.closing).ask(running.title)
            event.ignore()
            return
        if self.session.ask_about_unsaved(self.close):
            event.ignore()
            return
        keep_window(self, self.settings)
        self.settings.save()
        self.header_state.stop()
        self.hide()  # before waiting for threads
        self.controllers.end(CLOSING_WAIT_MS)
        for page in self.pages.made:
            page.close_page()
        self.shell.close_views()
        event.accept()

    def _stop_and_close(self) -> None:
        self._may_stop = True
        self.close()

    def _lay_out(self) -> None:
        middle = row(self.rail, self.stack, self.properties, spacing=0)
        middle.setStretch(1, 1)
        self.unsaved = UnsavedQuestion(self.look, self.session, self.controllers.programming, self)
        whole = column(self.header, self.closing, self.unsaved.bar, middle, self.tour.bar, self.strip, spacing=0)
        whole.setStretch(3, 1)
        centre = QWidget()
        centre.setLayout(whole)
        self.shell = Shell(self, centre, self.look, self.session, self.controllers)
        self.setCentralWidget(self.shell)
        centre.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        centre.setFocus()

    def _connect(self) -> None:
        session, controllers, header = self.session, self.controllers, self.header
        self.rail.chosen.connect(self.show_page)
        self.properties.actionClicked.connect(self._act)
        self.properties.decisionClicked.connect(self._decide)
        header.menu.aboutToShow.connect(lambda: self.project_menu.fill(header.menu, self.actions_))
        header.fileClicked.connect(self.project_menu.inspect_files)
        header.helpClicked.connect(self.show_help)
        header.themeClicked.connect(self.change_theme)
        header.stopClicked.connect(controllers.rig.stop)
        header.role.valueChanged.connect(self._change_role)
        controllers.startup.rigLoaded.connect(self.next_frame.wait)
        self.next_frame.drawn.connect(controllers.startup.go_on)
        controllers.startup.imported.connect(self.make_pages)
        controllers.files.measured.connect(lambda: self.show_page("inspection"))
        header.operatorSetupClicked.connect(self.shell.set_up)
        self.strip.cancelClicked.connect(controllers.jobs.cancel)
        self.strip.messagesClicked.connect(self.show_messages)
        self.actions_.refused.connect(lambda words, reason: session.tell(f"{words}: {reason}", "", "info", cause=MOMENT))
        controllers.jobs.progressed.connect(self._show_progress)
        self.closing.closeClicked.connect(self._stop_and_close)
        session.busyChanged.connect(self._show_busy)
        session.messageAdded.connect(self._show_message)
        session.messages.changed.connect(self._show_open)
        session.projectChanged.connect(self._name_window)
        session.cellChanged.connect(self._allow_escape)
        session.appearanceChanged.connect(self._show_role)
        self._escape = QShortcut(Qt.Key.Key_Escape, self, controllers.rig.stop)
        self._escape.setEnabled(False)

    def _allow_escape(self) -> None:
        self._escape.setEnabled(self.session.cell.connected or self.session.moving)

    def _go_on(self) -> None:
        self.show_page("clouds")

    def _follow_properties(self) -> None:
        if self.sender() is self.page:  # those of a page out of sight are shown with it
            self._show_properties()

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

    def _show_open(self) -> None:
        """Count the open messages; one whose cause has ended gives its place in the strip to the newest that is open."""
        messages = self.session.messages
        self.strip.show_open(len(messages.open))
        shown = messages[-1] if len(messages) else None
        if shown is not None and shown.level in ("warning", "error") and shown.cause != MOMENT and not messages.is_open(shown):
            newest = messages.open[-1] if messages.open else Message("")
            self.strip.show_message(newest.text, newest.hint, newest.level)

    def show_help(self) -> None:
        """Show the help of the page."""
        self.help.show_page(self.page.name)

    def show_messages(self) -> None:
        """Show the message centre."""
        self.messages.begin()

    def show_settings(self) -> None:
        """Show the settings."""
        self.settings_dialog.begin()

    def show_shortcuts(self) -> None:
        """Show the list of shortcuts."""
        self.shortcuts.begin()

    def show_commands(self) -> None:
        """Show the command palette."""
        self.palette_.begin()

    def change_theme(self) -> None:
        """Change between the light and the dark theme, and keep the choice."""
        self.settings.set_text("theme", "light" if self.look.theme.shade == "dark" else "dark")

    def save_log(self) -> None:
        """Save what support needs in one file."""
        stamp = QDateTime.currentDateTime().toString("yyyy-MM-dd-HHmm")
        file = choose_new(self, "Save the log for support", f"measureapp-support-{stamp}.zip", "support", "*.zip")
        if file is None:
            return
        texts, folder = support_lines(self.settings, self.session.messages), Path.home() / "MeasureApp"
        self.controllers.background.run(
            "Saving the log", lambda job: save_support_log(file, texts, folder, job), self._log_saved, quiet=True
        )

    def _log_saved(self, file: Path) -> None:
        self.session.tell(tr("The log is saved to {file}.", file=file), "Send this file to support.", "done")

    def _name_window(self) -> None:
        name = self.session.project_name
        self.setWindowTitle(tr("{name} – MeasureApp", name=name) if name else tr("MeasureApp"))

    def _change_role(self, role: str) -> None:
        roles = self.controllers.roles
        if role == self.session.role:
            return
        (roles.become_operator if role == "operator" else roles.ask_engineer)()

    def _show_role(self) -> None:
        self.header.role.setValue(self.session.role)
