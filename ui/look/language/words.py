"""Translation of the window's texts: `tr` of a text with values, `translated` of a text that was written elsewhere, `later` marks constants."""

from __future__ import annotations

from measureapp.language.languages import ENGLISH
from measureapp.language.translator import Translator

TRANSLATOR = Translator()


def spoken() -> str:
    """Return the name of the language that texts are translated into."""
    catalogue = TRANSLATOR.catalogue
    return ENGLISH if catalogue is None else catalogue.language


def tr(source: str, /, **values: object) -> str:
    """Translate a text; ``values`` replace its placeholders: ``tr("{count} views left out", count=3)``."""
    return TRANSLATOR.translate(source, values)


def later(source: str) -> str:
    """Mark a text of one word for translation, which would otherwise be taken for a name; it is translated where it is displayed."""
    return source


def for_name(word: str, /) -> str:
    """Translate a lower-case word of a name that is proposed; unlike other texts a name stays as it is when the language changes."""
    catalogue = TRANSLATOR.catalogue
    sources = () if catalogue is None else (word[:1].upper() + word[1:], word)
    return next((found for one in sources if catalogue is not None and (found := catalogue.translation(one))), word)


def translated(text: str) -> str:
    """Translate a constant, or a message of the core, for display; texts that are translated already stay."""
    return TRANSLATOR.renewed(text)
