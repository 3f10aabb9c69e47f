"""Rotation of the cameras against each other since the calibration, from the phases of any viewpoint.

A point matched in two cameras is projected into every other camera: there its phase must be the one of the reference camera's pixel. One
combination of these differences is the point's unknown depth, and is eliminated; the rest contradicts the calibration. Of three
cameras that is one number per point, the trifocal residual (R. Hartley and A. Zisserman, Multiple View Geometry, 2nd ed., chapter 15).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import cv2
import numpy as np

from measureapp.arrays import BoolArray, FloatArray
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.camera_shift import ShiftEvidence
from measureapp.data.phase import PhaseMap
from measureapp.reconstruct.diagnosis.sample import FlatView, Samples, match_samples

SAMPLES, LEAST_SAMPLES = 700, 100  # matching them along whole epipolar lines takes most of the time; a scan has several views
SLOPE_PX = 2.0  # half the length over which the slope of the phase is taken
WHOLE = 0.999  # share of valid pixels under an interpolated phase
LARGEST_PX = 20.0  # a phase further off is another surface's
ROUNDS, WEAKEST_RAD = 3, float(np.deg2rad(1.0))  # of the rejection; the prior of its turns bounds what the phases do not determine
OUTLIER = 5.0  # robust standard deviations; beyond them a sample is a wrong match or lies beside an edge


def camera_shift(phase_maps: Mapping[str, PhaseMap], cameras: CameraArrayCalibration) -> ShiftEvidence | None:
    """Measure the evidence of one viewpoint for rotated cameras.

    The points are matched here, between the reference camera and the next one alone: a cloud has only those that all cameras
    agree on, of which a turned camera leaves few and wrong ones.

    Parameters
    ----------
    phase_maps : of the cameras that took part

    Returns
    -------
    evidence : None where the phases are not redundant (two cameras with fringes of one direction), or too few points are seen by all
    """
    names = tuple(name for name in cameras.names if name in phase_maps)
    orthogonal = {name: each for name in names if (each := phase_maps[name].orthogonal) is not None}
    both = len(orthogonal) == len(names)
    if names[0] != cameras.reference or (len(names) - 1) * (1 + both) < 2:
        return None
    samples = Samples.of(phase_maps[names[0]]).subsample(SAMPLES)
    if len(samples) < LEAST_SAMPLES:
        return None
    points, pixels = _match_points(samples, names[:2], phase_maps[names[1]], cameras)
    if len(points) < LEAST_SAMPLES:
        return None
    equations = [_equations(names, phase_maps, points, pixels, cameras)]
    if both:
        equations.append(_equations(names, orthogonal, points, pixels, cameras))
    return _evidence(names, equations)


def _match_points(
    samples: Samples, pair: tuple[str, ...], there: PhaseMap, cameras: CameraArrayCalibration
) -> tuple[FloatArray, FloatArray]:
    """Points (N, 3) in the reference camera's frame and their pixels (N, 2) as (x, y), matched with one other camera."""
    first, second = cameras.cameras[pair[0]], cameras.cameras[pair[1]]
    matches = match_samples(samples, first, second, FlatView.of(there, second))
    flat, depth = matches.flat[matches.front], 1.0 / matches.inverse_depth[matches.front]
    points = np.column_stack([flat, np.ones(len(flat))]) * depth[:, None]
    return points, samples.pixel[matches.index[matches.front]]


@dataclass(frozen=True, slots=True, eq=False)
class _Equations:
    """ρ = −(a dZ + B ω) + noise for every point, one equation for each camera but the reference, in px of that camera's image."""

    good: BoolArray  # (N,)
    own: FloatArray  # (N, n, 3): shift of each camera's image across the fringes by its own turn, px/rad
    off: list[FloatArray] = field(default_factory=list)  # ρ (N,)
    by_depth: list[FloatArray] = field(default_factory=list)  # a (N,)
    by_turn: list[FloatArray] = field(default_factory=list)  # B (N, 3 n)
    sigma: list[FloatArray] = field(default_factory=list)  # (N,), of the camera's own phase
    shared_sigma: list[FloatArray] = field(default_factory=list)  # (N,), of the reference camera's phase


def _equations(
    names: tuple[str, ...], maps: Mapping[str, PhaseMap], points_mm: FloatArray, pixels: FloatArray, cameras: CameraArrayCalibration
) -> _Equations:
    count = len(points_mm)
    reference = cameras.cameras[names[0]].pinhole
    phase, sigma, slope, good = _sample_phase(maps[names[0]], pixels)
    _, by_point = reference.project_with_jacobian(points_mm)
    made = _Equations(good, np.zeros((count, len(names), 3)))
    made.own[:, 0] = _project_across_fringes(slope, by_point @ _rotation_jacobian(points_mm))
    rays = points_mm / points_mm[:, 2:]
    for number, name in enumerate(names[1:], start=1):
        inside = cameras.cameras[name].reference_from_camera.inverse()
        local = inside.apply(points_mm)
        at, by_point = cameras.cameras[name].pinhole.project_with_jacobian(local)
        theirs, their_sigma, their_slope, good = _sample_phase(maps[name], at)
        steep = np.maximum(np.linalg.norm(their_slope, axis=1), 1e-9)
        by_turn = np.zeros((count, 3 * len(names)))
        by_turn[:, :3] = _project_across_fringes(
            their_slope, by_point @ (inside.rotation @ -_rotation_jacobian(points_mm))
        )  # the reference's turn moves the point
        by_turn[:, 3 * number : 3 * number + 3] = made.own[:, number] = _project_across_fringes(
            their_slope, by_point @ _rotation_jacobian(local)
        )
        made.good[:] &= good & (np.abs(theirs - phase) < LARGEST_PX * steep)
        made.off.append((theirs - phase) / steep)
        made.by_depth.append(_project_across_fringes(their_slope, (by_point @ (rays @ inside.rotation.T)[..., None]))[:, 0])
        made.by_turn.append(by_turn)
        made.sigma.append(their_sigma / steep)
        made.shared_sigma.append(sigma / steep)
    return made


def _sample_phase(phase_map: PhaseMap, at: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray, BoolArray]:
    """Return phase (N,), its standard deviation, its slope (N, 2) in rad/px along x and y, and where all are good, at pixels (N, 2)."""
    valid = phase_map.valid.astype(np.float32)
    good = np.ones(len(at), bool)
    read = []
    for shift in ((0.0, 0.0), (SLOPE_PX, 0.0), (-SLOPE_PX, 0.0), (0.0, SLOPE_PX), (0.0, -SLOPE_PX)):
        places = (at + shift).astype(np.float32)
        good &= _interpolate(valid, places) > WHOLE
        read.append(_interpolate(phase_map.phase_rad, places))
    slope = np.column_stack([read[1] - read[2], read[3] - read[4]]) / (2.0 * SLOPE_PX)
    return read[0], _interpolate(phase_map.sigma_rad, at.astype(np.float32)), slope, good & (np.linalg.norm(slope, axis=1) > 0)


def _interpolate(image: FloatArray, at: FloatArray) -> FloatArray:
    x, y = np.ascontiguousarray(at[:, :1]), np.ascontiguousarray(at[:, 1:])
    taken = cv2.remap(np.asarray(image, np.float32), x, y, cv2.INTER_LINEAR, borderMode=cv2.BORDER_CONSTANT, borderValue=0)
    return np.asarray(taken, np.float64)[:, 0]


def _rotation_jacobian(points_mm: FloatArray) -> FloatArray:
    """Return the derivatives (N, 3, 3) of points (N, 3) in the frame of a camera that rotates by ω: −ω × X = [X]× ω."""
    x, y, z = points_mm.T
    zero = np.zeros_like(x)
    return np.stack([np.stack([zero, -z, y], -1), np.stack([z, zero, -x], -1), np.stack([-y, x, zero], -1)], -2)


def _project_across_fringes(slope: FloatArray, motion: FloatArray) -> FloatArray:
    """Return the components (N, K) px of image motions (N, 2, K) across the fringes."""
    steep = np.maximum(np.linalg.norm(slope, axis=1, keepdims=True), 1e-9)
    return np.einsum("nj,njk->nk", slope / steep, motion)


def _evidence(names: tuple[str, ...], equations: list[_Equations]) -> ShiftEvidence | None:
    good = np.logical_and.reduce([one.good for one in equations])
    if np.count_nonzero(good) < LEAST_SAMPLES:
        return None
    off = np.stack([each[good] for one in equations for each in one.off], 1)  # (N, m)
    by_depth = np.stack([each[good] for one in equations for each in one.by_depth], 1)
    by_turn = np.stack([each[good] for one in equations for each in one.by_turn], 1)  # (N, m, 3 n)
    whitening = np.linalg.inv(np.linalg.cholesky(_covariance(equations, good)))
    off, by_depth = np.einsum("nij,nj->ni", whitening, off), np.einsum("nij,nj->ni", whitening, by_depth)
    by_turn = whitening @ by_turn
    along = by_depth / np.sum(by_depth**2, axis=1, keepdims=True)
    depth = -np.einsum("ni,nij->nj", along, by_turn)  # what a turn does to the point's depth, mm/rad
    left = -(off - by_depth * np.einsum("ni,ni->n", along, off)[:, None])
    design = by_turn + by_depth[..., None] * depth[:, None, :]
    near = _find_inliers(left, design)
    left, design, depth = left[near], design[near], depth[near].reshape(-1, len(names), 3)
    own = np.concatenate([one.own[good][near] for one in equations])
    return ShiftEvidence(
        cameras=names,
        samples=len(left),
        information=np.einsum("nik,nil->kl", design, design),
        gradient=np.einsum("nik,ni->k", design, left),
        misfit=float(np.sum(left**2)),
        freedom=left.shape[0] * (left.shape[1] - 1),
        image_px2=np.einsum("nci,ncj->cij", own, own) / len(own),
        depth_mm2=np.einsum("nci,ncj->cij", depth, depth) / len(depth),
    )


def _find_inliers(left: FloatArray, design: FloatArray) -> BoolArray:
    """Return which samples a rotation of the cameras explains; the others are wrong matches or next to an edge.

    Residuals are taken about a fit, not about zero: the samples that a turn moves most determine it best.
    """
    near = np.ones(len(left), bool)
    prior = np.eye(design.shape[2]) / WEAKEST_RAD**2
    for _ in range(ROUNDS):
        information = np.einsum("nik,nil->kl", design[near], design[near]) + prior
        turns = np.linalg.solve(information, np.einsum("nik,ni->k", design[near], left[near]))
        size = np.linalg.norm(left - design @ turns, axis=1)
        near = size <= OUTLIER * max(1.0, float(np.median(size)) / 0.6745)
    return near


def _covariance(equations: list[_Equations], good: BoolArray) -> FloatArray:
    """Covariance (N, m, m) of the equations: every camera's own phase noise, and the reference's, which is in all of its direction."""
    blocks = []
    for one in equations:
        own, shared = np.stack(one.sigma, 1)[good], np.stack(one.shared_sigma, 1)[good]
        blocks.append(own[:, :, None] ** 2 * np.eye(own.shape[1]) + shared[:, :, None] * shared[:, None, :])
    if len(blocks) == 1:
        return blocks[0]
    zero = np.zeros_like(blocks[0])
    return np.block([[blocks[0], zero], [zero, blocks[1]]])
