"""New, Open, Recent, Save as, Close; and files that are inspected without a project."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QObject
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QMenu, QWidget

from measureapp.data.length_unit import LengthUnit
from measureapp.errors import MeasureError
from ui.actions.actions import Actions
from ui.controllers.controllers import Controllers
from ui.controllers.files import FileQuestion, FilesToMeasure
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import sentence_case
from ui.session import Session
from ui.settings.dialogs import choose_file, choose_folder, choose_new
from ui.settings.settings import Settings
from ui.widgets.new_project_dialog import NewProjectDialog
from ui.widgets.unit_dialog import UnitDialog

CLOUDS = "Clouds and meshes (*.ply *.stl *.obj *.pcd *.xyz *.txt *.csv *.asc *.pts)"
REFERENCES = "Nominals and inspection programs (*.stl *.ply *.obj *.step *.stp *.toml)"
TEMPLATES = "Templates and part programs (*.mpart)"
PROJECTS = "projects"  # purpose of the folder that holds projects
ENTRIES = (
    "project.new",
    "project.start",
    "project.open",
    "",
    "project.copy",
    "project.template",
    "project.close",
    "",
    "file.inspect",
    "",
    "settings",
    "palette",
    "keys",
    "",
    "exit",
)
SAMPLES = {"gypsum": "gypsum cross, all dimensions pass", "gear": "gear, one dimension is not proven"}
"""Sample projects of `resources/samples`, in words."""
BELOW = "project.open"  # the entry after which recent projects are listed


class ProjectMenu(QObject):
    """Asks which project or file is meant, and leaves the work to the controllers."""

    def __init__(self, look: Look, session: Session, controllers: Controllers, settings: Settings, window: QWidget) -> None:
        super().__init__(window)
        self._look, self._session, self._controllers, self._settings, self._window = look, session, controllers, settings, window
        controllers.files.unitAsked.connect(self._ask_unit)
        self.unit_dialog: UnitDialog | None = None
        self.new_dialog: NewProjectDialog | None = None

    def fill(self, menu: QMenu, actions: Actions) -> None:
        """Offer the commands of a project, and the projects that were opened last."""
        menu.clear()
        for id_ in ENTRIES:
            action = actions.action(id_)
            if action is None:
                menu.addSeparator()
                continue
            words = translated(action.text)
            entry = menu.addAction(f"{words}\t{QKeySequence(action.shortcut).toString()}" if action.shortcut else words)
            reason = actions.reason(action)
            entry.setEnabled(not reason)
            entry.setToolTip(translated(reason))
            entry.triggered.connect(lambda _=False, chosen=id_: actions.perform(chosen))
            if id_ == BELOW:
                self._offer_recent(menu.addMenu(tr("Open recent")))
                self._offer_samples(menu.addMenu(tr("Open a sample")), actions)
        menu.setToolTipsVisible(True)

    def _offer_recent(self, menu: QMenu) -> None:
        projects = self._controllers.project.recent()
        menu.setEnabled(bool(projects))
        menu.setToolTipsVisible(True)
        for folder, name in projects:
            entry = menu.addAction(name.replace("&", "&&"))
            entry.setToolTip(str(folder))
            entry.triggered.connect(lambda _=False, chosen=folder: self._controllers.project.open(chosen))

    def _offer_samples(self, menu: QMenu, actions: Actions) -> None:
        for name, words in SAMPLES.items():
            entry = menu.addAction(translated(sentence_case(words)))
            entry.setEnabled(not self._session.busy_with)
            entry.triggered.connect(lambda _=False, chosen=f"sample.{name}": actions.perform(chosen))

    def new(self) -> None:
        """Ask for name and place of a new project."""
        rig = self._session.rig
        self.new_dialog = NewProjectDialog(self._look, self._settings.folder(PROJECTS), "" if rig is None else rig.name, self._window)
        self.new_dialog.chosen.connect(self._create)
        self.new_dialog.finished.connect(self.new_dialog.deleteLater)
        self.new_dialog.open()

    def _create(self, folder: Path, part: str) -> None:
        self._settings.set_folder(PROJECTS, folder.parent)
        self._controllers.project.create(folder, part)

    def start(self) -> None:
        """Ask for a template, and for the folder of the project that starts from it."""
        if self._session.refuse_during_job():
            return
        template = choose_file(self._window, "Choose a template", TEMPLATES, "templates")
        if template is not None:
            folder = choose_new(self._window, "Create the project in a new folder", template.stem, PROJECTS)
            if folder is not None:
                self._controllers.project.start(template, folder)

    def save_template(self) -> None:
        """Ask for the file of a template of the open project."""
        if self._session.refuse_during_job():
            return
        name = f"{self._session.part or self._session.project_name}.mpart"
        chosen = choose_new(self._window, "Save the project as a template", name, "templates", TEMPLATES)
        if chosen is not None:
            self._controllers.project.save_template(chosen)

    def open(self) -> None:
        """Ask for the folder of a project."""
        if self._session.refuse_during_job():
            return
        chosen = choose_folder(self._window, "Open a project folder", PROJECTS)
        if chosen is not None:
            self._controllers.project.open(chosen)

    def copy(self) -> None:
        """Ask for the folder of a copy."""
        if self._session.refuse_during_job():
            return
        chosen = choose_new(self._window, "Save a copy of the project as", f"{self._session.project_name} copy", PROJECTS)
        if chosen is not None:
            self._controllers.project.copy_to(chosen)

    def close(self) -> None:
        """Close the project."""
        if not self._session.refuse_during_job():
            self._session.open_project("", "", None)

    def inspect_files(self) -> None:
        """Ask for a cloud or mesh, and for what it is compared with."""
        cloud = choose_file(self._window, "Choose the cloud or mesh to inspect", CLOUDS, "clouds")
        if cloud is not None:
            self.inspect(cloud)

    def inspect(self, cloud: Path) -> None:
        """Ask with what a cloud or mesh is compared."""
        reference = choose_file(self._window, "Choose its nominal or inspection program", REFERENCES, "nominals")
        if reference is not None:
            self._controllers.files.measure(FilesToMeasure(cloud, reference))

    def use_program(self, path: Path) -> None:
        """Make a file the inspection program of the project; one that is not valid is refused in words."""
        try:
            self._controllers.programming.replace(path.read_text(encoding="utf-8"))
        except (OSError, UnicodeDecodeError) as error:
            self._session.tell(tr("{name} cannot be read: {error}.", name=path.name, error=error), "Choose another file.", "error")
        except MeasureError as error:
            self._session.tell(f"{path.name}: {error.message}", error.hint, "error")

    def _ask_unit(self, asked: FileQuestion) -> None:
        question, kept = asked.question, "unit" if asked.question.what == "points" else "nominal_unit"
        dialog = UnitDialog(self._look, question.what, question.finding, LengthUnit(question.unit), parent=self._window)
        dialog.chosen.connect(lambda unit: self._controllers.files.measure(replace(asked.files, **{kept: unit})))
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()
        self.unit_dialog = dialog
