"""File names that are valid on every system."""

from __future__ import annotations

import re
import unicodedata

LONGEST = 120  # characters, ending included
LONGEST_BYTES = 240  # of UTF-8; file systems allow 255
FORBIDDEN = re.compile(r'[<>:"/\\|?*\x00-\x1f\x7f-\x9f\u2028\u2029]')
RESERVED = re.compile(r"^(con|prn|aux|nul|conin\$|conout\$|com[0-9¹²³]|lpt[0-9¹²³])(\.|$)", re.IGNORECASE)


def safe_file_name(text: str, ending: str = "", *, fallback: str = "unnamed") -> str:
    """Return ``text`` as a file name without what Windows, macOS or Linux refuse, in Unicode's composed form.

    >>> safe_file_name('Ø 12/H7: "bore"', ".pdf"), safe_file_name("con"), safe_file_name(" .. ")
    ('Ø 12 H7 bore.pdf', '_con', 'unnamed')
    """
    composed = unicodedata.normalize("NFC", text)
    stem = " ".join("".join(letter for letter in FORBIDDEN.sub(" ", composed) if unicodedata.category(letter) not in ("Cs", "Cf")).split())
    stem = stem.strip(". ") or fallback
    if RESERVED.match(stem):
        stem = f"_{stem}"
    stem = stem[: LONGEST - len(ending)]
    while len(f"{stem}{ending}".encode()) > LONGEST_BYTES:
        stem = stem[:-1]
    return f"{stem.rstrip('. ')}{ending}"
