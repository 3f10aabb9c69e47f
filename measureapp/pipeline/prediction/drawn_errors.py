"""One error of the calibration, drawn from its covariance, and smooth errors of each view in predicted clouds.

A scan has one calibration, whose errors bend all its clouds. Bent clouds fit together less well, and registration states errors of form by how well they
fit. Points exactly on the nominal would hide this share.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.measurement import ViewResult
from measureapp.data.view_errors import POSE, CalibrationErrors
from measureapp.geometry.transform import RigidTransform
from measureapp.pipeline.assemble import camera_errors
from measureapp.pipeline.prediction.form_errors import bend
from measureapp.pipeline.prediction.rig_model import RigModel

DRAWS = 31  # of which the median is taken: a single one may bend clouds several times as much as another
POINTS = 300  # of each cloud, to compare draws
SEED = 1


def with_drawn_errors(views: Sequence[ViewResult], rig: RigModel) -> tuple[ViewResult, ...]:
    """Displace clouds and kinematic positions by a typical error of the calibration, and each cloud by a smooth error of its own."""
    return displace(views, rig, draw_error(views, rig))


def draw_error(views: Sequence[ViewResult], rig: RigModel) -> FloatArray | None:
    """Return a typical error (K,) of the calibration in its standard deviations; None without a covariance."""
    errors = None if rig.uncertainty is None else camera_errors(rig.uncertainty, views)
    return None if errors is None else _typical_draw(errors, np.concatenate([_thinned(view) for view in views]))


def displace(views: Sequence[ViewResult], rig: RigModel, drawn: FloatArray | None) -> tuple[ViewResult, ...]:
    """Displace clouds and kinematic positions by one error of the calibration, as `draw_error` returns it, and each cloud by a smooth error of its own.

    Without a covariance of the calibration, only the smooth errors remain.
    """
    bent = [bend(view, rig.form_mm) for view in views]
    errors = None if rig.uncertainty is None or drawn is None else camera_errors(rig.uncertainty, views)
    if errors is None or drawn is None:
        return tuple(bent)
    return tuple(_displaced(view, number, errors, drawn) for number, view in enumerate(bent))


def _thinned(view: ViewResult) -> FloatArray:
    points = np.asarray(view.cloud.points_mm)
    return points[:: max(1, len(points) // POINTS)]


def _typical_draw(errors: CalibrationErrors, points_mm: FloatArray) -> FloatArray:
    """Return the draw (K,) that bends points (N, 3) the median amount of `DRAWS`; rigid motions of all points bend nothing."""
    products = errors.distortion.products(points_mm)
    fields = np.stack([products @ errors.distortion.coefficients_mm[:, axis] for axis in range(3)], axis=1)  # (N, 3, K)
    arms = points_mm - points_mm.mean(axis=0)
    turns = np.stack([np.cross(axis, arms) for axis in np.eye(3)], axis=2)
    rigid = np.concatenate([np.broadcast_to(np.eye(3), (len(arms), 3, 3)), turns], axis=2).reshape(-1, POSE)
    flat = fields.reshape(len(rigid), -1)
    basis = np.linalg.qr(rigid)[0]
    bent = flat - basis @ (basis.T @ flat)
    draws = np.random.default_rng(SEED).standard_normal((DRAWS, flat.shape[1]))
    sizes = np.linalg.norm(bent @ draws.T, axis=0)
    return np.asarray(draws[np.argsort(sizes)[DRAWS // 2]])


def _displaced(view: ViewResult, number: int, errors: CalibrationErrors, drawn: FloatArray) -> ViewResult:
    points = np.asarray(view.cloud.points_mm)
    products = errors.distortion.products(points)
    moved = np.column_stack([products @ (errors.distortion.coefficients_mm[:, axis] @ drawn) for axis in range(3)])
    motion = np.asarray(errors.kinematic_motions)[POSE * number : POSE * (number + 1)] @ drawn
    change = RigidTransform.from_vector(motion[3:], motion[:3], view.part_from_camera.from_frame, view.part_from_camera.from_frame)
    return replace(view, cloud=replace(view.cloud, points_mm=points + moved), part_from_camera=view.part_from_camera @ change)
