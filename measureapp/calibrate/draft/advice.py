"""Guidance: sentences, gauges and the outline of the board to show next."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.board import BoardDescription
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform

SIDE_STEPS = 6  # points along each side of an outline, so that a distorting lens bends it


@dataclass(frozen=True, slots=True)
class Gauge:
    """How much of something was reached."""

    name: str
    value: float  # in `unit`
    target: float  # in `unit`; more is not needed
    unit: str  # "%", "°", "mm" or "" for a count
    camera: str = ""  # where it belongs to one camera

    @property
    def share(self) -> float:
        """The fraction of the target that was reached, 0…1."""
        return float(np.clip(self.value / self.target, 0.0, 1.0))

    @property
    def reached(self) -> bool:
        """Whether nothing more is needed."""
        return self.value >= self.target


@dataclass(frozen=True, slots=True, eq=False)
class Ghost:
    """Where the board should be shown next."""

    outlines_px: Mapping[str, FloatArray]  # camera -> closed outline of the board (N, 2) in its image
    base_from_flange: RigidTransform | None = None  # where the robot has to be for that; whether it can reach it is not checked
    guide_mm: float | None = None
    table_rad: float | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Advice:
    """What is still missing, the most important first; nothing where enough was collected."""

    sentences: tuple[str, ...]
    gauges: tuple[Gauge, ...]
    ghost: Ghost | None = None

    @property
    def enough(self) -> bool:
        """Whether nothing is missing."""
        return not self.sentences


@dataclass(slots=True)
class Notes:
    """Advice in the making; a wish that several cameras have appears once."""

    wishes: dict[str, list[str]] = field(default_factory=dict)  # text -> cameras that wish it
    gauges: list[Gauge] = field(default_factory=list)

    def wish(self, text: str, camera: str = "") -> None:
        """Add a wish, as part of a sentence that starts with a capital letter."""
        self.wishes.setdefault(text, []).append(camera)

    def sentences(self, cameras: Sequence[str]) -> tuple[str, ...]:
        """Return the wishes as sentences; with several cameras, those of some of them name which."""
        return tuple(_sentence(text, [one for one in owners if one], cameras) for text, owners in self.wishes.items())


def _sentence(text: str, owners: Sequence[str], cameras: Sequence[str]) -> str:
    whole = text if text.endswith(".") else f"{text}."
    if not owners or len(cameras) == 1 or len(owners) == len(cameras):
        return whole
    named = f"Camera {owners[0]}" if len(owners) == 1 else f"Cameras {', '.join(owners[:-1])} and {owners[-1]}"
    return f"{named}: {whole[0].lower()}{whole[1:]}"


def outline_px(pinhole: PinholeCamera, camera_from_board: RigidTransform, board: BoardDescription) -> FloatArray | None:
    """Return the outline of the marks (N, 2), closed, if it is in front of the camera and in its image; else None.

    Distortion estimated from few views may fold outside of them: None where its Jacobian is not positive.
    """
    marks = board.flat_corners_mm
    low, high = marks.min(axis=0)[:2], marks.max(axis=0)[:2]
    corners = np.array([low, [high[0], low[1]], high, [low[0], high[1]], low])
    steps = np.linspace(0, 1, SIDE_STEPS, endpoint=False)[:, None]
    sides = [start + steps * (end - start) for start, end in pairwise(corners)]
    flat = np.concatenate([*sides, corners[:1]])
    points = camera_from_board.apply(np.column_stack([flat, np.zeros(len(flat))]))
    if points[:, 2].min() <= 0:
        return None
    pixels, slopes = pinhole.project_with_jacobian(points)
    size = np.array([pinhole.width_px, pinhole.height_px])
    folded = np.linalg.det(slopes[:, :, :2]) <= 0
    return pixels if np.all((pixels >= 0) & (pixels <= size - 1)) and not folded.any() else None


def outlines_px(cameras: CameraArrayCalibration, place: RigidTransform, board: BoardDescription) -> dict[str, FloatArray]:
    """Return camera -> outline of the board at ``place`` (camera_from_board of the reference) for the cameras in whose image it is complete."""
    seen = {}
    for name, camera in cameras.cameras.items():
        own = camera.reference_from_camera.inverse() @ place
        found = outline_px(camera.pinhole, own, board)
        if found is not None:
            seen[name] = found
    return seen
