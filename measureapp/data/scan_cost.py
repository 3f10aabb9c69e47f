"""What the images of a scan plan cost, in time and on the disk, before any device is connected."""

from __future__ import annotations

from measureapp.data.plan import ScanPlan, Viewpoint
from measureapp.data.rig import RigDescription

READOUT_S = 0.069  # of an image of the paper's cameras; a connected camera states its own


def image_time_s(exposure_us: float, readout_s: float = READOUT_S, transfer_s: float = 0.0) -> float:
    """Return the least time from one image to the next, in s.

    The projector holds a pattern until the rolling shutters of all cameras have read their last row, so the read-out follows the
    exposure and does not run beside the next one; and images cannot follow faster than they are sent.
    """
    return max(exposure_us * 1e-6 + readout_s, transfer_s)


def viewpoint_time_s(plan: ScanPlan, viewpoint: Viewpoint, rig: RigDescription) -> float:
    """Return the least time at a viewpoint, in s: the wait for it to settle, and its images."""
    settle_s = plan.settle_of(viewpoint)
    images_s = plan.patterns.count * sum(image_time_s(exposure_us) for exposure_us in plan.exposures_of(viewpoint))
    return (rig.motion.settle_s if settle_s is None else settle_s) + images_s


def stack_bytes(plan: ScanPlan, viewpoint: Viewpoint, rig: RigDescription) -> int:
    """Return the size of the images of a viewpoint."""
    image = sum(camera.width_px * camera.height_px * (1 if camera.bit_depth == 8 else 2) for camera in rig.cameras)
    return image * plan.patterns.count * len(plan.exposures_of(viewpoint))
