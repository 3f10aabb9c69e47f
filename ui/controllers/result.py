"""What a wizard's last page shows: the verdict, every value, and what changed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from ui.controllers.result_values import Quantity, ValueRow, camera_quantities, rig_quantities, rows_beside

if TYPE_CHECKING:
    from measureapp.calibrate.camera_array import CameraArraySolution
    from measureapp.data.calibration import CameraArrayCalibration, RigCalibration
    from measureapp.pipeline.collecting.observation import Observation
    from measureapp.pipeline.collecting.setup import Setup
    from measureapp.pipeline.collecting.solved import Solved
    from ui.workers.job import Job


@dataclass(frozen=True, eq=False)
class Before:
    """What the result is laid beside: the calibration before it, and the truth of a virtual rig."""

    cameras: CameraArrayCalibration | None
    rig: RigCalibration | None
    truth: RigCalibration | None


@dataclass(frozen=True, eq=False)
class Result:
    """One solved calibration, judged."""

    solved: Solved
    verdict: str
    level: Literal["pass", "fail", "not proven"]
    rows: tuple[ValueRow, ...]
    facts: tuple[tuple[str, str], ...]
    warnings: tuple[str, ...]
    comparison: str
    has_truth: bool
    has_previous: bool
