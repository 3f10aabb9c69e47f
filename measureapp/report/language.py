"""The words of documents in their language: fixed texts, sentences that the core wrote, and texts of layouts."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from pathlib import Path

from measureapp.data.dimension import Dimension
from measureapp.language.languages import ENGLISH, catalogue_of
from measureapp.language.translator import Translator, punctuated
from measureapp.report.model import ReportModel
from measureapp.report.words import format_name

LAYOUT_TEXT = re.compile(r'\bt\("([^"]+)"')
"""How a layout in Typst or HTML names a text that is translated: ``t("Page {page} of {pages}", page: …)``."""


class Words:
    """Translates what a document states; names that people gave stay as they are."""

    def __init__(self, language: str = ENGLISH, names: Iterable[str] = ()) -> None:
        """Raise InputError where the catalogue of the language is damaged."""
        self.language = language
        self._translator = Translator(name for name in names if name)
        self._translator.use(catalogue_of(language))

    def tr(self, source: str, /, **values: object) -> str:
        """Return a fixed text with its values; values that are texts of the program are translated, too."""
        return self._translator.translate(source, values)

    def said(self, text: str) -> str:
        """Return a constant, or a sentence that the core wrote with its values in it."""
        return self._translator.renewed(text)

    def label(self, word: str) -> str:
        """Return a lower-case word of a document, which the catalogue may have as a label."""
        for source in (word, word.capitalize()):
            if (there := self.tr(source)) != source:
                return there
        return word

    def listed(self, text: str) -> str:
        """Return a text of translated items with the marks of its language between them."""
        return text if self.language == ENGLISH else punctuated(text)

    @property
    def tag(self) -> str:
        """The language as HTML names it, such as ``zh-CN``."""
        return self.language.replace("_", "-")

    def of_layout(self, layout: str) -> dict[str, str]:
        """Return the translations of the texts that a layout names."""
        return {text: self.tr(text) for text in layout_texts(layout)}


def layout_texts(layout: str) -> list[str]:
    """Return the texts that a layout in Typst or HTML has translated.

    >>> layout_texts('#t("Views") {{ t("Page {page}", page=1) }}')
    ['Views', 'Page {page}']
    """
    return list(dict.fromkeys(LAYOUT_TEXT.findall(layout)))


def read_layout(path: Path) -> str:
    """Return the text of a layout; letters that are no UTF-8 are replaced, as the typesetter names them better."""
    return path.read_text(encoding="utf-8", errors="replace")


def words_of(model: ReportModel) -> Words:
    """Return the words of a report in its language."""
    language = model.details.language
    return Words(language, () if language == ENGLISH else _names(model))


def names_of_dimensions(dimensions: Iterable[Dimension]) -> Iterator[str]:
    """Yield the names that people gave to dimensions and to what they refer to, also as they are printed."""
    for dimension in dimensions:
        for name in (dimension.name, dimension.group, *dimension.features, *dimension.datums):
            yield from (name, format_name(name))
        yield "|".join(dimension.datums)


def _names(model: ReportModel) -> Iterator[str]:
    """Yield every text of a report that people gave."""
    measurement, details = model.measurement, model.details
    description, inspection = details.template.description, measurement.inspection
    yield from (model.title, measurement.project, measurement.part, measurement.rig, details.part_program)
    yield from (str(getattr(details.identification, one)) for one in type(details.identification).model_fields)
    yield from (description.company, description.address, description.opening, description.closing)
    yield from names_of_dimensions(model.dimensions)
    if inspection is not None:
        yield inspection.program
        for feature in inspection.features:
            yield from (feature.name, format_name(feature.name))
    for view in measurement.views:
        yield view.viewpoint_id
    for name, camera in measurement.calibration.cameras.cameras.items():
        yield from (name, camera.serial)
    yield from (setup.name for setup in measurement.setups)
    if details.plan is not None:
        yield details.plan.name
