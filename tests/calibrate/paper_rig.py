"""The virtual rig of the paper without images: its true axes with their errors, and corners with stated noise."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from measureapp.calibrate.boards.observation import Observation
from measureapp.calibrate.boards.pose import board_pose, stated_pose, triangulate
from measureapp.calibrate.cameras.prior import POSE_NAMES, derivatives, perturb_cameras, pose_camera_jacobian
from measureapp.calibrate.motions.axis_motion import rigid_motion
from measureapp.calibrate.motions.axis_noise import AxisNoise, expected_noise
from measureapp.calibrate.poses import change_between
from measureapp.calibrate.rig.joint import number_approaches, solve_rig
from measureapp.calibrate.rig.joint_solution import RigSolution
from measureapp.data.board import CheckerboardDescription
from measureapp.data.calibration import CameraArrayCalibration, LabelledCovariance
from measureapp.data.fringe import AxisReadback
from measureapp.data.plan import Viewpoint
from measureapp.geometry.transform import RigidTransform
from measureapp.planning.calibration_views import calibration_viewpoints
from measureapp.planning.viewpoints import plan_around_part
from measureapp.project.rig_file import read_rig
from measureapp.simulate.effects.motions import GuideMotion, TableMotion, draw_guide_motion, draw_table_motion
from measureapp.simulate.options import AxisEffects, RigErrors
from measureapp.simulate.truth import Truth, draw_truth

BOARD = CheckerboardDescription(columns=14, rows=11, square_mm=15.0)
CORNER_SIGMA_PX = 0.1  # of one coordinate, at full resolution: what real boards and lenses usually leave
IMAGE_SIGMA_PX = 0.03  # of the virtual rig's images of this board, see test_rig_figures
GUIDED = "guide06"  # the middle of the first pass along the guide
RIG = read_rig("paper")
NOISE = expected_noise(RIG)
STRAIGHT = AxisEffects()  # no error motions of table and guide


def planned(stations: bool = True) -> tuple[Viewpoint, ...]:
    plan = plan_around_part(RIG, "gypsum", radius_mm=60.0, height_mm=80.0, count=8) if stations else None
    return calibration_viewpoints(RIG, plan)


@dataclass
class Cell:
    """A rig as really built, moved like the virtual one."""

    truth: Truth
    moves: np.random.Generator
    turned_rad: dict[str, float] = field(default_factory=dict)  # viewpoint -> how far the table truly stood
    table: TableMotion | None = None
    guide: GuideMotion | None = None

    @classmethod
    def of(cls, seed: int, effects: AxisEffects = STRAIGHT) -> Cell:
        drawn = np.random.default_rng([seed, 103])
        return cls(
            draw_truth(RIG, BOARD, RigErrors(), seed),
            np.random.default_rng([seed, 101]),
            table=draw_table_motion(effects, drawn),
            guide=draw_guide_motion(effects, RIG, drawn),
        )

    def placed(self, viewpoints: tuple[Viewpoint, ...]) -> list[tuple[str, AxisReadback, RigidTransform]]:
        """Return name, read-back and true camera_from_board of every viewpoint; an axis that keeps its goal does not move."""
        result, last, reached = [], (None, None, None), [None, None, None]
        truth = self.truth
        for viewpoint in viewpoints:
            read = AxisReadback(viewpoint.flange.transform(), viewpoint.guide_mm, float(np.deg2rad(viewpoint.table_deg)))
            goals = (read.base_from_flange.matrix.tobytes(), read.guide_mm, read.table_rad)
            if goals[0] != last[0]:
                reached[0] = truth.robot.true_pose(read.base_from_flange, self.moves)
            if goals[1] != last[1]:
                reached[1] = truth.guide.guide_from_base(read.guide_mm, self.moves)
            if goals[2] != last[2]:
                reached[2] = truth.table.true_angle_rad(read.table_rad, self.moves)
            last = goals
            self.turned_rad[viewpoint.id] = reached[2]
            rig = truth.calibration
            slid = reached[1] if self.guide is None else reached[1] @ self.guide.at(read.guide_mm)
            camera = slid @ reached[0] @ rig.hand_eye.flange_from_camera
            table = rig.table_from_guide.inverse()
            if self.table is not None:
                table = table @ self.table.at(read.table_rad)
            turned = RigidTransform.from_vector([0, 0, reached[2]], np.zeros(3), "table", "table")
            result.append((viewpoint.id, read, camera.inverse() @ table @ turned @ truth.table_from_board))
        return result


def corners_of(
    cameras: CameraArrayCalibration, pose: RigidTransform, sigma_px: float, generator: np.random.Generator
) -> dict[str, np.ndarray]:
    seen = {}
    for name, camera in cameras.cameras.items():
        pixels = camera.pinhole.project(camera.reference_from_camera.inverse().apply(pose.apply(BOARD.corners_mm)))
        size = np.array([camera.pinhole.width_px, camera.pinhole.height_px])
        if np.all((pixels > 5) & (pixels < size - 6)):
            seen[name] = pixels + generator.normal(scale=sigma_px, size=pixels.shape)
    return seen


def camera_prior_of(cameras: CameraArrayCalibration, poses: list[RigidTransform], sigma_px: float) -> LabelledCovariance:
    """Return the covariance that a bundle adjustment over ``poses`` would give."""
    reference = f"{cameras.reference}."
    first = [derivatives(stated_pose(poses[0], 1.0, 1.0), camera, BOARD)[2][:-3] for camera in cameras.cameras.values()]
    labels = [label for own in first for label in own if not (label.startswith(reference) and label.endswith(POSE_NAMES))]
    normal = np.zeros((len(labels), len(labels)))
    for pose in poses:
        by_pose, mixed = np.zeros((6, 6)), np.zeros((6, len(labels)))
        for name in corners_of(cameras, pose, 0.0, np.random.default_rng(0)):
            to_pose, to_own, own = derivatives(stated_pose(pose, 1.0, 1.0), cameras.cameras[name], BOARD)
            known = [index for index, label in enumerate(own) if label in labels]
            at = [labels.index(own[index]) for index in known]
            normal[np.ix_(at, at)] += to_own[:, known].T @ to_own[:, known]
            by_pose += to_pose.T @ to_pose
            mixed[:, at] += to_pose.T @ to_own[:, known]
        if not by_pose.any():
            continue
        normal -= mixed.T @ np.linalg.solve(by_pose, mixed)  # the board's pose is not given
    scale = np.sqrt(np.diag(normal))
    return LabelledCovariance(tuple(labels), sigma_px**2 * np.linalg.inv(normal / np.outer(scale, scale)) / np.outer(scale, scale))


@dataclass
class Run:
    """One simulated calibration."""

    cell: Cell
    solution: RigSolution
    prior: LabelledCovariance
    observations: list[Observation]
    cameras: CameraArrayCalibration  # as they were calibrated before


def calibrated(
    seed: int,
    *,
    corner_sigma_px: float = CORNER_SIGMA_PX,
    corner_errors: bool = True,
    camera_errors: bool = True,
    stations: bool = True,
    camera_prior_used: bool = True,
    noise: AxisNoise = NOISE,
    effects: AxisEffects = STRAIGHT,
    stop_mm: float = 0.0,
    **options: Any,
) -> Run:
    """Calibrate rig ``seed`` from corners with that noise and cameras drawn from their covariance; each may be without error all the same.

    Where the cameras stop scatters by ``stop_mm`` in every coordinate.
    """
    cell = Cell.of(seed, effects)
    true_cameras = cell.truth.calibration.cameras
    placed = cell.placed(planned(stations))
    prior = camera_prior_of(true_cameras, [pose for _, _, pose in placed], corner_sigma_px)
    generator, scatter = np.random.default_rng([seed, 7]), np.random.default_rng([seed, 8])
    error = np.linalg.cholesky(prior.covariance) @ generator.normal(size=len(prior.parameters)) * camera_errors
    cameras = perturb_cameras(true_cameras, prior.parameters, error)
    observations = []
    approaches = number_approaches([read.base_from_flange for _, read, _ in placed])
    for approach, (name, read, pose) in zip(approaches, placed, strict=True):
        stopped = scatter.normal(scale=stop_mm, size=3) if stop_mm else np.zeros(3)
        there = RigidTransform.from_vector(np.zeros(3), stopped, pose.to_frame, pose.to_frame) @ pose
        corners = corners_of(true_cameras, there, corner_sigma_px * corner_errors, generator)
        if corners:
            seen = board_pose(corners, cameras, BOARD, corner_sigma_px)
            camera_jacobian = pose_camera_jacobian(seen, dict.fromkeys(corners), cameras, BOARD, prior.parameters)
            observations.append(Observation(name, read, seen, camera_jacobian, approach))
    solution = solve_rig(observations, cameras, noise=noise, camera_prior=prior if camera_prior_used else None, **options)
    return Run(cell, solution, prior, observations, cameras)


def errors_of(run: Run) -> dict[str, float]:
    """Return the error of every labelled parameter (board and hand-eye as small changes, directions across the true ones)."""
    from measureapp.calibrate.motions.axis_motion import perpendicular_basis

    truth, found = run.cell.truth.calibration, run.solution
    x = change_between(truth.hand_eye.flange_from_camera.matrix[None], found.calibration.hand_eye.flange_from_camera.matrix[None])[0]
    guide_from_board = truth.table_from_guide.inverse() @ run.cell.truth.table_from_board
    board = change_between(guide_from_board.matrix[None], found.guide_from_board.matrix[None])[0]
    state = found.state
    guide = perpendicular_basis(state.guide_direction) @ (state.guide_direction - truth.guide.direction)
    axis = perpendicular_basis(state.axis_direction) @ (state.axis_direction - truth.axis.direction)
    # the point of the true axis in the plane across the found axis through its point
    away = state.axis_point_mm - truth.axis.point_mm
    along = float(away @ state.axis_direction) / float(truth.axis.direction @ state.axis_direction)
    point = perpendicular_basis(state.axis_direction) @ (away - along * truth.axis.direction)
    values = [*x, *guide, found.calibration.guide.scale - truth.guide.scale, *axis, *point, *board]
    return dict(zip(found.parameters, map(float, values), strict=True))


def angle_deg(first: np.ndarray, second: np.ndarray) -> float:
    return float(np.rad2deg(np.linalg.norm(np.cross(first, second))))


def guide_off_deg(run: Run) -> float:
    """Return the error of the guide's direction against the board as it stood on the table, at its true angle, while the guide moved."""
    truth, found = run.cell.truth.calibration, run.solution
    table = run.solution.chain.table_group[[one.name for one in found.residuals].index(GUIDED)]
    stood = found.calibration.axis.turned(float(found.state.table_changes[table])) @ found.guide_from_board
    turned = RigidTransform.from_vector([0, 0, run.cell.turned_rad[GUIDED]], np.zeros(3), "table", "table")
    stood_truly = truth.table_from_guide.inverse() @ turned @ run.cell.truth.table_from_board
    return angle_deg(stood.inverse().rotate(found.calibration.guide.direction), stood_truly.inverse().rotate(truth.guide.direction))


def shift_of_points(true: CameraArrayCalibration, found: CameraArrayCalibration) -> np.ndarray:
    """Return true_camera_from_found_camera (4, 4) that carries points of the common field, as measured, best onto where they are."""
    points = np.array([[x, y, 550.0 + z] for x in (-140, 0, 140) for y in (-100, 0, 100) for z in (-50, 0, 50)], float)
    points = RIG.camera(RIG.reference).head_from_camera.transform("head", "camera").inverse().apply(points)
    pixels = {name: one.pinhole.project(one.reference_from_camera.inverse().apply(points)) for name, one in true.cameras.items()}
    return rigid_motion(triangulate(pixels, found), points)


def figures_of(run: Run, without_image_errors: Run) -> dict[str, float]:
    """Return the errors the figures are about.

    Axis and guide are compared in the guide frame, which only the robot reaches, and against the board, as points measured with the
    same cameras stand to them: that is what stitching needs, and neither the robot's errors nor a turn common to all that the
    cameras see are in it. Of the errors of hand-eye and guide, what stays with perfect images is what robot and rail allow; the rest is
    beyond. The lens' centre is known only together with where the camera's axis points, and then points lie right all the same: "at the
    points" is the rest without the motion that the cameras' errors make of all points before the head.
    """
    truth, found = run.cell.truth.calibration, run.solution.calibration
    true_board, seen_board = run.cell.truth.table_from_board, run.solution.guide_from_board
    board_from_guide, seen_from_guide = (truth.table_from_guide.inverse() @ true_board).inverse(), seen_board.inverse()
    true_axis, axis = board_from_guide.rotate(truth.axis.direction), seen_from_guide.rotate(found.axis.direction)
    middle = BOARD.corners_mm.mean(axis=0)
    feet = [
        point + direction * float(direction @ (middle - point))
        for point, direction in (
            (board_from_guide.apply(truth.axis.point_mm), true_axis),
            (seen_from_guide.apply(found.axis.point_mm), axis),
        )
    ]
    perfect = without_image_errors.solution.calibration
    allowed = perfect.hand_eye.flange_from_camera
    seen = shift_of_points(truth.cameras, found.cameras)
    own = change_between(truth.hand_eye.flange_from_camera.matrix[None], allowed.matrix[None])[0]
    beyond = change_between(allowed.matrix[None], found.hand_eye.flange_from_camera.matrix[None])[0]
    at_points = change_between((allowed.matrix @ seen)[None], found.hand_eye.flange_from_camera.matrix[None])[0]
    return {
        "axis direction against the board, deg": angle_deg(axis, true_axis),
        "axis place against the board, mm": float(np.linalg.norm(feet[1] - feet[0])),
        "axis direction in the guide frame, deg": angle_deg(found.axis.direction, truth.axis.direction),
        "hand-eye the robot allows, mm": float(np.linalg.norm(own[3:])),
        "hand-eye the robot allows, deg": float(np.rad2deg(np.linalg.norm(own[:3]))),
        "hand-eye beyond, mm": float(np.linalg.norm(beyond[3:])),
        "hand-eye beyond, deg": float(np.rad2deg(np.linalg.norm(beyond[:3]))),
        "hand-eye beyond at the points, mm": float(np.linalg.norm(at_points[3:])),
        "hand-eye beyond at the points, deg": float(np.rad2deg(np.linalg.norm(at_points[:3]))),
        "guide direction against the board, deg": guide_off_deg(run),
        "guide direction the rail allows, deg": guide_off_deg(without_image_errors),
        "guide direction in the base, deg": angle_deg(found.guide.direction, truth.guide.direction),
        "guide direction in the base the robot allows, deg": angle_deg(perfect.guide.direction, truth.guide.direction),
        "guide scale": abs(found.guide.scale - truth.guide.scale),
        "guide scale the slide allows": abs(perfect.guide.scale - truth.guide.scale),
    }
