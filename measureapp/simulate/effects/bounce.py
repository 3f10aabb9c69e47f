"""Light that reaches a surface by way of another one: scattered there, and reflected to the camera as matt or as glossy as the surface is."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import cv2
import numpy as np

from measureapp.arrays import FloatArray, IntArray

RECEIVER_STEP = 12  # pixels of the camera between two places at which second light is computed
SENDERS = 400
OFFSET_MM = 0.1
NEAREST_MM = 1.0  # keeps the light of a patch from diverging where it touches the receiver


@dataclass(frozen=True, slots=True, eq=False)
class Bounce:
    """Second light of one camera's image: a weight for every pair of receiver and sender.

    Receivers are a coarse grid of pixels, senders are patches of the lit surface, of which each is lit by one pixel of the projector.
    The weights are form factors [1]_ of patches that see each other times the albedos of both; a glossy receiver adds its lobe, which
    differs between cameras.

    References
    ----------
    .. [1] M. F. Cohen, J. R. Wallace, Radiosity and Realistic Image Synthesis, Academic Press, 1993, chapter 4.
    """

    weights: FloatArray  # (R, S) float32
    rows: IntArray  # (R,) of the coarse grid
    columns: IntArray  # (R,)
    sender_px: FloatArray  # (S, 2) column and row of the projector
    coarse: tuple[int, int]

    def light(self, pattern: FloatArray | None, lamp: float, shape: tuple[int, int]) -> FloatArray:
        """Return the second light (H, W) float32 under a pattern (h, w), or under the head lamp."""
        if pattern is None:
            strength = np.full(len(self.sender_px), lamp, np.float32)
        else:
            column, row = np.round(self.sender_px).astype(int).T
            inside = (column >= 0) & (row >= 0) & (column < pattern.shape[1]) & (row < pattern.shape[0])
            strength = np.zeros(len(column), np.float32)
            strength[inside] = pattern[row[inside], column[inside]]
        grid = np.zeros(self.coarse, np.float32)
        grid[self.rows, self.columns] = self.weights @ strength
        return np.asarray(cv2.resize(grid, shape[::-1], interpolation=cv2.INTER_LINEAR))


class Places(NamedTuple):
    """Places on a surface that a camera sees, in the scene."""

    points_mm: FloatArray  # (N, 3)
    normals: FloatArray  # (N, 3), unit, towards the camera
    to_camera: FloatArray  # (N, 3), unit
    materials: FloatArray  # (N, 3): albedo, gloss, sharpness


def bounce(
    light: FloatArray,
    places: Callable[[IntArray, IntArray], Places],
    hidden: Callable[[FloatArray], Any],
    sender_places: tuple[FloatArray, FloatArray, FloatArray, FloatArray],
    strength: float,
) -> Bounce | None:
    """Compute the second light of one camera.

    Parameters
    ----------
    light : (H, W, 4), light map of the camera
    places : what pixels see, given by rows and columns
    hidden : whether the rays (N, 6), of the length of their direction, meet the surface
    sender_places : points (S, 3), unit normals (S, 3), projector pixels (S, 2) and areas × light × albedo (S,) of the lit patches
    strength : of the second light; 1: as the albedo has it
    """
    coarse = light[RECEIVER_STEP // 2 :: RECEIVER_STEP, RECEIVER_STEP // 2 :: RECEIVER_STEP]
    rows, columns = np.nonzero(coarse[..., 3] > 0.0)
    sources, source_normals, source_px, power = sender_places
    if not len(rows) or not len(sources):
        return None
    points, normals, to_camera, materials = places(rows * RECEIVER_STEP + RECEIVER_STEP // 2, columns * RECEIVER_STEP + RECEIVER_STEP // 2)
    weights = np.zeros((len(rows), len(sources)), np.float32)
    for s in range(len(sources)):  # a column of the matrix at a time, so that the rays of one sender are cast together
        towards = sources[s] - points
        distance = np.maximum(np.linalg.norm(towards, axis=1), NEAREST_MM)
        direction = towards / distance[:, None]
        received = np.einsum("ij,ij->i", normals, direction)
        sent = -direction @ source_normals[s]
        some = np.flatnonzero((received > 0.01) & (sent > 0.01))
        if not len(some):
            continue
        start = points[some] + OFFSET_MM * normals[some]
        end = sources[s] + OFFSET_MM * source_normals[s]
        open_way = some[~hidden(np.hstack([start, end - start]).astype(np.float32))]
        solid = received[open_way] * sent[open_way] / (np.pi * distance[open_way] ** 2)
        matt, gloss = coarse[rows, columns, 3][open_way], 0.0
        if materials[open_way, 1].any():
            gloss = _lobe(normals[open_way], direction[open_way], to_camera[open_way], materials[open_way]) / np.sqrt(received[open_way])
        weights[open_way, s] = strength * np.minimum(solid * power[s], 1.0) * (matt + gloss)
    return Bounce(weights, rows, columns, source_px, coarse.shape[:2])


def _lobe(normals: FloatArray, to_light: FloatArray, to_camera: FloatArray, materials: FloatArray) -> FloatArray:
    """Blinn-Phong lobe (N,) of `part.Material` for light from unit directions (N, 3)."""
    half = to_light + to_camera
    cosine = np.einsum("ij,ij->i", normals, half) / np.maximum(np.linalg.norm(half, axis=1), 1e-9)
    return np.asarray(materials[:, 1] * np.maximum(cosine, 0.0) ** materials[:, 2])
