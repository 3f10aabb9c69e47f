"""A part of planes, cylinders and a sphere, measured in four views whose errors are drawn from the model that is stated with them."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from measureapp.data.dimension import Dimension
from measureapp.data.inspection_program import InspectionProgram
from measureapp.data.view_errors import POWERS, CloudDistortion, FormErrors, SystematicErrors, ViewErrors
from measureapp.geometry.transform import RigidTransform
from measureapp.inspection.dimensions import inspect
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.settings import InspectionSettings, UncertaintySettings

VIEWS = 4
NOISE_MM, SHIFT_MM, TURN_RAD, SCALE = 0.01, 0.004, 3e-5, 3e-5
SCALE_PPM = 200.0
COMMON_MM, COMMON_RAD = 0.2, 1e-3  # of all views together: no dimension shows it


def plane(name: str, point: list[float], direction: list[float]) -> dict[str, object]:
    return {"name": name, "shape": "plane", "point_mm": point, "direction": direction, "cut": {"band_mm": 3}}


FEATURES = [
    plane("right", [0, 40, 0], [0, 1, 0]),
    plane("left", [0, -40, 0], [0, -1, 0]),
    plane("top", [0, 0, 60], [0, 0, 1]),
    {"name": "pin", "shape": "cylinder", "point_mm": [80, 0, 0], "direction": [0, 0, 1], "radius_mm": 15, "cut": {"band_mm": 3}},
    {"name": "small pin", "shape": "cylinder", "point_mm": [-80, 0, 0], "direction": [0, 0, 1], "radius_mm": 4, "cut": {"band_mm": 2}},
    {"name": "ball", "shape": "sphere", "point_mm": [0, 0, 120], "radius_mm": 20, "cut": {"band_mm": 3}},
    {"name": "spot", "shape": "surface_point", "point_mm": [5, 40, 3], "direction": [0, 1, 0], "patch_mm": 12, "cut": {"band_mm": 3}},
    {"name": "back", "shape": "surface_point", "point_mm": [5, -40, 3], "direction": [0, -1, 0], "patch_mm": 12, "cut": {"band_mm": 3}},
    {"name": "middle", "shape": "midplane", "of": ["right", "left"]},
    {"name": "foot", "shape": "intersection", "of": ["pin", "top"]},
]
DIMENSIONS = [
    {"name": "width", "kind": "distance", "features": ["right", "left"], "nominal": 80},
    {"name": "half width", "kind": "distance", "features": ["right", "middle"], "nominal": 40},
    {"name": "corner", "kind": "angle", "features": ["right", "top"], "nominal": 90},
    {"name": "pin diameter", "kind": "diameter", "features": ["pin"], "nominal": 30},
    {"name": "small radius", "kind": "radius", "features": ["small pin"], "nominal": 4},
    {"name": "pins", "kind": "distance", "features": ["pin", "small pin"], "nominal": 160},
    {"name": "ball diameter", "kind": "diameter", "features": ["ball"], "nominal": 40},
    {"name": "ball over top", "kind": "distance", "features": ["ball", "top"], "nominal": 60},
    {"name": "wall", "kind": "thickness", "features": ["spot", "back"], "nominal": 80},
    {"name": "foot to wall", "kind": "distance", "features": ["foot", "right"], "nominal": 40},
]
PROGRAM = InspectionProgram.model_validate({"name": "test", "alignment": "none", "features": FEATURES, "dimensions": DIMENSIONS})


@dataclass(frozen=True)
class Drawn:
    """Points without error, which view measured each, and how views and calibration err."""

    exact: MeasuredPoints

    def measured(self, rng: np.random.Generator) -> MeasuredPoints:
        errors, points, view = self.exact.errors, self.exact.points_mm, self.exact.view
        assert errors is not None and view is not None and self.exact.normals is not None
        chosen = [rng.standard_normal(columns.shape[1]) for columns in (errors.stitching_motions, errors.calibration_motions)]
        moved, normals = np.zeros_like(points), np.asarray(self.exact.normals, float)
        for axis, direction in enumerate(np.eye(3)):
            along = errors.along(points, np.tile(direction, (len(points), 1)), view)
            moved[:, axis] = along["stitching"] @ chosen[0] + along["calibration"] @ chosen[1]
        out = NOISE_MM * rng.standard_normal(len(points))
        for share, columns in errors.along(points, normals, view).items():
            if share in ("form", "common"):
                out += columns @ rng.standard_normal(columns.shape[1])
        if errors.scale:
            points = points * (1 + errors.scale * rng.standard_normal())
        return replace(self.exact, points_mm=points + moved + out[:, None] * normals)


def surfaces(rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    u, v = rng.uniform(-25, 25, (2, 300))
    flat = np.zeros(300)
    turn, height = rng.uniform(0, 2 * np.pi, 300), rng.uniform(-20, 20, 300)
    round_ = np.column_stack([np.cos(turn), np.sin(turn), flat])
    ball = rng.standard_normal((300, 3))
    ball /= np.linalg.norm(ball, axis=1, keepdims=True)
    parts = [
        (np.column_stack([u, flat + 40, v]), [0, 1, 0]),
        (np.column_stack([u, flat - 40, v]), [0, -1, 0]),
        (np.column_stack([u, v, flat + 60]), [0, 0, 1]),
        (15 * round_ + np.column_stack([flat + 80, flat, height]), round_),
        (4 * round_ + np.column_stack([flat - 80, flat, height]), round_),
        (20 * ball + [0, 0, 120], ball),
    ]
    return np.vstack([points for points, _ in parts]), np.vstack([np.broadcast_to(normal, (300, 3)) for _, normal in parts])


def errors_of(rng: np.random.Generator, own: float = 1.0) -> ViewErrors:
    poses = tuple(RigidTransform.from_vector(rng.normal(size=3), rng.normal(0, 400, 3), "part", "camera") for _ in range(VIEWS))
    centres = rng.uniform(-40, 40, (VIEWS, 3))
    common = np.zeros((6 * VIEWS, 6))
    for number, centre in enumerate(centres):
        block = common[6 * number : 6 * number + 6]
        block[:3, :3], block[3:, 3:] = COMMON_MM * np.eye(3), COMMON_RAD * np.eye(3)
        block[:3, 3:] = COMMON_RAD * np.cross(np.eye(3), centre).T  # about the origin
    rows = rng.normal(size=(6 * VIEWS, 6 * VIEWS))  # correlated among views
    sizes = own * np.tile([SHIFT_MM] * 3 + [TURN_RAD] * 3, VIEWS)
    mixed = sizes[:, None] * rows / np.linalg.norm(rows, axis=1, keepdims=True)
    grown = np.zeros((len(POWERS), 3, 1))
    for axis, power in enumerate(((1, 0, 0), (0, 1, 0), (0, 0, 1))):
        grown[POWERS.index(power), axis, 0] = SCALE * own * 100.0
    held = np.zeros((6 * VIEWS, 1))  # the poses follow the scale so that the middle of the part stays in its place
    for number, pose in enumerate(poses):
        held[6 * number : 6 * number + 3, 0] = SCALE * own * pose.translation_mm
    return ViewErrors(poses, centres, np.hstack([common, mixed]), held, CloudDistortion(np.zeros(3), np.full(3, 100.0), grown))


def drawn(own: float = 1.0) -> Drawn:
    rng = np.random.default_rng(8)
    points, normals = surfaces(rng)
    faced = np.arctan2(normals[:, 1], normals[:, 0]) / (2 * np.pi) * VIEWS
    view = np.floor(faced + np.arange(len(points)) % 2 + 0.5).astype(int) % VIEWS  # two views see each place
    return Drawn(MeasuredPoints(points, normals, np.full(len(points), NOISE_MM), view, errors_of(rng, own)))


def with_form(made: Drawn) -> Drawn:
    """Add errors of form as large as those by the poses, that change over less than the part."""
    points, view = made.exact.points_mm, made.exact.view
    assert made.exact.errors is not None and view is not None
    nodes = [points[view == number][::60] for number in range(VIEWS)]
    of = np.repeat(np.arange(VIEWS), [len(each) for each in nodes])
    motions = np.random.default_rng(2).normal(size=(6 * VIEWS, len(of))) * np.tile([SHIFT_MM / 9] * 3 + [TURN_RAD / 9] * 3, VIEWS)[:, None]
    form = FormErrors(np.vstack(nodes), of, np.full(VIEWS, SHIFT_MM), np.full(VIEWS, 30.0), motions)
    return Drawn(replace(made.exact, errors=replace(made.exact.errors, form=form)))


def with_common(made: Drawn) -> Drawn:
    """Add errors that all views have in common, as large as those by the poses."""
    assert made.exact.errors is not None
    nodes = np.random.default_rng(3).normal(size=(12, 3))
    nodes /= np.linalg.norm(nodes, axis=1, keepdims=True)
    motions = np.random.default_rng(4).normal(size=(6 * VIEWS, 12)) * np.tile([SHIFT_MM / 4] * 3 + [TURN_RAD / 4] * 3, VIEWS)[:, None]
    return Drawn(replace(made.exact, errors=replace(made.exact.errors, systematic=SystematicErrors(nodes, SHIFT_MM, motions))))


def with_scale(made: Drawn) -> Drawn:
    """Add a scale of everything that errs more than all else together over 100 mm."""
    assert made.exact.errors is not None
    return Drawn(replace(made.exact, errors=replace(made.exact.errors, scale=SCALE_PPM * 1e-6)))


def inspected(points: MeasuredPoints) -> tuple[Dimension, ...]:
    scale_ppm = 0.0 if points.errors is None else points.errors.scale * 1e6
    return inspect(points, PROGRAM, settings=InspectionSettings(uncertainty=UncertaintySettings(scale_ppm=scale_ppm))).dimensions
