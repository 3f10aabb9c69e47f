"""Settings of a project."""

from __future__ import annotations

from typing import Literal

from measureapp.data.board import AnyBoard, CheckerboardDescription
from measureapp.data.model import Model
from measureapp.data.rig import RigDescription

DEFAULT_BOARD = CheckerboardDescription(columns=14, rows=11, square_mm=15.0)


class ProjectSettings(Model):
    """Settings of a project, fixed when it is created."""

    schema_version: Literal[1] = 1
    name: str
    part: str
    rig: RigDescription
    board: AnyBoard = DEFAULT_BOARD

    def same_job(self, other: ProjectSettings) -> bool:
        """Whether both are of one job; what the rig states about the speeds of its axes changes no measurement."""
        mine, others = (one.model_copy(update={"rig": one.rig.without_speeds()}) for one in (self, other))
        return mine == others
