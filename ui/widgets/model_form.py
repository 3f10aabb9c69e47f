"""Form made from a pydantic model: one editor for each field, the problems in words below them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from enum import Enum
from types import UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import SecretStr, ValidationError
from pydantic.fields import FieldInfo
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QAbstractButton, QLabel, QPushButton, QWidget

from measureapp.data.model import Model
from ui.look.field_words import choice_words, field_words, place_words, problem_sentence, problem_words, tip_words
from ui.look.language.words import tr, translated
from ui.widgets.basic import Form, clear, column, label, row
from ui.widgets.field_editors import (
    CheckEditor,
    ChoiceEditor,
    FieldEditor,
    KeptEditor,
    NumberEditor,
    NumbersEditor,
    OptionalEditor,
    TableEditor,
    TextEditor,
    table_problem,
)

DEEPEST = 3  # levels of models inside each other that are forms
CLOSED, OPEN = "\u25b8", "\u25be"
AXES = {"mm": ("x", "y", "z"), "deg": ("x", "y", "z"), "wxyz": ("w", "x", "y", "z")}


class FieldRows(FieldEditor):
    """Editors of the fields of a model, or of some of them; what they contain is not validated."""

    def __init__(
        self, model: type[Model], only: Sequence[str] | None = None, own: Mapping[str, FieldEditor] | None = None, depth: int = 0
    ) -> None:
        """``only``: fields shown, in this order, None: all; ``own``: editors in place of those that follow from the type."""
        super().__init__()
        self.model = model
        self.editors: dict[str, FieldEditor] = {}
        self._notes: dict[str, QLabel] = {}
        self.touched = set[str]()  # fields in which something was entered, or removed
        self.note = _note()
        form = Form()
        for name in model.model_fields if only is None else only:
            field = model.model_fields[name]
            self._add(form, name, field, (own or {}).get(name) or editor_for(field.annotation, name, depth))
        self.setLayout(column(form, self.note, spacing=8))
        self.set_raw({})

    def _add(self, form: Form, name: str, field: FieldInfo, editor: FieldEditor) -> None:
        words, _ = field_words(name)
        named, note = QLabel(translated(words)), _note()
        for widget in (named, editor):
            widget.setToolTip(translated(tip_words(field.description)))
        for inner in (editor, *editor.findChildren(QWidget)):
            if inner is editor or (inner.focusPolicy() != Qt.FocusPolicy.NoFocus and not inner.accessibleName()):
                own = inner.text() if isinstance(inner, QAbstractButton) else ""
                inner.setAccessibleName(translated(f"{words}: {own}" if own else words))
        self.editors[name], self._notes[name] = editor, note
        cell = QWidget()
        cell.setLayout(column(editor, note, spacing=2))
        named.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)
        named.setContentsMargins(0, 7, 0, 0)
        form.add(named, cell)
        editor.edited.connect(lambda: self.touched.add(name))
        editor.edited.connect(self._edited)

    def raw(self) -> dict[str, Any]:
        """Return what was entered, by field."""
        return {name: editor.raw() for name, editor in self.editors.items()}

    def set_raw(self, value: Any) -> None:
        """Show values by field, or a model; a field without a value has its default."""
        values = _by_field(value)
        for name, editor in self.editors.items():
            editor.blockSignals(True)
            editor.set_raw(values[name] if name in values else start_value(self.model.model_fields[name]))
            editor.blockSignals(False)

    def place_problem(self, place: tuple[int | str, ...], words: str) -> bool:
        """Show a problem below the field at ``place``, else below all fields."""
        name = str(place[0]) if place else ""
        if name not in self.editors:
            self.note.setText(translated(f"{place_words(place)}: {words}" if name else words))
            self.note.show()
        elif not self.editors[name].place_problem(place[1:], words):
            self._notes[name].setText(translated(words))
            self._notes[name].show()
        return True

    def clear_problems(self) -> None:
        """Show no problem."""
        for note in (self.note, *self._notes.values()):
            note.hide()
        for editor in self.editors.values():
            editor.clear_problems()

    def _edited(self) -> None:
        self.edited.emit()


class ModelForm(FieldRows):
    """Edits a model: value(), setValue(model), valueChanged, edited (also while it is invalid), problem()."""

    valueChanged = Signal(object)

    def __init__(self, model: type[Model], only: Sequence[str] | None = None) -> None:
        """``only``: fields shown, in this order; None: all."""
        super().__init__(model, only)
        self.edited.connect(self._check)
        self._check()

    def value(self) -> Model:
        """Return the model; raises ValidationError when something is invalid, see `problem`."""
        return self.model.model_validate(self.raw())

    def setValue(self, model: Model) -> None:
        """Show a model."""
        self.set_raw(model)
        self.edited.emit()

    def problem(self) -> str:
        """Return the first problem, with its field; empty if everything is valid."""
        found = self._problems()
        return problem_sentence(found[0]) if found else ""

    def _problems(self) -> Sequence[Mapping[str, Any]]:
        raw = self.raw()
        for name, editor in self.editors.items():
            if isinstance(editor, TableEditor) and table_problem(raw[name]):
                return [{"loc": (name,), "type": "", "msg": table_problem(raw[name])}]
        try:
            self.model.model_validate(raw)
        except ValidationError as error:
            return error.errors(include_url=False)
        return []

    def _check(self) -> None:
        """Show the first problem; a field that is still to be filled in is none before it was touched."""
        self.clear_problems()
        found, raw = self._problems(), self.raw()
        if not found:
            self.valueChanged.emit(self.value())
        for one in found:
            name = str(one["loc"][0]) if one["loc"] else ""
            if name in self.touched or raw.get(name, 0) not in (None, ""):
                self.place_problem(one["loc"], problem_words(one))
                return


class GroupEditor(FieldEditor):
    """A model inside a model: a heading that folds its fields; they are made when they are first unfolded."""

    def __init__(self, model: type[Model], depth: int) -> None:
        super().__init__()
        self._model, self._depth = model, depth
        self._rows: FieldRows | None = None
        self.button = QPushButton(tr("{closed} Show", closed=CLOSED))
        self.button.setCheckable(True)
        self.button.setAutoDefault(False)
        self.button.setProperty("role", "quiet")
        self.button.toggled.connect(self._fold)
        self._column = column(row(self.button, 0), spacing=4)
        self.setLayout(self._column)

    @property
    def rows(self) -> FieldRows:
        """The fields."""
        if self._rows is None:
            self._rows = FieldRows(self._model, depth=self._depth)
            self._rows.set_raw(self._kept or {})
            self._rows.setVisible(self.button.isChecked())
            self._rows.edited.connect(self.edited)
            self._column.addWidget(self._rows)
        return self._rows

    def raw(self) -> Any:
        """Return what was entered, by field."""
        return self._rows.raw() if self._rows is not None else _by_field(self._kept)

    def set_raw(self, value: Any) -> None:
        """Show values by field, or a model."""
        super().set_raw(value)
        if self._rows is not None:
            self._rows.set_raw(value or {})

    def place_problem(self, place: tuple[int | str, ...], words: str) -> bool:
        """Unfold the fields and show a problem."""
        self.unfold()
        return self.rows.place_problem(place, words)

    def clear_problems(self) -> None:
        """Show no problem."""
        if self._rows is not None:
            self._rows.clear_problems()

    def unfold(self) -> None:
        """Show the fields."""
        self.button.setChecked(True)

    def _fold(self, unfolded: bool) -> None:
        self.rows.setVisible(unfolded)
        self.button.setText(tr("{open} Hide", open=OPEN) if unfolded else tr("{closed} Show", closed=CLOSED))


class ListEditor(FieldEditor):
    """Any number of models, one below the other."""

    def __init__(self, model: type[Model], name: str, depth: int) -> None:
        super().__init__()
        self._model, self._depth = model, depth
        self.items: list[FieldRows] = []
        self._column = column(spacing=8)
        self.button = QPushButton(tr("Add"))
        self.button.setAutoDefault(False)
        self.button.setAccessibleName(tr("Add: {field_words}", field_words=field_words(name)[0]))
        self.button.clicked.connect(self._append)
        self.setLayout(column(self._column, row(self.button, 0), spacing=8))

    def raw(self) -> Any:
        """Return what was entered, by item and field."""
        return [item.raw() for item in self.items]

    def set_raw(self, value: Any) -> None:
        """Show models or their values by field."""
        clear(self._column)
        self.items = []
        for item in value or ():
            self._show(item)

    def place_problem(self, place: tuple[int | str, ...], words: str) -> bool:
        """Show a problem inside an item."""
        if not place or not isinstance(place[0], int) or place[0] >= len(self.items):
            return False
        return self.items[place[0]].place_problem(place[1:], words)

    def clear_problems(self) -> None:
        """Show no problem."""
        for item in self.items:
            item.clear_problems()

    def _append(self) -> None:
        self._show({})
        self.edited.emit()

    def _show(self, value: Any) -> None:
        item = FieldRows(self._model, depth=self._depth)
        item.set_raw(value)
        item.edited.connect(self.edited)
        remove = QPushButton(tr("Remove"))
        remove.setAutoDefault(False)
        remove.clicked.connect(lambda: self._remove(item))
        framed = QWidget()
        framed.setObjectName("surface")
        framed.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        framed.setLayout(column(item, row(remove, 0), margin=12))
        self.items.append(item)
        self._column.addWidget(framed)

    def _remove(self, item: FieldRows) -> None:
        self.set_raw([other.raw() for other in self.items if other is not item])
        self.edited.emit()


def editor_for(kind: Any, name: str, depth: int = 0) -> FieldEditor:
    """Return the editor of a field by its type; a type without an editor is shown and kept."""
    _, unit = field_words(name)
    origin, options = get_origin(kind), get_args(kind)
    if origin is Annotated:
        return editor_for(options[0], name, depth)
    if origin in (Union, UnionType):
        inner = [option for option in options if option is not type(None)]
        optional = len(inner) == 1 and len(inner) < len(options)
        return OptionalEditor(editor_for(inner[0], name, depth), {} if _is_model(inner[0]) else None) if optional else KeptEditor()
    if origin is Literal:
        return ChoiceEditor(options, choice_words)
    if origin is tuple:
        return _tuple_editor(options, name, depth)
    if origin is dict:
        return TableEditor()
    return _plain_editor(kind, unit, depth)


def _plain_editor(kind: Any, unit: str, depth: int) -> FieldEditor:
    if kind is bool:
        return CheckEditor()
    if kind in (int, float):
        return NumberEditor(unit)
    if kind in (str, SecretStr):
        return TextEditor(secret=kind is SecretStr)
    if isinstance(kind, type) and issubclass(kind, Enum):
        return ChoiceEditor(list(kind), choice_words)
    if _is_model(kind) and depth + 1 < DEEPEST:
        return GroupEditor(kind, depth + 1)
    return KeptEditor()


def _tuple_editor(options: Sequence[Any], name: str, depth: int) -> FieldEditor:
    _, unit = field_words(name)
    if len(options) == 2 and options[1] is Ellipsis:
        if options[0] in (int, float):
            return NumbersEditor(None, unit)
        return ListEditor(options[0], name, depth + 1) if _is_model(options[0]) and depth + 1 < DEEPEST else KeptEditor()
    if all(option in (int, float) for option in options):
        names = AXES.get(name.rpartition("_")[2], ())
        return NumbersEditor(len(options), unit, names if len(names) == len(options) else ())
    return KeptEditor()


def start_value(field: FieldInfo) -> Any:
    """Return the first value of a field: its default, or an empty one that has to be filled in."""
    if not field.is_required():
        return field.get_default(call_default_factory=True)
    return {} if _is_model(field.annotation) else None


def _by_field(value: Any) -> Mapping[str, Any]:
    return value.model_dump() if isinstance(value, Model) else dict(value or {})


def _is_model(kind: Any) -> bool:
    return isinstance(kind, type) and issubclass(kind, Model)


def _note() -> QLabel:
    note = label("", "problem", wrap=True)
    note.hide()
    return note
