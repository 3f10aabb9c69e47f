"""Application of a theme: fast, because nothing but colours changes after the first time."""

from __future__ import annotations

from PySide6.QtWidgets import QApplication, QToolTip

from ui.look.style.palette import palette_of
from ui.look.style.window_style import WindowStyle
from ui.look.theme import Theme, font, provide_fonts


def apply(application: QApplication, theme: Theme) -> None:
    """Draw the application in the colours of a theme; style and font are set once."""
    style = application.style()
    if isinstance(style, WindowStyle):
        if style.ink.theme == theme:
            return
        style.set_theme(theme)
    else:
        application.setStyle(WindowStyle(theme))
        provide_fonts()
        application.setFont(font(theme.sizes["body"]))
    palette = palette_of(theme)
    QToolTip.setPalette(palette)
    application.setPalette(palette)
