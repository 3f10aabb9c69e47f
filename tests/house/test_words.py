"""Texts that users read keep to the terms of the field; retired words are named with their replacement."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]

RETIRED = {
    # word or phrase as a regular expression, at word boundaries, in any case → use instead
    r"by the axes|placed by (the )?axes|the axes hold": "kinematic position, kinematic placement",
    r"fine[- ]stitch(ing|ed)": "registration, registered",
    r"as drawn|(of|from|onto|with|beside) the drawing|drawing of (a|the|another) part": "nominal",
    r"tak(e|es|en|ing) out|took out": "remove, delete",
    r"tak(e|es|en|ing) back|took back": "undo; correct",
    r"shares": "contributions; percentages, fractions",
    r"promis(e|es|ed)": "uncertainty; predicted performance; specification",
    r"leav(e|es|ing) open|left open": "does not determine; unconstrained",
    r"errs?": "deviates, has an error",
    r"told( from)?|tells?": "reported, stated, determined; distinguish",
    r"alike|resembles?": "systematic, common; correlated",
    r"(in|have) common share|form share|common share": "systematic (form) error",
    r"rims": "depth discontinuities, occlusion edges",
    r"islands?": "isolated patch",
    r"hangs? together": "connected component",
    r"fringes across|across fringes": "orthogonal fringes, second fringe direction",
    r"other light": "ambient light",
    r"close (its|the|their) ring|around the ring": "loop closure",
    r"sieves?": "filter chain",
    r"groundwork": "registration cache",
    r"recipes?": "decode plan",
    r"coach(es|ing)?": "guidance",
    r"carried( on| along)?": "propagated, transformed",
    r"paper rig|rig of the paper": "reference rig",
    r"as it really is": "true (surface, value); ground truth",
    r"as they were calibrated|stands? still|stands? as": "passed; stationary",
    r"(it )?lies in|(?-i:Written:)": "saved to",
    r"look(s|ed|ing)? (at|askance|the same)|askance": "inspect, examine, evaluate; at an oblique angle",
    r"left out|leav(e|es|ing) out": "excluded, rejected, not used",
    r"in sight": "visible; in the field of view",
    r"asked (for|ahead|of)|asks? for": "requested, required",
    r"taken together|joined points": "combined, mean",
    r"came (out|of it)|comes out": "result, solution",
    r"given up|gives up": "cancelled, stopped, timed out",
    r"the why": "the reason",
    r"judged": "evaluated",
    r"one more eye": "inverse camera",
    r"worth a (second )?look": "to be inspected",
}


class Text(NamedTuple):
    """One text with its place."""

    path: str
    line: int
    words: str


def is_docstring(owner: ast.AST, node: ast.AST) -> bool:
    body = getattr(owner, "body", None)
    return isinstance(body, list) and bool(body) and isinstance(body[0], ast.Expr) and body[0].value is node


def is_command(owner: ast.AST) -> bool:
    """Whether this function is a command of the command line, whose docstring is its help text."""
    decorators = owner.decorator_list if isinstance(owner, ast.FunctionDef) else []
    return any(isinstance(one, ast.Call) and isinstance(one.func, ast.Attribute) and one.func.attr == "command" for one in decorators)


def literals(source: str) -> Iterator[tuple[int, str]]:
    """Yield the texts of a module: string literals with a blank or a capital letter, f-strings with … for their values.

    Identifiers of documents have neither; docstrings are no texts, except those of commands.
    """
    tree = ast.parse(source)
    skipped: set[int] = set()
    for owner in ast.walk(tree):
        if isinstance(owner, ast.JoinedStr):
            skipped |= {id(part) for part in owner.values}
        for node in ast.iter_child_nodes(owner):
            if isinstance(node, ast.Expr) and is_docstring(owner, node.value) and not is_command(owner):
                skipped.add(id(node.value))
    for node in ast.walk(tree):
        if id(node) in skipped:
            continue
        if isinstance(node, ast.JoinedStr):
            yield node.lineno, "".join(str(part.value) if isinstance(part, ast.Constant) else "…" for part in node.values)
        elif isinstance(node, ast.Constant) and isinstance(node.value, str) and (" " in node.value or node.value[:1].isupper()):
            yield node.lineno, node.value


def texts() -> Iterator[Text]:
    """Yield every text that users read: of the core, the window and the plugins, the help pages, the README and the CHANGELOG."""
    for top in ("measureapp", "ui", "plugins"):
        for path in sorted((ROOT / top).rglob("*.py")):
            for line, words in literals(path.read_text(encoding="utf-8")):
                yield Text(path.relative_to(ROOT).as_posix(), line, words)
    for path in (ROOT / "README.md", ROOT / "CHANGELOG.md", *sorted((ROOT / "resources" / "help").glob("*.md"))):
        for line, words in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            yield Text(path.relative_to(ROOT).as_posix(), line, words)


@cache
def findings() -> tuple[tuple[str, str], ...]:
    """Return (file, "file:line: phrase → replacement") for every retired phrase in every text."""
    phrases = [(re.compile(rf"\b(?:{phrase})(?![\w-])", flags=re.IGNORECASE), instead) for phrase, instead in RETIRED.items()]
    return tuple(
        (text.path, f"{text.path}:{text.line}: “{found.group()}” → {instead}")
        for text in texts()
        for pattern, instead in phrases
        for found in pattern.finditer(text.words)
    )


def test_texts_use_the_terms_of_the_field() -> None:
    found = [finding for _, finding in findings()]
    assert not found, "\n" + "\n".join(found)


def test_a_retired_word_is_found_in_a_text_and_not_in_a_docstring() -> None:
    source = 'def f():\n    """By the axes."""\n    say(f"{name}: 3 points left out.")\n    return {"left_out": 3, "shares": 4}\n'
    assert list(literals(source)) == [(3, "…: 3 points left out.")]
    command = '@app.command()\ndef f():\n    """By the axes."""\n'
    assert list(literals(command)) == [(3, "By the axes.")]
