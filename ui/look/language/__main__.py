"""Brings the catalogues up to date with the code: ``python -m ui.look.language [--missing]``."""

from __future__ import annotations

import sys

from measureapp.language.catalogue import Entry, read_catalogue, write_catalogue
from measureapp.language.languages import LANGUAGES
from ui.look.language.sources import catalogue_file, core_texts, window_texts


def main(arguments: list[str]) -> int:
    """Add new texts, drop those that are gone, and print what is missing; with ``--missing`` every text that is."""
    texts = {**{text: f"core.{room}" for text, room in core_texts().items()}, **window_texts()}
    for language in LANGUAGES:
        if language == "en":
            continue
        path = catalogue_file(language)
        known = read_catalogue(path).entries if path.exists() else {}
        entries = [(room, known.get(text) or Entry(text)) for text, room in sorted(texts.items(), key=lambda one: (one[1], one[0]))]
        write_catalogue(path, language, entries)
        missing = [entry.source for _, entry in entries if not entry.translation]
        told = [
            f"{language}: {len(entries) - len(missing)} of {len(entries)} texts translated.",
            *(missing if "--missing" in arguments else ()),
        ]
        sys.stdout.write("\n".join(told) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
