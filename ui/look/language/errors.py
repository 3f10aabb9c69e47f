"""What errors and progress say, followed to where it is written: names, parameters, results of functions, texts of pieces."""

from __future__ import annotations

import ast
import builtins
import re
from collections.abc import Iterable
from dataclasses import dataclass, replace

from ui.look.language.core import Core, Function, name_of
from ui.look.language.templates import CODE, PLACEHOLDER, VALUE, WORDS, escaped, has_sentence, is_template, is_text, numbered

OF_PYTHON = (OSError, ValueError, RuntimeError)  # what they say becomes part of what an error of the program says
BASES = {"MeasureError", "Cancelled"} | {
    name for name, one in vars(builtins).items() if isinstance(one, type) and issubclass(one, OF_PYTHON)
}
"""Every class derived from them is an error, too."""
TELLING = {"report"}  # methods whose texts the window displays
KIND = "kind"  # what a variable is called that holds a class of errors
SAME = {"filter", "tuple", "list", "sorted", "set", "dict", "fromkeys"}  # calls that give what they get
FILLING = {"format", "replace"}
PARTS = {"strip", "lstrip", "rstrip", "removesuffix", "removeprefix", "get", "items", "values", "capitalize", "lower"}
NAME = re.compile(r"\w+")
WORD = re.compile(r"[a-z]{2,}")  # rather than the value of a setting


@dataclass(frozen=True, slots=True)
class Use:
    """An expression whose text is told."""

    node: ast.expr
    is_piece: bool = False  # of another text
    is_choice: bool = False  # one of those written there, as in ``"near" if … else "far"``
    is_template: bool = False  # values are put into it later


def told_texts(core: Core) -> dict[str, str]:
    """Return what errors and progress of the core say, as templates, with their modules: {text: module}."""
    return _Following(core).follow()


def error_classes(core: Core) -> set[str]:
    """Return the names of all classes of errors."""
    found, count = set(BASES), 0
    while len(found) > count:
        count = len(found)
        found |= {name for name, made in core.classes.items() for one in made if any(name_of(base) in found for base in one.bases)}
    return found


class _Following:
    def __init__(self, core: Core) -> None:
        self._core = core
        self._errors = error_classes(core)
        self._seen = set[Use]()
        self._waiting: list[Use] = []

    def follow(self) -> dict[str, str]:
        for call in self._core.raised:
            self._use(_arguments(call))
        for name in sorted(self._errors | TELLING | {KIND}):
            for call in self._core.calls[name]:
                if name not in TELLING or isinstance(call.func, ast.Attribute):
                    self._use(_arguments(call))
        for one in (one for name in sorted(self._errors) for one in self._core.classes[name]):
            for call in (node for node in ast.walk(one) if isinstance(node, ast.Call) and name_of(node.func) == "__init__"):
                self._use(call.args)
        order = {name: place for place, name in enumerate(self._core.trees)}
        found: dict[str, str] = {}
        while self._waiting:
            use = self._waiting.pop()
            module = self._core.module(use.node)
            for text in filter(None, (_as_text(raw, use) for raw in self._read(use))):
                found[text] = min(found.get(text, module), module, key=order.__getitem__)
        return {text: module for text, module in found.items() if (bare := _bare(text)) == text or bare not in found}

    def _use(self, nodes: Iterable[ast.expr], of: Use | None = None, *, is_piece: bool = False) -> None:
        """Follow expressions; what is known of the text that they are used in applies to them, too."""
        for node in nodes:
            use = Use(node) if of is None else Use(node, of.is_piece or is_piece, False, of.is_template)
            self._add(use)

    def _add(self, use: Use) -> None:
        if use not in self._seen:
            self._seen.add(use)
            self._waiting.append(use)

    def _read(self, use: Use) -> list[str]:
        """Return the texts that stand in an expression itself, values replaced; what it refers to is followed."""
        node = use.node
        if isinstance(node, ast.Constant):
            return [node.value if use.is_template else escaped(node.value)] if isinstance(node.value, str) else []
        if isinstance(node, ast.JoinedStr):
            return ["".join(self._piece(piece, use) for piece in node.values)]
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
            left, right = (self._alternatives(side, use) for side in (node.left, node.right))
            return [before + after for before in left or [VALUE] for after in right or [VALUE]] if left or right else []
        if isinstance(node, ast.IfExp | ast.BoolOp):
            for side in (node.body, node.orelse) if isinstance(node, ast.IfExp) else node.values:
                self._add(replace(use, node=side, is_choice=isinstance(node, ast.IfExp)))
            return []
        self._refer(node, use)
        return []

    def _alternatives(self, node: ast.expr, use: Use) -> list[str]:
        """Return the texts that a part of a sum can be."""
        if isinstance(node, ast.IfExp):
            return [*self._alternatives(node.body, use), *self._alternatives(node.orelse, use)]
        return self._read(replace(use, node=node, is_choice=False))

    def _piece(self, piece: ast.expr, use: Use) -> str:
        if isinstance(piece, ast.FormattedValue):
            self._use([piece.value], use, is_piece=True)
            return VALUE
        return escaped(str(piece.value)) if isinstance(piece, ast.Constant) else ""

    def _refer(self, node: ast.expr, use: Use) -> None:
        if isinstance(node, ast.Name):
            self._name(node, use)
        elif isinstance(node, ast.Attribute):
            self._attribute(node, use)
        elif isinstance(node, ast.Call):
            self._call(node, use)
        elif isinstance(node, ast.Subscript | ast.Starred):
            self._use([node.value], use)
        elif isinstance(node, ast.Tuple | ast.List | ast.Set):
            for one in node.elts:
                self._add(replace(use, node=one))
        elif isinstance(node, ast.Dict | ast.DictComp):
            self._use([node.value] if isinstance(node, ast.DictComp) else node.values, use)
        elif isinstance(node, ast.ListComp | ast.GeneratorExp | ast.SetComp):
            self._use([node.elt], use)

    def _name(self, node: ast.Name, use: Use) -> None:
        scope = self._core.scope(node)
        while isinstance(scope, Function | ast.Lambda):
            bound = self._core.bindings(scope, node.id)
            self._use(bound, use)
            if isinstance(scope, Function) and node.id in _parameters(scope):
                self._parameter(scope, node.id, use)
                return
            if bound:
                return
            scope = self._core.scope(scope)
        self._use(self._core.constants(self._core.module(node), node.id), use)

    def _parameter(self, function: Function, name: str, use: Use) -> None:
        """Follow what all calls of a function give for a parameter."""
        owner = self._core.owner(function)
        called = owner.name if owner is not None and function.name == "__init__" else function.name
        positional = [one.arg for one in (*function.args.posonlyargs, *function.args.args)]
        if owner is not None and "staticmethod" not in map(name_of, function.decorator_list):
            positional = positional[1:]
        for call in self._core.calls[called]:
            if self._calls(call, function, called):
                self._use(_given(call, positional, name), use, is_piece=True)

    def _calls(self, call: ast.Call, function: Function, called: str) -> bool:
        """Whether a call of this name is one of this function."""
        here, there = self._core.module(call), self._core.module(function)
        if here == there:
            return True
        if isinstance(call.func, ast.Name):
            source = self._core.imported(here, called)
            return source is not None and source[0] in (there, there.rpartition(".")[0])
        if self._core.owner(function) is None:
            return name_of(call.func.value) == there.rpartition(".")[2] if isinstance(call.func, ast.Attribute) else False
        return len(self._core.functions[called]) == 1

    def _attribute(self, node: ast.Attribute, use: Use) -> None:
        if node.attr.isupper():  # a constant of another module
            for module in (one for one in self._core.trees if one.rpartition(".")[2] == name_of(node.value)):
                self._use(self._core.constants(module, node.attr), use)
        else:
            self._use(self._core.attributes(self._core.module(node), node.attr), use)
            for function in self._core.functions[node.attr]:
                if {"property", "cached_property"} & set(map(name_of, function.decorator_list)):
                    self._results(function, use)
            if not use.is_piece and node.attr != "name":  # names are not translated
                self._field(node.attr, use)

    def _field(self, name: str, use: Use) -> None:
        """Follow what all objects of data types get for a field of this name."""
        for made in (one for called, found in self._core.classes.items() if called not in self._errors for one in found):
            fields = [one.target.id for one in made.body if isinstance(one, ast.AnnAssign) and isinstance(one.target, ast.Name)]
            if name in fields:
                for call in self._core.calls[made.name]:
                    self._use(_given(call, fields, name), use, is_piece=True)
        for call in self._core.calls["replace"]:
            self._use((one.value for one in call.keywords if one.arg == name), use, is_piece=True)

    def _call(self, node: ast.Call, use: Use) -> None:
        name = name_of(node.func)
        if name == "join":
            self._use(node.args, use, is_piece=True)
        elif isinstance(node.func, ast.Attribute) and name in FILLING | PARTS:
            self._add(replace(use, node=node.func.value, is_choice=False, is_template=use.is_template or name in FILLING))
            self._use(node.args[1:] if name == "get" else [], use)
        elif name in SAME:
            self._use(node.args, use)
        else:
            for function in self._core.functions[name]:
                if self._calls(node, function, name):
                    self._results(function, use)

    def _results(self, function: Function, use: Use) -> None:
        for node in ast.walk(function):
            if isinstance(node, ast.Return | ast.Yield) and node.value is not None and self._core.scope(node) is function:
                self._use([node.value], use)


def _as_text(raw: str, use: Use) -> str | None:
    """Return what an expression says as a template; None for a value, a name or a key."""
    text = numbered(raw)
    if CODE.search(raw):
        return None
    if PLACEHOLDER.search(text.replace("{{", "").replace("}}", "")):
        return text if " " in text.strip() and (has_sentence(text) if use.is_piece else is_template(text)) else None
    if use.is_piece and NAME.fullmatch(raw):
        return text if use.is_choice and WORD.fullmatch(raw) else None
    return text if WORDS.search(text) and is_text(_bare(raw)) else None


def _bare(text: str) -> str:
    """Return a template as the constant that it was escaped from."""
    return text.replace("{{", "{").replace("}}", "}")


def _arguments(call: ast.Call) -> list[ast.expr]:
    return [*call.args, *(one.value for one in call.keywords)]


def _parameters(function: Function) -> set[str]:
    return {one.arg for one in (*function.args.posonlyargs, *function.args.args, *function.args.kwonlyargs)}


def _given(call: ast.Call, positional: list[str], name: str) -> list[ast.expr]:
    """Return what a call gives for a parameter; nothing where it is not written there."""
    named = [one.value for one in call.keywords if one.arg == name]
    if named or name not in positional:
        return named
    place = positional.index(name)
    first = call.args[: place + 1]
    return [] if len(first) <= place or any(isinstance(one, ast.Starred) for one in first) else [first[place]]
