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
LEAST_COSINE = 0.01  # between a normal and the way of the light
MOST_PAIRS = 1_000_000  # of receivers and senders looked at together, for their memory
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
    seen = coarse[rows, columns, 3]
    weights = np.zeros((len(rows), len(sources)), np.float32)
    together = max(1, MOST_PAIRS // len(rows))  # senders whose rays are cast at once
    for first in range(0, len(sources), together):
        some = slice(first, first + together)
        receiver, sender = _facing(points, normals, sources[some], source_normals[some])
        start = points[receiver] + OFFSET_MM * normals[receiver]
        end = (sources[some] + OFFSET_MM * source_normals[some])[sender]
        open_way = ~hidden(np.hstack([start, end - start]).astype(np.float32))
        receiver, sender = receiver[open_way], sender[open_way] + first
        towards = sources[sender] - points[receiver]
        distance = np.maximum(np.sqrt(np.einsum("ij,ij->i", towards, towards)), NEAREST_MM)
        direction = towards / distance[:, None]
        received = np.einsum("ij,ij->i", normals[receiver], direction)
        solid = -received * np.einsum("ij,ij->i", source_normals[sender], direction) / (np.pi * distance**2)
        reflected = seen[receiver]
        if materials[:, 1].any():
            lobe = _lobe(normals[receiver], direction, to_camera[receiver], materials[receiver])
            reflected = reflected + lobe / np.sqrt(received)
        weights[receiver, sender] = strength * np.minimum(solid * power[sender], 1.0) * reflected
    return Bounce(weights, rows, columns, source_px, coarse.shape[:2])


def _facing(points: FloatArray, normals: FloatArray, sources: FloatArray, source_normals: FloatArray) -> tuple[IntArray, IntArray]:
    """Return which receivers (N,) and senders (N,) face each other by more than LEAST_COSINE on both sides."""
    squares = (np.einsum("ij,ij->i", places, places) for places in (points, sources))
    distance = np.sqrt(np.maximum(np.add.outer(*squares) - 2.0 * points @ sources.T, NEAREST_MM**2))
    received = normals @ sources.T - np.einsum("ij,ij->i", normals, points)[:, None]
    sent = points @ source_normals.T - np.einsum("ij,ij->i", sources, source_normals)
    receiver, sender = np.nonzero((received > LEAST_COSINE * distance) & (sent > LEAST_COSINE * distance))
    return receiver, sender


def _lobe(normals: FloatArray, to_light: FloatArray, to_camera: FloatArray, materials: FloatArray) -> FloatArray:
    """Blinn-Phong lobe (N,) of `part.Material` for light from unit directions (N, 3)."""
    half = to_light + to_camera
    cosine = np.einsum("ij,ij->i", normals, half) / np.maximum(np.linalg.norm(half, axis=1), 1e-9)
    return np.asarray(materials[:, 1] * np.maximum(cosine, 0.0) ** materials[:, 2])
