"""What the pattern sets are called, and one line about each."""

from __future__ import annotations

from measureapp.data.pattern_sets import DEFAULT_NAME, PATTERN_SETS
from ui.look.wording import sentence_case, several

TITLES = {
    "paper": "Paper: 32 and 33 px",
    "paper-8-step": "Paper's pitches, 8 steps",
    "three-close": "Three close pitches",
    "three-close-3-step": "Three close, 3 steps",
    "three-close-8-step": "Three close, 8 steps",
    "three-wide": "Three wide pitches",
    "three-wide-8-step": "Three wide, 8 steps",
    "three-wide-32": "Three wide, from 32 px",
    "hierarchical": "Each half of the last",
    "gray": "Gray code",
    "complementary-gray": "Complementary Gray code",
    "complementary-gray-8-step": "Complementary Gray, 8 steps",
}
BOTH = "-both"


def pattern_title(name: str) -> str:
    """Return what the set of this name is called."""
    plain = name.removesuffix(BOTH)
    title = TITLES.get(plain) or sentence_case(plain.replace("-", " "))
    return title + (", both ways" if name != plain else "")


def pattern_line(name: str) -> str:
    """Return one line about the set of this name: ``Recommended. 12 images: 4 steps at 16, 17.84 and 18.14 px.``"""
    patterns = PATTERN_SETS[name]
    advice = "Recommended. " if name == DEFAULT_NAME else ""
    return f"{advice}{several(patterns.count, 'image')}: {patterns.name.partition(': ')[2]}."


def pattern_titles() -> dict[str, str]:
    """Return the titles of all sets by name, the recommended one and the paper's first."""
    first = (DEFAULT_NAME, "paper")
    return {name: pattern_title(name) for name in (*first, *(name for name in PATTERN_SETS if name not in first))}
