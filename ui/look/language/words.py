"""Translation of texts: `tr` of a text with values, `translated` of a text that was written elsewhere, `later` marks constants."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Mapping

from ui.look.language.catalogue import Catalogue

KEPT = 20_000  # texts whose origin is remembered, so that they can be translated anew when the language changes


class Translator:
    """The chosen catalogue, and where the texts on display came from."""

    def __init__(self) -> None:
        self.catalogue: Catalogue | None = None  # None: English
        self._issued: OrderedDict[str, tuple[str, Mapping[str, object]]] = OrderedDict()

    def translate(self, source: str, values: Mapping[str, object]) -> str:
        """Translate a text and put its values in."""
        if self.catalogue is None:
            template, put = source, values
        else:  # values may be words of the core, such as the reason of a refusal
            template = self.catalogue.translation(source) or source
            put = {name: self.translate_written(value) if isinstance(value, str) else value for name, value in values.items()}
        made = template.format(**put) if values else template
        if made:
            self._issued[made] = source, values
            self._issued.move_to_end(made)
            if len(self._issued) > KEPT:
                self._issued.popitem(last=False)
        return made

    def translate_written(self, text: str) -> str:
        """Translate a text that was written without `tr`: a constant, or a message of the core with its values put in."""
        if self.catalogue is None or not text or text in self._issued:
            return text
        if self.catalogue.translation(text) is not None:
            return self.translate(text, {})
        found = self.catalogue.find_template(text)
        if found is None:
            return text
        source, values = found
        return self.translate(source, values)

    def renewed(self, text: str) -> str:
        """Return a displayed text in the language chosen now; texts of unknown origin stay."""
        origin = self._issued.get(text)
        if origin is None:
            return self.translate_written(text)
        source, values = origin
        return self.translate(source, {name: self.renewed(value) if isinstance(value, str) else value for name, value in values.items()})


TRANSLATOR = Translator()


def tr(source: str, /, **values: object) -> str:
    """Translate a text; ``values`` replace its placeholders: ``tr("{count} views left out", count=3)``."""
    return TRANSLATOR.translate(source, values)


def later(source: str) -> str:
    """Mark the text of a constant for translation; it is translated where it is displayed."""
    return source


def translated(text: str) -> str:
    """Translate a constant, or a message of the core, for display; texts that are translated already stay."""
    return TRANSLATOR.translate_written(text)
