"""Detection of mistakes that decode smoothly: wrong shift sign, exchanged or rotated images, a camera that has moved."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from itertools import permutations
from typing import Literal

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration, ProjectorCalibration
from measureapp.data.phase import PhaseMap
from measureapp.errors import ReconstructError
from measureapp.reconstruct.diagnosis.sample import FlatView, Samples, match_samples
from measureapp.reconstruct.diagnosis.witness import (
    Residuals,
    compare_with_projector,
    correlate_contrast,
    extract_contrast,
    observe_with_camera,
)
from measureapp.reconstruct.projector.depth import triangulate_with_projector
from measureapp.reconstruct.projector.state import ProjectorState

Kind = Literal[
    "wrong-sign", "phase-runs-backwards", "fringe-direction", "turned-image", "swapped-cameras", "unrelated-cameras", "moved-camera",
    "projector-off", "wrong-pitch",
]  # fmt: skip
CLEARLY = 0.8  # share of the samples that must agree
BACKWARDS = np.cos(np.radians(135))
SIMILAR, MORE_SIMILAR = 0.4, 0.25  # least cosine or correlation of equal directions or textures; a clear difference of correlations
LEAST_MATCHES = 50
LEAST_MATCHED, POOR_MATCHED = 0.2, 0.3  # shares of samples: of an order that is named; below which other orders are tried
CLEARLY_MORE, CLEARLY_NEARER = 2.5, 4.0  # how much better another order must match, or its witness agree
LEAST_MISFIT_PX = 0.05  # what the sampling of this check leaves
FAITHFUL_PX = 3.0
UNRELATED_SHARE = 0.03  # of the image's width
MOVED_PX = 0.25  # what a good calibration leaves
MOVED_SIGMAS = 3.0
SCALE_OFF = 0.01
LEAST_PROJECTOR_SHARE = 0.5


@dataclass(frozen=True, slots=True)
class Finding:
    """An error or a suspicious property of a measurement, and its remedy."""

    kind: Kind
    severity: Literal["error", "warning"]  # error: points would be wrong
    message: str
    remedy: str
    figures: Mapping[str, float] = field(default_factory=dict)

    def error(self) -> ReconstructError:
        """Return it as an exception."""
        return ReconstructError(self.message, self.remedy)


@dataclass(frozen=True, slots=True, eq=False)
class Agreement:
    """How well images in some order fit a calibration."""

    matched: float  # share of the samples of the first camera that have a match in the second one, in front of both
    samples: int
    misfit_px: float | None  # residual beyond noise of a witness: a third camera, orthogonal fringes or the projector; None without one
    along: Residuals | None = None  # of a third camera along, or of the second one orthogonal to the epipolar lines
    correlation: float | None = None  # correlation of the fine contrast of both images, where there is no witness

    def is_clearly_better_than(self, other: Agreement) -> bool:
        """Whether it matches as much and its witness agrees far better, or matches far more and no witness objects."""
        if self.matched < max(LEAST_MATCHED, other.matched / CLEARLY_MORE):
            return False
        if self.misfit_px is not None and other.misfit_px is not None:
            return max(self.misfit_px, LEAST_MISFIT_PX) * CLEARLY_NEARER < other.misfit_px
        if (
            self.correlation is not None
            and other.correlation is not None
            and self.correlation > max(SIMILAR, other.correlation + MORE_SIMILAR)
        ):
            return True
        return self.matched > CLEARLY_MORE * other.matched and (self.misfit_px or 0.0) < FAITHFUL_PX


def diagnose(phase_maps: Mapping[str, PhaseMap], cameras: CameraArrayCalibration) -> tuple[Finding, ...]:
    """Search for mistakes with a few thousand pixels per camera; takes some tenths of a second.

    What is detected depends on the data. Exchanged images of two converging cameras, for instance, still give
    a surface in front of them (inverted in depth). A third camera, horizontal fringes or a calibrated projector reveal it, or at least
    the texture of the part, whose contrast is then not correlated.

    Parameters
    ----------
    phase_maps : of the vertical fringes, one per camera; all must be of the calibration's sizes

    Returns
    -------
    findings : the errors first; empty for a measurement that fits its calibration
    """
    names = tuple(name for name in cameras.names if name in phase_maps)
    samples = {name: Samples.of(phase_maps[name]) for name in names}
    names = tuple(name for name in names if len(samples[name]) >= LEAST_MATCHES)
    if not names:
        return ()
    maps = {name: phase_maps[name] for name in names}
    directions = list(_check_directions(maps, samples, cameras))
    reversed_phase = any(finding.severity == "error" for finding in directions)
    if any(finding.kind == "wrong-sign" for finding in directions):
        return tuple(directions)
    # A projector that contradicts the images of all cameras does not show which of them are exchanged.
    checks = replace(cameras, projector=None) if reversed_phase else cameras
    orders = list(_check_order(maps, checks)) if len(names) > 1 else []
    if any(finding.kind == "swapped-cameras" for finding in orders):
        return tuple(orders)
    if reversed_phase:
        return tuple(directions)
    projector = [] if cameras.projector is None else list(_check_projector(maps, samples, cameras, cameras.projector))
    return tuple(sorted([*directions, *orders, *projector], key=lambda finding: finding.severity != "error"))


# ---- The direction of the phase


def _check_directions(maps: Mapping[str, PhaseMap], samples: Mapping[str, Samples], cameras: CameraArrayCalibration) -> Iterator[Finding]:
    """With a calibrated projector the direction of the phase in every image is known; without, only that it is common to all cameras."""
    if cameras.projector is not None:
        cosines = {name: _cosine_to_projector(samples[name], cameras.cameras[name], cameras.projector) for name in maps}
        yield from _check_against_projector(cosines)
        return
    ways = {name: _mean_direction(samples[name], cameras.cameras[name]) for name in maps}
    middle = np.sum(list(ways.values()), axis=0)
    against = [name for name, way in ways.items() if float(way @ middle) < 0]
    if against or any(float(one @ other) < -SIMILAR for one in ways.values() for other in ways.values()):
        named = " and ".join(against or ways)
        yield Finding(
            "turned-image",
            "error",
            f"The phase of {named} increases in the opposite direction to that of the other cameras.",
            f"Check whether the images of {named} are rotated by 180° or mirrored, and whether the calibration belongs to them.",
        )
    elif float(middle[0]) < BACKWARDS * float(np.linalg.norm(middle)):
        yield Finding(
            "phase-runs-backwards",
            "warning",
            f"The phase decreases from left to right in the images of {', '.join(maps)}.",
            "Either shift_sign is wrong, or the projector (or the reference camera) is mounted upside down. Change shift_sign, or calibrate the "
            "projector: its calibration distinguishes the two.",
        )


def _cosine_to_projector(samples: Samples, camera: CameraCalibration, projector: ProjectorCalibration) -> FloatArray:
    """Return the cosine (N,) between every phase gradient and that of the projector's column on a plane facing the camera."""
    projector_from_camera = projector.reference_from_projector.inverse() @ camera.reference_from_camera
    focal = float(camera.pinhole.matrix[0, 0])
    flat = camera.pinhole.normalise(samples.pixel)
    depth = _meeting_depth(projector_from_camera.inverse().rotation[:, 2], projector_from_camera.inverse().translation_mm)
    columns = [
        projector.pinhole.project(projector_from_camera.apply(np.column_stack([flat + step, np.ones(len(flat))]) * depth))[:, 0]
        for step in ([0.0, 0.0], [1 / focal, 0.0], [0.0, 1 / focal])
    ]
    expected = np.column_stack([columns[1] - columns[0], columns[2] - columns[0]])
    lengths = np.linalg.norm(expected, axis=1) * np.linalg.norm(samples.gradient, axis=1)
    return np.asarray((expected * samples.gradient).sum(axis=1) / np.maximum(lengths, 1e-30))


def _meeting_depth(axis: FloatArray, centre_mm: FloatArray) -> float:
    """Return the depth in the camera's frame at which its optical axis comes nearest to the projector's; for parallel ones 3 baselines."""
    baseline = max(float(np.linalg.norm(centre_mm)), 1.0)
    sine = 1 - axis[2] ** 2
    depth = float(centre_mm[2] - axis[2] * (axis @ centre_mm)) / sine if sine > 1e-4 else 0.0
    return depth if baseline / 4 < depth < 100 * baseline else 3 * baseline


def _check_against_projector(cosines: Mapping[str, FloatArray]) -> Iterator[Finding]:
    against = [name for name, cosine in cosines.items() if (cosine < -SIMILAR).mean() > CLEARLY]
    if len(against) == len(cosines):
        yield Finding(
            "wrong-sign",
            "error",
            f"The phase of {', '.join(against)} increases against the columns of the calibrated projector.",
            "Change the sign of shift_sign, reverse the order of the phase-shifted images, or check whether the projector is mounted upside down.",
            {name: float(np.median(cosine)) for name, cosine in cosines.items()},
        )
    elif against:
        named = " and ".join(against)
        yield Finding(
            "turned-image",
            "error",
            f"The phase of {named} increases in the opposite direction to that of the other cameras and the projector.",
            f"Check whether the images of {named} are rotated by 180° or mirrored, and whether the calibration belongs to them.",
        )
    orthogonal = [name for name, cosine in cosines.items() if (np.abs(cosine) < SIMILAR).mean() > CLEARLY]
    if orthogonal:
        yield Finding(
            "fringe-direction",
            "error",
            f"The fringes in the images of {', '.join(orthogonal)} are orthogonal to those of the calibrated projector.",
            "Check the fringe direction of the pattern set, and whether images are rotated by 90°.",
        )


def _mean_direction(samples: Samples, camera: CameraCalibration) -> FloatArray:
    """Return the mean direction (3,) in which the phase grows, seen from the reference camera."""
    ways = samples.gradient / np.maximum(np.linalg.norm(samples.gradient, axis=1, keepdims=True), 1e-30)
    mean = ways.mean(axis=0)
    way = camera.reference_from_camera.rotation @ np.array([mean[0], mean[1], 0.0])
    return np.asarray(way / max(float(np.linalg.norm(way)), 1e-30))


# ---- The order of the cameras, and whether they have moved since the calibration


def _check_order(maps: Mapping[str, PhaseMap], cameras: CameraArrayCalibration) -> Iterator[Finding]:
    """Compare the order of the images with all others where it does not fit; one that fits clearly better is named."""
    names = tuple(maps)
    given = _evaluate_order(names, names, maps, cameras)
    poor = given.matched < POOR_MATCHED or (given.misfit_px or 0.0) > MOVED_PX or given.correlation is not None
    others = {order: _evaluate_order(names, order, maps, cameras) for order in _other_orders(names, maps)} if poor else {}
    better = {order: other for order, other in others.items() if other.is_clearly_better_than(given)}
    if better:
        yield _report_exchange(names, min(better, key=lambda order: (better[order].misfit_px or 0.0, -better[order].matched)), given)
    elif given.matched * given.samples < LEAST_MATCHES:
        yield Finding(
            "unrelated-cameras",
            "error",
            f"Only {given.matched:.0%} of the phases of {names[0]} have a match on their epipolar line in {names[1]}, in front of both cameras.",
            "Check that the calibration belongs to these images, and that the cameras see the same part.",
            {"matched": given.matched},
        )
    elif given.along is not None and given.along.beyond_noise_px > UNRELATED_SHARE * maps[names[0]].phase_rad.shape[1]:
        px = given.along.beyond_noise_px
        yield Finding(
            "unrelated-cameras",
            "error",
            f"The images of {', '.join(names)} contradict the calibration: matched points have phase residuals of {px:.0f} px.",
            "Check that the calibration belongs to these images and their order.",
            {"px": px},
        )
    elif given.along is not None:
        yield from _report_movement(names, given.along, len(names) > 2)


def _report_exchange(names: tuple[str, ...], order: tuple[str, ...], given: Agreement) -> Finding:
    moved = [(name, other) for name, other in zip(names, order, strict=True) if name != other]
    return Finding(
        "swapped-cameras",
        "error",
        f"The images of {' and '.join(name for name, _ in moved)} appear to be exchanged.",
        "Exchange them, for instance in the manifest: " + ", ".join(f"{name} ← {other}" for name, other in moved) + ".",
        {"matched": given.matched, "px": given.misfit_px or 0.0},
    )


def _other_orders(names: tuple[str, ...], maps: Mapping[str, PhaseMap]) -> list[tuple[str, ...]]:
    """Return the other orders of the images that their sizes allow."""
    shapes = [maps[name].phase_rad.shape for name in names]
    return [order for order in permutations(names) if order != names and [maps[name].phase_rad.shape for name in order] == shapes]


def _evaluate_order(
    names: tuple[str, ...], order: tuple[str, ...], maps: Mapping[str, PhaseMap], cameras: CameraArrayCalibration
) -> Agreement:
    """Give the i-th calibrated camera the images of the i-th camera of ``order``; match the first two and check the matches independently."""
    devices = [cameras.cameras[name] for name in names]
    images = [maps[name] for name in order]
    samples = Samples.of(images[0])
    matches = match_samples(samples, devices[0], devices[1], FlatView.of(images[1], devices[1]))
    matched = float(matches.front.sum()) / max(len(samples), 1)
    if matches.front.sum() < LEAST_MATCHES:
        return Agreement(matched, len(samples), None)
    along = None
    if len(names) > 2:
        along = observe_with_camera(matches, samples, devices[0], devices[2], FlatView.of(images[2], devices[2]))
    elif images[0].orthogonal is not None and images[1].orthogonal is not None:
        rows, view = samples.orthogonal(images[0].orthogonal), FlatView.of(images[1].orthogonal, devices[1])
        along = observe_with_camera(matches, rows, devices[0], devices[1], view, orthogonal=True)
    if along is not None and len(along.px) >= LEAST_MATCHES:
        return Agreement(matched, len(samples), along.beyond_noise_px, along)
    if cameras.projector is None:
        correlation = correlate_contrast(
            matches, samples, devices[0], devices[1], (extract_contrast(images[0]), extract_contrast(images[1]))
        )
        return Agreement(matched, len(samples), None, correlation=correlation)
    seen, _ = compare_with_projector(matches, samples, devices[0], cameras.projector, images[0])
    return Agreement(matched, len(samples), seen.beyond_noise_px if len(seen.px) >= LEAST_MATCHES else None)


def _report_movement(names: tuple[str, ...], residuals: Residuals, third: bool) -> Iterator[Finding]:
    """Report residuals beyond phase noise and the errors of a good calibration."""
    beyond, noise = residuals.systematic_px()
    if beyond < max(MOVED_PX, MOVED_SIGMAS * noise):
        return
    depth_mm = beyond * float(np.median(residuals.depth_per_px))
    observed = f"Points of {names[0]} and {names[1]} in {names[2]}" if third else f"Orthogonal fringes of {names[0]} in {names[1]}"
    yield Finding(
        "moved-camera",
        "warning",
        f"{observed} have a systematic residual of {beyond:.2f} px, about {depth_mm:.3f} mm of depth; phase noise explains {noise:.2f} px.",
        f"One of {', '.join(names)} has moved since its calibration: check the mountings and calibrate again.",
        {"px": beyond, "mm": depth_mm, "noise_px": noise},
    )


# ---- The projector


def _check_projector(
    maps: Mapping[str, PhaseMap], samples: Mapping[str, Samples], cameras: CameraArrayCalibration, projector: ProjectorCalibration
) -> Iterator[Finding]:
    names = tuple(maps)
    columns = projector.pinhole.width_px
    seen = {name: float(np.percentile(_projector_columns(samples[name], maps[name]), 99)) for name in names}
    if max(seen.values()) > (1 + SCALE_OFF) * columns:
        yield Finding(
            "wrong-pitch",
            "error",
            f"The phases reach projector column {max(seen.values()):.0f}, but the calibrated projector has {columns} columns.",
            "Check the pitches of the pattern set, and that the calibration belongs to this projector and its resolution.",
        )
        return
    if len(names) == 1:
        yield from _check_single_camera(names[0], maps[names[0]], cameras, projector)
        return
    here, there = (cameras.cameras[name] for name in names[:2])
    matches = match_samples(samples[names[0]], here, there, FlatView.of(maps[names[1]], there))
    if matches.front.sum() < LEAST_MATCHES:
        return
    residuals, both = compare_with_projector(matches, samples[names[0]], here, projector, maps[names[0]])
    if len(residuals.px) < LEAST_MATCHES:
        return
    slope, _ = np.polyfit(both[:, 0], both[:, 1], 1)
    off = float(np.median(both[:, 0] - both[:, 1]))
    spread, noise = residuals.systematic_px()
    if abs(slope - 1) > SCALE_OFF:
        yield Finding(
            "wrong-pitch",
            "warning",
            f"The projector columns of the phases are {slope:.3f} times those of the calibrated projector.",
            "Check the pitches and projector_px of the pattern set, or calibrate the projector again.",
            {"scale": float(slope), "columns": off},
        )
    elif spread > FAITHFUL_PX + MOVED_SIGMAS * noise:
        yield Finding(
            "projector-off",
            "warning",
            f"The calibrated projector deviates by {off:+.1f} columns from the points of two cameras.",
            "The projector or a camera has moved: calibrate the projector again, and do not use its points until then.",
            {"columns": off, "px": spread},
        )


def _projector_columns(samples: Samples, phase_map: PhaseMap) -> FloatArray:
    scale, offset = phase_map.pixel_of_phase()
    return samples.phase * scale + offset


def _check_single_camera(
    name: str, phase_map: PhaseMap, cameras: CameraArrayCalibration, projector: ProjectorCalibration
) -> Iterator[Finding]:
    """With a single camera nearly all phases must intersect their column in front of it and inside the projector's image."""
    made = triangulate_with_projector(replace(phase_map, orthogonal=None), cameras.cameras[name], projector)
    seen = max(int((made.state != ProjectorState.NO_PHASE).sum()), 1)
    share = float((made.state == ProjectorState.POINT).sum()) / seen
    parallel = float((made.state == ProjectorState.PARALLEL).sum()) / seen
    if share + parallel < LEAST_PROJECTOR_SHARE:
        yield Finding(
            "projector-off",
            "error",
            f"Only {share:.0%} of the phases of {name} intersect their projector column in front of the camera.",
            "Check shift_sign and the pitches, and that the calibration belongs to this camera and projector.",
            {"share": share},
        )
