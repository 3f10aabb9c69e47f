"""The caps that CONTRIBUTING states: length of files and functions, number of parameters, methods of a controller."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FILE_LINES, FUNCTION_LINES, PARAMETERS, CONTROLLER_METHODS = 400, 60, 8, 30
ROOMS = ("measureapp", "ui", "plugins", "installer")
Function = ast.FunctionDef | ast.AsyncFunctionDef


def sources() -> list[Path]:
    return [path for room in ROOMS for path in sorted((ROOT / room).rglob("*.py"))]


@pytest.fixture(scope="module")
def functions() -> list[tuple[str, Function]]:
    """All functions with their places, parsed once for all caps."""
    return list(_functions())


def _functions() -> Iterator[tuple[str, Function]]:
    for path in sources():
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, Function):
                yield f"{path.relative_to(ROOT).as_posix()}:{node.lineno} {node.name}", node


def test_no_file_is_longer_than_its_cap() -> None:
    lengths = {path.relative_to(ROOT).as_posix(): len(path.read_text(encoding="utf-8").splitlines()) for path in sources()}
    assert {path: lines for path, lines in lengths.items() if lines > FILE_LINES} == {}


def test_no_function_is_longer_than_its_cap_without_its_docstring(functions: list[tuple[str, Function]]) -> None:
    long = {}
    for where, node in functions:
        documented = ast.get_docstring(node, clean=False)
        lines = (node.end_lineno or node.lineno) - node.lineno + 1 - (documented.count("\n") + 1 if documented else 0)
        if lines > FUNCTION_LINES:
            long[where] = lines
    assert long == {}


def test_no_function_has_more_parameters_than_its_cap(functions: list[tuple[str, Function]]) -> None:
    """Kernels are free, since a compiled loop takes its arrays one by one; so are commands, whose options are parameters."""
    many = {}
    for where, node in functions:
        count = len([one for one in (*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs) if one.arg not in ("self", "cls")])
        if count > PARAMETERS and "kernel" not in where and not _is_compiled(node) and not _is_command(node):
            many[where] = count
    assert many == {}


@pytest.mark.parametrize("room", ["ui/controllers"])
def test_no_controller_has_more_methods_than_its_cap(room: str) -> None:
    classes = {
        f"{path.name} {node.name}": len([one for one in node.body if isinstance(one, Function)])
        for path in sorted((ROOT / room).rglob("*.py"))
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.ClassDef)
    }
    assert {name: count for name, count in classes.items() if count > CONTROLLER_METHODS} == {}


def _is_compiled(node: Function) -> bool:
    return any("njit" in ast.dump(one) for one in node.decorator_list)


def _is_command(node: Function) -> bool:
    return any(
        isinstance(one, ast.Call) and isinstance(one.func, ast.Attribute) and one.func.attr == "command" for one in node.decorator_list
    )
