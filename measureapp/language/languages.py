"""Which languages there are, and their catalogues."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Final

from measureapp.errors import InputError
from measureapp.resources import resource

if TYPE_CHECKING:
    from measureapp.language.catalogue import Catalogue

ENGLISH: Final = "en"
LANGUAGES: Final = {ENGLISH: "English", "zh_CN": "简体中文"}  # each in its own words


def known_language(name: str) -> str:
    """Return the name of a language. Raises InputError for one that there is not."""
    if name not in LANGUAGES:
        raise InputError(f"There is no language {name!r}.", f"Name one of: {', '.join(LANGUAGES)}.")
    return name


@cache
def catalogue_of(name: str) -> Catalogue | None:
    """Return the translations into a language, which are read once; None for English. Raises InputError where the file is damaged."""
    from measureapp.language.catalogue import read_catalogue

    return None if name == ENGLISH else read_catalogue(resource(f"languages/measureapp_{name}.ts"))
