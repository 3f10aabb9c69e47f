"""What all clouds may err by alike, as no residual between them tells: by how large the errors of form are that residuals do tell."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.view_errors import POSE, RADIAN, CommonErrors
from measureapp.register.joint.form_errors import LEFT_OUT, MOST_POINTS
from measureapp.register.joint.pose_errors import JointInfluence
from measureapp.register.pairs.smooth_errors import pivoted


def common_errors(joint: JointInfluence, sizes_mm: FloatArray) -> CommonErrors:
    """Return the errors that all clouds have in common, and how the views follow them.

    What clouds err by beside noise and calibration, comes of light and blur, and these follow from how the surface is turned to the cameras. So
    what one cloud has, all may have where they see a surface turned alike. Of that pairs show the least, as their views see the part from nearly the same
    side; so the common errors count as large as those of form, besides them (decision 14).

    Parameters
    ----------
    sizes_mm : (V,), standard deviation of each cloud's error of form
    """
    normals = np.vstack([_some(np.asarray(cloud.normals, float)) for cloud in joint.clouds])
    directions = _some(normals)
    nodes = directions[pivoted(directions, RADIAN, LEFT_OUT)[0]]
    size = float(np.sqrt(np.mean(np.square(sizes_mm))))
    still = CommonErrors(nodes, size, np.zeros((POSE * len(joint.poses), len(nodes))))
    return replace(still, motions=joint.by_clouds(still))


def _some(directions: FloatArray) -> FloatArray:
    return directions[:: max(1, -(-len(directions) // MOST_POINTS))]
