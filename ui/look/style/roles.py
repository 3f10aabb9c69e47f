"""What a widget looks like by its object name or its property ``role``: the one table to extend for new looks."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from PySide6.QtGui import QPalette

FontSize = str  # a token of the theme: "small", "body", "heading", "title"


@dataclass(frozen=True)
class TextLook:
    """Font and colour of a label."""

    size: FontSize = "body"
    bold: bool = False
    colour: QPalette.ColorRole = QPalette.ColorRole.WindowText
    least_height: str = ""  # token of a size


@dataclass(frozen=True)
class FrameLook:
    """Background and border of a frame; colours are tokens, empty: none."""

    fill: str = ""
    border: str = ""
    rounded: bool = False
    edge: str = ""  # "top", "bottom", "left", "right": a border on one side only
    pill: bool = False


@dataclass(frozen=True)
class ButtonLook:
    """Colours and room of a push button; colours are tokens, empty: none."""

    padding_px: int = 16
    height_px: int = 32
    bold: bool = False
    text: str = "text"
    fill: str = ""
    border: str = "line"
    hover_fill: str = "raised"
    hover_border: str = "faint"
    pressed_fill: str = "sunken"
    focus_border: str = "accent"
    checked_fill: str = "accent_soft"
    checked_text: str = "accent_text"
    left: bool = False  # text on the left


SOFT = QPalette.ColorRole.Dark
PROBLEM = QPalette.ColorRole.BrightText
TEXTS: Final[dict[str, TextLook]] = {
    "title": TextLook("title", bold=True),
    "heading": TextLook("heading", bold=True),
    "strong": TextLook(bold=True),
    "soft": TextLook(colour=SOFT),
    "small": TextLook("small", colour=SOFT),
    "caption": TextLook("small", bold=True, colour=SOFT),
    "field": TextLook(least_height="control"),
    "problem": TextLook("small", colour=PROBLEM),
    "figure": TextLook("title", bold=True),
}
"""By the property ``role`` of a label."""
FRAMES: Final[dict[str, FrameLook]] = {
    "surface": FrameLook("surface", "line", rounded=True),
    "card": FrameLook("surface", "line", rounded=True),
    "sunken": FrameLook("sunken", rounded=True),
    "hairline": FrameLook("line"),
    "chip": FrameLook("sunken", pill=True),
    "header": FrameLook("surface", "line", edge="bottom"),
    "rail": FrameLook("surface", "line", edge="right"),
    "tour": FrameLook("accent_soft", "accent", edge="top"),
    "strip": FrameLook("surface", "line", edge="top"),
    "properties": FrameLook("surface", "line", edge="left"),
}
"""By the object name of a frame, or of a plain widget with ``WA_StyledBackground``."""
BUTTONS: Final[dict[str, ButtonLook]] = {
    "normal": ButtonLook(),
    "primary": ButtonLook(
        24,
        40,
        bold=True,
        text="accent_on",
        fill="accent",
        border="accent",
        hover_fill="accent_hover",
        hover_border="accent_hover",
        pressed_fill="accent_pressed",
        focus_border="text",
    ),
    "stop": ButtonLook(
        24,
        40,
        bold=True,
        text="accent_on",
        fill="verdict_fail",
        border="verdict_fail",
        hover_fill="verdict_fail",
        hover_border="verdict_fail",
        pressed_fill="verdict_fail",
        focus_border="text",
    ),
    "quiet": ButtonLook(8, border="", hover_fill="sunken", hover_border=""),
    "message": ButtonLook(8, border="", hover_fill="sunken", hover_border="", left=True),
    "segment": ButtonLook(12, text="soft", focus_border="text"),
}
"""By the property ``role`` of a push button."""
