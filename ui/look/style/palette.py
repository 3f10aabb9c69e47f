"""The palette of a theme."""

from __future__ import annotations

from PySide6.QtGui import QColor, QPalette

from ui.look.theme import Theme


def palette_of(theme: Theme) -> QPalette:
    """Return the palette of a theme; controls take further colours from its tokens."""
    role = QPalette.ColorRole
    names = {
        role.Window: "window",
        role.Base: "surface",
        role.AlternateBase: "surface",
        role.WindowText: "text",
        role.Text: "text",
        role.ButtonText: "text",
        role.Button: "surface",
        role.PlaceholderText: "faint",
        role.Highlight: "accent",
        role.HighlightedText: "accent_on",
        role.Accent: "accent",
        role.Link: "accent_text",
        role.LinkVisited: "accent_text",
        role.ToolTipBase: "raised",
        role.ToolTipText: "text",
        role.Light: "raised",
        role.Midlight: "sunken",
        role.Mid: "line",
        role.Dark: "soft",
        role.Shadow: "faint",
        role.BrightText: "verdict_fail",
    }
    palette = QPalette()
    for one, name in names.items():
        palette.setColor(one, QColor(theme.colours[name]))
    for one in (role.WindowText, role.Text, role.ButtonText, role.Dark):
        palette.setColor(QPalette.ColorGroup.Disabled, one, QColor(theme.colours["faint"]))
    return palette
