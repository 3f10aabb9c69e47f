"""Keys on the screen, for touch screens whose system offers none: letters and digits of at least 48 px."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QGuiApplication, QKeyEvent, QMouseEvent, QPointerEvent, QPointingDevice
from PySide6.QtWidgets import QApplication, QFrame, QLineEdit, QSizePolicy, QWidget

from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.pages.operator.big import BigButton
from ui.widgets.basic import column, row

ROWS = ("1234567890-", "QWERTYUIOP/", "ASDFGHJKL_.", "ZXCVBNM,:")
HEIGHT_PX, GAP_PX = 52, 6
SPACE, ERASE, SHIFT, DONE = " ", "⌫", "⇧", "\r"
SPECIAL = {ERASE: Qt.Key.Key_Backspace, DONE: Qt.Key.Key_Return}


class TouchKeyboard(QFrame):
    """Types into the field that has the focus; keys go to it directly, so that the bar-code scanner takes none of them for a code."""

    doneClicked = Signal()

    def __init__(self, look: Look) -> None:
        super().__init__()
        self.setObjectName("operator-strip")
        self.keys: dict[str, BigButton] = {}
        lines = [row(*(self._key(letter, letter, look) for letter in letters), spacing=GAP_PX) for letters in ROWS]
        lines[0].addWidget(self._key(ERASE, ERASE, look))
        self.keys[ERASE].setAccessibleName(tr("Delete the last letter"))
        shift = self._key(SHIFT, SHIFT, look)
        shift.setCheckable(True)
        shift.setChecked(True)
        shift.setAccessibleName(tr("Capital letters"))
        shift.toggled.connect(self._show_case)
        lines[3].insertWidget(0, shift)
        lines[3].addWidget(self._key(SPACE, "Space", look), 2)
        lines[3].addWidget(self._key(DONE, "Enter", look), 2)
        self.hide_button = BigButton("Hide", look, "", "key")
        self._fit(self.hide_button)
        self.hide_button.clicked.connect(self.doneClicked)
        lines[3].addWidget(self.hide_button, 1)
        for place in range(1 + len(ROWS[3])):
            lines[3].setStretch(place, 1)
        layout = column(*lines, spacing=GAP_PX)
        layout.setContentsMargins(24, 8, 24, 8)
        self.setLayout(layout)
        self.hide()

    def _key(self, key: str, words: str, look: Look) -> BigButton:
        made = self.keys[key] = BigButton(words, look, "", "key")
        self._fit(made)
        made.clicked.connect(lambda: self._type(key))  # each press counts, however fast
        return made

    def _fit(self, button: BigButton) -> None:
        button.setProperty("low", True)
        button.setFocusPolicy(Qt.FocusPolicy.NoFocus)  # the field keeps it
        button.setMinimumSize(HEIGHT_PX, HEIGHT_PX)
        button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    def _type(self, key: str) -> None:
        target = QApplication.focusWidget()
        if key == SHIFT or not isinstance(target, QLineEdit):
            return
        code = SPECIAL.get(key, Qt.Key.Key_unknown)
        text = "" if key in SPECIAL else key if self.keys[SHIFT].isChecked() else key.lower()
        for kind in (QEvent.Type.KeyPress, QEvent.Type.KeyRelease):
            QApplication.sendEvent(target, QKeyEvent(kind, code, Qt.KeyboardModifier.NoModifier, text))

    def _show_case(self, capital: bool) -> None:
        for key, button in self.keys.items():
            if key.isalpha():
                button.setText(translated(key) if capital else translated(key.lower()))


class KeyboardCaller(QObject):
    """Shows the keys when a field is touched by a finger, and hides them when the system shows its own, or no field has the focus."""

    def __init__(self, workspace: QWidget, keyboard: TouchKeyboard) -> None:
        super().__init__(workspace)
        self._workspace, self._keyboard = workspace, keyboard
        keyboard.doneClicked.connect(keyboard.hide)
        QGuiApplication.inputMethod().visibleChanged.connect(self._follow_system)
        application = QApplication.instance()
        assert isinstance(application, QApplication)
        application.focusChanged.connect(self._follow_focus)
        for field in workspace.findChildren(QLineEdit):
            field.installEventFilter(self)

    def toggle(self) -> None:
        """Show or hide the keys; they are shown for the field that has the focus, else for the first one, and only where there is one."""
        fields = [field for field in self._workspace.findChildren(QLineEdit) if field.isVisible() and field.isEnabled()]
        if self._keyboard.isVisible() or not fields:
            self._keyboard.hide()
            return
        if QApplication.focusWidget() not in fields:
            fields[0].setFocus()
        self._keyboard.show()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Note a finger on a field; the event goes on to it."""
        by_finger = event.type() == QEvent.Type.TouchBegin or (
            event.type() == QEvent.Type.MouseButtonPress and isinstance(event, QMouseEvent) and _is_finger(event)
        )
        if by_finger and isinstance(watched, QLineEdit) and not QGuiApplication.inputMethod().isVisible():
            self._keyboard.show()
        return False

    def _follow_system(self) -> None:
        if QGuiApplication.inputMethod().isVisible():
            self._keyboard.hide()

    def _follow_focus(self, _before: QWidget | None, now: QWidget | None) -> None:
        if now is not None and not (isinstance(now, QLineEdit) and self._workspace.isAncestorOf(now)):
            self._keyboard.hide()


def _is_finger(event: QPointerEvent) -> bool:
    return event.pointerType() == QPointingDevice.PointerType.Finger
