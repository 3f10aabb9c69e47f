"""The header bar: project, state of the rig, role."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QMenu, QWidget

from ui.look.language.words import translated
from ui.look.look import Look
from ui.widgets.basic import PART, Button, ElidedLabel, TailLabel, column, row
from ui.widgets.segments import Segments

ROOM_FOR_WORDS = 1400  # px


class Chip(QFrame):
    """Shows one state by text and icon colour."""

    def __init__(self, look: Look, icon: str, text: str = "") -> None:
        super().__init__()
        self.setObjectName("chip")
        self.setFixedHeight(32)
        self._look, self._icon_name, self._colour = look, icon, "soft"
        self._icon, self._text = QLabel(), TailLabel(text)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(12, 0, 12, 0)
        layout.setSpacing(8)
        layout.addWidget(self._icon)
        layout.addWidget(self._text)
        look.changed.connect(self._redraw)
        self._redraw()

    def text(self) -> str:
        """Return the whole text."""
        return self._text.words

    def show_state(self, text: str, colour: str = "soft", tip: str = "") -> None:
        """Set text, icon colour and tooltip."""
        self._text.set_words(text)
        self._colour = colour
        self.setToolTip(translated("\n".join(line for line in (text, tip) if line) if PART in text else tip))
        self._redraw()

    def _redraw(self) -> None:
        self._icon.setPixmap(self._look.icon(self._icon_name, self._colour).pixmap(QSize(18, 18)))


class HeaderBar(QFrame):
    """Project and part on the left, chips in the middle, role and theme on the right."""

    fileClicked = Signal()
    helpClicked = Signal()
    themeClicked = Signal()
    stopClicked = Signal()
    operatorSetupClicked = Signal()

    def __init__(self, look: Look, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("header")
        self.setFixedHeight(look.theme.sizes["header"])
        self._look = look
        self.project, self.part = ElidedLabel("No project open", "heading"), ElidedLabel("", "small")
        self.devices = Chip(look, "devices", "Loading devices…")
        self.calibration = Chip(look, "calibration", "Not calibrated")
        self.disk = Chip(look, "disk")
        self.role = Segments({"operator": "Operator", "engineer": "Engineer"})
        self.role.setValue("engineer")
        self.open = Button("Project", look, "open", "quiet", "New, open, copy or close a project; settings; exit")
        self.menu = QMenu(self)
        self.open.setMenu(self.menu)
        self.open.allow_compact()
        self.file = Button("", look, "file", "quiet", "Inspect a cloud or mesh from a file, against a nominal or by a program")
        self.file.clicked.connect(self.fileClicked)
        self.stop = Button("Stop", look, "stop", "stop", "Stop all axes, lamps and cameras (Esc). This is no safety function.")
        self.stop.clicked.connect(self.stopClicked)
        self.stop.hide()
        self.operator_setup = Button("", look, "person", "quiet", "Set up operator mode: PIN, folders, shifts")
        self.operator_setup.clicked.connect(self.operatorSetupClicked)
        self._shade = Button("", look, "dark", "quiet", "Change between the light and the dark theme")
        self._shade.clicked.connect(self.themeClicked)
        self._help = Button("", look, "help", "quiet", "Help for this page (F1)")
        self._help.clicked.connect(self.helpClicked)
        names = column(0, self.project, self.part, 0, spacing=0)
        layout = row(
            names,
            16,
            self.stop,
            self.devices,
            self.calibration,
            self.disk,
            8,
            self.open,
            self.file,
            self.role,
            self.operator_setup,
            self._shade,
            self._help,
        )
        layout.setContentsMargins(24, 0, 16, 0)
        layout.setStretch(0, 1)
        layout.setAlignment(Qt.AlignmentFlag.AlignVCenter)
        self.setLayout(layout)
        look.changed.connect(self._redraw)
        self._redraw()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Shorten the widest button where there is little room."""
        super().resizeEvent(event)
        self.open.set_compact(self.width() < ROOM_FOR_WORDS)

    def show_project(self, name: str, part: str) -> None:
        """Show project and part."""
        self.project.set_words(name or "No project open")
        self.part.set_words(part)
        self.part.setVisible(bool(part))

    def _redraw(self) -> None:
        self._shade.set_icon("light" if self._look.theme.shade == "dark" else "dark")
