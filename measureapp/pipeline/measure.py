"""From fringe stacks, of a rig or stored, to the clouds of the views."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, replace
from typing import Any

import numpy as np

from measureapp.acquire.engine import Engine
from measureapp.acquire.tasks.fringes import ExposureTaken, FringeTask
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.data.calibration import RigCalibration
from measureapp.data.fringe import FringeStack
from measureapp.data.measurement import ViewResult
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.data.plan import ScanPlan
from measureapp.data.rig import RigDescription
from measureapp.devices.rig import Rig
from measureapp.errors import CalibrationError, DecodeError, InputError, ReconstructError, StorageError
from measureapp.fringe.checks.stack import check_stack
from measureapp.fringe.decode import decode
from measureapp.fringe.exposures.bracket import BracketLimits
from measureapp.fringe.patterns.draw import pattern_images
from measureapp.fringe.settings import DecodeSettings
from measureapp.pipeline.bracket import propose_bracket
from measureapp.pipeline.events import Event, ExposuresChosen, ValidityKnown, ViewFailed, ViewReady
from measureapp.pipeline.live_decoding import LiveDecoding
from measureapp.pipeline.noise import decode_settings_of
from measureapp.pipeline.validity import check_before_scan
from measureapp.pipeline.watch import Stopwatch
from measureapp.planning.reach import check_reach
from measureapp.progress import NoProgress, PartOf, Progress
from measureapp.project.folder import ProjectFolder
from measureapp.project.geometry.robot_file import arm_of
from measureapp.reconstruct.diagnosis.camera_shift import camera_shift
from measureapp.reconstruct.diagnosis.diagnose import diagnose
from measureapp.reconstruct.projector.with_projector import reconstruct_view_with_projector
from measureapp.reconstruct.reconstruct import Reconstruction, reconstruct
from measureapp.reconstruct.rectification.rectifier import Rectifier
from measureapp.register.clouds.quality import assess_cloud
from measureapp.register.joint.registration_cache import RegistrationCache

OnEvent = Callable[[Event], None]
LAST_IMAGE_TO_CLOUD = "last image to cloud"  # without the time for storing, which runs in parallel
LEAST_POINTS_SHARE, MOST_EPIPOLAR_PX = 0.3, 0.3  # points per decoded pixel, epipolar error; beyond them a view is diagnosed


class _Processing:
    """Sink of a scan: decodes while images are taken, stores every stack and, with a calibration, computes its cloud."""

    def __init__(
        self,
        project: ProjectFolder,
        calibration: RigCalibration | None,
        on_event: OnEvent,
        watch: Stopwatch,
        settings: DecodeSettings,
        live: LiveDecoding | None = None,
        registration_cache: RegistrationCache | None = None,
    ) -> None:
        self.views: dict[str, ViewResult] = {}
        self._project, self._calibration, self._on_event, self._watch = project, calibration, on_event, watch
        self._rectifier = None if calibration is None else Rectifier(calibration.cameras)
        self._live = None if calibration is None else live
        self._settings, self._registration_cache = settings, registration_cache
        self._memory = BufferPool()

    def exposure_taken(self, taken: ExposureTaken) -> None:
        """Decode the exposure in the background."""
        if self._live is not None:
            self._live.exposure_taken(taken)

    def drop(self, viewpoint_id: str) -> None:
        """Discard a viewpoint that failed."""
        if self._live is not None:
            self._live.drop(viewpoint_id)

    def store(self, stack: FringeStack) -> None:
        """Store the raw images and process them in parallel; a stack that cannot be stored yields no view."""
        with ThreadPoolExecutor(1, "storing") as pool:
            storing = pool.submit(self._store, stack)
            try:
                self.process(stack, NoProgress())
            finally:
                if storing.exception() is not None:
                    self.views.pop(stack.viewpoint_id, None)
        storing.result()

    def _store(self, stack: FringeStack) -> None:
        with self._watch.stage("storing"):
            self._project.frames.store(stack)

    def process_stored(self, viewpoint_id: str, progress: Progress) -> None:
        """Compute the cloud of a stored stack; one that is damaged is reported by an event, and yields no view."""
        if self._calibration is None:
            return
        try:
            stack = self._project.frames.load(viewpoint_id)
        except StorageError as error:
            self._on_event(ViewFailed(viewpoint_id, str(error), damaged=True))
            return
        self.process(stack, progress)

    def process(self, stack: FringeStack, progress: Progress) -> None:
        """Compute the cloud of a stack; a view without points is reported by an event."""
        if self._calibration is None or self._rectifier is None:
            return
        with self._watch.stage("clouds"):
            try:
                decoded = None if self._live is None else self._live.maps(stack)
                maps, last_image_s = decoded or (None, 0.0)
                view = compute_cloud(stack, self._calibration, progress, self._rectifier, maps, self._memory, self._settings)
            except (DecodeError, ReconstructError) as error:
                self._on_event(ViewFailed(stack.viewpoint_id, str(error)))
                return
        if decoded is not None:
            view = replace(view, timings_s={LAST_IMAGE_TO_CLOUD: time.monotonic() - last_image_s})
        self.views[view.viewpoint_id] = view
        if self._registration_cache is not None and view.quality.accepted:
            self._registration_cache.add(view.cloud, view.part_from_camera)
        self._on_event(ViewReady(view))


def scan(
    rig: Rig,
    project: ProjectFolder,
    calibration: RigCalibration | None,
    on_event: OnEvent,
    progress: Progress,
    watch: Stopwatch,
    bracket_s: float | None = None,
    registration_cache: RegistrationCache | None = None,
) -> tuple[ViewResult, ...]:
    """Run the project's plan on the rig and process every stack as it is taken; stored viewpoints are not taken again.

    With ``registration_cache``, every view is registered with the earlier ones during the scan. Without a calibration the images are stored
    and no views are returned. With ``bracket_s``, the time budget per viewpoint, the exposures are chosen by a probe at the first
    viewpoint, unless some viewpoints are stored already.

    Raises
    ------
    CalibrationError
        The calibration is of other cameras or other lens settings; or it has expired, or was made at another temperature, and the
        rig's rules refuse that.
    PlanError
        A viewpoint is out of reach; nothing was moved.
    StorageError
        There is not enough disk space; nothing was moved.
    """
    plan = project.plan()
    if plan is None:
        raise CalibrationError(f"{project.path} has no scan plan.", "Plan the scan first.")
    check_reach(plan, rig.description, arm_of(rig.description))
    if calibration is not None:
        on_event(ValidityKnown(check_before_scan(rig, calibration)))
    stored = project.stored_viewpoints()
    check_space(project, rig.description, plan)
    settings = decode_settings_of(project)
    with LiveDecoding(settings) as live:
        sink = _Processing(project, calibration, on_event, watch, settings, live, registration_cache)
        for viewpoint_id in stored:
            sink.process_stored(viewpoint_id, NoProgress())
        images = pattern_images(plan.patterns, rig.projector.width_px, rig.projector.height_px)
        rig.place_on_table("part")
        if bracket_s is not None and not stored:
            plan = _choose_exposures(rig, project, plan, bracket_s, on_event)
        with watch.stage("scan with storing and clouds"):
            task = FringeTask(plan.patterns, plan.bracket.exposures_us, images, sink)
            waiting = [viewpoint for viewpoint in plan if viewpoint.id not in stored]
            Engine(rig).run(plan.name, waiting, task, on_event, progress)
    return tuple(sink.views[viewpoint.id] for viewpoint in plan if viewpoint.id in sink.views)


def _choose_exposures(rig: Rig, project: ProjectFolder, plan: ScanPlan, bracket_s: float, on_event: OnEvent) -> ScanPlan:
    """Choose the exposures by a probe at the first viewpoint, and store the plan with them."""
    planned = plan.bracket.exposures_us
    limits = BracketLimits(bracket_s, len(planned), longest_us=max(rig.description.exposures_us))
    proposal = propose_bracket(rig, plan.patterns, limits, plan[0], project.noise(), compare={"plan": planned})
    chosen = plan.model_copy(update={"bracket": proposal.bracket})
    project.save_plan(chosen)
    planned_share = proposal.compared["plan"].decodable_share
    on_event(ExposuresChosen(proposal.exposures_us, proposal.figures.decodable_share, planned_share, proposal.note))
    return chosen


def compute_clouds(
    project: ProjectFolder, calibration: RigCalibration, on_event: OnEvent, progress: Progress, watch: Stopwatch
) -> tuple[ViewResult, ...]:
    """Compute the clouds of all stored viewpoints. Raises InputError when no images are stored."""
    sink = _Processing(project, calibration, on_event, watch, decode_settings_of(project))
    stored = project.stored_viewpoints()
    if not stored:
        raise InputError(
            f"{project.path} contains no images of the part.", "Scan the part first, or restore the project's folder `stacks`."
        )
    for index, viewpoint_id in enumerate(stored):
        part = PartOf(progress, index / len(stored), (index + 1) / len(stored), f"{viewpoint_id}: ")
        sink.process_stored(viewpoint_id, part)
    return tuple(sink.views.values())


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
    findings = diagnose(maps, calibration.cameras) if _is_suspicious(result, maps) else ()
    for finding in findings:
        if finding.severity == "error":
            raise finding.error()
    quality = assess_cloud(result.cloud, completeness=_completeness(maps, result.cloud.pixel))
    return ViewResult(
        viewpoint_id=stack.viewpoint_id,
        cloud=result.cloud,
        quality=quality,
        part_from_camera=calibration.part_from_camera(stack.readback),
        decode={name: decode_figures(phase_map) for name, phase_map in maps.items()},
        pairs=tuple(asdict(pair) for pair in result.pairs),
        rejected=dict(result.rejected),
        readback=stack.readback,
        findings=tuple(f"{finding.message} {finding.remedy}" for finding in findings),
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
        "order_conflicts": int(np.count_nonzero(phase_map.state == PixelState.ORDER_CONFLICT)),
    }


def _completeness(maps: Mapping[str, PhaseMap], pixels: np.typing.NDArray[Any]) -> float:
    """Return the number of points relative to the illuminated pixels of the reference camera."""
    unlit = (PixelState.SHADOW, PixelState.WEAK_MODULATION)
    lit = int(np.count_nonzero(~np.isin(next(iter(maps.values())).state, unlit)))
    return min(1.0, len(pixels) / lit) if lit else 0.0


def check_space(project: ProjectFolder, rig: RigDescription, plan: ScanPlan) -> None:
    """Check that the missing images fit on the disk; the project need not exist yet. Raises StorageError."""
    missing = len(plan) - len(project.stored_viewpoints())
    project.frames.require_space(stack_bytes(rig, plan) * missing)


def stack_bytes(rig: RigDescription, plan: ScanPlan) -> int:
    """Return the size of the images of one viewpoint."""
    images = plan.patterns.count * len(plan.bracket.exposures_us)
    return sum(camera.width_px * camera.height_px * (1 if camera.bit_depth == 8 else 2) * images for camera in rig.cameras)
