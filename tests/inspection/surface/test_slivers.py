"""Needles are cut across into pieces that add up to them, few and short enough for single precision."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.inspection.surface.slivers import LARGEST, SLENDER, split_slivers


def longest_and_height(corners: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    edges = np.roll(corners, -1, axis=1) - corners
    longest = np.linalg.norm(edges, axis=2).max(axis=1)
    return longest, np.linalg.norm(np.cross(edges[:, 0], edges[:, 1]), axis=1) / longest


def areas(corners: np.ndarray) -> np.ndarray:
    return np.asarray(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2)


def slender(count: int, foot: float, rng: np.random.Generator) -> np.ndarray:
    """Triangles up to 200 mm long and 0.02 to 2 mm high, with the foot of their height at a share of their length, turned anyhow."""
    length, height = rng.uniform(20, 200, count), rng.uniform(0.02, 2, count)
    flat = np.zeros((count, 3, 3))
    flat[:, 1, 0] = length
    flat[:, 2, 0], flat[:, 2, 1] = foot * length, height
    turn = np.linalg.qr(rng.standard_normal((count, 3, 3)))[0]
    shuffled = np.stack([flat[k, rng.permutation(3)] for k in range(count)])
    return np.asarray(shuffled @ turn + rng.uniform(-300, 300, (count, 1, 3)))


@pytest.mark.parametrize("foot", [0.0, 0.001, 0.3, 0.5, 1.0])
def test_the_pieces_of_slender_triangles_are_short_few_and_add_up(foot: float) -> None:
    whole = slender(200, foot, np.random.default_rng(3))
    pieces = split_slivers(whole)
    parts = pieces.corners_mm(whole)
    longest, height = longest_and_height(parts)
    assert ((longest**3 <= LARGEST * height**2 * (1 + 1e-6)) | (longest <= SLENDER * height)).all()
    own, of_parts = areas(whole), areas(parts)
    assert np.allclose(np.stack([np.bincount(pieces.parents, of_parts[:, k], len(whole)) for k in range(3)], axis=1), own, atol=1e-9)
    assert (np.einsum("md,md->m", of_parts, own[pieces.parents]) > 0).all()  # none lies upside down
    length, width = longest_and_height(whole)
    cuts = 6 * length / np.cbrt(LARGEST * width**2)  # the integral of the step's inverse over each needle
    tips = 2 * np.log2(length**3 / (LARGEST * width**2) + 2)
    assert (np.bincount(pieces.parents, minlength=len(whole)) <= 2 * 1.5 * cuts + 2 * tips + 4).all()


def test_stout_and_empty_triangles_stay_whole() -> None:
    stout = np.array(
        [[[0, 0, 0], [900, 0, 0], [400, 700, 0]], [[0, 0, 0], [3, 0, 0], [0, 0.5, 0]], [[0, 0, 0], [1, 1, 1], [3, 3, 3]]], float
    )
    pieces = split_slivers(stout)
    assert list(pieces.parents) == [0, 1, 2]
    assert np.array_equal(pieces.corners_mm(stout), stout)
