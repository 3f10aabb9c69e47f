"""Inverse kinematics of ortho-parallel arms with a spherical wrist in closed form: eight branches per pose, limits ignored."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.geometry.kinematics.arm import JOINTS, cross_matrix
from measureapp.geometry.kinematics.ortho_parallel import OrthoParallelArm

SIGNS = np.array([1.0, -1.0])
SINGULAR = 1e-9  # sine of the wrist angle, or radius in mm, below which an angle is undetermined
ROUNDING_MM = 1e-10  # a fully stretched arm is still within reach


def all_branches(arm: OrthoParallelArm, base_from_flange: FloatArray, current_rad: FloatArray) -> FloatArray:
    """Return the joint angles of all branches for many poses at once.

    Parameters
    ----------
    base_from_flange : (N, 4, 4), mm
    current_rad : (6,); at a singularity, joint 1 or joint 4 keeps its angle

    Returns
    -------
    (N, 8, 6) float
        Shoulder, elbow and wrist change sign with halves, quarters and eighths. NaN where the arm cannot reach. Angles are not wrapped.
    """
    count = len(base_from_flange)
    rotations = base_from_flange[:, :3, :3] @ arm.base_from_flange.T
    wrist_mm = base_from_flange[:, :3, 3] + base_from_flange[:, :3, :3] @ arm.wrist_in_flange_mm
    first, radius_mm, height_mm = _turn(arm, wrist_mm, current_rad[0])
    second, third = _reach(arm, radius_mm, height_mm)
    joints = np.empty((count, 2, 2, 2, JOINTS))
    joints[..., 0] = first[:, :, None, None]
    joints[..., 1], joints[..., 2] = second[..., None], third[..., None]
    joints[..., 3:] = _wrist(arm, rotations, joints[:, :, :, 0, :3], current_rad[3])
    return joints.reshape(count, 8, JOINTS)


def _turn(arm: OrthoParallelArm, wrist_mm: FloatArray, current_rad: float) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return joint 1, the wrist centre's signed distance in front of axis 1, both (N, 2), and its height (N,)."""
    forward, across, up = ((wrist_mm - arm.origin_mm) @ arm.upright.T).T
    distance = np.hypot(forward, across)
    least = abs(arm.lateral_mm)
    within = _within(distance, least, np.inf, arm.slack_mm)
    radius = np.sqrt((within - least) * (within + least))[:, None] * SIGNS
    turn = np.arctan2(across, forward)[:, None] - np.arctan2(arm.lateral_mm, radius)
    return np.where(distance[:, None] < SINGULAR, current_rad, arm.turn_sense * turn), radius, up


def _reach(arm: OrthoParallelArm, radius_mm: FloatArray, height_mm: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return joints 2 and 3, (N, 2, 2), from the triangle of shoulder, elbow and wrist."""
    forward, up = radius_mm - arm.shoulder_mm[0], (height_mm - arm.shoulder_mm[1])[:, None]
    distance = _within(np.hypot(forward, up), *arm.reach_mm, arm.slack_mm)
    cosine = (distance**2 - arm.upper_mm**2 - arm.fore_mm**2) / (2.0 * arm.upper_mm * arm.fore_mm)
    elbow = np.arccos(np.clip(cosine, -1.0, 1.0))[..., None] * SIGNS
    inner = np.arctan2(arm.fore_mm * np.sin(elbow), arm.upper_mm + arm.fore_mm * np.cos(elbow))
    second = np.arctan2(forward, up)[..., None] - inner - arm.upper_rad
    return second, arm.elbow_sense * (elbow - (arm.fore_rad - arm.upper_rad))


def _wrist(arm: OrthoParallelArm, rotations: FloatArray, arm_joints: FloatArray, current_rad: float) -> FloatArray:
    """Return joints 4, 5, 6, (N, 2, 2, 2, 3), of ``rotations`` (N, 3, 3) after joints 1, 2, 3 (N, 2, 2, 3).

    With ``v`` the direction of axis 6 seen from the forearm, joint 5 follows from the sine and cosine of its angle to axis 4, which is exact
    also near the singularity; joint 4 from the direction of ``v`` about axis 4; joint 6 from what is then still to be turned about axis 6.
    """
    fourth, fifth, sixth = arm.wrist_axes
    side = np.cross(fifth, fourth)
    axis_1, axis_2 = arm.turn_sense * arm.upright[2], arm.upright[1]
    forearm = _about(axis_1, arm_joints[..., 0]) @ _about(axis_2, arm_joints[..., 1] + arm.elbow_sense * arm_joints[..., 2])
    turned = forearm.swapaxes(-1, -2) @ rotations[:, None, None]
    v = turned @ sixth
    sine, cosine = np.linalg.norm(v @ cross_matrix(fourth), axis=-1), v @ fourth
    angle = np.arctan2(sine, cosine)[..., None] * SIGNS
    joint_5 = angle - arm.wrist_rad
    joint_4 = np.arctan2((v @ fifth)[..., None] * SIGNS, (v @ side)[..., None] * SIGNS)
    joint_4 = np.where(sine[..., None] < SINGULAR, current_rad, joint_4)
    rest = _about(fifth, -joint_5) @ _about(fourth, -joint_4) @ (turned @ fifth)[..., None, :, None]
    joint_6 = np.arctan2(rest[..., 0] @ np.cross(sixth, fifth), rest[..., 0] @ fifth)
    return np.stack([joint_4, joint_5, joint_6], axis=-1)


def _within(distances_mm: FloatArray, least_mm: float, greatest_mm: float, slack_mm: float) -> FloatArray:
    """Return distances clipped to a range; NaN if they are outside by more than the slack and rounding."""
    outside_mm = np.maximum(least_mm - distances_mm, distances_mm - greatest_mm)
    return np.where(outside_mm > slack_mm + ROUNDING_MM, np.nan, np.clip(distances_mm, least_mm, greatest_mm))


def _about(axis: FloatArray, angles_rad: FloatArray) -> FloatArray:
    """Return rotations (..., 3, 3) about one axis by Rodrigues' formula."""
    cross = cross_matrix(axis)
    angles = angles_rad[..., None, None]
    return np.eye(3) + np.sin(angles) * cross + (1.0 - np.cos(angles)) * (cross @ cross)
