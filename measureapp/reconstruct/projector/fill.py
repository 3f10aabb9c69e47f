"""Points of the projector where a camera has a phase that no other camera has."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from pydantic import Field

from measureapp.arrays import BoolArray, FloatArray
from measureapp.data.cloud import PointCloud
from measureapp.data.model import Model
from measureapp.reconstruct.projector.lit_camera import LitCamera

CLIPPED_AT = 5.0  # limits: a wrong fringe order must not move the mean of its surroundings
SAMPLES = 100_000


class FillSettings(Model):
    """When the projector may fill what the cameras left."""

    max_disagreement_mm: float = Field(default=0.1, ge=0, description="largest disagreement of projector and cameras, mm of depth")
    max_disagreement_sigmas: float = Field(default=1.0, ge=0, description="the same in standard deviations of a point; the larger counts")
    window_px: int = Field(default=65, ge=9, description="width of the surroundings in which both must agree")
    least_compared: int = Field(default=200, ge=1, description="points that both must have before anything is filled")


@dataclass(frozen=True, slots=True)
class ProjectorAgreement:
    """How far the projector's depths lie from those of the cameras, where both have one."""

    compared: int
    bias_mm: float  # median of projector minus cameras
    disagreement_mm: float  # median size of the mean difference in a window: free of noise, sees tilts as well
    limit_mm: float
    refused: str  # reason why nothing was filled; empty where it was


@dataclass(frozen=True, slots=True, eq=False)
class ProjectorFill:
    """Points that the projector adds to those of one camera."""

    cloud: PointCloud  # in frame ``camera``, the filled points alone, marked by PROJECTOR_BIT
    filled: BoolArray  # (H, W), the pixels that got them, in the order of the cloud
    agreement: ProjectorAgreement
    rejected: dict[str, int]  # reason -> count


def fill_with_projector(
    depth_mm: FloatArray,
    sigma_mm: FloatArray,
    lit: LitCamera,
    fillable: BoolArray | None = None,
    fill: FillSettings | None = None,
) -> ProjectorFill:
    """Give pixels that have a phase but no point of two cameras a point of camera and projector.

    Only where the projector agrees with the cameras' points around (or, far from any, with all of them); where it disagrees over the
    whole image its calibration is off, and nothing is filled. The new points are cleaned together with those that are there.

    Parameters
    ----------
    depth_mm, sigma_mm : (H, W) float32, what the cameras measured and cleaning left, on the grid of the lit camera; 0 for none
    fillable : (H, W), pixels that may be filled: without those that a camera contradicted; None for all
    fill : None for the defaults

    Raises
    ------
    ReconstructError
        The images have another size than the camera is calibrated for.
    """
    made = lit.triangulate()
    agreement, fits = _agreement(depth_mm, sigma_mm, made.depth_mm, made.sigma_mm, fill or FillSettings())
    wanted = (made.depth_mm > 0) & (depth_mm == 0)
    if fillable is not None:
        wanted &= fillable
    new = wanted & fits
    joint = np.where(new, made.depth_mm, depth_mm).astype(np.float32)
    joint_sigma = np.where(new, made.sigma_mm, sigma_mm).astype(np.float32)
    cleaned = lit.clean(joint, joint_sigma, new)
    kept = np.asarray(new & (cleaned.depth_mm > 0))
    cloud = lit.make_cloud(cleaned, joint_sigma, kept)
    rejected = made.rejected | {
        "disagreement of projector and cameras": int((wanted & ~fits).sum()),
        "cleaned away": int((new & ~kept).sum()),
    }
    return ProjectorFill(cloud, kept, agreement, rejected)


def _agreement(
    depth_mm: FloatArray, sigma_mm: FloatArray, other_mm: FloatArray, other_sigma_mm: FloatArray, fill: FillSettings
) -> tuple[ProjectorAgreement, BoolArray]:
    """Compare both depths; also where (H, W) the projector agrees."""
    both = (depth_mm > 0) & (other_mm > 0)
    compared = int(both.sum())
    if compared < fill.least_compared:
        words = f"only {compared} points of the cameras to compare the projector with"
        return ProjectorAgreement(compared, 0.0, 0.0, fill.max_disagreement_mm, words), np.zeros(both.shape, np.bool_)
    chosen = np.flatnonzero(both)[:: max(1, compared // SAMPLES)]
    difference = (other_mm - depth_mm).astype(np.float32)
    noise = np.hypot(sigma_mm.ravel()[chosen], other_sigma_mm.ravel()[chosen])
    limit = max(fill.max_disagreement_mm, fill.max_disagreement_sigmas * float(np.median(noise)))
    bias = float(np.median(difference.ravel()[chosen]))
    mean, share = _local_mean(np.clip(difference, bias - CLIPPED_AT * limit, bias + CLIPPED_AT * limit), both, fill.window_px)
    disagreement = float(np.median(np.abs(mean.ravel()[chosen])))
    refused = ""
    if max(disagreement, abs(bias)) > limit:
        refused = f"projector and cameras disagree by {max(disagreement, abs(bias)):.3f} mm, more than {limit:.3f} mm"
    near = share * fill.window_px**2 >= fill.window_px
    fits = np.zeros(both.shape, np.bool_) if refused else np.asarray(~near | (np.abs(mean) <= limit))
    return ProjectorAgreement(compared, bias, disagreement, limit, refused), fits


def _local_mean(values: FloatArray, there: BoolArray, window_px: int) -> tuple[FloatArray, FloatArray]:
    """Return the mean (H, W) of the values that are there in the window round each pixel, 0 for none, and their share of the window."""
    size = (window_px, window_px)
    total = cv2.boxFilter(np.where(there, values, np.float32(0)), cv2.CV_32F, size, borderType=cv2.BORDER_CONSTANT)
    share = cv2.boxFilter(there.astype(np.float32), cv2.CV_32F, size, borderType=cv2.BORDER_CONSTANT)
    share[share < 0.5 / window_px**2] = 0
    return np.where(share > 0, total / np.maximum(share, np.float32(1e-9)), np.float32(0)), np.asarray(share)
