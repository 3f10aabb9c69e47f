"""A small writer of SVG drawings in millimetres."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape

import numpy as np

from measureapp.arrays import FloatArray

Point = tuple[float, float]
LETTERS = "DejaVu Sans, Libertinus Sans, sans-serif"


class Panel:
    """One projection: a rectangle of the world, drawn into a rectangle of the page; world x to the right, world y up."""

    def __init__(self, page: tuple[float, float, float, float], world: tuple[float, float, float, float]) -> None:
        """Map ``world`` (x0, y0, x1, y1) into ``page`` (left, top, width, height), undistorted and centred."""
        left, top, width, height = page
        x0, y0, x1, y1 = world
        self.scale = min(width / max(x1 - x0, 1e-6), height / max(y1 - y0, 1e-6))
        self._x0 = left + width / 2 - self.scale * (x0 + x1) / 2
        self._y0 = top + height / 2 + self.scale * (y0 + y1) / 2
        self.parts: list[str] = []

    def at(self, point: Point) -> Point:
        """Return a world point on the page."""
        return self._x0 + self.scale * point[0], self._y0 - self.scale * point[1]

    def line(self, points: Iterable[Sequence[float] | FloatArray], colour: str, width: float = 1.0, *, dash: str = "") -> None:
        """Draw a polyline."""
        dashes = f' stroke-dasharray="{dash}"' if dash else ""
        self.parts.append(
            f'<polyline points="{self._points(points)}" fill="none" stroke="{colour}" stroke-width="{width:g}" stroke-linejoin="round"'
            f' stroke-linecap="round"{dashes}/>'
        )

    def lines(self, segments: FloatArray, colour: str, width: float = 1.0) -> None:
        """Draw many straight lines (N, 2, 2) of one colour, as one path."""
        if len(segments):
            places = np.array([self._x0, self._y0]) + self.scale * np.array([1.0, -1.0]) * segments
            path = ("M%.1f,%.1fL%.1f,%.1f" * len(segments)) % tuple(places.ravel().tolist())
            self.parts.append(f'<path d="{path}" fill="none" stroke="{colour}" stroke-width="{width:g}" stroke-linecap="round"/>')

    def polygon(self, points: Iterable[Sequence[float] | FloatArray], fill: str, stroke: str = "none", *, opacity: float = 1.0) -> None:
        """Draw a closed shape."""
        self.parts.append(f'<polygon points="{self._points(points)}" fill="{fill}" fill-opacity="{opacity:g}" stroke="{stroke}"/>')

    def circle(self, centre: Point, radius_mm: float, fill: str, stroke: str) -> None:
        """Draw a circle of this size in the world."""
        x, y = self.at(centre)
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius_mm * self.scale:.1f}" fill="{fill}" stroke="{stroke}"/>')

    def dot(self, centre: Point, text: str, fill: str) -> None:
        """Draw a numbered dot of the same size in every drawing."""
        x, y = self.at(centre)
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="9" fill="{fill}" stroke="#ffffff"/>')
        self.parts.append(_text(x, y + 3.2, text, 9, "#ffffff", "middle"))

    def mark(self, page_point: Point, text: str, colour: str) -> None:
        """Draw a small dot with a text above it, at a point of the page."""
        x, y = page_point
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="5" fill="{colour}" stroke="#ffffff"/>')
        self.parts.append(_text(x, y - 8.0, text, 11, colour, "middle"))

    def text(self, at: Point, text: str, *, colour: str = "#55636b", shift: Point = (0.0, 0.0), anchor: str = "middle") -> None:
        """Write a text at a world point, shifted on the page."""
        x, y = self.at(at)
        self.parts.append(_text(x + shift[0], y + shift[1], text, 11, colour, anchor))

    def heading(self, page_x: float, page_y: float, text: str) -> None:
        """Write the name of the projection."""
        self.parts.append(_text(page_x, page_y, text, 13, "#182126", "start"))

    def _points(self, points: Iterable[Sequence[float] | FloatArray]) -> str:
        return " ".join(f"{x:.1f},{y:.1f}" for x, y in (self.at((float(point[0]), float(point[1]))) for point in points))


def _text(x: float, y: float, text: str, size: float, colour: str, anchor: str) -> str:
    shown = escape("".join(letter if letter.isprintable() else "?" for letter in text))
    return (
        f'<text x="{x:.1f}" y="{y:.1f}" font-family="{LETTERS}" font-size="{size:g}" fill="{colour}" text-anchor="{anchor}">{shown}</text>'
    )


def svg(width: int, height: int, panels: Iterable[Panel]) -> str:
    """Return a drawing with a white background."""
    body = "\n".join(part for panel in panels for part in panel.parts)
    head = f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}">'
    return f'{head}\n<rect width="{width}" height="{height}" fill="#ffffff"/>\n{body}\n</svg>\n'
