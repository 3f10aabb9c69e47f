"""Brings the catalogues up to date with the code: ``python -m ui.look.language [--missing] [--help-page NAME …]``."""

from __future__ import annotations

import sys

from measureapp.language.catalogue import Entry, read_catalogue, write_catalogue
from measureapp.language.languages import LANGUAGES
from ui.look.language.help_pages import outdated, renew
from ui.look.language.sources import catalogue_file, core_texts, window_texts


def main(arguments: list[str]) -> int:
    """Add new texts, drop those that are gone, and print what is missing; with ``--missing`` every text that is.

    ``--help-page NAME …``: note that the translations of these pages are those of the present English text. Raises InputError without a page.
    """
    languages = [one for one in LANGUAGES if one != "en"]
    if arguments[:1] == ["--help-page"]:
        for language in languages:
            for name in arguments[1:]:
                renew(name, language)
    else:
        _renew_catalogues(languages, every="--missing" in arguments)
    for language in languages:
        if old := outdated(language):
            sys.stdout.write(f"{language}: help pages to translate, because their English text is new: {', '.join(old)}.\n")
    return 0


def _renew_catalogues(languages: list[str], every: bool) -> None:
    texts = {**{text: f"core.{room}" for text, room in core_texts().items()}, **window_texts()}
    for language in languages:
        path = catalogue_file(language)
        known = read_catalogue(path).entries if path.exists() else {}
        entries = [(room, known.get(text) or Entry(text)) for text, room in sorted(texts.items(), key=lambda one: (one[1], one[0]))]
        write_catalogue(path, language, entries)
        missing = [entry.source for _, entry in entries if not entry.translation]
        told = [f"{language}: {len(entries) - len(missing)} of {len(entries)} texts translated.", *(missing if every else ())]
        sys.stdout.write("\n".join(told) + "\n")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
