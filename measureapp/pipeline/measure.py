"""From fringe stacks, of a rig or stored, to the clouds of the views."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import asdict, replace
from typing import Any

import numpy as np

from measureapp.compiled.buffer_pool import BufferPool
from measureapp.data.calibration import RigCalibration
from measureapp.data.fringe import FringeStack
from measureapp.data.measurement import ViewResult
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.data.plan import ScanPlan
from measureapp.data.rig import RigDescription
from measureapp.data.scan_cost import stack_bytes
from measureapp.errors import DecodeError, InputError, ReconstructError, StorageError
from measureapp.fringe.checks.stack import check_stack
from measureapp.fringe.decode import decode
from measureapp.fringe.settings import DecodeSettings
from measureapp.pipeline.events import CloudsKept, Event, ViewFailed, ViewReady
from measureapp.pipeline.kept_views import KeptViews, kept_views, made_from
from measureapp.pipeline.noise import decode_settings_of
from measureapp.pipeline.stack_findings import blur_findings, stack_findings
from measureapp.pipeline.watch import Stopwatch
from measureapp.progress import PartOf, Progress
from measureapp.project.folder import ProjectFolder
from measureapp.project.large_clouds import map_large
from measureapp.reconstruct.diagnosis.camera_shift import camera_shift
from measureapp.reconstruct.diagnosis.diagnose import diagnose
from measureapp.reconstruct.projector.with_projector import reconstruct_view_with_projector
from measureapp.reconstruct.reconstruct import Reconstruction, reconstruct
from measureapp.reconstruct.rectification.rectifier import Rectifier
from measureapp.register.clouds.quality import assess_cloud

OnEvent = Callable[[Event], None]
LEAST_POINTS_SHARE, MOST_EPIPOLAR_PX = 0.3, 0.3  # points per decoded pixel, epipolar error; beyond them a view is diagnosed


def compute_clouds(
    project: ProjectFolder,
    calibration: RigCalibration,
    on_event: OnEvent,
    progress: Progress,
    watch: Stopwatch,
    kept: KeptViews | None = None,
) -> tuple[ViewResult, ...]:
    """Compute the clouds of all stored viewpoints, except those that would come out as they are; these are placed where the axes say now.

    Clouds whose images were dropped stay as they were. Raises InputError when no viewpoint is stored.

    Parameters
    ----------
    kept : the answer of `kept_views`; None: it is asked
    """
    settings, rectifier, memory = decode_settings_of(project), Rectifier(calibration.cameras), BufferPool()
    stored = require_stored(project)
    with watch.stage("clouds"):
        kept = kept or kept_views(project, calibration, settings)
    views = list[ViewResult]()
    if kept.unchanged:
        on_event(CloudsKept(kept.unchanged, len(stored), kept.placed_anew))
    for index, viewpoint_id in enumerate(stored):
        part = PartOf(progress, index / len(stored), (index + 1) / len(stored), f"{viewpoint_id}: ")
        with watch.stage("clouds"):
            view = kept.views.get(viewpoint_id) or compute_stored(project, viewpoint_id, calibration, part, rectifier, memory, settings)
        if isinstance(view, ViewFailed):
            on_event(view)
            continue
        views.append(view)
        on_event(ViewReady(view))
    return tuple(views)


def require_stored(project: ProjectFolder) -> tuple[str, ...]:
    """Return the viewpoints whose images are stored, in the order of the plan. Raises InputError when there is none."""
    stored = tuple(project.stored_viewpoints())
    if not stored:
        raise InputError(
            f"{project.path} contains no images of the part.", "Scan the part first, or restore the project's folder `stacks`."
        )
    return stored


def compute_stored(
    project: ProjectFolder,
    viewpoint_id: str,
    calibration: RigCalibration,
    progress: Progress,
    rectifier: Rectifier,
    memory: BufferPool | None = None,
    settings: DecodeSettings | None = None,
) -> ViewResult | ViewFailed:
    """Compute the cloud of a viewpoint from its stored images; where that fails, return why: the others are computed without it."""
    try:
        view = compute_cloud(project.frames.load(viewpoint_id), calibration, progress, rectifier, None, memory, settings)
        return stored_view(project, view, calibration, settings or DecodeSettings())
    except StorageError as error:
        return ViewFailed(viewpoint_id, str(error), damaged=True)
    except (DecodeError, ReconstructError) as error:
        return ViewFailed(viewpoint_id, str(error))


def stored_view(project: ProjectFolder, view: ViewResult, calibration: RigCalibration, settings: DecodeSettings) -> ViewResult:
    """Return a view computed from stored images with what it was made from, its cloud on disk where it is large."""
    made = made_from(project, view.viewpoint_id, calibration.cameras, settings)
    return replace(view, cloud=map_large(view.cloud, project.path), made_from=made)


def compute_cloud(
    stack: FringeStack,
    calibration: RigCalibration,
    progress: Progress,
    rectifier: Rectifier,
    maps: Mapping[str, PhaseMap] | None = None,
    memory: BufferPool | None = None,
    settings: DecodeSettings | None = None,
) -> ViewResult:
    """Decode (unless ``maps`` are given), match, triangulate and assess one viewpoint, with array buffers from ``memory``.

    Raises
    ------
    DecodeError, ReconstructError
    """
    if stack.readback is None:
        raise ReconstructError(f"{stack.viewpoint_id} has no axis read-back.", "Use a stack taken by a rig.")
    if maps is None:
        check_stack(stack)
        maps = decode(stack, settings, PartOf(progress, 0.0, 0.5), memory)
    if len(maps) == 1 and calibration.cameras.projector is not None:
        result = reconstruct_view_with_projector(maps, calibration.cameras, rectifier=rectifier).reconstruction
    else:
        result = reconstruct(maps, calibration.cameras, progress=PartOf(progress, 0.5, 1.0), rectifier=rectifier, memory=memory)
    progress.check()
    findings = diagnose(maps, calibration.cameras) if _is_suspicious(result, maps) else ()
    for finding in findings:
        if finding.severity == "error":
            raise finding.error()
    blurred = blur_findings(result.blur_px, calibration.cameras)
    progress.check()
    quality = assess_cloud(result.cloud, completeness=_completeness(maps, result.cloud.pixel))
    return ViewResult(
        viewpoint_id=stack.viewpoint_id,
        cloud=result.cloud,
        quality=quality,
        part_from_camera=calibration.part_from_camera(stack.readback),
        decode={
            name: decode_figures(phase_map)
            | {"limits": limits_told(phase_map, settings or DecodeSettings(), result.max_sigma_mm.get(name))}
            for name, phase_map in maps.items()
        },
        pairs=tuple(asdict(pair) for pair in result.pairs),
        rejected=dict(result.rejected),
        readback=stack.readback,
        findings=(*(f"{finding.message} {finding.remedy}" for finding in findings), *stack_findings(maps, result.cloud), *blurred),
        shift=camera_shift(maps, calibration.cameras),
    )


def _is_suspicious(result: Reconstruction, maps: Mapping[str, PhaseMap]) -> bool:
    """Whether few decoded pixels have points, or the epipolar errors are large: then the cause is diagnosed."""
    decoded = max(int(np.count_nonzero(phase_map.valid)) for phase_map in maps.values())
    off = max((max(pair.epipolar_px or 0.0, pair.across_px or 0.0) for pair in result.pairs), default=0.0)
    return len(result.cloud) < LEAST_POINTS_SHARE * decoded or off > MOST_EPIPOLAR_PX


def decode_figures(phase_map: PhaseMap) -> dict[str, Any]:
    """Return the decoding figures of one camera, as printed by `decode`."""
    valid = phase_map.valid
    return {
        "valid_ratio": {"exposures": list(phase_map.valid_ratio_exposures), "composite": phase_map.valid_ratio_composite},
        "decoded_ratio": float(valid.mean()),
        "modulation_median": float(np.median(phase_map.modulation[valid])) if valid.any() else 0.0,
        "phase_sigma_median": float(np.median(phase_map.sigma_rad[valid])) if valid.any() else 0.0,
        "noise": None if phase_map.evidence is None else asdict(phase_map.evidence),
        "order_conflicts": int(np.count_nonzero(phase_map.state == PixelState.ORDER_CONFLICT)),
    }


def limits_told(phase_map: PhaseMap, settings: DecodeSettings, max_sigma_mm: float | None) -> dict[str, float | None]:
    """Return the limits beyond which pixels of a camera became no points."""
    return {
        "modulation_grey": settings.faint_modulation_grey(phase_map.saturation),
        "modulation_of_doubtful_orders_grey": settings.min_modulation_grey(phase_map.saturation),
        "phase_sigma_rad": settings.max_sigma_rad,
        "point_sigma_mm": max_sigma_mm,
    }


def _completeness(maps: Mapping[str, PhaseMap], pixels: np.typing.NDArray[Any]) -> float:
    """Return the number of points relative to the illuminated pixels of the reference camera."""
    unlit = (PixelState.SHADOW, PixelState.WEAK_MODULATION)
    lit = int(np.count_nonzero(~np.isin(next(iter(maps.values())).state, unlit)))
    return min(1.0, len(pixels) / lit) if lit else 0.0


def check_space(project: ProjectFolder, rig: RigDescription, plan: ScanPlan, retake: Collection[str] = ()) -> None:
    """Check that the missing images fit on the disk, and those to be retaken; the project need not exist yet. Raises StorageError."""
    stored = set(project.stored_viewpoints()).difference(retake)
    project.frames.require_space(sum(stack_bytes(plan, viewpoint, rig) for viewpoint in plan if viewpoint.id not in stored))
