"""Systematic errors shared by all views, which residuals between views do not show; their size is inferred from the form errors."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.view_errors import DIRECTION_REACH_RAD, POSE, SystematicErrors
from measureapp.register.joint.form_errors import MOST_POINTS, NEGLECTED_VARIANCE
from measureapp.register.joint.pose_sensitivity import JointSensitivity
from measureapp.register.pairs.smooth_errors import pivoted_cholesky


def estimate_systematic_errors(joint: JointSensitivity, sizes_mm: FloatArray) -> SystematicErrors:
    """Model the systematic errors of all clouds, and their effect on the poses.

    Errors of a cloud beyond noise and calibration are caused by light and blur, which depend on the orientation of the surface relative to
    the cameras. All views may share them where they see equally oriented surfaces. Pairs show little of this, as their viewpoints are
    close to each other; the systematic errors are therefore assumed as large as the form errors, and added to them (decision 14).

    Parameters
    ----------
    sizes_mm : (V,), standard deviation of each cloud's form error
    """
    normals = np.vstack([_subsample(np.asarray(cloud.normals, float)) for cloud in joint.clouds])
    directions = _subsample(normals)
    nodes = directions[pivoted_cholesky(directions, DIRECTION_REACH_RAD, NEGLECTED_VARIANCE)[0]]
    size = float(np.sqrt(np.mean(np.square(sizes_mm))))
    without_motions = SystematicErrors(nodes, size, np.zeros((POSE * len(joint.poses), len(nodes))))
    return replace(without_motions, motions=joint.propagate_cloud_errors(without_motions))


def _subsample(directions: FloatArray) -> FloatArray:
    return directions[:: max(1, -(-len(directions) // MOST_POINTS))]
