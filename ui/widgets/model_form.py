"""A form made from a pydantic model: one editor for each field, with its description as tooltip."""

from __future__ import annotations

import json
from typing import Any, Literal, cast, get_args, get_origin

from pydantic import BaseModel, SecretStr, ValidationError
from pydantic.fields import FieldInfo
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QLineEdit, QWidget

from measureapp.data.model import first_problem
from ui.widgets.basic import Form, column, label

UNITS = {
    "mm": "mm",
    "deg": "°",
    "us": "µs",
    "ms": "ms",
    "s": "s",
    "px": "px",
    "bytes": "bytes",
    "db": "dB",
    "deg_per_s": "°/s",
    "mm_per_s": "mm/s",
    "deg_per_s2": "°/s²",
}
UNSET = "not set"


class ModelForm(QWidget):
    """Edits an instance of a model: `value()`, `setValue(model)`, `valueChanged`, and `problem()` for what does not fit.

    Text and numbers are typed as they stand in a file; lists and tables are typed as JSON; an empty line leaves the default.
    """

    valueChanged = Signal()

    def __init__(self, kind: type[BaseModel], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.kind = kind
        self.editors: dict[str, QWidget] = {name: _editor(field) for name, field in kind.model_fields.items()}
        self.trouble = label("", "small", wrap=True)
        self.trouble.setProperty("verdict", "fail")
        self.trouble.hide()
        form = Form()
        for name, editor in self.editors.items():
            words = _words(name)
            editor.setAccessibleName(words)
            editor.setToolTip(kind.model_fields[name].description or "")
            form.add(words, editor)
            _changed(editor).connect(self._check)
        self.setLayout(column(form, self.trouble, 0))

    def document(self) -> dict[str, Any]:
        """Return what was typed, by field, without what was left to its default."""
        typed = {name: _typed(editor, self.kind.model_fields[name]) for name, editor in self.editors.items()}
        return {name: value for name, value in typed.items() if value is not None}

    def value(self) -> BaseModel:
        """Return the model. Raises ValidationError where something does not fit, see `problem`."""
        return self.kind.model_validate(self.document())

    def problem(self) -> str:
        """Return the first thing that does not fit, in words; empty if all is well."""
        try:
            self.value()
        except ValidationError as error:
            return f"{first_problem(error, 'the settings')}."
        return ""

    def setValue(self, document: dict[str, Any]) -> None:
        """Show settings, by field; what is not among them shows its default."""
        for name, editor in self.editors.items():
            _show(editor, document.get(name), self.kind.model_fields[name])
        self._check()

    def _check(self) -> None:
        problem = self.problem()
        self.trouble.setText(problem)
        self.trouble.setVisible(bool(problem))
        self.valueChanged.emit()


def _editor(field: FieldInfo) -> QWidget:
    options = _options(field)
    if field.annotation is bool:
        box = QCheckBox()
        box.setChecked(bool(field.default))
        return box
    if options:
        chosen = QComboBox()
        for option in options:
            chosen.addItem(str(option), option)
        chosen.setCurrentIndex(max(0, chosen.findData(field.default)))
        return chosen
    line = QLineEdit()
    line.setPlaceholderText(_default_words(field))
    if field.annotation is SecretStr:
        line.setEchoMode(QLineEdit.EchoMode.PasswordEchoOnEdit)
    return line


def _options(field: FieldInfo) -> tuple[Any, ...]:
    return get_args(field.annotation) if get_origin(field.annotation) is Literal else ()


def _default_words(field: FieldInfo) -> str:
    if field.is_required():
        return "required"
    default = field.get_default(call_default_factory=True, validated_data={})
    if default is None:
        return UNSET
    if isinstance(default, SecretStr):
        return "as delivered"
    plain = default.model_dump(mode="json") if isinstance(default, BaseModel) else default
    return plain if isinstance(plain, str) else json.dumps(plain, ensure_ascii=False, default=str)


def _changed(editor: QWidget) -> Any:
    if isinstance(editor, QCheckBox):
        return editor.toggled
    return editor.currentIndexChanged if isinstance(editor, QComboBox) else cast(QLineEdit, editor).textChanged


def _typed(editor: QWidget, field: FieldInfo) -> Any:
    """Return what an editor holds; None where it was left to the default."""
    if isinstance(editor, QCheckBox):
        return editor.isChecked() if editor.isChecked() != field.default else None
    if isinstance(editor, QComboBox):
        return editor.currentData() if field.is_required() or editor.currentData() != field.default else None
    text = cast(QLineEdit, editor).text().strip()
    if not text:
        return None
    if field.annotation in (str, SecretStr):
        return text
    try:
        return json.loads(text.replace(",", ".") if _is_number(field) else text)
    except ValueError:
        return text  # the model says what is wrong with it


def _is_number(field: FieldInfo) -> bool:
    if get_origin(field.annotation) is tuple:
        return False
    return bool({int, float} & {field.annotation, *get_args(field.annotation)})


def _show(editor: QWidget, value: Any, field: FieldInfo) -> None:
    if isinstance(editor, QCheckBox):
        editor.setChecked(bool(field.default if value is None else value))
    elif isinstance(editor, QComboBox):
        editor.setCurrentIndex(max(0, editor.findData(field.default if value is None else value)))
    else:
        line = cast(QLineEdit, editor)
        line.setText("" if value is None else value if isinstance(value, str) else json.dumps(value, ensure_ascii=False))


def _words(name: str) -> str:
    """Return the name of a field in words, with its unit."""
    for ending in sorted(UNITS, key=len, reverse=True):
        if name.endswith(f"_{ending}"):
            return f"{name.removesuffix(f'_{ending}').replace('_', ' ').capitalize()} ({UNITS[ending]})"
    return name.replace("_", " ").capitalize()
