"""All controllers of the window, built once."""

from __future__ import annotations

from PySide6.QtCore import QObject

from ui.controllers.demo import DemoController
from ui.controllers.documents import DocumentsController
from ui.controllers.jobs import JobRunner
from ui.controllers.project import ProjectController
from ui.controllers.startup import StartupController
from ui.session import Session


class Controllers(QObject):
    """What the user can do."""

    def __init__(self, session: Session, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.jobs = JobRunner(session, self)
        self.background = JobRunner(session, self)
        self.demo = DemoController(session, self.jobs, self)
        self.project = ProjectController(session, self.jobs, self)
        self.documents = DocumentsController(session, self.jobs, self)
        self.startup = StartupController(session, self.background, self)
