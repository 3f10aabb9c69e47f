"""Acquisition of fringes of both directions on the board, for the calibration of the projector."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from measureapp.acquire.capture import (
    BOARD_SATURATED_SHARE,
    SHOW_TIMEOUT_S,
    capture_stack,
    grab_checked,
    move_to,
    set_exposure,
)
from measureapp.acquire.events import Event
from measureapp.data.fringe import FringeStack, PatternSet
from measureapp.data.plan import ExposureBracket, ScanPlan, Viewpoint
from measureapp.devices.rig import Rig
from measureapp.progress import PartOf, Progress

PROBE_SHARE = 0.1  # of the time


def capture_board_fringes(
    rig: Rig, viewpoint: Viewpoint, patterns: PatternSet, on_event: Callable[[Event], None], progress: Progress
) -> FringeStack:
    """Take all patterns at the longest exposure of the rig without significant saturation; the patterns must be loaded already.

    One exposure is enough: a board reflects diffusely, and its black squares need no phase.

    Raises
    ------
    DeviceError
        A device refused a setting, or delivered an image other than the requested one three times in a row.
    Cancelled
        From ``progress``.
    """
    move_to(rig, viewpoint)
    exposure_us = _well_exposed_us(rig, patterns, PartOf(progress, 0.0, PROBE_SHARE))
    plan = ScanPlan(name="board", viewpoints=(viewpoint,), patterns=patterns, bracket=ExposureBracket(exposures_us=(exposure_us,)))
    return capture_stack(rig, viewpoint, plan, on_event, PartOf(progress, PROBE_SHARE, 1.0), lambda _: None)


def _well_exposed_us(rig: Rig, patterns: PatternSet, progress: Progress) -> int:
    """Return the longest exposure at which no camera saturates significantly in any image of the first group."""
    tried = rig.description.exposures_us
    for done, exposure_us in enumerate(tried[:-1]):
        progress.report(done, len(tried), f"exposure {exposure_us / 1000:g} ms")
        set_exposure(rig.cameras, exposure_us)
        if all(_saturated(rig, name, exposure_us, patterns) <= BOARD_SATURATED_SHARE for name in rig.cameras):
            return exposure_us
    return tried[-1]


def _saturated(rig: Rig, name: str, exposure_us: int, patterns: PatternSet) -> float:
    """Return the fraction of a camera's pixels saturated in at least one image of the first group."""
    level = rig.description.camera(name).saturation
    clipped = []
    for pattern in range(patterns.groups[0].count):
        rig.projector.show(pattern, timeout_s=SHOW_TIMEOUT_S)
        clipped.append(grab_checked(rig.cameras[name], exposure_us, pattern) >= level)
    return float(np.mean(np.any(clipped, axis=0)))
