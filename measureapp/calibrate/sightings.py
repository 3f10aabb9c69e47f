"""What a camera calibration starts from: the corners of the board as cameras saw them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray, read_only
from measureapp.errors import CalibrationError

Cause = Literal["blurred", "over-exposed", "too dark", "hidden", "part", "wrong board", "not found"]


class BoardRefused(CalibrationError):
    """An image from which no marks are taken; `cause` names why in one word or two."""

    def __init__(self, message: str, hint: str, cause: Cause) -> None:
        super().__init__(message, hint)
        self.cause: Cause = cause


class AmbiguousPart(BoardRefused):
    """An image of a part of the board that may be one of several; where the board was expected to be tells which."""

    def __init__(self, message: str, hint: str) -> None:
        super().__init__(message, hint, "part")


def naming_refused(error: CalibrationError, refused: Sequence[tuple[str, str]]) -> CalibrationError:
    """Return the error of a calibration that failed, with the first of the images that gave nothing to it: often its cause.

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


@dataclass(frozen=True, slots=True, eq=False)
class FoundBoard:
    """The marks of a board found in one image."""

    ids: IntArray  # (N,) rising, indices into ``board.corners_mm``
    corners_px: FloatArray  # (N, 2)
    sigma_px: FloatArray  # (N,) estimated standard deviation of one coordinate
    edge_px: float  # how wide edges are in the image, 10 to 90 %

    def __post_init__(self) -> None:
        object.__setattr__(self, "ids", read_only(self.ids, np.int64, (None,)))
        object.__setattr__(self, "corners_px", read_only(self.corners_px, np.float64, (len(self.ids), 2)))
        object.__setattr__(self, "sigma_px", read_only(self.sigma_px, np.float64, (len(self.ids),)))


@dataclass(frozen=True, slots=True, eq=False)
class Sighting:
    """The corners of one board position in one camera, in the order of ``board.corners_mm``: all of them, or those of `ids`."""

    camera: str
    view: str  # the same in all cameras that saw the same position
    corners_px: FloatArray  # (N, 2)
    ids: IntArray | None = None  # (N,) rising, indices into ``board.corners_mm``; None: all of them
    sigma_px: FloatArray | None = None  # (N,) standard deviation of one coordinate, where it was estimated
    edge_px: float = 0.0  # how wide edges are in the image, 10 to 90 %; 0 where not known

    def __post_init__(self) -> None:
        object.__setattr__(self, "corners_px", read_only(self.corners_px, np.float64, (None, 2)))
        count = len(self.corners_px)
        if self.ids is not None:
            object.__setattr__(self, "ids", read_only(self.ids, np.int64, (count,)))
        if self.sigma_px is not None:
            object.__setattr__(self, "sigma_px", read_only(self.sigma_px, np.float64, (count,)))

    @property
    def known_ids(self) -> IntArray:
        """Indices of the corners into ``board.corners_mm`` (N,), also where all were seen."""
        return np.arange(len(self.corners_px)) if self.ids is None else self.ids


def sighting_of(camera: str, view: str, found: FoundBoard) -> Sighting:
    """Return what was found in an image as the sighting of a camera."""
    return Sighting(camera, view, found.corners_px, found.ids, found.sigma_px, found.edge_px)


def spreads(sightings: Sequence[Sighting]) -> list[FloatArray | None]:
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
    """A sighting that was left out, or some corners of it, and why."""

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
