"""Search by letters in order, as in command palettes: "oprj" finds "Open project"."""

from __future__ import annotations

import re

WORD_START, FOLLOWING, PREFIX, AS_TYPED = 3.0, 2.0, 4.0, 3.0
KEYWORD_SHARE = 0.6


def score(typed: str, text: str, keywords: str = "") -> float | None:
    """Return how well the words typed fit; None if the letters of one occur in this order neither in the text nor in the keywords.

    >>> score("op", "Open project") > score("op", "Stop everything")
    True
    >>> score("pdf export", "PDF report", "export save") > 0.0
    True
    >>> score("xyz", "Open project") is None
    True
    """
    points = 0.0
    for letters in typed.casefold().split():
        in_text, in_keywords = _score(letters, text.casefold()), _score(letters, keywords.casefold())
        if in_text is None and in_keywords is None:
            return None
        points += max(in_text or 0.0, KEYWORD_SHARE * (in_keywords or 0.0))
    return points


def _score(letters: str, text: str) -> float | None:
    """Score the best of all alignments that begin at an occurrence of the first letter; better where a word begins as typed."""
    best: float | None = None
    start = text.find(letters[0])
    while start >= 0:
        found = _from(letters, text, start)
        if found is not None and (best is None or found > best):
            best = found
        start = text.find(letters[0], start + 1)
    begins_a_word = best is not None and re.search(rf"(?<!\w){re.escape(letters)}", text)
    return best + AS_TYPED * len(letters) if begins_a_word else best


def _from(letters: str, text: str, start: int) -> float | None:
    points, place, last = 0.0, start, -2
    for letter in letters:
        place = text.find(letter, place)
        if place < 0:
            return None
        points += 1.0
        if place == 0 or not text[place - 1].isalnum():
            points += WORD_START
        if place == last + 1:
            points += FOLLOWING
        last, place = place, place + 1
    return points + (PREFIX if text.startswith(letters) else 0.0) - 0.01 * len(text)
