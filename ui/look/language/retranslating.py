"""Change of the language of everything on display, a little at a time so that the window never stalls."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import chain
from weakref import WeakKeyDictionary

from PySide6.QtCore import QEvent, QObject, QSignalBlocker, Qt, QTimer
from PySide6.QtGui import QAction
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QApplication,
    QComboBox,
    QDoubleSpinBox,
    QGroupBox,
    QLabel,
    QLineEdit,
    QMenu,
    QPlainTextEdit,
    QSpinBox,
    QTabBar,
    QWidget,
)

from measureapp.language.translator import Origin
from ui.look.language.words import TRANSLATOR
from ui.look.wording import THIN

AT_ONCE = 150  # widgets between two turns of the event loop; about 20 ms
GIVEN = "given"  # property of boxes whose items are names that people gave, or values
FIRST_ITEM, FIRST_TIP = 1_000, 100_000  # items of a combo box and their tooltips are kept apart from its other texts
ORIGINS: WeakKeyDictionary[QObject, dict[int, tuple[str, Origin]]] = WeakKeyDictionary()
Getter = Callable[[], str]
Setter = Callable[[str], object]


def remember(one: QObject) -> None:
    """Keep what the texts of a widget were translated from, just after it was made: later another English text may have the same one."""
    if TRANSLATOR.catalogue is None:  # English texts are their own sources
        return
    origins = ORIGINS.setdefault(one, {})
    for place, (read, _) in enumerate(_texts(one)):
        bare = read().removeprefix(THIN)
        if (issued := TRANSLATOR.origin(bare)) is not None:
            origins[place] = bare, issued


class Retranslation(QObject):
    """Goes through all widgets and actions, those in sight first; ``finish`` does the rest at once."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._left: Iterator[QObject] = iter(())
        self._timer = QTimer(self)
        self._timer.setInterval(0)
        self._timer.timeout.connect(self._go_on)

    def begin(self) -> None:
        """Begin anew."""
        widgets = sorted(QApplication.allWidgets(), key=lambda one: not one.isVisible())
        own = Qt.FindChildOption.FindDirectChildrenOnly  # each widget is in the list itself
        actions = dict.fromkeys(action for widget in widgets for action in widget.findChildren(QAction, options=own))
        self._left = chain(widgets, actions)
        self._timer.start()

    def finish(self) -> None:
        """Change all texts that are left."""
        while self._timer.isActive():
            self._go_on()

    def _go_on(self) -> None:
        for _ in range(AT_ONCE):
            one = next(self._left, None)
            if one is None:
                self._timer.stop()
                return
            try:
                _renew(one)
            except RuntimeError:  # deleted by Qt since the list was made
                continue


def _renew(one: QObject) -> None:
    for place, (read, write) in enumerate(_texts(one)):
        text = read()
        bare = text.removeprefix(THIN)  # between an icon and its text
        if bare and (new := _renewed(one, place, bare)) != bare:
            write(text[: len(text) - len(bare)] + new)
    if isinstance(one, QComboBox) and not one.property(GIVEN):
        _renew_items(one)
    elif isinstance(one, QAbstractItemView):
        one.viewport().update()
    if isinstance(one, QWidget):
        QApplication.sendEvent(one, QEvent(QEvent.Type.LanguageChange))
        one.update()


def _renew_items(box: QComboBox) -> None:
    with QSignalBlocker(box):
        for place in range(box.count()):
            box.setItemText(place, _renewed(box, FIRST_ITEM + place, box.itemText(place)))
            if tip := box.itemData(place, Qt.ItemDataRole.ToolTipRole):
                box.setItemData(place, _renewed(box, FIRST_TIP + place, tip), Qt.ItemDataRole.ToolTipRole)


def _renewed(one: QObject, place: int, text: str) -> str:
    """Return a text in the chosen language; its own origin counts, as several English texts may have one translation."""
    origins = ORIGINS.setdefault(one, {})
    if place in origins and origins[place][0] == text:
        origin = origins[place][1]
        new = TRANSLATOR.translate(origin.source, origin.values)
    else:
        new = TRANSLATOR.renewed(text)
    if (issued := TRANSLATOR.origin(new)) is not None:
        origins[place] = new, issued
    return new


def _texts(one: QObject) -> Iterator[tuple[Getter, Setter]]:
    """Return how the texts of a widget or action are read and written."""
    if isinstance(one, QAction):
        yield one.text, one.setText
        yield one.toolTip, one.setToolTip
        return
    if not isinstance(one, QWidget):
        return
    yield one.toolTip, one.setToolTip
    yield one.windowTitle, one.setWindowTitle
    yield one.accessibleName, one.setAccessibleName
    yield one.accessibleDescription, one.setAccessibleDescription
    set_words = getattr(one, "set_words", None)
    if set_words is not None:  # elided: what is on display is not the whole text
        yield (lambda: str(getattr(one, "words", ""))), set_words
    elif (isinstance(one, QLabel) and one.textFormat() != Qt.TextFormat.RichText) or isinstance(one, QAbstractButton):
        yield one.text, one.setText
    elif isinstance(one, QLineEdit | QPlainTextEdit):
        yield one.placeholderText, one.setPlaceholderText
    elif isinstance(one, QSpinBox | QDoubleSpinBox):
        yield one.suffix, one.setSuffix
    elif isinstance(one, QGroupBox | QMenu):
        yield one.title, one.setTitle
    elif isinstance(one, QTabBar):
        for place in range(one.count()):
            yield (lambda place=place: one.tabText(place)), (lambda text, place=place: one.setTabText(place, text))  # type: ignore[misc]
