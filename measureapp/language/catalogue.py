"""Catalogues of translations: files of Qt Linguist, read as they are."""

from __future__ import annotations

import re
import string
from collections import defaultdict
from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from xml.etree import ElementTree

from measureapp.errors import InputError

LONGEST_VALUE = 2000  # letters that a value of a recognised message may have
SURE_LETTERS = 10  # fixed letters of a template by which a message is recognised, whatever its values are
LEAST_LETTERS = 6  # and by which it is recognised if its values are single words, or texts that are known
FEWEST_LETTERS = 3  # and if it is a whole sentence with values that are known or no words, or if its values are numbers
ANY = f".{{0,{LONGEST_VALUE}}}?"
REPEATED_LETTERS = 5  # of a fixed piece by which a value is found to contain its template again
NUMBER = r"[-+−±]?\d[\d.,]*"


@dataclass(frozen=True, slots=True)
class Entry:
    """One text and its translation; empty: not translated yet."""

    source: str
    translation: str = ""


@dataclass
class Catalogue:
    """Translations into one language."""

    language: str  # as in "zh_CN"
    entries: dict[str, Entry] = field(default_factory=dict)
    _patterns: dict[str, list[tuple[str, str]]] | None = None  # of templates, by the longest fixed word; compiled when they are needed

    def translation(self, source: str) -> str | None:
        """Return the translation of a text; None without one."""
        entry = self.entries.get(source)
        return entry.translation if entry is not None and entry.translation else None

    def find_templates(self, text: str) -> list[tuple[str, dict[str, str]]]:
        """Return the templates that a text may have been made of, and its values as texts; those with most fixed letters first."""
        if self._patterns is None:
            self._patterns = _patterns(self.entries.values())
        found: list[tuple[str, dict[str, str]]] = []
        for word in dict.fromkeys(WORD.findall(text)):
            for pattern, source in self._patterns.get(word, ()):
                match = _compiled(pattern).fullmatch(text)
                if match is not None and not _repeated(source, match):
                    found.append((source, match.groupdict()))
        return sorted(found, key=lambda one: -len(PLACEHOLDER.sub("", one[0])))


LETTER = re.compile(r"[A-Za-z]")
WORD = re.compile(r"[A-Za-z]{3,}")
PLACEHOLDER = re.compile(r"(?<!\{)\{(\w+)[^{}]*\}(?!\})")


def placeholders(text: str) -> list[str]:
    """Return the names of the placeholders of a text, sorted. Raises ValueError where it cannot be formatted.

    >>> placeholders("{count} of {total} views")
    ['count', 'total']
    """
    return sorted(name for _, name, _, _ in string.Formatter().parse(text) if name is not None)


def read_catalogue(path: Path) -> Catalogue:
    """Read a file of Qt Linguist.

    Raises
    ------
    InputError
        The file is damaged, or a translation has other placeholders than its source.
    """
    try:
        tree = ElementTree.parse(path).getroot()
    except (OSError, ElementTree.ParseError) as error:
        raise InputError(f"{path} is not a file of Qt Linguist: {error}.", "Install the program anew.") from error
    found = Catalogue(tree.get("language", ""))
    for message in tree.iter("message"):
        source, translation = message.findtext("source", ""), message.findtext("translation", "")
        if translation and _names(source) != _names(translation):
            raise InputError(f"{path}: “{translation}” has other placeholders than “{source}”.", "Correct this translation.")
        found.entries[source] = Entry(source, translation)
    return found


def write_catalogue(path: Path, language: str, entries: Iterable[tuple[str, Entry]]) -> None:
    """Write a file of Qt Linguist from pairs of context and entry, in their order."""
    contexts: dict[str, list[Entry]] = defaultdict(list)
    for room, entry in entries:
        contexts[room].append(entry)
    root = ElementTree.Element("TS", version="2.1", language=language, sourcelanguage="en")
    for name, own in contexts.items():
        context = ElementTree.SubElement(root, "context")
        ElementTree.SubElement(context, "name").text = name
        for entry in own:
            message = ElementTree.SubElement(context, "message")
            ElementTree.SubElement(message, "source").text = entry.source
            translation = ElementTree.SubElement(message, "translation")
            translation.text = entry.translation or None
            if not entry.translation:
                translation.set("type", "unfinished")
    ElementTree.indent(root, "  ")
    text = ElementTree.tostring(root, encoding="unicode")
    path.write_text(f'<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n{text}\n', encoding="utf-8")


def _names(text: str) -> list[str] | None:
    """Return the placeholders; None where the text is no template."""
    try:
        return placeholders(text)
    except ValueError:
        return None


def fixed_letters(source: str) -> int:
    """Return how many letters of a template are not of its values."""
    return len(LETTER.findall(PLACEHOLDER.sub("", source)))


def _repeated(source: str, match: re.Match[str]) -> bool:
    """Whether a value contains a fixed piece of its template again: the text lists several, which are translated one by one."""
    pieces = [piece for piece in PLACEHOLDER.split(source)[::2] if len(LETTER.findall(piece)) >= REPEATED_LETTERS]
    return any(piece in value for piece in pieces for value in match.groups())


@cache
def _compiled(pattern: str) -> re.Pattern[str]:
    """Return a pattern compiled: most of the 2000 are never needed, and all of them take 0.2 s."""
    return re.compile(pattern, re.DOTALL)


def _patterns(entries: Iterable[Entry]) -> dict[str, list[tuple[str, str]]]:
    """Return patterns of the translated templates by a fixed word that a text must contain to match."""
    found: dict[str, list[tuple[str, str]]] = defaultdict(list)
    for entry in entries:
        if not entry.translation or not _names(entry.source):
            continue
        pieces = PLACEHOLDER.split(entry.source)
        words = [word for piece in pieces[::2] for word in WORD.findall(piece)]
        letters = fixed_letters(entry.source)
        if not words or letters < FEWEST_LETTERS:
            continue  # such as "{a} of {b}": it would match too much
        value = ANY if letters >= LEAST_LETTERS or entry.source.endswith(".") else NUMBER
        seen: set[str] = set()
        text = ""
        for place, piece in enumerate(pieces):
            if place % 2 == 0:
                text += re.escape(piece.replace("{{", "{").replace("}}", "}"))
            else:
                text += f"(?P={piece})" if piece in seen else f"(?P<{piece}>{value})"
                seen.add(piece)
        found[max(words, key=len)].append((text, entry.source))
    return found
