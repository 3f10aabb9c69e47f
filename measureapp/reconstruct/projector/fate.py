"""What becomes of a pixel that is measured with the projector."""

from __future__ import annotations

from enum import IntEnum

from measureapp.data.point_state import PointState
from measureapp.reconstruct.kernels import projector as kernel


class ProjectorFate(IntEnum):
    """What became of a pixel."""

    POINT = kernel.POINT
    NO_PHASE = kernel.NO_PHASE
    PARALLEL = kernel.PARALLEL  # the ray runs nearly along the lit surface
    BEHIND = kernel.BEHIND  # they meet behind the camera or the projector
    OUTSIDE = kernel.OUTSIDE  # they meet outside the projector's image
    UNSOLVED = kernel.UNSOLVED  # the distortion has no inverse there
    CONTRADICTED = kernel.CONTRADICTED  # column and row belong to no point of the ray

    @property
    def words(self) -> str:
        """How it is called among the reasons of rejection."""
        return REASONS[self]


REASONS = {
    ProjectorFate.POINT: "point of the projector",
    ProjectorFate.NO_PHASE: "no phase",
    ProjectorFate.PARALLEL: "parallel to the projector's fringe",
    ProjectorFate.BEHIND: "behind the camera or the projector",
    ProjectorFate.OUTSIDE: "outside the projector's image",
    ProjectorFate.UNSOLVED: "distortion of the projector has no inverse",
    ProjectorFate.CONTRADICTED: "projector's column and row contradict each other",
}

OF_POINT = {
    ProjectorFate.POINT: PointState.VALID,
    ProjectorFate.NO_PHASE: PointState.NO_PHASE,
    ProjectorFate.PARALLEL: PointState.AMBIGUOUS,
    ProjectorFate.BEHIND: PointState.UNMATCHED,
    ProjectorFate.OUTSIDE: PointState.UNMATCHED,
    ProjectorFate.UNSOLVED: PointState.UNMATCHED,
    ProjectorFate.CONTRADICTED: PointState.CONTRADICTED,
}
