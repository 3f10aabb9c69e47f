"""First step: which board is shown, and where its images come from."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QSpinBox, QWidget

from measureapp.data.board import BoardDescription
from ui.controllers.collecting_nouns import RigSetup, Start, StoredSession
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import several, when
from ui.widgets.basic import Button, Form, card, column, label, row, scrolled
from ui.widgets.board_form import BoardForm
from ui.widgets.path_field import PathField
from ui.widgets.segments import Segments

if TYPE_CHECKING:
    from measureapp.calibrate.draft.draft import Kind

RIG, IMAGES = "rig", "images"
VIRTUAL_HINT = "A simulated rig with hidden errors. The result page shows the true values beside the estimates."
REAL_HINT = "The robot brings the cameras to the board. Fix the board on the table first, and keep the cell clear."
TABLES_HINT = (
    "One line per position of the board, in the order of the images. "
    "A folder in which a project keeps its views of the board needs no tables: it holds where the axes stood."
)
TABLES = {  # axis -> name, columns
    "base_from_flange": ("Robot poses", "name,x_mm,y_mm,z_mm,qw,qx,qy,qz"),
    "guide_mm": ("Guide positions", "name,position_mm"),
    "table_rad": ("Table angles", "position,angle_deg"),
}
TABLE_FILES = "Tables (*.csv);;All files (*)"
KEPT_TIP = "The wizard shows what is missing while you collect, and saves every view at once."


class SetupPage(QWidget):
    """Edits a `Start`; offers to continue a stored session."""

    resumeClicked = Signal()
    changed = Signal()

    def __init__(self, look: Look, kind: Kind) -> None:
        super().__init__()
        self._kind = kind
        self.source = Segments({RIG: "From the rig", IMAGES: kind.words.recorded})
        self.source.valueChanged.connect(self._show_source)
        self.board = BoardForm()
        self.board.edited.connect(self.changed)
        self.folder = PathField(look, "Folder with images of the board", "Folder with the images", "board images")
        self.folder.valueChanged.connect(self.changed)
        self.tables = {axis: PathField(look, *TABLES[axis], "tables", files=TABLE_FILES) for axis in kind.readback_in_rig}
        self.resolution = Segments({"quarter": "Quarter", "half": "Half", "full": "Full"})
        self.seed = QSpinBox()
        self.seed.setRange(1, 9999)
        self._virtual = True
        self._lay_out(look)
        self._show_source()

    def _lay_out(self, look: Look) -> None:
        self._kept_words = label("", "body", wrap=True)
        go_on = Button("Continue it", look, "run")
        go_on.clicked.connect(self.resumeClicked)
        kept_row = row(self._kept_words, go_on, spacing=16)
        kept_row.setStretch(0, 1)
        self.kept = card(kept_row, margin=12)
        self.kept.hide()
        self._rig_name, self._rig_note = label("", "strong"), label("", "small", wrap=True)
        form = Form()
        form.add("Resolution", self.resolution)
        form.add("Seed of the rig", self.seed)
        self._virtual_form = QWidget()
        self._virtual_form.setLayout(form)
        self._rig_part = QWidget()
        self._rig_part.setLayout(column(self._rig_name, self._rig_note, 8, self._virtual_form))
        self._images_part = QWidget()
        self._images_part.setLayout(column(self.folder, label(self._kind.words.folder, "small", wrap=True), *self._table_part()))
        source = card(label("Images", "heading"), 4, row(self.source, 0), 8, self._rig_part, self._images_part, 0, margin=20)
        board = card(label("Board", "heading"), 4, self.board, 0, margin=20)
        both = row(source, board, spacing=16)
        both.setStretch(0, 1)
        both.setStretch(1, 1)
        tips = card(
            label("Good views", "heading"),
            *(label(tr("•  {tip}", tip=tip), "body", wrap=True) for tip in (*self._kind.words.hints, KEPT_TIP)),
            margin=20,
        )
        content = QWidget()
        content.setObjectName("clear")
        content.setLayout(column(label(self._kind.words.purpose, "body", wrap=True), self.kept, both, tips, 0, spacing=12))
        self.setLayout(column(scrolled(content)))  # fields for several tables are higher than the smallest window

    def _table_part(self) -> list[QWidget]:
        """The tables of axis positions at recorded images."""
        if not self.tables:
            return []
        form = Form()
        form.setContentsMargins(0, 8, 0, 0)
        for axis, field in self.tables.items():
            form.add(TABLES[axis][0], field)
        fields = QWidget()
        fields.setLayout(form)
        return [fields, label(TABLES_HINT, "small", wrap=True)]

    def offer_rig(self, rig: RigSetup) -> None:
        """Show the rig that can take the images, and start with its board."""
        self._virtual = rig.virtual
        self._rig_name.setText(translated(rig.name))
        self._rig_note.setText(translated(VIRTUAL_HINT) if rig.virtual else translated(REAL_HINT))
        self._virtual_form.setVisible(rig.virtual and not rig.fixed)
        self.resolution.setValue(rig.resolution)
        self.seed.setValue(rig.seed)
        self.board.setValue(rig.board)

    def offer_kept(self, kept: StoredSession | None) -> None:
        """Offer to go on with views that were kept, where there are any."""
        self.kept.setVisible(kept is not None)
        if kept is not None:
            age = when(kept.saved)
            self._kept_words.setText(
                tr("{count} of an earlier session are kept{words}.", count=several(kept.views, "view"), words=f" ({age})" if age else "")
            )

    def value(self) -> Start:
        """Return the settings. Raises ValueError where the board's sizes contradict each other."""
        board: BoardDescription = self.board.value()
        folder = self.folder.value() if self.source.value() == IMAGES else None
        tables = {axis: path for axis, field in self.tables.items() if (path := field.value()) is not None}
        return Start(board, folder, self.resolution.value(), self.seed.value(), tables)

    def problem(self) -> str:
        """Return the reason why the wizard cannot begin yet; empty where it can."""
        if self.board.problem():
            return "Check the board"
        if self.source.value() == IMAGES and self.folder.value() is None:
            return "Choose a folder"
        return ""

    def _show_source(self) -> None:
        images = self.source.value() == IMAGES
        self._images_part.setVisible(images)
        self._rig_part.setVisible(not images)
        self.changed.emit()
