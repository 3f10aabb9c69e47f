"""What tests need of the sources of the program, all read at once."""

from __future__ import annotations

import ast
import gc
from collections.abc import Iterator
from typing import NamedTuple

import pytest

from ui.look.language import sources
from ui.look.language.core import Core
from ui.look.language.templates import escaped, has_sentence, template


class ReadSources(NamedTuple):
    """Texts and files of the program."""

    texts: dict[str, str]  # every text, and its room
    told: list[str]  # what errors of the core say, as the catalogue collects it
    raised: dict[str, str]  # place in the core -> sentence in a `raise` statement there
    modules: list[str]  # that the window reaches

    @classmethod
    def of_program(cls) -> ReadSources:
        """Read all sources, without collecting garbage meanwhile: there is none, and it takes half of the time."""
        told, cores, follow = list[str](), list[Core](), sources.told_texts

        def note(core: Core) -> dict[str, str]:
            found = follow(core)
            cores.append(core)
            told.extend(found)
            return found

        gc.disable()
        try:
            with pytest.MonkeyPatch.context() as patch:
                patch.setattr(sources, "told_texts", note)
                texts = {**sources.core_texts(), **sources.window_texts()}
            (core,) = cores
            return cls(texts, told, dict(sentences_raised(core)), list(core.trees))
        finally:
            gc.enable()


def sentences_raised(core: Core) -> Iterator[tuple[str, str]]:
    """Yield place and text of every sentence in a `raise` statement outside the window, told apart from the rule that collects them."""
    for name, tree in ((one, tree) for one, tree in core.trees.items() if not one.startswith("ui")):
        for node in (one.exc for one in ast.walk(tree) if isinstance(one, ast.Raise) and isinstance(one.exc, ast.Call)):
            whole = {
                id(piece)
                for one in ast.walk(node)
                if isinstance(one, ast.JoinedStr | ast.BinOp)
                for piece in ast.walk(one)
                if piece is not one
            }
            for one in (one for one in ast.walk(node) if id(one) not in whole):
                text = template(one) if isinstance(one, ast.JoinedStr) else escaped(one.value) if is_string(one) else ""
                if " " in text and has_sentence(text):
                    yield f"{name}:{one.lineno}:{one.col_offset}", text


def is_string(node: ast.AST) -> bool:
    """Whether a node is a text without values."""
    return isinstance(node, ast.Constant) and isinstance(node.value, str)
