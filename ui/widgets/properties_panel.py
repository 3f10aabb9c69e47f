"""Panel with the properties of the selection."""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import QEvent, Qt, Signal, SignalInstance
from PySide6.QtWidgets import QApplication, QFrame, QGridLayout, QLabel, QScrollArea, QVBoxLayout, QWidget

from ui.look.language.words import translated
from ui.look.look import Look
from ui.widgets.basic import Button, clear, column, label, row


@dataclass(frozen=True)
class Group:
    """Properties under one heading."""

    heading: str
    rows: tuple[tuple[str, str], ...]  # name and value; without a name, the value has the whole width


@dataclass(frozen=True)
class Properties:
    """Properties of one object, with actions."""

    title: str
    groups: tuple[Group, ...] = ()
    note: str = ""
    action: str = ""  # label of a button below the properties
    decision: str = ""  # label of a button above the properties


BUTTON_MARGINS = 80  # of the panel, the scroll bar and the button
FOLDED_WIDTH = 48


class PropertiesPanel(QFrame):
    """Shows `Properties`; can be folded to the edge."""

    actionClicked = Signal()
    decisionClicked = Signal()

    def __init__(self, look: Look, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("properties")
        self._look = look
        self._width = look.theme.sizes["properties"]
        self._button = Button("", look, "fold", "quiet", "Fold or unfold the properties")
        self._button.setFixedSize(32, 32)
        self._button.clicked.connect(self.toggle)
        self.title = label("Properties", "heading", wrap=True)
        self._body = QWidget()
        self._body.setObjectName("clear")
        self._rows = QVBoxLayout(self._body)
        self._rows.setContentsMargins(16, 8, 16, 16)
        self._rows.setSpacing(4)
        self._scroll = QScrollArea()
        self._scroll.setWidgetResizable(True)
        self._scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._scroll.setWidget(self._body)
        top = row(self.title, self._button)
        top.setContentsMargins(16, 8, 8, 0)
        top.setAlignment(self._button, Qt.AlignmentFlag.AlignTop)
        self.setLayout(column(top, self._scroll, spacing=0))
        self.setFixedWidth(self._width)
        self.shown = Properties("Properties")
        self._values: list[QLabel] = []  # the note, then the values
        self._buttons: list[Button] = []  # of the decision and the action, if there are any
        self._shape: tuple[object, ...] = ()  # of the rows
        self._missed: Properties | None = None  # shown while folded, not laid out yet

    @property
    def folded(self) -> bool:
        """Whether the panel is folded to the edge."""
        return self.maximumWidth() == FOLDED_WIDTH

    def toggle(self) -> None:
        """Fold or unfold."""
        self.fold(not self.folded)

    def fold(self, fold: bool) -> None:
        """Fold to the edge, or unfold."""
        self.setFixedWidth(FOLDED_WIDTH if fold else self._width)
        self._scroll.setVisible(not fold)
        self.title.setVisible(not fold)
        self._button.set_icon("unfold" if fold else "fold")
        if not fold and self._missed is not None:
            self._lay_out(self._missed)
            self._rows.activate()
            QApplication.sendEvent(self._body, QEvent(QEvent.Type.LayoutRequest))  # else the rows are squeezed for a moment

    def show_properties(self, properties: Properties) -> None:
        """Show these properties; while folded, when they are unfolded."""
        self.shown = properties
        self.title.setText(translated(properties.title))
        if self.folded:
            self._missed = properties
        else:
            self._lay_out(properties)

    def _lay_out(self, properties: Properties) -> None:
        """Make the rows; where only values differ from those before, none is made anew."""
        same = _shape(properties) == self._shape and bool(self._values)
        self._shape, self._missed = _shape(properties), None
        if same:
            for shown, words in zip(self._values, _values(properties), strict=True):
                shown.setText(translated(words))
            for button, words in zip(self._buttons, _offers(properties), strict=True):
                self._name(button, words)
            return
        clear(self._rows)
        self._buttons = []
        self._values = [label(properties.note, "soft", wrap=True)] if properties.note else []
        for note in self._values:
            self._rows.addWidget(note)
        self._offer(properties.decision, self.decisionClicked)
        for group in properties.groups:
            self._rows.addSpacing(12)
            self._rows.addWidget(label(group.heading, "caption"))
            self._rows.addWidget(_hairline())
            self._rows.addLayout(_grid(group, self._values))
        self._offer(properties.action, self.actionClicked)
        self._rows.addStretch(1)

    def _offer(self, words: str, clicked: SignalInstance) -> None:
        if words:
            button = Button(words, self._look)
            self._name(button, words)
            self._buttons.append(button)
            button.clicked.connect(clicked)
            self._rows.addSpacing(8)
            self._rows.addWidget(button)

    def _name(self, button: Button, words: str) -> None:
        """Write on a button what it does, with names shortened to its width; its tooltip has all of it."""
        full = translated(words)
        button.setText(button.fontMetrics().elidedText(full, Qt.TextElideMode.ElideRight, self._width - BUTTON_MARGINS))
        button.setToolTip(full if button.text() != full else "")
        button.setAccessibleName(full)


def _hairline() -> QFrame:
    line = QFrame()
    line.setObjectName("hairline")
    line.setFixedHeight(1)
    return line


def _shape(properties: Properties) -> tuple[object, ...]:
    """Return what decides about the rows: everything but title, note, values and the words of buttons."""
    names = tuple((group.heading, tuple(name for name, _ in group.rows)) for group in properties.groups)
    return names, bool(properties.note), bool(properties.action), bool(properties.decision)


def _offers(properties: Properties) -> list[str]:
    """Return the words of the buttons in their order."""
    return [words for words in (properties.decision, properties.action) if words]


def _values(properties: Properties) -> list[str]:
    """Return the texts of the labels that keep their places: the note, then the values."""
    return [*([properties.note] if properties.note else []), *(value for group in properties.groups for _, value in group.rows)]


def _grid(group: Group, values: list[QLabel]) -> QGridLayout:
    """Return the rows of a group, and add the labels of their values to ``values``."""
    grid = QGridLayout()
    grid.setHorizontalSpacing(16)
    grid.setVerticalSpacing(4)
    for place, (name, value) in enumerate(group.rows):
        if not name:
            values.append(label(value, wrap=True))
            grid.addWidget(values[-1], place, 0, 1, 2)
            continue
        shown = QLabel(translated(value))
        values.append(shown)
        shown.setTextFormat(Qt.TextFormat.PlainText)  # names come from files
        shown.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignTop)
        shown.setWordWrap(True)
        shown.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        named = label(name, "soft", wrap=True)
        named.setAlignment(Qt.AlignmentFlag.AlignTop)
        grid.addWidget(named, place, 0)
        grid.addWidget(shown, place, 1)
    grid.setColumnStretch(0, 1)
    grid.setColumnStretch(1, 1)
    return grid
