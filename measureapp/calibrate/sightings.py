"""Sightings of a board by cameras: the input of every calibration, with rejections and residuals."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Literal

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray, read_only
from measureapp.errors import CalibrationError

Cause = Literal["blurred", "over-exposed", "too dark", "hidden", "part", "wrong board", "not found"]


class BoardDetectionError(CalibrationError):
    """An image without usable marks; `cause` is the reason in one or two words."""

    def __init__(self, message: str, hint: str, cause: Cause) -> None:
        super().__init__(message, hint)
        self.cause: Cause = cause


class AmbiguousPart(BoardDetectionError):
    """An image of a part of the board that may be one of several; only an expected board pose identifies it."""

    def __init__(self, message: str, hint: str) -> None:
        super().__init__(message, hint, "part")


def explain_by_refused(error: CalibrationError, refused: Sequence[tuple[str, str]]) -> CalibrationError:
    """Add the first image without marks to the error of a calibration that failed: often its cause.

    Parameters
    ----------
    refused : name and reason of each
    """
    if not refused:
        return error
    name, reason = refused[0]
    images = "1 image" if len(refused) == 1 else f"{len(refused)} images"
    return CalibrationError(f"{error.message} {images} could not be used; {name}: {reason.rstrip('.')}.", error.hint)


LARGEST_SPREAD = 5.0


ALL_MARKS: IntArray = np.empty(0, np.int64)  # placeholder for "every mark of the board" when a sighting is made


@dataclass(frozen=True, slots=True, eq=False)
class Sighting:
    """The marks of a board detected in one image; the detector leaves `camera` and `view` empty, `of` fills them in."""

    camera: str
    view: str  # the same in all cameras for the same position
    corners_px: FloatArray  # (N, 2)
    ids: IntArray = field(default_factory=lambda: ALL_MARKS)  # (N,) rising, indices into ``board.corners_mm``; by default all, in order
    sigma_px: FloatArray | None = None  # (N,) standard deviation of one coordinate, where it was estimated
    edge_px: float = 0.0  # 10–90 % width of edges in the image; 0 where not known

    def __post_init__(self) -> None:
        object.__setattr__(self, "corners_px", read_only(self.corners_px, np.float64, (None, 2)))
        count = len(self.corners_px)
        ids = np.arange(count) if self.ids is ALL_MARKS else self.ids
        object.__setattr__(self, "ids", read_only(ids, np.int64, (count,)))
        if self.sigma_px is not None:
            object.__setattr__(self, "sigma_px", read_only(self.sigma_px, np.float64, (count,)))

    def of(self, camera: str, view: str) -> Sighting:
        """Return the same marks as the sighting of a camera in a view."""
        return replace(self, camera=camera, view=view)


def relative_sigmas(sightings: Sequence[Sighting]) -> list[FloatArray | None]:
    """Return the standard deviations (N,) of every sighting's corners over the median of its camera; None where none were estimated.

    Only their ratios are taken from the images: the level of a camera's noise follows from the residuals of the adjustment.
    Ratios stay within a factor of `LARGEST_SPREAD` of one, since the level of a single view is itself an estimate.
    """
    known: dict[str, list[FloatArray]] = {}
    for one in sightings:
        if one.sigma_px is not None:
            known.setdefault(one.camera, []).append(one.sigma_px)
    usual = {camera: float(np.median(np.concatenate(values))) for camera, values in known.items()}
    return [
        None if one.sigma_px is None else np.clip(one.sigma_px / usual[one.camera], 1 / LARGEST_SPREAD, LARGEST_SPREAD) for one in sightings
    ]


@dataclass(frozen=True, slots=True)
class Rejection:
    """A rejected sighting, or rejected corners of it, with the reason."""

    camera: str
    view: str
    reason: str


@dataclass(frozen=True, slots=True)
class ViewResidual:
    """How well one used sighting fits; rms of the distances of its corners."""

    camera: str
    view: str
    rms_px: float
    corners: int


def rms(residuals_px: FloatArray, used: BoolArray | None = None) -> float:
    """Return the root mean square length of residual vectors (N, 2), as OpenCV counts it; 0 without any."""
    chosen = residuals_px if used is None else residuals_px[used]
    return float(np.sqrt(np.mean(np.sum(chosen**2, axis=-1)))) if len(chosen) else 0.0
