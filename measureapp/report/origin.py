"""Where a value comes from, in the language of a document: features, filter, criterion, datums and copies."""

from __future__ import annotations

import re

from measureapp.language.translator import full_stop
from measureapp.report.language import Words

FEATURE = re.compile(r"(?P<points>[^:;]+: \d+ points, \d+ rejected)(?P<segment>, small segment: [^(]+?)?(?: \((?P<how>.+)\))?")
SHARE = re.compile(r"(\d+%) ([^,;]+)")  # of the border of a grown feature that ends for one reason
BEGINS = re.compile(r"; |, (?=[^:;,()]+: (?:\d+ points, |not found|constructed)|\d+ constructed features: )")


def origin_words(traceability: str, words: Words) -> str:
    """Return the source of a value; its parts are translated one by one, as the names in them are anyone's."""
    parts = [_part_words(part, words) for part in origin_parts(traceability)]
    made = "; ".join(parts)
    return words.listed(made if full_stop(made) == "." else "；".join(parts))


def origin_parts(traceability: str) -> list[str]:
    """Return the parts of a source, of features each; what stands in brackets belongs to the part before.

    >>> origin_parts("rim: 9 points, 1 rejected (grown; border: edge), hub: 7 points, 0 rejected; datums A|B")
    ['rim: 9 points, 1 rejected (grown; border: edge)', 'hub: 7 points, 0 rejected', 'datums A|B']
    """
    parts, start = list[str](), 0
    for mark in BEGINS.finditer(traceability):
        before = traceability[start : mark.start()]
        if before.count("(") == before.count(")"):
            parts.append(before)
            start = mark.end()
    return [*parts, traceability[start:]]


def _part_words(part: str, words: Words) -> str:
    found = FEATURE.fullmatch(part)
    if found is None:
        return words.said(part)
    how = words.said(SHARE.sub(lambda one: f"{one[1]} {words.said(one[2])}", found["how"])) if found["how"] else ""
    bracketed = "" if not how else f" ({how})" if full_stop(how) == "." else f"（{how}）"
    return words.said(found["points"]) + (words.said(found["segment"]) if found["segment"] else "") + bracketed
