"""A simulated rig: cameras, board, axes, and what they would see with stated noise."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest

from measureapp.calibrate.boards.observation import Observation
from measureapp.calibrate.boards.pose import board_pose
from measureapp.calibrate.poses import apply_changes
from measureapp.calibrate.sightings import Sighting
from measureapp.data.board import CheckerboardDescription
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration, LinearGuide, RotationAxis
from measureapp.data.fringe import AxisReadback
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform, orthonormalise, rotation_about
from tests.calibration_session.shown_board import Shown

WIDTH, HEIGHT, FOCAL = 1296, 972, 2045.0
TOE_RAD = np.deg2rad(35.2)
BOARD_CENTRE_MM = np.array([78.0, 60.0, 0.0])


def lens(distortion=(-0.1, 0.08, 0.0004, -0.0003, 0.02)) -> PinholeCamera:
    matrix = np.array([[FOCAL, 0, WIDTH / 2 + 7], [0, FOCAL * 1.001, HEIGHT / 2 - 5], [0, 0, 1]])
    return PinholeCamera(WIDTH, HEIGHT, matrix, np.array(distortion))


def placed(rotation, translation, name) -> CameraCalibration:
    return CameraCalibration(name, lens(), RigidTransform.from_parts(rotation, translation, "camera", name))


@pytest.fixture
def shown(monkeypatch) -> Shown:
    return Shown(monkeypatch)


@pytest.fixture(scope="session")
def board() -> CheckerboardDescription:
    return CheckerboardDescription(columns=14, rows=11, square_mm=12.0)


@pytest.fixture(scope="session")
def head() -> CameraArrayCalibration:
    """Two lower cameras 350 mm apart, turned in, and one above them turned down."""
    half = TOE_RAD / 2
    right = placed(rotation_about([0, 1, 0], -TOE_RAD), [350 * np.cos(half), 0, 350 * np.sin(half)], "right")
    to_middle = rotation_about([0, 1, 0], -half)
    upper = placed(to_middle @ rotation_about([1, 0, 0], -np.deg2rad(20)), to_middle @ [175, -200, 0], "upper")
    left = placed(np.eye(3), [0, 0, 0], "left")
    return CameraArrayCalibration("left", {"left": left, "right": right, "upper": upper})


def seen_corners(head, board, camera_from_board, sigma_px, generator):
    """Return camera -> corners with noise."""
    points = camera_from_board.apply(board.corners_mm)
    return {
        name: camera.pinhole.project(camera.reference_from_camera.inverse().apply(points))
        + generator.normal(scale=sigma_px, size=(len(points), 2))
        for name, camera in head.cameras.items()
    }


def board_before_cameras(generator, tilt_rad=0.6, aside_mm=60.0) -> RigidTransform:
    """Return a random pose of the board in the shared field of the head, about 550 mm away."""
    middle = rotation_about([0, 1, 0], -TOE_RAD / 2)
    turn = middle @ rotation_about([0, 0, 1], generator.uniform(-0.8, 0.8))
    turn = turn @ rotation_about([*generator.normal(size=2), 0.001], generator.uniform(0.2, tilt_rad))
    centre = middle @ np.array([*generator.uniform(-aside_mm, aside_mm, 2), generator.uniform(500, 600)])
    # the middle of the shared field lies halfway between the lower cameras
    centre = centre + middle @ np.array([175.0, 0.0, 0.0])
    return RigidTransform.from_parts(turn, centre - turn @ BOARD_CENTRE_MM, "camera", "board")


def sightings_of(head, board, views, sigma_px, generator, tilt_rad=0.6):
    result = []
    for number in range(views):
        corners = seen_corners(head, board, board_before_cameras(generator, tilt_rad), sigma_px, generator)
        result += [Sighting(name, f"{number:02d}", pixels) for name, pixels in corners.items()]
    return tuple(result)


@dataclass(frozen=True)
class TrueRig:
    """The truth of a simulated rig with a board fixed on its table."""

    head: CameraArrayCalibration
    board: CheckerboardDescription
    flange_from_camera: RigidTransform
    guide: LinearGuide
    axis: RotationAxis
    guide_from_board: RigidTransform

    def base_from_flange(self, azimuth_deg, elevation_deg, distance_mm, roll_deg, guide_mm) -> RigidTransform:
        """Return the robot pose that looks at the board."""
        azimuth, elevation = np.deg2rad([azimuth_deg, elevation_deg])
        towards = np.array([-np.cos(elevation) * np.cos(azimuth), -np.cos(elevation) * np.sin(azimuth), np.sin(elevation)])
        x = np.cross(-towards, [0, 0, 1.0])
        x /= np.linalg.norm(x)
        turn = np.column_stack([x, np.cross(-towards, x), -towards]) @ rotation_about([0, 0, 1], np.deg2rad(roll_deg))
        head = RigidTransform.from_parts(turn, self.guide_from_board.apply(BOARD_CENTRE_MM) + towards * distance_mm, "guide", "head")
        camera = RigidTransform.from_parts(rotation_about([0, 1, 0], TOE_RAD / 2), [-175.0, 0, 0], "head", "camera")
        return self.guide.guide_from_base(guide_mm).inverse() @ head @ camera @ self.flange_from_camera.inverse()

    def camera_from_board(self, readback: AxisReadback, robot_error=None) -> RigidTransform:
        """Return what the camera truly sees; ``robot_error`` is the small change of the flange."""
        flange = readback.base_from_flange
        if robot_error is not None:
            changed = flange.matrix @ apply_changes(np.eye(4), robot_error)
            flange = RigidTransform(orthonormalise(changed), "base", "flange")
        guide_from_camera = self.guide.guide_from_base(readback.guide_mm) @ flange @ self.flange_from_camera
        return guide_from_camera.inverse() @ self.axis.turned(readback.table_rad) @ self.guide_from_board


@pytest.fixture(scope="session")
def rig(head, board) -> TrueRig:
    turn = np.column_stack([[0, -1, 0], [np.sqrt(0.5), 0, -np.sqrt(0.5)], [np.sqrt(0.5), 0, np.sqrt(0.5)]])
    return TrueRig(
        head,
        board,
        RigidTransform.from_vector([0.2, -1.2, 0.3], [100, -150, 80], "flange", "camera"),
        LinearGuide(np.array([0.002, 1, -0.001]), 1.0005),
        RotationAxis(np.array([700.0, 20, 100]), np.array([0.003, -0.002, 1]), "guide"),
        RigidTransform.from_parts(turn, np.array([700.0, 20, 190]) - turn @ BOARD_CENTRE_MM, "guide", "board"),
    )


ROBOT_SIGMA_MM, ROBOT_SIGMA_RAD, CORNER_SIGMA_PX = 0.3, float(np.deg2rad(0.02)), 0.05


def readbacks_of(rig: TrueRig) -> dict[str, AxisReadback]:
    """Return 20 robot poses, 9 table angles and 7 slide positions."""
    result = {}
    for k in range(20):
        azimuth = (-30, -12, 12, 30, 0)[k % 5]
        slide = -385 * np.sin(np.deg2rad(azimuth))
        pose = rig.base_from_flange(azimuth, (27, 47, 67)[(k // 5) % 3], (500, 550, 600)[2 * k % 3], (-35, 0, 35, 15)[3 * k % 4], slide)
        result[f"pose{k:02d}"] = AxisReadback(pose, float(slide), 0.0)
    still = rig.base_from_flange(0, 55, 550, 0, 0.0)
    result |= {f"axis{k}": AxisReadback(still, 0.0, float(np.deg2rad(angle))) for k, angle in enumerate(range(-60, 61, 15))}
    still = rig.base_from_flange(0, 50, 590, 0, 0.0)
    return result | {f"guide{k}": AxisReadback(still, float(slide), 0.0) for k, slide in enumerate(range(-75, 76, 25))}


def observations_of(rig: TrueRig, generator, robot_errors=True) -> list[Observation]:
    """Return sightings with corner noise and one error per robot pose."""
    errors = {}
    result = []
    for name, readback in readbacks_of(rig).items():
        key = readback.base_from_flange.matrix.tobytes()
        sigma = np.array([ROBOT_SIGMA_RAD] * 3 + [ROBOT_SIGMA_MM] * 3) * robot_errors
        error = errors.setdefault(key, generator.normal(size=6) * sigma)
        corners = seen_corners(rig.head, rig.board, rig.camera_from_board(readback, error), CORNER_SIGMA_PX, generator)
        result.append(Observation(name, readback, board_pose(corners, rig.head, rig.board, CORNER_SIGMA_PX)))
    return result


@pytest.fixture
def generator() -> np.random.Generator:
    return np.random.default_rng(7)


@pytest.fixture(scope="session")
def simulate():
    """The functions of this file, for tests (which cannot import a conftest)."""

    class Simulate:
        corners = staticmethod(seen_corners)
        sightings = staticmethod(sightings_of)
        board_pose = staticmethod(board_before_cameras)
        observations = staticmethod(observations_of)
        readbacks = staticmethod(readbacks_of)
        robot_sigma_mm, robot_sigma_rad, corner_sigma_px = ROBOT_SIGMA_MM, ROBOT_SIGMA_RAD, CORNER_SIGMA_PX

    return Simulate
