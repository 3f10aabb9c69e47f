"""The files that the window reaches by its imports, and where their names are bound, called and defined."""

from __future__ import annotations

import ast
from collections import defaultdict
from collections.abc import Iterable, Iterator
from pathlib import Path

from measureapp.resources import resource

ROOT = resource("languages").parent.parent
Function = ast.FunctionDef | ast.AsyncFunctionDef
GATHERING = {"append", "extend", "add"}  # calls that put a text into a list


def name_of(node: ast.AST) -> str:
    """Return the name, or the last one of a dotted one; empty for other expressions."""
    return node.attr if isinstance(node, ast.Attribute) else node.id if isinstance(node, ast.Name) else ""


def children(node: ast.AST) -> list[ast.AST]:
    """Return the nodes right below one, in the order of the source; without operators and contexts, which are half of all."""
    found: list[ast.AST] = []
    for name in node._fields:
        value = getattr(node, name, None)
        if isinstance(value, list):
            found += [one for one in value if isinstance(one, ast.AST) and one._fields]
        elif isinstance(value, ast.AST) and value._fields:
            found.append(value)
    return found


def reached_files() -> dict[str, ast.Module]:
    """Return the syntax of window and plugins, and of all files of the core that they import, directly or through others, by module."""
    paths = {_module(path): path for folder in ("measureapp", "plugins", "ui") for path in sorted((ROOT / folder).rglob("*.py"))}
    waiting = [name for name in paths if not name.startswith("measureapp")]
    found: dict[str, ast.Module] = {}
    while waiting:
        parts = waiting.pop().split(".")
        for name in (".".join(parts[:count]) for count in range(1, len(parts) + 1)):  # a package is imported before what is in it
            if name in paths and name not in found:
                found[name] = ast.parse(paths[name].read_text(encoding="utf-8"))
                waiting += _imports(found[name])
    return {name: found[name] for name in paths if name in found and not name.startswith("ui.look.language")}


def _module(path: Path) -> str:
    return ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")


def _imports(tree: ast.Module) -> Iterator[str]:
    waiting: list[ast.AST] = [tree]
    while waiting:
        node = waiting.pop()
        if isinstance(node, ast.Import):
            yield from (one.name for one in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            yield from (f"{node.module}.{one.name}" for one in node.names)
        waiting += [child for child in children(node) if not isinstance(child, ast.expr)]  # nine nodes of ten, none an import


class Core:
    """The syntax of these files with what is needed to follow a text from where it is used to where it is written."""

    def __init__(self, trees: dict[str, ast.Module]) -> None:
        self.trees = trees
        self.functions: dict[str, list[Function]] = defaultdict(list)
        self.classes: dict[str, list[ast.ClassDef]] = defaultdict(list)
        self.calls: dict[str, list[ast.Call]] = defaultdict(list)
        self.raised: list[ast.Call] = []
        self._bound: dict[tuple[ast.AST, str], list[ast.expr]] = defaultdict(list)  # by function or module, and name
        self._attributes: dict[tuple[str, str], list[ast.expr]] = defaultdict(list)  # by module and name
        self._imported: dict[str, dict[str, tuple[str, str]]] = {name: {} for name in trees}  # by module and name: module and name there
        self._scopes: dict[ast.AST, ast.AST] = {}
        self._modules: dict[ast.AST, str] = {}
        self._owners: dict[ast.AST, ast.ClassDef] = {}
        for name, tree in trees.items():
            self._read(name, tree)

    def module(self, node: ast.AST) -> str:
        """Return the module that a node stands in."""
        return self._modules[node]

    def scope(self, node: ast.AST) -> ast.AST | None:
        """Return the function that a node stands in, else its module; None for a module."""
        return self._scopes.get(node)

    def owner(self, function: Function) -> ast.ClassDef | None:
        """Return the class of a method."""
        return self._owners.get(function)

    def attributes(self, module: str, name: str) -> list[ast.expr]:
        """Return what objects of a module have under a name."""
        return self._attributes.get((module, name), [])

    def bindings(self, scope: ast.AST, name: str) -> list[ast.expr]:
        """Return what a function or module binds to a name, or puts into the list of this name."""
        return self._bound.get((scope, name), [])

    def imported(self, module: str, name: str) -> tuple[str, str] | None:
        """Return where a name of a module is imported from: module, and name there."""
        return self._imported[module].get(name)

    def constants(self, module: str, name: str) -> list[ast.expr]:
        """Return what a module binds to a name, also one that it imports."""
        tree = self.trees.get(module)
        if tree is not None and (tree, name) in self._bound:
            return self._bound[tree, name]
        source = self._imported.get(module, {}).get(name)
        return [] if source is None or source == (module, name) else self.constants(*source)

    def _read(self, module: str, tree: ast.Module) -> None:
        waiting: list[tuple[ast.AST, ast.AST, ast.ClassDef | None]] = [(child, tree, None) for child in children(tree)]
        while waiting:
            node, scope, owner = waiting.pop()
            self._modules[node], self._scopes[node] = module, scope
            self._note(module, node, scope, owner)
            if isinstance(node, Function | ast.Lambda):
                scope, owner = node, None
            elif isinstance(node, ast.ClassDef):
                owner = node
            waiting += [(child, scope, owner) for child in children(node)]

    def _note(self, module: str, node: ast.AST, scope: ast.AST, owner: ast.ClassDef | None) -> None:
        if isinstance(node, Function):
            self.functions[node.name].append(node)
            if owner is not None:
                self._owners[node] = owner
        elif isinstance(node, ast.ClassDef):
            self.classes[node.name].append(node)
        elif isinstance(node, ast.Raise):
            self.raised += [node.exc] if isinstance(node.exc, ast.Call) else []
        elif isinstance(node, ast.Call):
            self.calls[name_of(node.func)].append(node)
            if isinstance(node.func, ast.Attribute) and node.func.attr in GATHERING:
                self._bound[scope, name_of(node.func.value)] += node.args
        elif isinstance(node, ast.ImportFrom):
            package = ".".join(module.split(".")[: -node.level]) + "." if node.level else ""  # of a relative import
            self._imported[module].update({one.asname or one.name: (package + (node.module or ""), one.name) for one in node.names})
        else:
            for target, value in _assigned(node):
                if isinstance(target, ast.Attribute) or owner is not None:
                    self._attributes[module, name_of(target)].append(value)
                else:
                    self._bound[scope, name_of(target)].append(value)


def _assigned(node: ast.AST) -> Iterator[tuple[ast.expr, ast.expr]]:
    """Yield the names that a statement binds, each with what it gets, or with that of which it gets a part."""
    if isinstance(node, ast.Assign):
        yield from _pairs(node.targets, node.value)
    elif isinstance(node, ast.AnnAssign | ast.AugAssign | ast.NamedExpr) and node.value is not None:
        yield node.target, node.value
    elif isinstance(node, ast.For | ast.comprehension):
        yield from ((one, node.iter) for one in ast.walk(node.target) if isinstance(one, ast.Name))


def _pairs(targets: Iterable[ast.expr], value: ast.expr) -> Iterator[tuple[ast.expr, ast.expr]]:
    for target in targets:
        if not isinstance(target, ast.Tuple):
            yield target, value
        elif isinstance(value, ast.Tuple) and len(value.elts) == len(target.elts):
            yield from zip(target.elts, value.elts, strict=True)
        else:
            yield from ((one, value) for one in target.elts)
