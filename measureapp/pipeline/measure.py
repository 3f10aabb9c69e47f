"""From fringe stacks to clouds, from clouds to a part, from a part to its dimensions."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, replace
from datetime import UTC, datetime
from typing import Any

import numpy as np

from measureapp.acquire.capture import ExposureTaken
from measureapp.acquire.engine import Engine
from measureapp.acquire.events import Event, ExposuresChosen, InspectionReady, StitchReady, ValidityKnown, ViewpointFailed, ViewReady
from measureapp.arrays import FloatArray
from measureapp.calibrate.stitch_uncertainty import view_uncertainty
from measureapp.data.calibration import RigCalibration
from measureapp.data.cloud import StitchedCloud
from measureapp.data.fringe import FringeStack
from measureapp.data.measurement import Inspection, Measurement, ViewResult
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.data.plan import ScanPlan
from measureapp.data.rig import RigDescription
from measureapp.data.validity import Validity
from measureapp.data.view_choices import ViewChoices
from measureapp.devices.rig import Rig
from measureapp.errors import CalibrationError, DecodeError, InputError, ReconstructError, RegistrationError
from measureapp.fringe.bracket import BracketLimits
from measureapp.fringe.decode import decode
from measureapp.fringe.patterns import pattern_images
from measureapp.fringe.stack_checks import check_stack
from measureapp.inspection.settings import InspectionSettings, UncertaintySettings
from measureapp.map_memory import MapMemory
from measureapp.pipeline.bracket import propose_bracket
from measureapp.pipeline.chosen_views import chosen, with_refused
from measureapp.pipeline.live_decoding import LiveDecoding
from measureapp.pipeline.validity import check_before_scan, validity_of
from measureapp.pipeline.watch import Stopwatch
from measureapp.planning.reach import check_reach
from measureapp.progress import NoProgress, PartOf, Progress
from measureapp.project.folder import ProjectFolder
from measureapp.reconstruct.camera_shift import camera_shift
from measureapp.reconstruct.diagnose import diagnose
from measureapp.reconstruct.reconstruct import Reconstruction, reconstruct
from measureapp.reconstruct.rectifier import Rectifier
from measureapp.register.cloud_quality import judge
from measureapp.register.groundwork import Groundwork
from measureapp.register.place import stations
from measureapp.register.settings import StitchSettings
from measureapp.register.stitch import stitch
from measureapp.register.surface import surface

OnEvent = Callable[[Event], None]
LAST_IMAGE_TO_CLOUD = "last image to cloud"  # storing goes on meanwhile and is not waited for
TYPICAL_RADIUS_MM = 100.0  # of points about the table's axis
LEAST_POINTS_SHARE, MOST_EPIPOLAR_PX = 0.3, 0.3  # of the phases; beside them a view is looked at for mistakes
KNOWN_STATION_MM, KNOWN_STATION_DEG = 0.03, 0.004  # repeatability of the robot and what the board leaves unknown


class _Processing:
    """The sink of a scan: decodes while images come, stores every stack for good and makes a cloud of it where there is a calibration."""

    def __init__(
        self,
        project: ProjectFolder,
        calibration: RigCalibration | None,
        on_event: OnEvent,
        watch: Stopwatch,
        live: LiveDecoding | None = None,
        groundwork: Groundwork | None = None,
    ) -> None:
        self.views: dict[str, ViewResult] = {}
        self._project, self._calibration, self._on_event, self._watch = project, calibration, on_event, watch
        self._rectifier = None if calibration is None else Rectifier(calibration.cameras)
        self._live = None if calibration is None else live
        self._groundwork = groundwork
        self._memory = MapMemory()

    def exposure_taken(self, taken: ExposureTaken) -> None:
        """Decode it on another thread."""
        if self._live is not None:
            self._live.exposure_taken(taken)

    def drop(self, viewpoint_id: str) -> None:
        """Forget what was decoded of a viewpoint that failed."""
        if self._live is not None:
            self._live.drop(viewpoint_id)

    def store(self, stack: FringeStack) -> None:
        """Keep the raw images, and process them meanwhile; returns when both are done. A stack that cannot be kept gives no view."""
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

    def process(self, stack: FringeStack, progress: Progress) -> None:
        """Make a cloud of a stack; a view without points is told, not passed on."""
        if self._calibration is None or self._rectifier is None:
            return
        with self._watch.stage("clouds"):
            try:
                decoded = None if self._live is None else self._live.maps(stack)
                maps, last_image_s = decoded or (None, 0.0)
                view = cloud_of_view(stack, self._calibration, progress, self._rectifier, maps, self._memory)
            except (DecodeError, ReconstructError) as error:
                self._on_event(ViewpointFailed(stack.viewpoint_id, str(error)))
                return
        if decoded is not None:
            view = replace(view, timings_s={LAST_IMAGE_TO_CLOUD: time.monotonic() - last_image_s})
        self.views[view.viewpoint_id] = view
        if self._groundwork is not None and view.quality.accepted:
            self._groundwork.add(view.cloud, view.part_from_camera)
        self._on_event(ViewReady(view))


def scan(
    rig: Rig,
    project: ProjectFolder,
    calibration: RigCalibration | None,
    on_event: OnEvent,
    progress: Progress,
    watch: Stopwatch,
    bracket_s: float | None = None,
    groundwork: Groundwork | None = None,
) -> tuple[ViewResult, ...]:
    """Run the project's plan on the rig and process every stack as it comes; stored viewpoints are not taken again.

    With ``groundwork``, every view is prepared for stitching and registered with the earlier ones while the scan goes on.

    Without a calibration the images are stored and no view comes back. With ``bracket_s``, the time for the images of one viewpoint,
    a probe at the first viewpoint chooses the exposures, unless some viewpoints are stored already.

    Raises
    ------
    CalibrationError
        The calibration is of other cameras than the rig's, or of cameras that are set otherwise; or it is too old, or was made at another
        temperature, and the rig's rules refuse such ones.
    PlanError
        A viewpoint is out of reach; nothing was moved.
    StorageError
        There is not enough disk space; nothing was moved.
    """
    plan = project.plan()
    if plan is None:
        raise CalibrationError(f"{project.path} has no scan plan.", "Plan the scan first.")
    check_reach(plan, rig.description)
    if calibration is not None:
        on_event(ValidityKnown(check_before_scan(rig, calibration)))
    stored = project.stored_viewpoints()
    check_space(project, rig.description, plan)
    with LiveDecoding() as live:
        sink = _Processing(project, calibration, on_event, watch, live, groundwork)
        for viewpoint_id in stored:
            sink.process(project.frames.load(viewpoint_id), NoProgress())
        images = pattern_images(plan.patterns, rig.projector.width_px, rig.projector.height_px)
        rig.place_on_table("part")
        if bracket_s is not None and not stored:
            plan = _with_chosen_exposures(rig, project, plan, bracket_s, on_event)
        with watch.stage("scan with storing and clouds"):
            Engine(rig, sink).run(plan, images, on_event, progress, stored)
    return tuple(sink.views[viewpoint.id] for viewpoint in plan if viewpoint.id in sink.views)


def _with_chosen_exposures(rig: Rig, project: ProjectFolder, plan: ScanPlan, bracket_s: float, on_event: OnEvent) -> ScanPlan:
    """Let a probe at the first viewpoint choose the exposures, and keep the plan with them."""
    planned = plan.bracket.exposures_us
    limits = BracketLimits(bracket_s, longest_us=max(rig.description.exposures_us))
    proposal = propose_bracket(rig, plan.patterns, bracket_s, len(planned), plan.viewpoints[0], limits=limits, compare={"plan": planned})
    chosen = plan.model_copy(update={"bracket": proposal.bracket})
    project.save_plan(chosen)
    planned_share = proposal.compared["plan"].decodable_share
    on_event(ExposuresChosen(proposal.exposures_us, proposal.figures.decodable_share, planned_share, proposal.note))
    return chosen


def clouds_from_disk(
    project: ProjectFolder, calibration: RigCalibration, on_event: OnEvent, progress: Progress, watch: Stopwatch
) -> tuple[ViewResult, ...]:
    """Make the clouds of all stored viewpoints. Raises InputError where no images are stored."""
    sink = _Processing(project, calibration, on_event, watch)
    stored = project.stored_viewpoints()
    if not stored:
        raise InputError(f"{project.path} holds no images of the part.", "Scan the part first, or put the project's folder `stacks` back.")
    for index, viewpoint_id in enumerate(stored):
        part = PartOf(progress, index / len(stored), (index + 1) / len(stored), f"{viewpoint_id}: ")
        sink.process(project.frames.load(viewpoint_id), part)
    return tuple(sink.views.values())


def cloud_of_view(
    stack: FringeStack,
    calibration: RigCalibration,
    progress: Progress,
    rectifier: Rectifier,
    maps: Mapping[str, PhaseMap] | None = None,
    memory: MapMemory | None = None,
) -> ViewResult:
    """Decode (where ``maps`` were not decoded already), match, triangulate and judge one viewpoint, all in ``memory``.

    Raises
    ------
    DecodeError, ReconstructError
    """
    if stack.readback is None:
        raise ReconstructError(f"{stack.viewpoint_id} has no read-back of the axes.", "Only stacks taken by a rig can be placed.")
    if maps is None:
        check_stack(stack)
        maps = decode(stack, None, PartOf(progress, 0.0, 0.5), memory)
    result = reconstruct(maps, calibration.cameras, progress=PartOf(progress, 0.5, 1.0), rectifier=rectifier, memory=memory)
    findings = diagnose(maps, calibration.cameras) if _looks_wrong(result, maps) else ()
    for finding in findings:
        if finding.severity == "error":
            raise finding.error()
    quality = judge(result.cloud, completeness=_completeness(maps, result.cloud.pixel))
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


def _looks_wrong(result: Reconstruction, maps: Mapping[str, PhaseMap]) -> bool:
    """Whether few phases became points, or another camera sees the points elsewhere: then it is worth to look for the reason."""
    decoded = max(int(np.count_nonzero(phase_map.valid)) for phase_map in maps.values())
    off = max((max(pair.epipolar_px or 0.0, pair.across_px or 0.0) for pair in result.pairs), default=0.0)
    return len(result.cloud) < LEAST_POINTS_SHARE * decoded or off > MOST_EPIPOLAR_PX


def decode_figures(phase_map: PhaseMap) -> dict[str, Any]:
    """Return the figures of decoding one camera, as `decode` prints them."""
    valid = phase_map.valid
    return {
        "valid_ratio": {"exposures": list(phase_map.valid_ratio_exposures), "composite": phase_map.valid_ratio_composite},
        "decoded_ratio": float(valid.mean()),
        "modulation_median": float(np.median(phase_map.modulation[valid])) if valid.any() else 0.0,
        "phase_sigma_median": float(np.median(phase_map.sigma_rad[valid])) if valid.any() else 0.0,
        "order_conflicts": int(np.count_nonzero(phase_map.state == PixelState.ORDER_CONFLICT)),
    }


def _completeness(maps: Mapping[str, PhaseMap], pixels: np.typing.NDArray[Any]) -> float:
    """Points over the pixels of the reference camera that see projected light."""
    unlit = (PixelState.SHADOW, PixelState.WEAK_MODULATION)
    lit = int(np.count_nonzero(~np.isin(next(iter(maps.values())).state, unlit)))
    return min(1.0, len(pixels) / lit) if lit else 0.0


def assemble(
    project: ProjectFolder,
    calibrated: RigCalibration,
    views: Sequence[ViewResult],
    on_event: OnEvent,
    progress: Progress,
    watch: Stopwatch,
    groundwork: Groundwork | None = None,
    *,
    choices: ViewChoices | None = None,
    validity: Validity | None = None,
) -> Measurement:
    """Stitch the clouds of all views, make the surface, measure the dimensions and keep everything.

    Parameters
    ----------
    groundwork : what was done of stitching while the views came
    choices : views used or refused by hand; None: as the project keeps them
    validity : of the calibration, where it is known for these views; None: judged anew

    Raises
    ------
    RegistrationError
        No view gave a cloud worth stitching.
    """
    if validity is None:
        validity = validity_of(project, calibrated, views)
        on_event(ValidityKnown(validity))
    choices = project.view_choices() if choices is None else choices
    good = chosen(views, choices)
    if not good:
        reasons = "; ".join(sorted({view.quality.reason or "refused by hand" for view in views})) or "no view gave points"
        told = " ".join(("", *validity.told))
        raise RegistrationError(f"There is nothing to stitch: {reasons}.{told}", "Look at the images; change exposures or viewpoints.")
    with watch.stage("stitching"):
        clouds, placed = [view.cloud for view in good], [view.part_from_camera for view in good]
        standing = stations([view.readback for view in good])
        settings, prior = stitch_settings(calibrated, good), _placed_by_axes(project, good)
        part = PartOf(progress, 0.0, 0.5)
        stitched = stitch(
            clouds,
            placed,
            settings,
            part,
            stations=standing,
            prior_covariance=prior,
            accepted=choices.used,
            groundwork=groundwork,
        )
        stitched = with_refused(stitched, views, choices)
    on_event(StitchReady(stitched))
    with watch.stage("surface"):
        mesh = surface(stitched, progress=PartOf(progress, 0.5, 0.7))
    with watch.stage("inspection"):
        inspection = _inspected(project, stitched, inspection_settings(calibrated, project.rig(), good), PartOf(progress, 0.7, 0.9))
    if inspection is not None:
        on_event(InspectionReady(inspection))
    plan = project.plan()
    measurement = Measurement(
        project=project.name,
        part=project.settings.part,
        rig=project.rig().name,
        measured_at=datetime.now(UTC).isoformat(timespec="seconds"),
        calibration=calibrated,
        views=tuple(views),
        stitched=stitched,
        mesh=mesh,
        inspection=inspection,
        settings={} if plan is None else _settings(plan),
        timings_s=dict(watch.seconds),
        validity=validity,
    )
    with watch.stage("saving"):
        project.save_measurement(measurement)
    progress.report(1.0, 1.0, "measured")
    return measurement


def _placed_by_axes(project: ProjectFolder, views: Sequence[ViewResult]) -> FloatArray | None:
    """Return the covariance of where the calibrated axes place the views, all together; None where the calibration did not keep it."""
    rig = project.rig_uncertainty()
    return None if rig is None else view_uncertainty(rig, [view.readback for view in views]).pose_covariance


def stitch_settings(calibration: RigCalibration, views: Sequence[ViewResult]) -> StitchSettings:
    """Return the settings of stitching where no covariance is known: the priors are tight where the robot's error was measured at every station of the scan."""
    known = all(calibration.station(view.readback) is not None for view in views)
    return StitchSettings(pose_sigma_mm=KNOWN_STATION_MM, pose_sigma_deg=KNOWN_STATION_DEG) if known else StitchSettings()


def inspection_settings(calibration: RigCalibration, rig: RigDescription, views: Sequence[ViewResult]) -> InspectionSettings:
    """Return the settings of inspection with what calibration and axes leave unknown, for the uncertainty of every dimension.

    Where the robot's error was measured at the stations of the scan, a view is placed as well as the robot repeats and the
    table turns; elsewhere only as well as the robot's absolute accuracy. The scale is known as well as the focal lengths.
    """
    known = all(calibration.station(view.readback) is not None for view in views)
    table_mm = float(np.deg2rad(rig.table.accuracy_arcsec / 3600.0)) * TYPICAL_RADIUS_MM
    placement_mm = float(np.hypot(rig.robot.repeatability_mm, table_mm)) if known else rig.robot.absolute_accuracy_mm
    scales = [
        camera.standard_deviations.get("fx", 0.0) / float(camera.pinhole.matrix[0, 0]) for camera in calibration.cameras.cameras.values()
    ]
    return InspectionSettings(uncertainty=UncertaintySettings(placement_mm=placement_mm, systematic_relative=max(scales)))


def _inspected(project: ProjectFolder, stitched: StitchedCloud, settings: InspectionSettings, progress: Progress) -> Inspection | None:
    if project.program is None:
        return None
    from measureapp.inspection.dimensions import inspect
    from measureapp.project.geometry_files import read_mesh
    from measureapp.project.program_file import read_program

    nominal = None if project.nominal is None else read_mesh(project.nominal, "nominal")
    return inspect(stitched, read_program(project.program), nominal, settings, progress=progress)


def _settings(plan: ScanPlan) -> dict[str, Any]:
    return {
        "plan": plan.name,
        "patterns": plan.patterns.name,
        "exposures_us": list(plan.bracket.exposures_us),
        "exposure rule": "all unsaturated exposures, weighted by inverse variance",
    }


def check_space(project: ProjectFolder, rig: RigDescription, plan: ScanPlan) -> None:
    """Refuse a plan whose missing images do not fit on the disk; the project need not be made yet. Raises StorageError."""
    missing = len(plan) - len(project.stored_viewpoints())
    project.frames.require_space(stack_bytes(rig, plan) * missing)


def stack_bytes(rig: RigDescription, plan: ScanPlan) -> int:
    """Return how much disk the images of one viewpoint take."""
    images = plan.patterns.count * len(plan.bracket.exposures_us)
    return sum(camera.width_px * camera.height_px * (1 if camera.bit_depth == 8 else 2) * images for camera in rig.cameras)
