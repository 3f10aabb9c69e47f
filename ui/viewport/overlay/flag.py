"""A flag: a box with name and values of one dimension, joined to its place by a line."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QSizeF

from measureapp.data.control_frame import ControlFrame
from ui.look.language.words import translated
from ui.viewport.overlay.control_frame import frame_size
from ui.viewport.overlay.style import OverlayStyle

SIGNS = {"pass": "✓", "fail": "✗", "not proven": "?", "not measured": "–"}
PADDING, TITLE_PX, LETTERS_PX, SIGN_WIDTH = 6.0, 12.0, 12.0, 18.0
LARGEST_WIDTH = 220.0


@dataclass(frozen=True, eq=False)
class Flag:
    """Name, value, tolerance and uncertainty at a place; empty texts are not shown."""

    key: str  # identifies it while it is dragged, selected and kept
    anchor_mm: np.ndarray  # (3,)
    title: str = ""
    value: str = ""
    tolerance: str = ""
    uncertainty: str = ""
    verdict: str = ""  # "pass", "fail", "not proven", "not measured" or none
    more: tuple[str, ...] = ()  # further lines, such as the components of a deviation
    pinned: tuple[float, float] | None = None  # middle of the box, as fractions of the picture, where it was dragged to
    frame: ControlFrame | None = None  # of a geometrical tolerance, drawn below the title

    @property
    def sign(self) -> str:
        """The sign of the verdict, so that the colour is not the only one."""
        return SIGNS.get(self.verdict, "")

    def lines(self) -> tuple[str, ...]:
        """Return the lines of the box, the title first."""
        return tuple(translated(line) for line in (self.title, self.value, self.tolerance, self.uncertainty, *self.more) if line)


def flag_size(flag: Flag, style: OverlayStyle) -> QSizeF:
    """Return the size of a flag's box."""
    lines = flag.lines()
    sizes = [style.measure(line, LETTERS_PX, bold=place == 0 and bool(flag.title)) for place, line in enumerate(lines)]
    width = max((size.width() for size in sizes), default=0.0) + (SIGN_WIDTH * style.scale if flag.sign else 0.0)
    height = sum(size.height() for size in sizes)
    width, padding = min(width, LARGEST_WIDTH * style.scale), 2 * PADDING * style.scale
    if flag.frame is not None:  # never cut
        frame = frame_size(flag.frame, style)
        width, height = max(width, frame.width() + (0.0 if flag.title else SIGN_WIDTH * style.scale)), height + frame.height()
    return QSizeF(width + padding, height + padding)
