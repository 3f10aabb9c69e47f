"""Icons of one set (Phosphor), one stroke width, drawn as vectors in the theme's colours."""

from __future__ import annotations

from PySide6.QtGui import QColor, QIcon

NAMES = {
    "rig": "robot",
    "calibration": "crosshair",
    "plan": "map-trifold",
    "scan": "aperture",
    "clouds": "circles-three-plus",
    "inspection": "ruler",
    "report": "file-text",
    "run": "play",
    "pause": "pause",
    "skip": "skip-forward",
    "cancel": "x-circle",
    "stop": "hand-palm",
    "connect": "link",
    "disconnect": "link-break",
    "live": "video-camera",
    "home": "house-line",
    "minus": "minus",
    "plus": "plus",
    "open": "folder-open",
    "file": "cube",
    "add": "plus-circle",
    "again": "arrows-clockwise",
    "export": "download-simple",
    "pdf": "file-pdf",
    "fit": "corners-out",
    "holes": "image-square",
    "labels": "tag",
    "section": "knife",
    "filter": "funnel",
    "grow": "arrows-out",
    "eye": "eye",
    "hidden": "eye-slash",
    "light": "sun",
    "dark": "moon",
    "help": "question",
    "devices": "share-network",
    "disk": "hard-drives",
    "person": "user",
    "fold": "caret-right",
    "unfold": "caret-left",
    "pass": "check",
    "fail": "x",
    "not proven": "question",
    "not measured": "minus",
    "no tolerance": "circle",
    "info": "info",
    "warning": "warning",
    "error": "warning-circle",
    "messages": "list",
    "remove": "trash",
    "undo": "arrow-u-up-left",
    "redo": "arrow-u-up-right",
    "hand-eye": "link",
    "axis": "arrows-clockwise",
    "guide": "arrows-left-right",
    "copy": "copy",
    "ungroup": "arrows-out-simple",
    "up": "arrow-up",
    "down": "arrow-down",
    "camera": "camera",
}


def icon(name: str, colour: QColor | str) -> QIcon:
    """Return one icon of the set."""
    import qtawesome

    glyph = NAMES[name]
    return qtawesome.icon(f"ph.{glyph}", color=QColor(colour), color_disabled=QColor(138, 149, 156, 120))
