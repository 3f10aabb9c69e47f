"""Editors of single values: text, number, yes or no, choice, optional value, several numbers, a table of settings.

Each has `raw()`, `set_raw(value)` and `edited`; `raw()` is what was entered, valid or not.
"""

from __future__ import annotations

import json
import tomllib
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import tomli_w
from pydantic import BaseModel, SecretStr
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QCheckBox, QLineEdit, QPlainTextEdit, QWidget

from ui.look.language.retranslating import GIVEN
from ui.look.language.words import tr, translated
from ui.widgets.basic import CalmComboBox, column, label, row

NUMBER_WIDTH, TUPLE_WIDTH, TEXT_HEIGHT, LINE_HEIGHT, FRAME = 144, 88, 200, 20, 20
PARAGRAPH = "\u2029"
INVALID = "Write one setting per line, as TOML: name = value. Texts are in quotation marks"


class FieldEditor(QWidget):
    """Base of the editors; it keeps a value as it is."""

    edited = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._kept: Any = None

    def raw(self) -> Any:
        """Return what was entered."""
        return self._kept

    def set_raw(self, value: Any) -> None:
        """Show a value."""
        self._kept = value

    def place_problem(self, place: tuple[int | str, ...], words: str) -> bool:
        """Show a problem inside the editor; return whether that was possible."""
        del place, words
        return False

    def clear_problems(self) -> None:
        """Show no problem."""

    def unfold(self) -> None:
        """Show all of a value that is folded."""


class KeptEditor(FieldEditor):
    """Shows a value that is too complex to be edited here, as JSON; it is saved as it is."""

    def __init__(self) -> None:
        super().__init__()
        self.text = _text_area("")
        self.text.setReadOnly(True)
        self.setLayout(column(self.text))

    def set_raw(self, value: Any) -> None:
        """Show a value."""
        super().set_raw(value)
        self.text.setPlainText(json.dumps(value, indent=1, ensure_ascii=False, default=_readable))
        _fit(self.text)


class TextEditor(FieldEditor):
    """A text, or a password."""

    def __init__(self, *, secret: bool = False) -> None:
        super().__init__()
        self.line = QLineEdit()
        if secret:
            self.line.setEchoMode(QLineEdit.EchoMode.Password)
        self.line.textEdited.connect(self.edited)
        self.setLayout(row(self.line))

    def raw(self) -> str:
        """Return the text."""
        return self.line.text()

    def set_raw(self, value: Any) -> None:
        """Show a text."""
        self.line.setText(translated(value.get_secret_value()) if isinstance(value, SecretStr) else "" if value is None else str(value))
        self.line.setCursorPosition(0)


class NumberEditor(FieldEditor):
    """A number with its unit; a text that is no number is passed on as it is."""

    def __init__(self, unit: str = "") -> None:
        super().__init__()
        self.line = _number_line(NUMBER_WIDTH)
        self.line.textEdited.connect(self.edited)
        self.setLayout(row(self.line, label(unit, "soft"), 0))

    def raw(self) -> int | float | str:
        """Return the number."""
        return _number(self.line.text())

    def set_raw(self, value: Any) -> None:
        """Show a number."""
        self.line.setText(translated(_digits(value)))


class NumbersEditor(FieldEditor):
    """A fixed count of numbers, or, without a count, any number of them separated by commas."""

    def __init__(self, count: int | None, unit: str = "", names: Sequence[str] = ()) -> None:
        super().__init__()
        self._count = count
        self.lines = [QLineEdit()] if count is None else [_number_line(TUPLE_WIDTH) for _ in range(count)]
        for line, name in zip(self.lines, names, strict=False):
            line.setAccessibleName(translated(name))
            line.setPlaceholderText(translated(name))
        for line in self.lines:
            line.textEdited.connect(self.edited)
        self.setLayout(row(*self.lines, label(unit, "soft"), *([] if count is None else [0])))

    def raw(self) -> list[int | float | str]:
        """Return the numbers."""
        if self._count is not None:
            return [_number(line.text()) for line in self.lines]
        return [_number(part) for part in self.lines[0].text().split(",") if part.strip()]

    def set_raw(self, value: Any) -> None:
        """Show numbers."""
        texts = [_digits(number) for number in value or ()]
        if self._count is None:
            self.lines[0].setText(", ".join(texts))
            return
        for line, text in zip(self.lines, texts or [""] * len(self.lines), strict=True):
            line.setText(translated(text))


class CheckEditor(FieldEditor):
    """Yes or no."""

    def __init__(self) -> None:
        super().__init__()
        self.box = QCheckBox(tr("Yes"))
        self.box.toggled.connect(self.edited)
        self.setLayout(row(self.box, 0))

    def raw(self) -> bool:
        """Return whether it is checked."""
        return self.box.isChecked()

    def set_raw(self, value: Any) -> None:
        """Show yes or no."""
        self.box.setChecked(bool(value))


class ChoiceEditor(FieldEditor):
    """One of a few values."""

    def __init__(self, options: Sequence[Any], words: Callable[[Any], str] | None = None) -> None:
        """``words``: how an option is shown; None: options are names that people gave, which no language changes."""
        super().__init__()
        self.box = CalmComboBox()
        self.box.setProperty(GIVEN, words is None)
        self.box.setMinimumWidth(NUMBER_WIDTH)
        self._options = list(options)
        for option in options:
            self.box.addItem((words or str)(option))
        self.box.currentIndexChanged.connect(self.edited)
        self.setLayout(row(self.box, 0))

    def raw(self) -> Any:
        """Return the value chosen."""
        return self._options[self.box.currentIndex()]

    def set_raw(self, value: Any) -> None:
        """Choose a value; one that is not offered is added, so that nothing is changed silently."""
        if value is None:
            return
        if value not in self._options:
            self._options.append(value)
            self.box.addItem(str(value))
        self.box.setCurrentIndex(self._options.index(value))


class OptionalEditor(FieldEditor):
    """A value that may be missing."""

    def __init__(self, inner: FieldEditor, start: Any) -> None:
        """``start``: first value when it is set."""
        super().__init__()
        self.inner, self._start = inner, start
        self.box = QCheckBox(tr("Set"))
        self.box.toggled.connect(self._toggle)
        inner.edited.connect(self.edited)
        inner.setVisible(False)
        line = row(self.box, inner, spacing=16)
        line.setAlignment(self.box, Qt.AlignmentFlag.AlignTop)
        line.setStretch(1, 1)
        self.setLayout(line)
        self.box.setMinimumHeight(32)

    def raw(self) -> Any:
        """Return the value, or None."""
        return self.inner.raw() if self.box.isChecked() else None

    def set_raw(self, value: Any) -> None:
        """Show a value, or that it is missing."""
        self.inner.set_raw(self._start if value is None else value)
        self.box.setChecked(value is not None)

    def place_problem(self, place: tuple[int | str, ...], words: str) -> bool:
        """Show a problem inside the editor."""
        return self.inner.place_problem(place, words)

    def clear_problems(self) -> None:
        """Show no problem."""
        self.inner.clear_problems()

    def _toggle(self, is_set: bool) -> None:
        self.inner.setVisible(is_set)
        if is_set:
            self.inner.unfold()
        self.edited.emit()


class TableEditor(FieldEditor):
    """A table of settings without a model, in lines of TOML; lines that are no TOML are passed on as text."""

    def __init__(self) -> None:
        super().__init__()
        self.text = _text_area("name = value")
        self.text.textChanged.connect(self.edited)
        self.setLayout(column(self.text))

    def raw(self) -> Any:
        """Return the table."""
        lines = self.text.document().toRawText().replace(PARAGRAPH, "\n")  # toPlainText() replaces no-break spaces
        try:
            return tomllib.loads(lines)
        except tomllib.TOMLDecodeError:
            return lines

    def set_raw(self, value: Any) -> None:
        """Show a table."""
        listed = {name: list(inner) if isinstance(inner, tuple) else inner for name, inner in dict(value or {}).items()}
        self.text.setPlainText(tomli_w.dumps(listed).rstrip())
        _fit(self.text)


def table_problem(raw: Any) -> str:
    """Return what is wrong with the value of a `TableEditor`; empty if nothing is."""
    return "" if isinstance(raw, Mapping) else f"{INVALID}."


def _number(text: str) -> int | float | str:
    plain = text.strip().replace("\u2212", "-")
    for kind in (int, float):
        try:
            return kind(plain)
        except ValueError:
            continue
    return text


def _digits(value: Any) -> str:
    return "" if value is None else repr(value).removesuffix(".0") if isinstance(value, int | float) else str(value)


def _readable(value: Any) -> Any:
    return value.model_dump(mode="json") if isinstance(value, BaseModel) else str(value)


def _number_line(width: int) -> QLineEdit:
    line = QLineEdit()
    line.setFixedWidth(width)
    return line


def _text_area(hint: str) -> QPlainTextEdit:
    area = QPlainTextEdit()
    area.setPlaceholderText(translated(hint))
    area.setTabChangesFocus(True)
    area.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
    return area


def _fit(area: QPlainTextEdit) -> None:
    """Give a text area the height of its text, within limits."""
    area.setFixedHeight(min(TEXT_HEIGHT, LINE_HEIGHT * (area.document().blockCount() + 1) + FRAME))
