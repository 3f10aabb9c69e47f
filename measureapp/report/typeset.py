"""Typesetting of a Typst layout with its data and pictures, in the fonts that come with the program."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

from measureapp.errors import StorageError
from measureapp.project.series.database import seconds
from measureapp.report.fonts import FAMILIES, every_text, font_folder, is_invisible, missing_letters, spell_out
from measureapp.report.language import Words, read_layout
from measureapp.resources import resource

MAIN, DATA = "main.typ", "report.json"
WORDS = "words.typ"  # the function of layouts that translates their texts
ARCHIVE = "a-2b"  # PDF/A-2b, for long-term archiving
NO_GLYPH = "could not be displayed"


@dataclass(frozen=True, slots=True)
class Typeset:
    """What is typeset: a layout, its data and its pictures."""

    layout: Path
    data: Mapping[str, Any]
    pictures: Mapping[str, bytes]
    created_at: str  # ISO 8601; equal documents at equal times are equal byte by byte
    words: Words = field(default_factory=Words)  # in the language of the document

    def with_words(self) -> dict[str, Any]:
        """Return the data with what is the same for every layout: its texts, its language and its fonts."""
        language, _, region = self.words.tag.partition("-")
        return {
            **self.data,
            "words": self.words.of_layout(read_layout(self.layout)),
            "lang": language,
            "region": region or None,
            "fonts": list(FAMILIES),
        }


def typeset(document: Typeset, form: Literal["pdf", "png"] = "pdf", ppi: float = 110.0) -> tuple[bytes, ...]:
    """Typeset a document and return it as PDF, or its pages as PNG.

    Letters that the program's fonts lack are taken from fonts of the computer; what these lack, too, is printed as its code point.

    Raises
    ------
    StorageError
        The layout has an error, which is named.
    """
    import typst

    compiled: Any = typst.compile
    data = document.with_words()
    letters = missing_letters(every_text(data))
    hidden = frozenset(letter for letter in letters if is_invisible(letter))
    try:
        with tempfile.TemporaryDirectory(prefix="measureapp-report-") as folder:
            place = Path(folder)
            for name, content in {
                MAIN: document.layout.read_bytes(),
                WORDS: resource(f"report/{WORDS}").read_bytes(),
                **document.pictures,
            }.items():
                (place / name).write_bytes(content)
            options: dict[str, Any] = {"root": folder, "font_paths": [str(font_folder())], "timestamp": int(seconds(document.created_at))}
            options["ignore_system_fonts"] = letters == hidden
            pdf = _with_letters(data, hidden, letters, place, options) if form == "pdf" or letters != hidden else b""
            if form == "pdf":
                return (pdf,)
            if not (place / DATA).exists():
                _write(place, data, hidden)
            made = compiled(str(place / MAIN), format="png", ppi=ppi, **options)
    except (typst.TypstError, RuntimeError) as error:
        hint = "Correct the template, or use the built-in one."
        raise StorageError(f"{document.layout}: the report template has an error: {error}.", hint) from error
    return tuple(bytes(page) for page in made) if isinstance(made, list) else (bytes(made),)


def _with_letters(data: Mapping[str, Any], hidden: frozenset[str], letters: frozenset[str], place: Path, options: dict[str, Any]) -> bytes:
    """Return the PDF; where no font at all has a letter, with code points in place of all letters that the program's fonts lack."""
    import typst

    _write(place, data, hidden)
    try:
        return _archived(place, options)
    except typst.TypstError as error:
        if NO_GLYPH not in str(error) or letters == hidden:
            raise
    _write(place, data, letters)
    options["ignore_system_fonts"] = True
    return _archived(place, options)


def _archived(place: Path, options: Mapping[str, Any]) -> bytes:
    """Return the PDF for archiving; a layout of the user's that cannot be archived makes a plain one."""
    import typst

    compiled: Any = typst.compile
    try:
        return bytes(compiled(str(place / MAIN), format="pdf", pdf_standards=ARCHIVE, **options))
    except typst.TypstError as error:
        if "PDF/A" not in str(error) or NO_GLYPH in str(error):
            raise
        return bytes(compiled(str(place / MAIN), format="pdf", **options))


def _write(place: Path, data: Mapping[str, Any], spelt: frozenset[str]) -> None:
    (place / DATA).write_text(json.dumps(spell_out(data, spelt)), encoding="utf-8")
