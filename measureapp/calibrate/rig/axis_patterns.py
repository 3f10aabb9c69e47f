"""Patterns in which the poses of views depart from a calibration when an axis is no longer as it was calibrated."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.calibrate.motions.axis_noise import SAME_POSE, AxisNoise
from measureapp.calibrate.motions.chain import groups_of
from measureapp.calibrate.motions.chain_state import POSE
from measureapp.calibrate.motions.error_motions import MotionModel, MovedAxes, motion_model
from measureapp.calibrate.rig.stitch_uncertainty import RigUncertainty, motions_in_cameras
from measureapp.data.axis_motions import ARCSEC
from measureapp.data.fringe import AxisReadback

UNIT_MM, UNIT_RAD = 0.005, 5 * ARCSEC  # of a pattern, whose size is estimated
LEAST_TRAVEL_MM = 10.0
LEAST_TURN_RAD = 0.1


def axis_patterns(rig: RigUncertainty, readbacks: Sequence[AxisReadback]) -> dict[str, FloatArray]:
    """Return motions (6 V, K) of the cameras at V views, each in its own frame (mm, rad), by independent causes of unit size.

    "table": error motions that follow its angle, and a place of its axis that changed; "guide": those that follow its position; "robot": displacements of the camera, one at each
    pose of the robot; "views": displacements of their own. Axes that did not move have no pattern.
    """
    angles = np.array([readback.table_rad for readback in readbacks])
    slides = np.array([readback.guide_mm for readback in readbacks])
    poses = np.array([readback.base_from_flange.matrix for readback in readbacks])
    model = _unit_model(rig, slides)
    moved = MovedAxes.at(model, np.zeros(model.size), angles, slides)
    by_table, by_guide, by_camera = motions_in_cameras(rig, readbacks)
    found = {}
    if np.ptp(angles) > LEAST_TURN_RAD:
        found["table"] = np.hstack([_stack(by_table @ moved.by_table) * model.prior_sigma, _stack(by_table @ _moved_axis(model))])
    if np.ptp(slides) > LEAST_TRAVEL_MM:
        found["guide"] = _stack(by_guide @ moved.by_guide) * model.prior_sigma
    stations = groups_of(poses[:, :3].reshape(-1, 12), SAME_POSE)
    unit = by_camera * np.repeat([UNIT_MM, UNIT_RAD], 3)
    count = int(stations.max()) + 1
    if 1 < count < len(readbacks):
        found["robot"] = _own_blocks(unit, stations, count)
    found["views"] = _own_blocks(unit, np.arange(len(readbacks)), len(readbacks))
    return found


def _unit_model(rig: RigUncertainty, slides_mm: FloatArray) -> MotionModel:
    low, high = float(slides_mm.min()), float(slides_mm.max())
    noise = AxisNoise(
        table_radial_mm=UNIT_MM,
        table_axial_mm=UNIT_MM,
        table_tilt_rad=UNIT_RAD,
        slide_mm=UNIT_MM,
        slide_rad=UNIT_RAD,
        slide_from_mm=low - LEAST_TRAVEL_MM,
        slide_to_mm=high + LEAST_TRAVEL_MM,
    )
    axis = rig.calibration.axis
    model = motion_model(noise, axis, axis.point_mm, guide=True)
    assert model is not None  # its motions are not zero
    return model


def _moved_axis(model: MotionModel) -> FloatArray:
    """Return motions (6, 4) of the table top by an axis that is no longer where it was calibrated: unit tilts, and shifts across it."""
    motions = np.zeros((POSE, 4))
    motions[:3, :2], motions[3:, 2:] = UNIT_RAD * model.axes[:2].T, UNIT_MM * model.axes[:2].T
    return motions


def _stack(motions: FloatArray) -> FloatArray:
    return motions.reshape(POSE * len(motions), -1)


def _own_blocks(unit: FloatArray, groups: IntArray, count: int) -> FloatArray:
    """Return motions (6 V, 6 G) by displacements of the groups (V,) of views, by ``unit`` (V, 6, 6)."""
    blocks = np.zeros((len(unit), POSE, count, POSE))
    blocks[np.arange(len(unit)), :, groups] = unit
    return blocks.reshape(POSE * len(unit), -1)
