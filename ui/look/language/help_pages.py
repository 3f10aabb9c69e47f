"""Help pages in every language; a translation names the English text that it translates by its digest."""

from __future__ import annotations

import re
from hashlib import sha256
from pathlib import Path

from measureapp.errors import InputError
from measureapp.language.catalogue import Catalogue
from measureapp.resources import resource

STATED = re.compile(r"<!-- translates ([0-9a-f]{16}) -->\n+")


def help_file(name: str, language: str = "en") -> Path:
    """Return the file of a help page in a language, which need not exist."""
    return resource("help") / ("" if language == "en" else language) / f"{name}.md"


def page_names(language: str = "en") -> list[str]:
    """Return the names of the help pages of a language, sorted."""
    return sorted(path.stem for path in help_file("", language).parent.glob("*.md"))


def read_help(name: str, catalogue: Catalogue | None) -> str:
    """Return a help page in the language of a catalogue, in English where it is not translated. Raises InputError or OSError without a page."""
    if catalogue is not None and help_file(name, catalogue.language).is_file():
        return STATED.sub("", help_file(name, catalogue.language).read_text(encoding="utf-8"), count=1)
    return help_file(name).read_text(encoding="utf-8")


def english_digest(name: str) -> str:
    """Return the digest of an English page, by which a translation tells whether the page has changed since."""
    return sha256(help_file(name).read_text(encoding="utf-8").encode()).hexdigest()[:16]


def outdated(language: str) -> list[str]:
    """Return the pages that a language lacks, or whose English text has changed since they were translated."""
    found = []
    for name in page_names():
        path = help_file(name, language)
        stated = STATED.match(path.read_text(encoding="utf-8")) if path.is_file() else None
        if stated is None or stated.group(1) != english_digest(name):
            found.append(name)
    return found


def renew(name: str, language: str) -> None:
    """Note that a page translates the present English text. Raises InputError where there is no such page."""
    path = help_file(name, language)
    if name not in page_names() or not path.is_file():
        raise InputError(f"There is no help page {name} in {language}.", f"Write {path} first.")
    text = STATED.sub("", path.read_text(encoding="utf-8"), count=1)
    path.write_text(f"<!-- translates {english_digest(name)} -->\n\n{text}", encoding="utf-8", newline="\n")
