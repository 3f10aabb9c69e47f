"""Reconstruction with a single camera and the projector."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import IntArray, read_only
from measureapp.data.cloud import PointCloud
from measureapp.data.point_state import PointState
from measureapp.errors import ReconstructError
from measureapp.reconstruct.cleaning.clean import WORDS
from measureapp.reconstruct.projector.lit_camera import LitCamera
from measureapp.reconstruct.projector.state import OF_POINT, ProjectorState


@dataclass(frozen=True, slots=True, eq=False)
class ProjectorReconstruction:
    """The cloud of a single camera and the projector, in frame ``camera``, and the state of every pixel."""

    cloud: PointCloud
    rejected: Mapping[str, int]  # reason -> count
    residual_rms_px: float | None
    state: IntArray  # (H, W) uint8 of PointState
    max_sigma_mm: float  # standard deviation above which points were left out


def reconstruct_with_projector(lit: LitCamera) -> ProjectorReconstruction:
    """Reconstruct with one camera and the projector alone; cleaned as the points of camera pairs are.

    Raises
    ------
    ReconstructError
        The images have another size than the camera is calibrated for, or no ray meets its column.
    """
    made = measure_with_projector(lit)
    lost = {state.words: made.rejected[state.words] for state in list(ProjectorState)[2:]}
    if sum(lost.values()) == np.count_nonzero((made.state != PointState.NO_PHASE) & (made.state != PointState.RIM)):
        most, name = max(lost, key=lambda reason: lost[reason]), lit.camera.name
        raise ReconstructError(
            f"Camera {name!r} and the projector give no points: {lost[most]} pixels are {most}."
            if lost[most]
            else f"Camera {name!r} has no pixel with a phase.",
            "Check shift_sign, the pitches and that the calibration belongs to these images.",
        )
    return made


def measure_with_projector(lit: LitCamera) -> ProjectorReconstruction:
    """Do what `reconstruct_with_projector` does, but return an empty cloud where no ray meets its column.

    Raises
    ------
    ReconstructError
        The images have another size than the camera is calibrated for.
    """
    made = lit.triangulate()
    cleaned = lit.clean(made.depth_mm, made.sigma_mm, made.depth_mm > 0)
    cloud = lit.make_cloud(cleaned, made.sigma_mm, np.asarray(cleaned.depth_mm > 0))
    triangulated = np.array([OF_POINT[state] for state in ProjectorState], np.uint8)[made.state]
    edges = lit.phase_map.state == PointState.RIM
    state = np.where(made.depth_mm > 0, cleaned.state, np.where(edges, np.uint8(PointState.RIM), triangulated))
    rejected = made.rejected | cleaned.rejected | {WORDS[PointState.RIM]: int(np.count_nonzero(edges))}
    return ProjectorReconstruction(cloud, rejected, made.residual_rms_px, read_only(state), lit.max_sigma_mm(made.sigma_mm))
