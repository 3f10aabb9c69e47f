"""Ground truth of the simulated rig: drawn once from a seed, hidden from all measuring code."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.board import BoardDescription
from measureapp.data.calibration import (
    CameraArrayCalibration,
    CameraCalibration,
    HandEye,
    LinearGuide,
    ProjectorCalibration,
    Provenance,
    RigCalibration,
    RotationAxis,
)
from measureapp.data.rig import CameraDescription, ProjectorDescription, RigDescription
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform, rotation_about
from measureapp.simulate.kinematics import (
    GuideErrors,
    RobotErrors,
    TableErrors,
    draw_axis,
    draw_guide_errors,
    draw_robot_errors,
    draw_table_errors,
    perturb,
)
from measureapp.simulate.options import RigErrors

BOARD_HEIGHT_MM = 90.0  # centre of the board above the table
BOARD_OFF_AXIS_MM = 20.0
BOARD_TILT_DEG = 45.0
CAMERA_LENS = np.array([-0.10, 0.05, 0.0, 0.0, 0.0])  # k1 k2 p1 p2 k3
CAMERA_LENS_SPREAD = np.array([0.015, 0.02, 4e-4, 4e-4, 0.0])
PROJECTOR_LENS = np.array([-0.03, 0.01, 0.0, 0.0, 0.0])
PROJECTOR_LENS_SPREAD = np.array([0.01, 0.005, 3e-4, 3e-4, 0.0])
FOCAL_SPREAD = 0.005
CENTRE_SPREAD = 0.01  # of the width


@dataclass(frozen=True, slots=True, eq=False)
class Truth:
    """True values of everything that calibrations estimate; frame `part` is `table` at table angle 0."""

    calibration: RigCalibration
    projector: PinholeCamera
    camera_from_projector: RigidTransform
    table_from_nominal: RigidTransform  # pose of the part on the table
    table_from_board: RigidTransform
    robot: RobotErrors | None  # None: a perfect axis
    guide: GuideErrors | None
    table: TableErrors | None

    def with_projector(self) -> RigCalibration:
        """Return the true calibration including the projector."""
        projector = ProjectorCalibration(self.projector, self.camera_from_projector)
        return replace(self.calibration, cameras=replace(self.calibration.cameras, projector=projector))


def draw_truth(rig: RigDescription, board: BoardDescription, errors: RigErrors, seed: int) -> Truth:
    """Draw the true rig for a nominal ``rig``; the same seed gives the same rig at every camera resolution."""
    generators = [np.random.default_rng([seed, subject]) for subject in range(9)]
    heads = {
        camera.name: perturb(
            camera.head_from_camera.transform("head", camera.name), rng, shift_mm=errors.camera_shift_mm, turn_deg=errors.camera_turn_deg
        )
        for camera, rng in zip(rig.cameras, generators[0].spawn(len(rig.cameras)), strict=True)
    }
    camera_from_head = _renamed(heads[rig.reference], "head", "camera").inverse()
    lenses = generators[1].spawn(len(rig.cameras))
    cameras = {
        camera.name: _camera(camera, camera_from_head @ heads[camera.name], rng) for camera, rng in zip(rig.cameras, lenses, strict=True)
    }
    flange_from_head = perturb(
        rig.flange_from_head.transform("flange", "head"),
        generators[2],
        shift_mm=errors.hand_eye_shift_mm,
        turn_deg=errors.hand_eye_turn_deg,
    )
    head_from_projector = perturb(
        rig.projector.head_from_projector.transform("head", "projector"),
        generators[3],
        shift_mm=errors.camera_shift_mm,
        turn_deg=errors.camera_turn_deg,
    )
    guide = draw_guide_errors(rig.guide, generators[4]) if errors.axes else None
    axis, top = _table_axis(rig, errors, generators[5])
    calibration = RigCalibration(
        cameras=CameraArrayCalibration(rig.reference, cameras, provenance=Provenance(method="truth")),
        hand_eye=HandEye(flange_from_head @ camera_from_head.inverse(), method="truth"),
        guide=LinearGuide(guide.direction, guide.scale) if guide else LinearGuide(np.array([0.0, 1.0, 0.0]), 1.0),
        axis=axis,
        provenance=Provenance(method="truth"),
    )
    table_from_guide = calibration.table_from_guide
    return Truth(
        calibration=calibration,
        projector=_projector(rig.projector, generators[3]),
        camera_from_projector=camera_from_head @ head_from_projector,
        table_from_nominal=_place_part(table_from_guide.apply(top), generators[6]),
        table_from_board=table_from_guide @ _board_on_stand(top, board, generators[7]),
        robot=draw_robot_errors(rig.robot, generators[8]) if errors.axes else None,
        guide=guide,
        table=draw_table_errors(rig.table, generators[8]) if errors.axes else None,
    )


def knock_camera(truth: Truth, camera: str, turn_rad: FloatArray) -> Truth:
    """Rotate one camera about its own centre by a rotation vector in its own frame; everything else stays in place."""
    head, hand_eye = truth.calibration.cameras, truth.calibration.hand_eye
    if camera != head.reference:
        one = head.cameras[camera]
        turn = RigidTransform.from_vector(turn_rad, np.zeros(3), camera, camera)
        moved = replace(one, reference_from_camera=one.reference_from_camera @ turn)
        cameras = replace(head, cameras={**head.cameras, camera: moved})
        return replace(truth, calibration=replace(truth.calibration, cameras=cameras))
    turn = RigidTransform.from_vector(turn_rad, np.zeros(3), "camera", "camera")
    back = turn.inverse()
    others = {
        name: one if name == camera else replace(one, reference_from_camera=back @ one.reference_from_camera)
        for name, one in head.cameras.items()
    }
    calibration = replace(
        truth.calibration,
        cameras=replace(head, cameras=others),
        hand_eye=replace(hand_eye, flange_from_camera=hand_eye.flange_from_camera @ turn),
    )
    return replace(truth, calibration=calibration, camera_from_projector=back @ truth.camera_from_projector)


def _renamed(transform: RigidTransform, to_frame: str, from_frame: str) -> RigidTransform:
    return RigidTransform(transform.matrix, to_frame, from_frame)


def _camera(camera: CameraDescription, reference_from_camera: RigidTransform, rng: np.random.Generator) -> CameraCalibration:
    pinhole = _pinhole(camera.width_px, camera.height_px, camera.focal_px, CAMERA_LENS + CAMERA_LENS_SPREAD * rng.standard_normal(5), rng)
    return CameraCalibration(camera.name, pinhole, reference_from_camera, serial=camera.serial)


def _projector(projector: ProjectorDescription, rng: np.random.Generator) -> PinholeCamera:
    lens = PROJECTOR_LENS + PROJECTOR_LENS_SPREAD * rng.standard_normal(5)
    return _pinhole(projector.width_px, projector.height_px, projector.focal_px, lens, rng)


def _pinhole(width_px: int, height_px: int, focal_px: float, lens: FloatArray, rng: np.random.Generator) -> PinholeCamera:
    focal = focal_px * (1.0 + FOCAL_SPREAD * rng.standard_normal())
    aspect = 1.0 + 2e-4 * rng.standard_normal()
    centre = (np.array([width_px, height_px]) - 1.0) / 2.0 + CENTRE_SPREAD * width_px * rng.standard_normal(2)
    matrix = np.array([[focal, 0.0, centre[0]], [0.0, focal * aspect, centre[1]], [0.0, 0.0, 1.0]])
    return PinholeCamera(width_px, height_px, matrix, lens)


def _table_axis(rig: RigDescription, errors: RigErrors, rng: np.random.Generator) -> tuple[RotationAxis, FloatArray]:
    """Draw the axis in the guide frame, and the centre of the table's top on it."""
    top = np.array(rig.table.centre_in_guide_mm) + errors.table_shift_mm / np.sqrt(3.0) * rng.standard_normal(3)
    return RotationAxis(top, draw_axis(errors.table_tilt_deg, rng), "guide"), top


def _place_part(top_in_table_mm: FloatArray, rng: np.random.Generator) -> RigidTransform:
    """Draw the pose of the part on the table, slightly off centre and rotated."""
    turn = np.deg2rad(rng.uniform(-10.0, 10.0))
    shift = [*rng.uniform(-3.0, 3.0, 2), 0.0]
    return RigidTransform.from_parts(rotation_about([0, 0, 1], turn), top_in_table_mm + shift, "table", "nominal")


def _board_on_stand(top_mm: FloatArray, board: BoardDescription, rng: np.random.Generator) -> RigidTransform:
    """Draw guide_from_board: printed side up and towards the robot, rows running down."""
    tilt = np.deg2rad(BOARD_TILT_DEG + rng.uniform(-3.0, 3.0))
    turn = rotation_about([0, 0, 1], np.deg2rad(rng.uniform(-5.0, 5.0)))
    x, y = np.array([0.0, -1.0, 0.0]), np.array([-np.cos(tilt), 0.0, -np.sin(tilt)])
    rotation = turn @ np.column_stack([x, y, np.cross(x, y)])
    away = rng.uniform(0.0, 2.0 * np.pi)
    centre = top_mm + np.array([BOARD_OFF_AXIS_MM * np.cos(away), BOARD_OFF_AXIS_MM * np.sin(away), BOARD_HEIGHT_MM])
    return RigidTransform.from_parts(rotation, centre - rotation @ board.middle_mm, "guide", "board")
