"""Translation of texts: `tr` of a text with values, `translated` of a text that was written elsewhere, `later` marks constants."""

from __future__ import annotations

import re
from collections import OrderedDict
from collections.abc import Mapping
from dataclasses import dataclass
from string import Formatter

from ui.look.language.catalogue import Catalogue

KEPT = 20_000  # texts whose origin is remembered, so that they can be translated anew when the language changes
SEPARATORS = [re.compile(f"({one})") for one in (r"\n", r"(?<=[.!?…]) ", " · ", ": ", "; ", ", ")]  # the coarsest first
LETTERS = re.compile(r"[A-Za-z]{2}")


IDEOGRAPHS = "\u4e00", "\u9fff"
BEGINS = {"lower": str.lower, "upper": str.upper}  # how a text begins, as the format of its placeholder
STOPPED = "stopped"  # a placeholder with the full stop of the script behind it


class WordsFormatter(Formatter):
    """Puts values into a template; those that are texts already, as found in a message, are not formatted again."""

    def format_field(self, value: object, format_spec: str) -> str:
        """Format one value."""
        if not isinstance(value, str):
            return format(value, format_spec)
        if format_spec == STOPPED:
            return value + full_stop(value)
        return BEGINS[format_spec](value[:1]) + value[1:] if format_spec in BEGINS else value


FORMATTER = WordsFormatter()


def full_stop(text: str) -> str:
    """Return the full stop of the script that a text ends in."""
    return "。" if IDEOGRAPHS[0] <= text[-1:] <= IDEOGRAPHS[1] else "."


@dataclass(frozen=True, slots=True)
class Origin:
    """What a displayed text was made of, and in which state of the translator."""

    source: str
    values: Mapping[str, object]
    state: int


class Translator:
    """The chosen catalogue, and where the texts on display came from."""

    def __init__(self) -> None:
        self._catalogue: Catalogue | None = None
        self._state = 0
        self._issued: OrderedDict[str, Origin] = OrderedDict()
        self._renewing = set[str]()

    @property
    def catalogue(self) -> Catalogue | None:
        """The translations in use; None: English."""
        return self._catalogue

    def use(self, catalogue: Catalogue | None) -> None:
        """Translate by another catalogue from now on."""
        self._catalogue = catalogue
        self._state += 1

    def translate(self, source: str, values: Mapping[str, object]) -> str:
        """Translate a text and put its values in; values that are texts of the program are translated, too."""
        template, put = source, values
        if self._catalogue is not None:
            template = self._catalogue.translation(source) or source
        if self._state:
            put = {name: self.renewed(value) if isinstance(value, str) else value for name, value in values.items()}
        made = FORMATTER.vformat(template, (), put) if values or "{{" in template else template
        if made and made not in values.values():  # else its value says all about it
            self._issued[made] = Origin(source, values, self._state)
            self._issued.move_to_end(made)
            if len(self._issued) > KEPT:
                self._issued.popitem(last=False)
        return made

    def origin(self, text: str) -> Origin | None:
        """Return what a text on display was last made of; None if it was not made here."""
        return self._issued.get(text)

    def renewed(self, text: str) -> str:
        """Return a text in the language chosen now: one displayed before, a constant, or a message of the core with its values put in.

        Texts of unknown origin, such as names that people gave, stay as they are.
        """
        if text in self._renewing:  # a value of itself, by way of other texts
            return text
        self._renewing.add(text)
        try:
            return self._renewed(text)
        finally:
            self._renewing.discard(text)

    def _renewed(self, text: str) -> str:
        origin = self._issued.get(text)
        if origin is not None:
            return text if origin.state == self._state else self.translate(origin.source, origin.values)
        catalogue = self._catalogue
        if catalogue is None or LETTERS.search(text) is None:
            return text
        constant = text.replace("{", "{{").replace("}", "}}")  # as a template without values
        if catalogue.translation(constant) is not None:
            return self.translate(constant, {})
        found = None if self._is_list(catalogue, text) else catalogue.find_template(text)
        if found is not None:
            return self.translate(*found)
        if text[-1] == "." and (catalogue.translation(text[:-1]) is not None or catalogue.find_template(text[:-1]) is not None):
            return self.translate(f"{{words:{STOPPED}}}", {"words": text[:-1]})  # a reason as a sentence of its own
        made = self._in_pieces(text)
        return self._begun_otherwise(text) if made == text else made

    @staticmethod
    def _is_list(catalogue: Catalogue, text: str) -> bool:
        """Whether a text lists constants, such as motions; a template that ends in a value would take the rest of the list for it."""
        items = text.split(", ")
        return len(items) > 1 and all(catalogue.translation(item) is not None for item in items)

    def _begun_otherwise(self, text: str) -> str:
        """Translate a text that is known with another case of its first letter, as where it became part of a sentence; names are one word."""
        other = text[0].swapcase() + text[1:]
        if " " not in text or other == text or self.renewed(other) == other:
            return text
        return self.translate("{words:lower}" if text[0].islower() else "{words:upper}", {"words": other})

    def _in_pieces(self, text: str) -> str:
        """Translate the sentences and items of a text one by one; where none is known it stays."""
        pieces = next((found for one in SEPARATORS if len(found := one.split(text)) > 1), [text])
        if len(pieces) == 1 or all(self.renewed(piece) == piece for piece in pieces[::2]):
            if text[-1] in "….:" and self.renewed(text[:-1]) != text[:-1]:  # such as a button that opens a dialog
                return self.translate("{words}" + text[-1], {"words": text[:-1]})
            return text
        values = {f"v{place}": piece for place, piece in enumerate(pieces[::2])}
        source = "".join(f"{{v{place // 2}}}" if place % 2 == 0 else piece for place, piece in enumerate(pieces))
        return self.translate(source, values)


TRANSLATOR = Translator()


def tr(source: str, /, **values: object) -> str:
    """Translate a text; ``values`` replace its placeholders: ``tr("{count} views left out", count=3)``."""
    return TRANSLATOR.translate(source, values)


def later(source: str) -> str:
    """Mark a text of one word for translation, which would otherwise be taken for a name; it is translated where it is displayed."""
    return source


def translated(text: str) -> str:
    """Translate a constant, or a message of the core, for display; texts that are translated already stay."""
    return TRANSLATOR.renewed(text)
