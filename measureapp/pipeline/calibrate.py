"""From images of the board to a calibrated rig."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from statistics import median

import numpy as np

from measureapp.calibrate.draft.draft import Known, Setup
from measureapp.calibrate.draft.verdict import Verdict, evaluate
from measureapp.calibrate.kinds.table import KINDS
from measureapp.calibrate.rig.joint_solution import RigSolution
from measureapp.calibration_session.detection import DETECTION_THREADS
from measureapp.calibration_session.observing import Position, RefusedImage, observe, solve_observed
from measureapp.data.board import BoardDescription, BoardView
from measureapp.data.calibration import CameraArrayCalibration, Provenance
from measureapp.data.conditions import LensSetting
from measureapp.data.rig import RigDescription
from measureapp.errors import CalibrationError
from measureapp.progress import PartOf, Progress
from measureapp.project.frame_store import checksum


@dataclass(frozen=True, slots=True, eq=False)
class SolvedViews:
    """The calibrated rig, the verdict on it, and the images in which the board was not detected."""

    solution: RigSolution
    verdict: Verdict
    refused: tuple[RefusedImage, ...]


def calibrate_from_views(views: Sequence[BoardView], board: BoardDescription, rig: RigDescription, progress: Progress) -> RigSolution:
    """Calibrate the rig from images of the board; raises as `solve_views`."""
    return solve_views(views, board, rig, progress).solution


def solve_views(
    views: Sequence[BoardView], board: BoardDescription, rig: RigDescription, progress: Progress, threads: int = DETECTION_THREADS
) -> SolvedViews:
    """Detect the board in all images, ``threads`` at a time, calibrate the cameras from them, then hand-eye, guide and axis.

    Raises
    ------
    CalibrationError
        The views do not determine the rig; the message says what is missing.
    """
    if not views:
        raise CalibrationError("There are no images of the board.", "Take them first, or give a calibration.")
    names = (rig.reference, *(camera.name for camera in rig.cameras if camera.name != rig.reference))
    serials, lenses = _devices(rig, views)
    setup = replace(Setup.on_rig(KINDS["rig"], board, names, Known(), rig), serials=serials)
    sizes_px = {camera.name: (camera.width_px, camera.height_px) for camera in rig.cameras}
    positions = [Position(view.viewpoint_id, lambda view=view: view.images, view.readback) for view in views]  # type: ignore[misc]
    observed = observe(positions, board, None, PartOf(progress, 0.0, 0.5), threads)
    sizes = {name: sizes_px[name] for name in names}
    observed, solved = solve_observed(observed, setup, sizes, PartOf(progress, 0.5, 1.0))
    progress.check()
    solution: RigSolution = solved.solution
    calibration = solution.calibration
    provenance = views_provenance(calibration.provenance.method, rig, views)
    own = replace(provenance, method=calibration.cameras.provenance.method)
    cameras = replace(_with_lenses(calibration.cameras, lenses), provenance=own)
    progress.check()
    verdict = evaluate(replace(observed.draft(setup, sizes), solved=solved))
    complete = replace(solution, calibration=replace(calibration, cameras=cameras, provenance=provenance))
    return SolvedViews(complete, verdict, observed.refused)


def _with_lenses(cameras: CameraArrayCalibration, lenses: Mapping[str, LensSetting]) -> CameraArrayCalibration:
    """Return the cameras with the settings of their lenses, as the cameras reported them."""
    return replace(cameras, cameras={name: replace(one, lens=lenses.get(name, one.lens)) for name, one in cameras.cameras.items()})


def views_provenance(method: str, rig: RigDescription, views: Sequence[BoardView]) -> Provenance:
    """Provenance of the calibration. It is as old as its last image: solving it again does not make it younger."""
    recorded = [view.conditions for view in views if view.conditions is not None]
    warm = [conditions.temperature_c for conditions in recorded if conditions.temperature_c is not None]
    return Provenance(
        created=max((conditions.taken_at for conditions in recorded), default=datetime.now(UTC).isoformat(timespec="seconds")),
        method=method,
        inputs=checksums_of(views),
        temperature_c=median(warm) if warm else None,
        valid_days=rig.calibration_rules.valid_days,
    )


def checksums_of(views: Sequence[BoardView]) -> dict[str, str]:
    """Return "view/camera" -> checksum of every image, which is how a project stores them."""
    return {f"{view.viewpoint_id}/{camera}": checksum(np.asarray(pixels)) for view in views for camera, pixels in view.images.items()}


def _devices(rig: RigDescription, views: Sequence[BoardView]) -> tuple[Mapping[str, str], Mapping[str, LensSetting]]:
    """Return the serial number of every camera, as it reported or else as the rig is described, and its lens setting."""
    last = next((view.conditions for view in reversed(views) if view.conditions is not None), None)
    serials = {camera.name: camera.serial for camera in rig.cameras}
    return (serials, {}) if last is None else ({**serials, **last.serials}, last.lenses)
