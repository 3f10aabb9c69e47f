"""Files and folders dropped on the window: what is going to happen is said before they are let go."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QEvent, QObject, QRectF, Qt
from PySide6.QtGui import QColor, QDragEnterEvent, QDragMoveEvent, QDropEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QMainWindow, QWidget

from ui.actions.actions import ENGINEERS
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.painting import set_letters

CLOUDS = {".ply", ".stl", ".obj", ".pcd", ".xyz", ".txt", ".csv", ".asc", ".pts"}
NOMINALS = {".step", ".stp", ".stl", ".obj"}
LARGEST_TOML_BYTES = 2_000_000
MARGIN = 24
ONE_AT_A_TIME = "Drop one file or folder at a time."


@dataclass(frozen=True)
class Drop:
    """What a dropped file means: words for the outline, and what is done; without ``act`` it is refused."""

    words: str
    act: Callable[[], object] | None = None


@dataclass(frozen=True)
class DropActions:
    """What can be done with files, and what is open."""

    open_project: Callable[[Path], object]
    inspect: Callable[[Path], object]
    set_nominal: Callable[[Path], object]
    set_program: Callable[[Path], object]
    open_plan: Callable[[Path], object]
    open_rig: Callable[[Path], object]
    is_engineer: Callable[[], bool]
    running: Callable[[], str]  # title of the running job
    is_measured: Callable[[], bool]  # a measured project is open, and its program may be changed


def meaning(paths: list[Path], actions: DropActions) -> Drop:
    """Return what dropped files mean at the moment."""
    if not actions.is_engineer():
        return Drop(ENGINEERS)
    if len(paths) != 1:
        return Drop(ONE_AT_A_TIME)
    path, running = paths[0], actions.running()
    if running:
        return Drop(tr("{running} is still running. Wait until it has finished, or cancel it.", running=running))
    if path.is_dir():
        return _folder(path, actions)
    kind = path.suffix.lower()
    if kind in NOMINALS and actions.is_measured():
        return Drop(tr("{name} becomes the nominal of the project", name=path.name), lambda: actions.set_nominal(path))
    if kind in CLOUDS:
        return Drop(tr("{name} is inspected", name=path.name), lambda: actions.inspect(path))
    if kind in NOMINALS:
        return Drop("A STEP file is a nominal. Open a measured project first.")
    if kind == ".toml":
        return _document(path, actions)
    if kind == ".mpart":
        return Drop("Part programs are chosen in operator mode, from the folder of part programs.")
    return Drop(
        tr("MeasureApp cannot use {name}. Drop a project folder, a cloud, a mesh, a nominal, a rig, a plan or a program.", name=path.name)
    )


def _folder(path: Path, actions: DropActions) -> Drop:
    if (path / "project.json").is_file():
        return Drop(tr("The project {name} is opened", name=path.name), lambda: actions.open_project(path))
    return Drop(tr("{name} is not a MeasureApp project.", name=path.name))


def _document(path: Path, actions: DropActions) -> Drop:
    described = toml_content(path)
    if described == "rig":
        return Drop(tr("The rig {name} is chosen", name=path.name), lambda: actions.open_rig(path))
    if described == "plan":
        return Drop(tr("The scan plan {name} is opened", name=path.name), lambda: actions.open_plan(path))
    if described == "program" and actions.is_measured():
        return Drop(tr("{name} becomes the inspection program of the project", name=path.name), lambda: actions.set_program(path))
    if described == "program":
        return Drop("This is an inspection program. Open a measured project first.")
    return Drop(tr("{name} is neither a rig, a scan plan nor an inspection program.", name=path.name))


def toml_content(path: Path) -> str:
    """Return what a TOML file describes, by its tables: "rig", "plan", "program"; empty: none of them."""
    try:
        if path.stat().st_size > LARGEST_TOML_BYTES:
            return ""
        keys = tomllib.loads(path.read_text(encoding="utf-8")).keys()
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError, RecursionError):
        return ""
    if keys & {"cameras", "devices", "projector"}:
        return "rig"
    if keys & {"viewpoints", "viewpoint", "groups", "group"}:
        return "plan"
    return "program" if keys & {"features", "dimensions", "datums", "sections"} else ""


class DropTarget(QObject):
    """Takes what is dropped on a window, and shows an outline with words while it hangs over it."""

    def __init__(self, look: Look, actions: DropActions, window: QMainWindow) -> None:
        super().__init__(window)
        self._actions = actions
        self.outline = Outline(look, window)
        window.setAcceptDrops(True)
        window.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Follow a drag over the window."""
        kind = event.type()
        if isinstance(event, QDropEvent) and kind == QEvent.Type.Drop:
            self._take(event)
            return True
        if isinstance(event, QDragEnterEvent | QDragMoveEvent):
            self._show(event, is_new=kind == QEvent.Type.DragEnter)
            return True
        if kind == QEvent.Type.DragLeave:
            self.outline.hide()
        return super().eventFilter(watched, event)

    def _show(self, event: QDropEvent, *, is_new: bool) -> None:
        """Accept the drag also where the drop is refused, so that the outline can say why."""
        if not event.mimeData().hasUrls():
            event.ignore()
            return
        if is_new:
            found = meaning(_paths(event), self._actions)
            self.outline.tell(found.words, refused=found.act is None)
        event.setDropAction(Qt.DropAction.CopyAction)
        event.accept()

    def _take(self, event: QDropEvent) -> None:
        self.outline.hide()
        found = meaning(_paths(event), self._actions)
        if found.act is None:
            event.ignore()
        else:
            event.setDropAction(Qt.DropAction.CopyAction)
            event.accept()
            found.act()


def _paths(event: QDropEvent) -> list[Path]:
    return [Path(url.toLocalFile()) for url in event.mimeData().urls() if url.isLocalFile()]


class Outline(QWidget):
    """A dashed border over the window, with what is going to happen."""

    def __init__(self, look: Look, window: QWidget) -> None:
        super().__init__(window)
        self._look, self.words, self.refused = look, "", False
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.hide()

    def tell(self, words: str, *, refused: bool) -> None:
        """Show these words."""
        self.words, self.refused = words, refused
        self.setAccessibleName(translated(words))
        self.setGeometry(self.parentWidget().rect())
        self.show()
        self.raise_()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw border and words."""
        theme = self._look.theme
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        veil = QColor(theme.colour("window"))
        veil.setAlpha(200)
        painter.fillRect(self.rect(), veil)
        colour = theme.colour("verdict_fail" if self.refused else "accent")
        painter.setPen(QPen(colour, 3, Qt.PenStyle.DashLine))
        box = QRectF(self.rect()).adjusted(MARGIN, MARGIN, -MARGIN, -MARGIN)
        painter.drawRoundedRect(box, theme.sizes["corner"], theme.sizes["corner"])
        set_letters(painter, theme.sizes["heading"], bold=True)
        painter.setPen(theme.colour("text"))
        painter.drawText(
            box.adjusted(MARGIN, 0, -MARGIN, 0), int(Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap), translated(self.words)
        )
