"""Fitted features; the class itself is defined with the fits, in `measureapp.geometry.feature`."""

from __future__ import annotations

from measureapp.geometry.feature import Feature, Shape

__all__ = ["Feature", "Shape"]
