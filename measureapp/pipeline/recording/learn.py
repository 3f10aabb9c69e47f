"""Calibration from a recording: jointly as on an own rig where it suffices for that, else link by link as far as it goes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from measureapp.calibrate.boards.observation import Observation
from measureapp.calibrate.cameras.array import CameraArraySolution
from measureapp.calibrate.draft.draft import Draft, Known, Setup
from measureapp.calibrate.draft.solve import solve
from measureapp.calibrate.kinds.rig import solve_with_cameras
from measureapp.calibrate.kinds.table import KINDS
from measureapp.calibrate.motions.axis_noise import expected_noise
from measureapp.calibrate.motions.propagation import propagate_robot_to_axis
from measureapp.calibrate.rig.joint_solution import RigSolution
from measureapp.calibrate.rig.stages import PAPER_GUIDE, transform_axis
from measureapp.calibrate.rig.stitch_uncertainty import RigUncertainty, uncertainty_of
from measureapp.calibration_session.observing import Observed, Position, observe, solve_observed
from measureapp.data.board import BoardDescription, BoardView
from measureapp.data.calibration import CameraArrayCalibration, HandEye, LinearGuide, RigCalibration, RobotStation, RotationAxis
from measureapp.data.fringe import AxisReadback, Readback
from measureapp.data.rig import RigDescription
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import RigidTransform
from measureapp.pipeline.calibrate import calibrate_from_views, views_provenance
from measureapp.pipeline.events import CalibrationReady, Event
from measureapp.pipeline.recording.motions import BoardReadback, determines_rig, moved_axes
from measureapp.pipeline.recording.stages import LINKS, Recorded, recorded, why_not_placed
from measureapp.pipeline.watch import Stopwatch
from measureapp.progress import PartOf, Progress
from measureapp.project.folder import ProjectFolder

ALTERNATIONS = 3  # of hand-eye and guide; the nominal direction is off by tenths of a degree, each turn leaves a small part of that
METHOD = "link by link from a recording"
STATIONARY = "none: the cameras are stationary"


@dataclass(frozen=True, slots=True, eq=False)
class Learnt:
    """What was calibrated from a recording."""

    cameras: CameraArrayCalibration
    links: Mapping[str, Any] = field(
        default_factory=dict
    )  # "hand_eye", "guide", "axis" -> its solution; the axis in frame "camera" or "guide"
    rig: RigCalibration | None = None  # None: the viewpoints cannot be placed, or the links do not make a rig
    uncertainty: RigUncertainty | None = None  # of a joint solution
    failed: Mapping[str, str] = field(default_factory=dict)  # link -> why it could not be solved from the views there are


def learn(project: ProjectFolder, progress: Progress) -> Learnt:
    """Calibrate from the board views of an imported project, with its known cameras if it has any.

    Raises
    ------
    CalibrationError
        The cameras are not known and their board views do not determine them; or a complete recording does not determine the rig.
    """
    found, views = recorded(project), project.board_views(progress)
    board, rig = project.settings.board, project.rig()
    if found.known is None and len(found.board) == len(views) and determines_rig(found.board):
        solution = calibrate_from_views(views, board, rig, progress)
        return _of_joint(solution, found)
    if found.known is None and not views:
        raise CalibrationError(f"{project.path} has neither board views nor known cameras.", "Add one of them to the recording.")
    calibrator = _Calibrator.of(found, views, board, rig, PartOf(progress, 0.0, 0.7))
    return calibrator.solve_links(PartOf(progress, 0.7, 1.0))


def calibrate_recording(project: ProjectFolder, on_event: Callable[[Event], None], progress: Progress, watch: Stopwatch) -> RigCalibration:
    """Calibrate the rig of an imported project and store it. Raises CalibrationError where its viewpoints cannot be placed."""
    with watch.stage("calibration"):
        learnt = learn(project, progress)
    if learnt.rig is None:
        reasons = [*learnt.failed.values(), why_not_placed(recorded(project), learnt.links)]
        raise CalibrationError(
            " ".join(filter(None, reasons)), "Compute its clouds by `measureapp process PROJECT`, or record what is missing."
        )
    project.save_calibration(learnt.rig, learnt.uncertainty)
    on_event(CalibrationReady(learnt.rig))
    return learnt.rig


def stationary_rig(cameras: CameraArrayCalibration) -> RigCalibration:
    """Return a rig whose part frame, with all axes at 0, is the camera frame: for cameras that stand still."""
    hand_eye = HandEye(RigidTransform.identity("flange", "camera"), method=STATIONARY)
    axis = RotationAxis(np.zeros(3), np.array([0.0, 0.0, 1.0]), "guide")
    return RigCalibration(cameras, hand_eye, PAPER_GUIDE, axis, cameras.provenance)


def _of_joint(solution: RigSolution, found: Recorded) -> Learnt:
    calibration, why = solution.calibration, why_not_placed(found)
    links = {link: getattr(calibration, link) for link in LINKS if found.links[link]}
    return Learnt(calibration.cameras, links, None if why else calibration, None if why else uncertainty_of(solution))


@dataclass(frozen=True, slots=True, eq=False)
class _Calibrator:
    """Cameras, and the observations of the board made with them."""

    found: Recorded
    views: Sequence[BoardView]
    rig: RigDescription
    board: BoardDescription  # with its bow, where that was estimated
    cameras: CameraArrayCalibration
    solution: CameraArraySolution | None  # None: the cameras were known
    observations: Mapping[str, Observation]

    @classmethod
    def of(
        cls, found: Recorded, views: Sequence[BoardView], board: BoardDescription, rig: RigDescription, progress: Progress
    ) -> _Calibrator:
        """Detect the board in all views, and calibrate the cameras where they are not known. Raises CalibrationError."""
        standing = {view.id: view.axes for view in found.board}
        first = [view for view in views if view.viewpoint_id in standing]  # in a row, so that approaches can be numbered
        others = [view for view in views if view.viewpoint_id not in standing]
        positions = [Position(one.viewpoint_id, lambda one=one: one.images, one.readback) for one in first]  # type: ignore[misc]
        loose = [Position(one.viewpoint_id, lambda one=one: one.images, Readback()) for one in others]  # type: ignore[misc]
        seen = [
            observe(some, board, found.known, PartOf(progress, start, end))
            for some, start, end in ((positions, 0.0, 0.3), (loose, 0.3, 0.6))
            if some
        ]
        observed = Observed(
            tuple(one for each in seen for one in each.observations),
            tuple(one for each in seen for one in each.refused),
            {key: image for each in seen for key, image in each.unclear.items()},
        )
        cameras, solution = found.known, None
        if cameras is None:
            names = (rig.reference, *(camera.name for camera in rig.cameras if camera.name != rig.reference))
            setup = Setup.on_rig(KINDS["cameras"], board, names, Known(), rig)
            observed, solved = solve_observed(observed, setup, _sizes_px(rig), PartOf(progress, 0.6, 1.0))
            solution, board = solved.camera_solution, solved.board
            provenance = views_provenance(solved.cameras.provenance.method, rig, views)
            cameras = replace(solved.cameras, provenance=provenance)
        return cls(found, views, rig, board, cameras, solution, {one.id: one for one in observed.usable})

    def solve_links(self, progress: Progress) -> Learnt:
        """Solve the links of the rig for which there are views; those that fail are told."""
        on_table = [view for view in self.found.board if view.on_table]
        links: dict[str, Any] = {}
        failed: dict[str, str] = {}
        if determines_rig(on_table):
            try:
                return self._solve_jointly(on_table, progress)
            except CalibrationError as error:
                failed["rig"] = str(error)
        for index, link in enumerate(LINKS):
            views = self.found.groups[link]
            if not views or (link == "guide" and self.found.robot_moves and "hand_eye" not in links):
                continue
            try:
                part = PartOf(progress, index / len(LINKS), (index + 1) / len(LINKS))
                links[link] = self._solve(link, views, links.get("hand_eye"), part)
                if link == "guide":
                    links |= self._alternate(links, part)
            except CalibrationError as error:
                failed[link] = str(error)
        is_rig = not why_not_placed(self.found, links) if self.found.viewpoints else {"hand_eye", "axis"} <= set(links)
        return Learnt(self.cameras, links, self._assemble(links) if is_rig else None, failed=failed)

    def _solve_jointly(self, views: Sequence[BoardReadback], progress: Progress) -> Learnt:
        observations = self._seen(views)
        setup = self._setup("rig", None)
        if self.solution is None:
            solution: RigSolution = solve(Draft(setup, observations, _sizes_px(self.rig)), progress).solution
        else:
            solution = solve_with_cameras(observations, self.solution, setup, progress)
        provenance = views_provenance(solution.calibration.provenance.method, self.rig, self.views)
        calibration = replace(solution.calibration, cameras=self.cameras, provenance=provenance)
        return _of_joint(replace(solution, calibration=calibration), self.found)

    def _solve(
        self, link: str, views: Sequence[BoardReadback], hand_eye: HandEye | None, progress: Progress, guide: LinearGuide = PAPER_GUIDE
    ) -> Any:
        """Solve one link; one whose guide should stand still, but moved, is solved with the guide taken as known."""
        kind = KINDS[link.replace("_", "-")]
        setup = self._setup(kind.name, hand_eye or stationary_rig(self.cameras).hand_eye)
        seen = self._seen(views)
        if kind.guide_at_zero:
            seen = tuple(replace(one, readback=_with_guide(one.axes, guide)) for one in seen)
        return kind.result(solve(Draft(setup, seen, _sizes_px(self.rig)), progress))

    def _alternate(self, links: Mapping[str, Any], progress: Progress) -> dict[str, Any]:
        """Solve hand-eye and guide in turn where the guide moved between the views for hand-eye, which started from its nominal direction."""
        views, guide, hand_eye = self.found.groups["hand_eye"], links["guide"], links.get("hand_eye")
        if hand_eye is None or "guide" not in moved_axes([view.axes for view in views]):
            return {}
        for _ in range(ALTERNATIONS):
            hand_eye = self._solve("hand_eye", views, None, progress, guide)
            guide = self._solve("guide", self.found.groups["guide"], hand_eye, progress)
        return {"hand_eye": hand_eye, "guide": guide}

    def _setup(self, kind: str, hand_eye: HandEye | None) -> Setup:
        return Setup(
            kind=KINDS[kind],
            board=self.board,
            camera_names=self.cameras.names,
            cameras=self.cameras,
            hand_eye=hand_eye,
            noise=expected_noise(self.rig),
            standoff_mm=self.rig.standoff_mm,
        )

    def _seen(self, views: Sequence[BoardReadback]) -> tuple[Observation, ...]:
        return tuple(self.observations[view.id] for view in views if view.id in self.observations)

    def _assemble(self, links: Mapping[str, Any]) -> RigCalibration:
        """Return the rig of these links; those without a solution are not needed, and stand at rest."""
        found, rest = self.found, stationary_rig(self.cameras)
        rig = replace(rest, hand_eye=links.get("hand_eye", rest.hand_eye), guide=links.get("guide", rest.guide))
        if "axis" in links:
            first = found.groups["axis"][0].axes
            axis = transform_axis(links["axis"], rig.guide_from_camera(first))
            if "hand_eye" in links:
                axis = propagate_robot_to_axis(axis, links["axis"], rig.hand_eye, expected_noise(self.rig))
            rig = replace(rig, axis=axis)
        elif "hand_eye" in links:
            rig = replace(rig, axis=RotationAxis(np.array(self.rig.table.centre_in_guide_mm), np.array([0.0, 0.0, 1.0]), "guide"))
        poses = [readback.base_from_flange for readback in found.viewpoints]
        stations = () if "hand_eye" in found.needed or not poses else (RobotStation(poses[0], poses[0]),)
        return replace(rig, provenance=views_provenance(METHOD, self.rig, self.views), stations=stations)


def _with_guide(readback: AxisReadback, guide: LinearGuide) -> AxisReadback:
    """Return the read-back of a robot whose base, at position 0 of the guide, stands for the guide and the robot."""
    carried = guide.guide_from_base(readback.guide_mm).matrix @ readback.base_from_flange.matrix
    return AxisReadback(RigidTransform(carried, "base", "flange"), 0.0, readback.table_rad)


def _sizes_px(rig: RigDescription) -> dict[str, tuple[int, int]]:
    return {camera.name: (camera.width_px, camera.height_px) for camera in rig.cameras}
