"""The centre of the window: the engineer's pages, or operator mode instead of all of them."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject
from PySide6.QtGui import QGuiApplication, QWindow
from PySide6.QtWidgets import QMainWindow, QStackedWidget, QWidget

from ui.controllers.controllers import Controllers
from ui.controllers.operator_roles import RoleController
from ui.look.look import Look
from ui.pages.operator.locking import EngineerLock
from ui.pages.operator.workspace import OperatorWorkspace
from ui.session import Session

INPUT = {
    QEvent.Type.KeyPress,
    QEvent.Type.MouseButtonPress,
    QEvent.Type.MouseMove,
    QEvent.Type.Wheel,
    QEvent.Type.TouchBegin,
    QEvent.Type.TouchUpdate,
}


class InputWatch(QObject):
    """Tells the roles of every input into a window of the program; installed on windows, not on the widgets in them."""

    def __init__(self, roles: RoleController, parent: QObject) -> None:
        super().__init__(parent)
        self._roles = roles
        application = QGuiApplication.instance()
        assert isinstance(application, QGuiApplication)
        application.focusWindowChanged.connect(self.watch)

    def watch(self, window: QWindow | None) -> None:
        """Watch a window that has got the focus."""
        if window is not None:
            window.removeEventFilter(self)
            window.installEventFilter(self)

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        """Note input; it goes on to the window."""
        if event.type() in INPUT:
            self._roles.note_input()
        return False


class Shell(QStackedWidget):
    """Shows the engineer's centre or the operator's workspace, by the role; the workspace is made when it is first needed."""

    def __init__(self, window: QMainWindow, centre: QWidget, look: Look, session: Session, controllers: Controllers) -> None:
        super().__init__()
        self._window, self._look, self._session, self._controllers = window, look, session, controllers
        self._centre = centre
        self._operator: OperatorWorkspace | None = None
        self._lock: EngineerLock | None = None
        self.addWidget(centre)
        self._watch = InputWatch(controllers.roles, self)
        session.appearanceChanged.connect(self._follow_role)

    @property
    def operator(self) -> OperatorWorkspace:
        """The workspace of operator mode."""
        if self._operator is None:
            self._operator = OperatorWorkspace(self._look, self._session, self._controllers)
            self._lock = EngineerLock(self._window, self._operator)
            self.addWidget(self._operator)
        return self._operator

    @property
    def is_operators(self) -> bool:
        """Whether operator mode is shown."""
        return self.currentWidget() is not self._centre

    def set_up(self) -> None:
        """Show the set-up of operator mode to the engineer."""
        from ui.pages.operator.setup_dialog import OperatorSetupDialog

        self._setup = OperatorSetupDialog(self._look, self._controllers.operator, self._controllers.roles, self._window)
        self._setup.finished.connect(self._setup.deleteLater)
        self._setup.open()

    def close_views(self) -> None:
        """Release the graphics memory."""
        if self._operator is not None:
            self._operator.close_views()

    def _follow_role(self) -> None:
        operators = self._session.role == "operator"
        if operators == self.is_operators:
            return
        workspace = self.operator
        assert self._lock is not None
        if operators:
            self._controllers.operator.stock.take_calibration()
            self._lock.lock()
        else:
            self._lock.unlock()
        self.setCurrentWidget(workspace if operators else self._centre)
