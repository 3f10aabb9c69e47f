"""Circular patterns of features."""

from __future__ import annotations

from pydantic import Field

from measureapp.data.model import Model


class Repeat(Model):
    """Circular pattern about the z axis: copy k (from 1) of a feature is rotated by (k − 1)·angle and named `name.k`."""

    count: int = Field(ge=2, le=1000)
    angle_deg: float = 0.0
