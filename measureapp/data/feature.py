"""Geometry fitted to points: the noun, which lives beside the fits."""

from __future__ import annotations

from measureapp.geometry.feature import Feature, Shape

__all__ = ["Feature", "Shape"]
