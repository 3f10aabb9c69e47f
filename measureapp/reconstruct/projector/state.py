"""State of a pixel that is measured with the projector."""

from __future__ import annotations

from enum import IntEnum

from measureapp.data.point_state import PointState
from measureapp.reconstruct.kernels import projector as kernel


class ProjectorState(IntEnum):
    """Why a pixel has a point of the projector, or has none."""

    POINT = kernel.POINT
    NO_PHASE = kernel.NO_PHASE
    PARALLEL = kernel.PARALLEL  # the ray runs nearly along the lit surface
    BEHIND = kernel.BEHIND  # they meet behind the camera or the projector
    OUTSIDE = kernel.OUTSIDE  # they meet outside the projector's image
    UNSOLVED = kernel.UNSOLVED  # the distortion has no inverse there
    CONTRADICTED = kernel.CONTRADICTED  # column and row belong to no point of the ray

    @property
    def words(self) -> str:
        """Its name among the reasons of rejection."""
        return REASONS[self]


REASONS = {
    ProjectorState.POINT: "point of the projector",
    ProjectorState.NO_PHASE: "no phase",
    ProjectorState.PARALLEL: "parallel to the projector's fringe",
    ProjectorState.BEHIND: "behind the camera or the projector",
    ProjectorState.OUTSIDE: "outside the projector's image",
    ProjectorState.UNSOLVED: "distortion of the projector has no inverse",
    ProjectorState.CONTRADICTED: "projector's column and row contradict each other",
}

OF_POINT = {
    ProjectorState.POINT: PointState.VALID,
    ProjectorState.NO_PHASE: PointState.NO_PHASE,
    ProjectorState.PARALLEL: PointState.AMBIGUOUS,
    ProjectorState.BEHIND: PointState.UNMATCHED,
    ProjectorState.OUTSIDE: PointState.UNMATCHED,
    ProjectorState.UNSOLVED: PointState.UNMATCHED,
    ProjectorState.CONTRADICTED: PointState.CONTRADICTED,
}
