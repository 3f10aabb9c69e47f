"""Light and dark theme from one token file."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QFont, QFontDatabase
from PySide6.QtWidgets import QApplication

from measureapp.resources import resource

Shade = Literal["light", "dark"]
TOKENS = Path("themes") / "tokens.toml"
FAMILIES = ["Inter", "Segoe UI Variable", "Segoe UI", "SF Pro Text", "Cantarell", "Roboto", "Noto Sans"]
SHIPPED = ("fonts/NotoSans-Regular.ttf", "fonts/NotoSans-Bold.ttf")  # the last family, also where it is not installed
CHINESE = ("fonts/NotoSansCJKsc-Regular.otf", "fonts/NotoSansCJKsc-Bold.otf")


@dataclass(frozen=True)
class Theme:
    """Colours and sizes of one shade."""

    shade: Shade
    colours: Mapping[str, str]
    sizes: Mapping[str, int]
    views: tuple[str, ...]

    @classmethod
    def load(cls, shade: Shade, path: Path | None = None) -> Theme:
        """Read the tokens of one shade."""
        tokens = tomllib.loads((path or resource(TOKENS)).read_text(encoding="utf-8"))
        accent = {"accent" if name == "base" else f"accent_{name}": value for name, value in tokens["accent"].items()}
        verdict = {f"verdict_{name}": value for name, value in tokens["verdict"].items()}
        return cls(shade, {**accent, **verdict, **tokens[shade]}, tokens["size"], tuple(tokens["palette"]["views"]))

    def colour(self, name: str) -> QColor:
        """Return a colour by its token."""
        return QColor(self.colours[name])

    def verdict(self, verdict: str) -> QColor:
        """Return the colour of a verdict: ``pass``, ``fail``, ``not proven``, ``not measured``."""
        return self.colour("verdict_" + verdict.replace(" ", "_"))

    def view(self, index: int) -> QColor:
        """Return the colour of the view with this index."""
        return QColor(self.views[index % len(self.views)])


def font(size_px: int, *, bold: bool = False) -> QFont:
    """Return the application's font with tabular figures."""
    made = QFont()
    made.setFamilies(FAMILIES)
    made.setPixelSize(size_px)
    made.setWeight(QFont.Weight.DemiBold if bold else QFont.Weight.Normal)
    made.setFeature(QFont.Tag("tnum"), 1)
    return made


def provide_fonts() -> None:
    """Load the fonts that come with the program; needs an application.

    Latin letters only where the computer has none of the window's families. Qt takes Chinese letters, which the window's font lacks, from the
    others: parts, programs and languages have such names in an English window, too.
    """
    has_family = bool(set(FAMILIES) & set(QFontDatabase.families()))
    for file in CHINESE if has_family else (*SHIPPED, *CHINESE):
        QFontDatabase.addApplicationFont(str(resource(file)))


def preferred_shade(application: QApplication) -> Shade:
    """Return the shade preferred by the desktop."""
    return "dark" if application.styleHints().colorScheme() == Qt.ColorScheme.Dark else "light"
