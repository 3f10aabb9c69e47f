"""A typical calibration of a rig that is not calibrated yet: solved from the views it would take, with stated noise of the corners."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.boards.observation import Observation
from measureapp.calibrate.draft.draft import Draft, Known, Setup
from measureapp.calibrate.draft.solve import solve
from measureapp.calibrate.kinds.table import KINDS
from measureapp.calibrate.rig.joint import number_approaches
from measureapp.calibrate.rig.joint_solution import RigSolution
from measureapp.calibrate.rig.stitch_uncertainty import uncertainty_of
from measureapp.calibrate.sightings import Sighting
from measureapp.data.board import BoardDescription
from measureapp.data.fringe import AxisReadback
from measureapp.data.plan import ScanPlan, Viewpoint
from measureapp.data.rig import CameraDescription, RigDescription
from measureapp.geometry.edge_blur import GAUSSIAN_RISE
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform, rotation_about
from measureapp.pipeline.prediction.rig_model import RigModel
from measureapp.pipeline.prediction.views import readback_of
from measureapp.planning.calibration_views import board_middle_mm, board_on_stand, calibration_viewpoints
from measureapp.progress import NoProgress, Progress

CORNER_SIGMA_PX = 0.04  # per coordinate, of marks found in images without defects
BLUR_PX = 0.75  # standard deviation, of a lens in focus and the pixels' width
MOST_TILT_DEG = 70.0  # of a board whose marks are found
LEAST_MARKS_SHARE = 0.5  # of a board that is found
SEED = 1
SOURCE = "typical calibration: the views that this rig would take, marks found to {sigma:g} px, axes as accurate as their data sheets state"


def typical_rig(
    description: RigDescription,
    plan: ScanPlan,
    board: BoardDescription,
    arm: ArmModel | None = None,
    progress: Progress | None = None,
) -> RigModel:
    """Calibrate the described rig from simulated marks of the board at the viewpoints of a calibration for ``plan``.

    The nominal rig is taken as the true one. The solution and its covariance are those of the code that calibrates from images.

    Raises
    ------
    CalibrationError
        The rig cannot reach enough views of the board.
    """
    progress = progress or NoProgress()
    views = calibration_viewpoints(description, plan, arm=arm)
    names = (description.reference, *(camera.name for camera in description.cameras if camera.name != description.reference))
    setup = Setup.on_rig(KINDS["rig"], board, names, Known(), description)
    setup = replace(setup, noise=replace(setup.noise, motion_spread=0.0))  # these views cannot show the axes to be better than stated
    observations = _observe(description, views, board)
    sizes_px = {camera.name: (camera.width_px, camera.height_px) for camera in description.cameras}
    solved = solve(Draft(setup, observations, {name: sizes_px[name] for name in names}), progress)
    solution: RigSolution = solved.solution
    return RigModel(description, solution.calibration, uncertainty_of(solution), SOURCE.format(sigma=CORNER_SIGMA_PX))


def nominal_pinhole(camera: CameraDescription) -> PinholeCamera:
    """Return a camera as described: no distortion, the principal point in the middle of the image."""
    middle = (camera.width_px - 1) / 2, (camera.height_px - 1) / 2
    matrix = np.array([[camera.focal_px, 0.0, middle[0]], [0.0, camera.focal_px, middle[1]], [0.0, 0.0, 1.0]])
    return PinholeCamera(camera.width_px, camera.height_px, matrix, np.zeros(5))


def _observe(rig: RigDescription, views: Sequence[Viewpoint], board: BoardDescription) -> tuple[Observation, ...]:
    """Return the observations of the views in which a camera finds the board, in the order of the views."""
    rng = np.random.default_rng(SEED)
    readbacks = [readback_of(view) for view in views]
    approaches = number_approaches([readback.base_from_flange for readback in readbacks])
    observations = []
    for view, readback, approach in zip(views, readbacks, approaches, strict=True):
        seen = _sight(view.id, _head_from_board(rig, readback, board), rig, board, rng)
        if seen:
            observations.append(Observation(view.id, readback, approach=approach, seen=seen))
    return tuple(observations)


def _head_from_board(rig: RigDescription, readback: AxisReadback, board: BoardDescription) -> RigidTransform:
    middle = RigidTransform.from_parts(np.eye(3), -np.asarray(board.middle_mm), "board", "board")
    guide_from_board = _turned(rig, readback.table_rad) @ board_on_stand(board_middle_mm(rig)) @ middle
    guide_from_base = RigidTransform.from_parts(np.eye(3), [0.0, readback.guide_mm, 0.0], "guide", "base")
    guide_from_head = guide_from_base @ readback.base_from_flange @ rig.flange_from_head.transform("flange", "head")
    return guide_from_head.inverse() @ guide_from_board


def _turned(rig: RigDescription, angle_rad: float) -> RigidTransform:
    centre, turn = np.array(rig.table.centre_in_guide_mm), rotation_about([0, 0, 1], angle_rad)
    return RigidTransform.from_parts(turn, centre - turn @ centre, "guide", "guide")


def _sight(
    view: str, head_from_board: RigidTransform, rig: RigDescription, board: BoardDescription, rng: np.random.Generator
) -> Mapping[str, Sighting]:
    """Return the sightings of every camera that sees enough of the board's printed side."""
    found = {}
    for camera in rig.cameras:
        camera_from_board = camera.head_from_camera.transform("head", camera.name).inverse() @ head_from_board
        places = camera_from_board.apply(board.corners_mm)
        if not _faces(camera_from_board, places):
            continue
        pixels = nominal_pinhole(camera).project(places) + CORNER_SIGMA_PX * rng.standard_normal((len(places), 2))
        inside = np.all((pixels > 0) & (pixels < np.array([camera.width_px, camera.height_px]) - 1), axis=1)
        if inside.mean() >= LEAST_MARKS_SHARE:
            marks = Sighting(camera.name, view, pixels[inside], np.flatnonzero(inside), edge_px=BLUR_PX * GAUSSIAN_RISE)
            found[camera.name] = replace(marks, sigma_px=np.full(int(inside.sum()), CORNER_SIGMA_PX))
    return found


def _faces(camera_from_board: RigidTransform, places_mm: FloatArray) -> bool:
    """Whether the printed side, which faces -z, is turned towards the camera."""
    if places_mm[:, 2].min() <= 0:
        return False
    towards = -places_mm.mean(axis=0)
    cosine = float(-camera_from_board.rotation[:, 2] @ towards / np.linalg.norm(towards))
    return cosine > np.cos(np.deg2rad(MOST_TILT_DEG))
