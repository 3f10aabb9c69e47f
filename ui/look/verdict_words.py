"""Verdicts in words: how many dimensions have which, the worst first."""

from __future__ import annotations

from collections.abc import Sequence

from ui.look.language.words import later, tr, translated
from ui.look.wording import several

NO_DIMENSIONS = "The program evaluated no dimension: there is no verdict."
NO_TOLERANCE = "No dimension has a tolerance: nothing is proven."
LOUD = {
    "fail": later("FAIL"),
    "not proven": later("NOT PROVEN"),
    "not measured": later("NOT MEASURED"),
    "pass": later("PASS"),
    "no tolerance": later("NO TOLERANCE"),
}
COUNTED = {
    "fail": "{n} fail",
    "not proven": "{n} not proven",
    "not measured": "{n} not measured",
    "pass": "{n} pass",
    "no tolerance": "{n} without tolerance",
}


def loud(verdict: str) -> str:
    """Return a verdict as it is called out to an operator.

    >>> loud("not proven")
    'NOT PROVEN'
    """
    return translated(LOUD[verdict])


def summary_words(verdicts: Sequence[str]) -> str:
    """Return how many dimensions have which verdict, the worst first.

    >>> summary_words(["pass", "fail"]), summary_words(["pass"])
    ('1 fail, 1 pass, of 2 dimensions.', 'The dimension passes.')
    """
    if not verdicts:
        return NO_DIMENSIONS
    if set(verdicts) == {"pass"}:
        return tr("All {count} pass.", count=several(len(verdicts), "dimension")) if len(verdicts) > 1 else "The dimension passes."
    if set(verdicts) == {"no tolerance"}:
        return NO_TOLERANCE
    counts = [tr(words, n=list(verdicts).count(name)) for name, words in COUNTED.items() if name in verdicts]
    return tr("{list}, of {count}.", list=", ".join(counts), count=several(len(verdicts), "dimension"))
