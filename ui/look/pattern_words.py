"""Titles and descriptions of the pattern sets as plain text, so that the window needs no computation to show them."""

from __future__ import annotations

from typing import NamedTuple

RECOMMENDED = "three-close"


class PatternWords(NamedTuple):
    """Title and one-line description of a pattern set."""

    title: str
    line: str


PATTERN_WORDS = {
    "three-close": PatternWords("Three close pitches", "Recommended. 12 images: 4 steps at 16, 17.84 and 18.14 px."),
    "paper": PatternWords("Paper: 32 and 33 px", "8 images: 4 steps at 32 and 33 px."),
    "three-close-3-step": PatternWords("Three close, 3 steps", "9 images: 3 steps at 16, 17.84 and 18.14 px."),
    "three-close-8-step": PatternWords("Three close, 8 steps", "24 images: 8 steps at 16, 17.84 and 18.14 px."),
    "paper-8-step": PatternWords("32 and 33 px, 8 steps", "16 images: 8 steps at 32 and 33 px."),
    "three-wide": PatternWords("Three wide pitches", "12 images: 4 steps at 16, 131.9 and 1088 px."),
    "three-wide-8-step": PatternWords("Three wide, 8 steps", "16 images: 8, 4 and 4 steps at 16, 131.9 and 1088 px."),
    "three-wide-32": PatternWords("Three wide, from 32 px", "12 images: 4 steps at 32, 186.6 and 1088 px."),
    "hierarchical": PatternWords("Hierarchical", "28 images: 4 steps, each pitch half of the one before, from 17 px."),
    "gray": PatternWords("Gray code", "10 images: 4 steps at 16 px."),
    "complementary-gray": PatternWords("Complementary Gray", "11 images: 4 steps at 16 px."),
    "complementary-gray-8-step": PatternWords("Complem. Gray, 8 steps", "15 images: 8 steps at 16 px."),
    "three-close-both": PatternWords("Three close, orthogonal", "24 images: 4 steps at 16, 17.84 and 18.14 px, both directions."),
    "paper-both": PatternWords("Paper, orthogonal", "16 images: 4 steps at 32 and 33 px, both directions."),
    "complementary-gray-both": PatternWords("Complem. Gray, orthogonal", "22 images: 4 steps at 16 px, both directions."),
}
