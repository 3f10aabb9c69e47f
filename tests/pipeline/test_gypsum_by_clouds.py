"""The gypsum part on the rig of the paper, calibrated and scanned without images: its dimensions do not follow the robot's errors."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from measureapp.arrays import FloatArray
from measureapp.data.cloud import StitchedCloud
from measureapp.geometry.transform import RigidTransform
from tests.pipeline.scanned_clouds import scanned_part
from tests.register.test_stitch import best_fit

SEEDS = range(1, 21)
STEP_MM, NOISE_MM = 0.8, 0.02
FACES = {"a": (0, 90.0), "b": (1, 70.0), "c": (1, 30.0)}  # axis of the drawing, and how far the two faces lie from it


def errors_mm(truth: list[RigidTransform], poses: list[RigidTransform], clouds) -> FloatArray:
    """Return by how much a, b and c are too long by poses alone."""
    samples = [np.asarray(cloud.points_mm)[::3] for cloud in clouds]
    true = np.vstack([pose.apply(sample) for pose, sample in zip(truth, samples, strict=True)])
    placed = np.vstack([pose.apply(sample) for pose, sample in zip(poses, samples, strict=True)])
    off = best_fit(placed, true).apply(placed) - true
    on_walls = (true[:, 2] > 3) & (true[:, 2] < 47)
    return np.array(
        [
            sum(sign * off[on_walls & (np.abs(sign * true[:, axis] - half) < 0.3), axis].mean() for sign in (1, -1))
            for axis, half in FACES.values()
        ]
    )


def scanned(seed: int) -> tuple[FloatArray, FloatArray, StitchedCloud]:
    """Return the errors of a, b and c by the axes and stitched, and what was stitched."""
    made = scanned_part(seed, "gypsum", step_mm=STEP_MM, noise_mm=NOISE_MM, camera_errors=False, camera_prior_used=False)
    placed = [placement.part_from_camera for placement in made.stitched.placements]
    return errors_mm(made.truth, made.kinematic, made.clouds), errors_mm(made.truth, placed, made.clouds), made.stitched


@pytest.mark.slow
def test_dimensions_do_not_follow_the_robots_errors(record_property: Callable[[str, object], None]) -> None:
    by_axes, stitched, parts = zip(*(scanned(seed) for seed in SEEDS), strict=True)
    for seed, before, after in zip(SEEDS, by_axes, stitched, strict=True):
        record_property(f"seed {seed}, a, b and c in mm: by the axes and stitched", (before.tolist(), after.tolist()))
    assert np.sqrt(np.mean(np.square(by_axes))) > 0.010  # the robot repeats within 0.02 mm at 0.6 m from the part
    # of a face against the opposite one, by the noise and the errors that the pairs show
    sigma = np.sqrt(2) * max(placement.sigma_mm for part in parts for placement in part.placements)
    assert sigma < 0.010
    assert np.abs(stitched).max() < 3 * sigma
    assert np.sqrt(np.mean(np.square(stitched))) < np.sqrt(np.mean(np.square(by_axes))) / 3
    for part in parts:
        assert part.loop_closure is not None
        assert part.loop_closure.gap_mm < 3 * part.loop_closure.sigma_mm and part.loop_closure.sigma_mm < 0.0125
