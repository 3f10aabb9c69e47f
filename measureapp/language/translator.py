"""A translator of texts: of templates with values, and of English sentences by the template that they were made of."""

from __future__ import annotations

import re
from collections import OrderedDict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from string import Formatter

from measureapp.language.catalogue import LEAST_LETTERS, PLACEHOLDER, SURE_LETTERS, Catalogue, fixed_letters

KEPT = 20_000  # texts whose origin is remembered, so that they can be translated anew when the language changes
SEPARATORS = [re.compile(f"({one})") for one in (r"\n", r"(?<=[.!?…]) ", " · ", ": ", "; ", ", ")]  # the coarsest first
AND = re.compile("( and | or )")
LETTERS = re.compile(r"[A-Za-z]{2}")

IDEOGRAPHS = "\u4e00", "\u9fff"
IDEOGRAPH = re.compile(f"[{IDEOGRAPHS[0]}-{IDEOGRAPHS[1]}]")
AFTER_IDEOGRAPH = f"(?<=[{IDEOGRAPHS[0]}-{IDEOGRAPHS[1]}）”])"
BEFORE_IDEOGRAPH = f"(?=[{IDEOGRAPHS[0]}-{IDEOGRAPHS[1]}])"
PUNCTUATION = tuple(  # of sentences that were put together, as Chinese writes it
    (re.compile(pattern), mark)
    for pattern, mark in (
        *(
            (rf"{AFTER_IDEOGRAPH}{ascii} (?=\S)|{ascii} {BEFORE_IDEOGRAPH}", mark)
            for ascii, mark in ((",", "，"), (";", "；"), (":", "："))
        ),
        (rf"(?:{AFTER_IDEOGRAPH}|(?<=\d[°%]))\. ?(?=$|[{IDEOGRAPHS[0]}-{IDEOGRAPHS[1]}])", "。"),
        (rf"(?<=[{IDEOGRAPHS[0]}-{IDEOGRAPHS[1]}]\s)([\d\s]*\d)\.$", r"\1。"),
        ("。 ", "。"),
        ("(?<=或)(?=[A-Za-z0-9])", " "),
    )
)
BEGINS = {"lower": str.lower, "upper": str.upper}  # how a text begins, as the format of its placeholder
STOPPED = "stopped"  # a placeholder with the full stop of the script behind it
UNSTOPPED = "unstopped"  # and without it
KEPT_UNITS = "kept"  # and with non-breaking spaces between numbers and their units
UNIT_AFTER_NUMBER = re.compile(r"(?<=\d) (?=(?:mm|µm|px|ppm|ms|µs|s|min|h|K|kB|MB|GB|TB)\b|[%°])")
NO_WORDS = re.compile(r"""`[^`]*`|'[^']*'|"[^"]*"|\S*[\d/\\._]\S*""")  # names in quotes, files, fields and numbers
WORD = re.compile(r"\b[a-zµ]{3,}\b")
WORDS = re.compile(r"\b[a-zµ]{3,}\b.*\s\w|\w\s.*\b[a-zµ]{3,}\b")  # of which a sentence is made, rather than a name


class WordsFormatter(Formatter):
    """Puts values into a template; those that are texts already, as found in a message, are not formatted again."""

    def format_field(self, value: object, format_spec: str) -> str:
        """Format one value."""
        if not isinstance(value, str):
            return format(value, format_spec)
        if format_spec == STOPPED:
            return value + full_stop(value)
        if format_spec == UNSTOPPED:
            return value.rstrip(".。")
        if format_spec == KEPT_UNITS:
            return UNIT_AFTER_NUMBER.sub("\u00a0", value)
        return BEGINS[format_spec](value[:1]) + value[1:] if format_spec in BEGINS else value


FORMATTER = WordsFormatter()


def full_stop(text: str) -> str:
    """Return the full stop of the script that a text is in."""
    return "。" if IDEOGRAPH.search(text) else "."


def punctuated(text: str) -> str:
    """Return a text with the marks of the script that it is in, also between parts of it that were translated one by one."""
    for pattern, mark in PUNCTUATION if IDEOGRAPH.search(text) else ():
        text = pattern.sub(mark, text)
    return text


@dataclass(frozen=True, slots=True)
class Origin:
    """What a displayed text was made of, and in which state of the translator."""

    source: str
    values: Mapping[str, object]
    state: int


class Translator:
    """The chosen catalogue, and where the texts on display came from."""

    def __init__(self, names: Iterable[str] = ()) -> None:
        """``names``: texts that people gave, which stay as they are, also where one equals a text of the program."""
        self._names = frozenset(names)
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
        if self._catalogue is not None:
            made = punctuated(made)
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
        if text in self._renewing or text in self._names:  # a value of itself, by way of other texts; or a name
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
        is_list = self._is_list(catalogue, text)
        found = None if is_list else self._template(catalogue, text)
        if found is not None:
            return self.translate(*found)
        if (
            text[-1] != "."
            and not is_list
            and (catalogue.translation(f"{text}.") is not None or self._template(catalogue, f"{text}.") is not None)
        ):
            return self.translate(f"{{words:{UNSTOPPED}}}", {"words": f"{text}."})  # a sentence as part of another one
        made = self._in_pieces(text)
        return self._begun_otherwise(text) if made == text else made

    def _template(self, catalogue: Catalogue, text: str) -> tuple[str, dict[str, str]] | None:
        """Return the template that a text was made of, and its values; one of few letters only if its values are known."""
        reason = text[:-1] if text[-1] == "." else ""  # as a sentence of its own
        whole = f"{{words:{STOPPED}}}", {"words": reason}
        if reason and catalogue.translation(reason) is not None:
            return whole
        found = [(one, whole) for one in catalogue.find_templates(reason)] if reason else []
        found += [(one, one) for one in catalogue.find_templates(text)]
        for (source, values), made in sorted(found, key=lambda one: -len(PLACEHOLDER.sub("", one[0][0]))):
            letters = fixed_letters(source)
            if letters >= SURE_LETTERS or all(
                self._is_known(value, WORD if letters < LEAST_LETTERS else WORDS) for value in values.values()
            ):
                return made
        return None

    def _is_known(self, value: str, unknown: re.Pattern[str]) -> bool:
        """Whether a value has no words, or all of it can be translated."""
        catalogue = self._catalogue
        if value in self._names:
            return True
        if catalogue is None or not value or unknown.search(NO_WORDS.sub("", value)) is None or value in self._issued:
            return True
        if any(catalogue.translation(one) is not None for one in (value, f"{value}.", value[0].swapcase() + value[1:])):
            return True
        if self._template(catalogue, value) is not None or self._template(catalogue, f"{value}.") is not None:
            return True
        pieces = self._pieces(value)
        return len(pieces) > 1 and all(self._is_known(piece, unknown) for piece in pieces[::2])

    @staticmethod
    def _is_list(catalogue: Catalogue, text: str) -> bool:
        """Whether a text lists constants, such as motions; a template that ends in a value would take the rest of the list for it."""
        items = text.split(", ")
        return len(items) > 1 and all(catalogue.translation(item) is not None for item in items)

    def _begun_otherwise(self, text: str) -> str:
        """Translate a text that is known with another case of its first letter, as where it became part of a sentence; names are one word."""
        other = text[0].swapcase() + text[1:]
        if " " not in self._pieces(text)[0] or other == text or self.renewed(other) == other:
            return text
        return self.translate("{words:lower}" if text[0].islower() else "{words:upper}", {"words": other})

    @staticmethod
    def _pieces(text: str) -> list[str]:
        """Return the sentences or items of a text, and between them what separates them."""
        return next((found for one in SEPARATORS if len(found := one.split(text)) > 1), [text])

    def _in_pieces(self, text: str) -> str:
        """Translate the sentences and items of a text one by one; where none is known it stays."""
        pieces = self._pieces(text)
        listed = AND.split(text)
        if len(pieces) == 1 and all(self.renewed(piece) != piece for piece in listed[::2]):
            pieces = listed  # a list whose items are known; other sentences are not torn apart
        if len(pieces) == 1 or all(self.renewed(piece) == piece for piece in pieces[::2]):
            if text[-1] in "….:" and self.renewed(text[:-1]) != text[:-1]:  # such as a button that opens a dialog
                return self.translate("{words}" + text[-1], {"words": text[:-1]})
            return text
        values = {f"v{place}": piece for place, piece in enumerate(pieces) if place % 2 == 0 or AND.fullmatch(piece)}
        source = "".join(f"{{v{place}}}" if f"v{place}" in values else piece for place, piece in enumerate(pieces))
        return self.translate(source, values)
