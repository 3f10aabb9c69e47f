"""Names that are proposed for new entries of a program: put together from those given and words of the language of who edits it."""

from __future__ import annotations

from collections.abc import Callable

from measureapp.language.translator import IDEOGRAPH

Word = Callable[[str], str]
"""Says a lower-case English word in the language of names."""


def english(word: str) -> str:
    """Return the word itself."""
    return word


def compound(*parts: str) -> str:
    """Return a name of several parts; Chinese writes no space between its words.

    >>> compound("bore", "diameter"), compound("bore", "直径"), compound("圆 1", "直径"), compound("分布圆", "直径")
    ('bore diameter', 'bore 直径', '圆 1 直径', '分布圆直径')
    """
    name = parts[0]
    for part in parts[1:]:
        closed = IDEOGRAPH.fullmatch(name[-1:]) and IDEOGRAPH.fullmatch(part[:1])
        name += part if closed else f" {part}"
    return name
