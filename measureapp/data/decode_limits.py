"""Limits of the pixels that a project decodes, where they are not the usual ones."""

from __future__ import annotations

import math
from typing import Literal

from pydantic import Field

from measureapp.data.model import Model


class DecodeLimits(Model):
    """Limits stored with a project and applied whenever it is recomputed; None: the usual one."""

    schema_version: Literal[1] = 1
    min_modulation: float | None = Field(default=None, ge=0, lt=255, description="grey levels of 255, of a valid pixel")
    max_phase_sigma_rad: float | None = Field(default=None, gt=0, le=math.pi, description="largest standard deviation of an absolute phase")
