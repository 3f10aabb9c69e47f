"""Report documents: page images for the preview, opening and export."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QUrl, Signal, Slot
from PySide6.QtGui import QDesktopServices, QImage

from measureapp.errors import InputError
from measureapp.language.languages import ENGLISH
from ui.controllers.jobs import JobRunner
from ui.controllers.report_header import ReportHeader, read_header, save_header
from ui.look.language.words import tr
from ui.session import Session

if TYPE_CHECKING:
    from measureapp.data.cloud import StitchedCloud
    from measureapp.data.measurement import Measurement
    from measureapp.report.model import ReportModel
    from ui.workers.job import Job

FORMATS = {  # words, ending
    "pdf": ("PDF report", "pdf"),
    "html": ("3-D report (HTML)", "html"),
    "xlsx": ("Dimensions (XLSX)", "xlsx"),
    "csv": ("Dimensions (CSV)", "csv"),
    "json": ("Everything as JSON", "json"),
    "ply": ("Stitched cloud (PLY)", "ply"),
    "stl": ("Surface mesh (STL)", "stl"),
    "open": ("Open patch (STL)", "stl"),
}
DOCUMENTS = ("pdf", "html", "xlsx", "csv", "json")


class DocumentsController(QObject):
    """Shows, opens and exports the results of a measurement."""

    pagesReady = Signal(object)  # tuple of QImage
    pagesFailed = Signal()
    headerReady = Signal(object)  # ReportHeader

    def __init__(self, session: Session, runner: JobRunner, drawing: JobRunner, parent: QObject | None = None) -> None:
        """``drawing``: draws the pages, also while another job runs."""
        super().__init__(parent)
        self._session = session
        self._runner, self._drawing = runner, drawing

    @property
    def _is_stored(self) -> bool:
        """Whether the open project is one on disk."""
        folder = self._session.folder
        return folder is not None and (folder / "project.json").exists()

    @property
    def can_open_pdf(self) -> bool:
        """Whether the PDF is there, or can be written to the project."""
        return "report_pdf" in self._session.files or self._is_stored

    def can_export(self, kind: str) -> bool:
        """Return whether the measurement has something of a kind of `FORMATS`."""
        measurement = self._session.measurement
        return measurement is not None and (kind != "stl" or measurement.mesh is not None)

    @Slot()
    def preview(self) -> None:
        """Draw the pages of the report."""
        measurement, folder = self._session.measurement, self._session.folder
        if measurement is not None:
            self._drawing.run(
                "Rendering the report",
                lambda job: (measurement, page_images(measurement, folder, job)),
                self._show_pages,
                on_stopped=self._no_pages,
                quiet=True,
            )

    @Slot(object)
    def _show_pages(self, drawn: tuple[Measurement, tuple[QImage, ...]]) -> None:
        if drawn[0] is self._session.measurement:  # else those of the present one follow
            self.pagesReady.emit(drawn[1])

    @Slot()
    def _no_pages(self) -> None:
        self.pagesFailed.emit()

    @Slot()
    def ask_header(self) -> None:
        """Read what the header states, to be edited; `headerReady` follows."""
        folder = self._session.folder
        if folder is not None and not self._session.refuse_during_job():
            self._runner.run("Reading the report header", lambda job: read_header(folder, job), self._show_header, quiet=True)

    @Slot(object)
    def _show_header(self, header: ReportHeader) -> None:
        self.headerReady.emit(header)

    @Slot(object)
    def set_header(self, header: ReportHeader) -> None:
        """Store header and template, and draw the pages again."""
        folder, measurement = self._session.folder, self._session.measurement
        if folder is not None:
            self._runner.run("Saving the report header", lambda job: save_header(folder, header, measurement, job), self._header_saved)

    @Slot(object)
    def _header_saved(self, _nothing: object) -> None:
        self.preview()

    def set_language(self, name: str) -> bool:
        """Choose the language of reports, write the project's documents in it, and draw the pages again; return whether it was done."""
        session = self._session
        if session.refuse_during_job():
            return False
        session.settings.set_text("report_language", name)
        folder, measurement = session.folder, session.measurement
        if measurement is not None and folder is not None and self._is_stored:
            self._runner.run("Writing the report", lambda job: save_documents(folder, measurement, job), self._language_changed)
        else:
            self.preview()
        return True

    @Slot(object)
    def _language_changed(self, files: dict[str, Path]) -> None:
        self._session.files = {**self._session.files, **files}
        self.preview()

    @Slot()
    def open_pdf(self) -> None:
        """Open the PDF in the default viewer."""
        path, folder, measurement = self._session.files.get("report_pdf"), self._session.folder, self._session.measurement
        if measurement is not None and folder is not None and self._is_stored and not _is_current(path, self._session.report_language):
            if not self._session.refuse_during_job():
                self._runner.run("Writing the report", lambda job: save_documents(folder, measurement, job), self._open_written)
        elif path is None or not path.exists():
            self._session.tell("There is no PDF report yet.", "Run the demo, or recompute the project.", "warning")
        else:
            self._open(path)

    @Slot(object)
    def _open_written(self, files: dict[str, Path]) -> None:
        self._session.set_files({**self._session.files, **files})
        self._open(files["report_pdf"])

    def _open(self, path: Path) -> None:
        if not QDesktopServices.openUrl(QUrl.fromLocalFile(str(path))):
            self._session.tell("No PDF viewer is installed.", tr("The report is saved to {path}.", path=path), "warning")

    @Slot()
    def open_folder(self) -> None:
        """Show the project's folder in the file manager."""
        folder = self._session.folder
        if folder is not None and not QDesktopServices.openUrl(QUrl.fromLocalFile(str(folder))):
            self._session.tell("The file manager could not be opened.", tr("The project is saved to {folder}.", folder=folder), "warning")

    @Slot(str, object)
    def export(self, kind: str, target: Path) -> None:
        """Write one document to ``target``; refused while a job runs, after which there may be another measurement."""
        measurement = self._session.measurement
        if self._session.refuse_during_job():
            return
        if measurement is None:
            self._session.tell("There is no measurement yet.", "Run the demo, or open a project.", "warning")
            return
        folder = self._session.folder
        cloud = self._session.filtered or measurement.stitched
        work = (
            (lambda job: export_open(cloud, target, job))
            if kind == "open"
            else (lambda job: export_document(kind, folder, measurement, target, job))
            if kind in DOCUMENTS
            else (lambda job: export(kind, measurement, target, job))
        )
        self._runner.run(tr("Exporting {name}", name=target.name), work, self._report_export)

    @Slot(object)
    def _report_export(self, target: Path) -> None:
        self._session.tell(tr("{name} saved to {parent}.", name=target.name, parent=target.parent), "", "done")


def _is_current(pdf: Path | None, language: str) -> bool:
    """Whether the PDF of a project is there, in this language; the JSON document beside it tells."""
    if pdf is None or not pdf.exists():
        return False
    try:
        return json.loads(pdf.with_suffix(".json").read_text(encoding="utf-8")).get("language", ENGLISH) == language
    except (OSError, ValueError):
        return False


def page_images(measurement: Measurement, folder: Path | None, job: Job) -> tuple[QImage, ...]:
    """Return the report's pages; runs on a job's thread, also what unpacks them, which takes 20 ms a page."""
    job.report(0, 2, "Rendering the pages")
    from measureapp.report.pdf import page_images as pages_of

    model = _model(folder, measurement, job.language)
    job.report(1, 2, "Rendering the pages")
    return tuple(QImage.fromData(page) for page in pages_of(model))


def _model(folder: Path | None, measurement: Measurement, language: str, progress: Job | None = None) -> ReportModel:
    """Return the report as it is now, of the measurement alone where its project is not stored, or gone."""
    from measureapp.progress import NoProgress
    from measureapp.project.folder import ProjectFolder
    from measureapp.report.compose import compose
    from measureapp.report.model import Details
    from measureapp.report.project import compose_project

    if folder is None or not (folder / "project.json").exists():
        return compose(measurement, details=Details(language=language))
    return compose_project(ProjectFolder.open(folder), measurement, language=language, progress=progress or NoProgress())


def export_document(kind: str, folder: Path | None, measurement: Measurement, target: Path, job: Job) -> Path:
    """Write one document of the report as it is now; runs on a job's thread."""
    job.report(0, 1, target.name)
    from measureapp.report.documents import write_document

    return write_document(_model(folder, measurement, job.language, job), kind, target)  # type: ignore[arg-type]


def save_documents(folder: Path, measurement: Measurement, job: Job) -> dict[str, Path]:
    """Write the project's documents, and return the files of the measurement; runs on a job's thread."""
    job.report(0, 1, "Documents")
    from measureapp.pipeline.documents import write_reports
    from measureapp.project.folder import ProjectFolder

    return write_reports(ProjectFolder.open(folder), measurement, job.language)


def export(kind: str, measurement: Measurement, target: Path, job: Job) -> Path:
    """Write one document; runs on a job's thread."""
    job.report(0, 1, target.name)
    from measureapp.project.geometry.files import write_cloud, write_mesh

    if kind == "ply":
        write_cloud(target, measurement.stitched)
    elif kind == "stl" and measurement.mesh is not None:
        write_mesh(target, measurement.mesh)
    elif kind == "stl":
        raise InputError("This measurement has no surface mesh.", "Recompute the project to create one.")
    return target


def export_open(cloud: StitchedCloud, target: Path, job: Job) -> Path:
    """Write the triangulation of one open patch; runs on a job's thread. Raises RegistrationError for other surfaces."""
    from measureapp.project.geometry.files import write_mesh
    from measureapp.register.surface.open import triangulate_open_patch

    write_mesh(target, triangulate_open_patch(cloud, job))
    return target
