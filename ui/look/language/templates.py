"""Which strings of the code are texts for people, and the templates that texts with values are recognised by."""

from __future__ import annotations

import ast
import re

WORDS = re.compile(r"[A-Za-z]{2}")
PLACEHOLDER = re.compile(r"\{\w+[^{}]*\}")
SENTENCE = re.compile(r"(^|[^\w.-])[a-zµ]{3,}")  # rather than the name of a view
CODE = re.compile(
    r"""[\w}\0]px;|vec3\(|%\(|color: |->|"do": |^(PRAGMA|SELECT|INSERT|BEGIN) |\?\w+="""
)  # style sheets, shaders, log formats, SQL, addresses
NAMES = re.compile(r"[\w./\\*#:+-]*")  # of files, keys and settings
VALUE = "\0"  # stands for a value in a template that is not numbered yet


def is_text(value: str) -> bool:
    """Whether a string reads like a text for people: several words, or one with a capital letter."""
    if CODE.search(value):
        return False
    bare = PLACEHOLDER.sub("", value).strip()
    if bare != value and " " in value and re.search(r"[a-z]{3}", bare):
        return True
    return bool(bare) and (NAMES.fullmatch(bare) is None or re.fullmatch(r"[A-Z][a-z-]+[….]?", bare) is not None)


def escaped(text: str) -> str:
    """Return a text as a template without values."""
    return text.replace("{", "{{").replace("}", "}}")


def is_template(text: str) -> bool:
    """Whether a template has words around its values."""
    return WORDS.search(PLACEHOLDER.sub("", text)) is not None


def has_sentence(text: str) -> bool:
    """Whether the words around the values of a template are more than a name."""
    return SENTENCE.search(PLACEHOLDER.sub("", text)) is not None


def numbered(text: str) -> str:
    r"""Return a template whose values are named in their order.

    >>> numbered("camera \0 at \0 ms")
    'camera {v1} at {v2} ms'
    """
    pieces = text.split(VALUE)
    return pieces[0] + "".join(f"{{v{count}}}{piece}" for count, piece in enumerate(pieces[1:], start=1))


def template(node: ast.JoinedStr) -> str:
    """Return the template of a text with values in it."""
    return numbered("".join(escaped(str(piece.value)) if isinstance(piece, ast.Constant) else VALUE for piece in node.values))
