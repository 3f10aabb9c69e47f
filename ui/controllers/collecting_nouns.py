"""Data types between the controllers of the wizards and their pages."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Literal

import numpy as np
from PySide6.QtGui import QImage

if TYPE_CHECKING:
    from measureapp.data.board import BoardDescription
    from measureapp.data.rig import Resolution

ViewVerdict = Literal["pass", "fail", "not proven", "not measured"]


@dataclass(frozen=True)
class RigSetup:
    """The rig that can take the images."""

    name: str
    virtual: bool
    fixed: bool  # resolution and seed are the open project's
    resolution: Resolution
    seed: int
    board: BoardDescription


@dataclass(frozen=True)
class Start:
    """How a wizard begins: with which board, and with recorded images or with the rig."""

    board: BoardDescription
    folder: Path | None  # of recorded images; None: the rig takes them
    resolution: Resolution
    seed: int
    tables: Mapping[str, Path] = field(default_factory=dict)  # axis positions at recorded images: axis -> table


@dataclass(frozen=True)
class StoredSession:
    """A stored session with views."""

    folder: Path
    views: int
    saved: str  # ISO 8601


@dataclass(frozen=True, eq=False)
class CollectedView:
    """One view of the board as the pages show it."""

    id: str
    name: str
    pictures: Mapping[str, QImage]  # camera -> small image
    corners_px: Mapping[str, np.ndarray]  # camera -> (N, 2)
    rejected_px: Mapping[str, np.ndarray]  # camera -> (M, 2) corners rejected by the calibration
    residuals_px: Mapping[str, float]  # camera -> rms
    verdict: ViewVerdict
    reason: str = ""
    reasons: Mapping[str, str] = field(default_factory=dict)  # camera -> reason why it has no marks
    residual_mm: float | None = None
    removed: bool = False
    empty: QImage = field(default_factory=QImage)


@dataclass(frozen=True, eq=False)
class LiveImage:
    """The newest image of one camera."""

    view: str
    pixels: np.ndarray
