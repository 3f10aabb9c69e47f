"""Light that reaches a surface by way of another one: scattered there, and reflected to the camera as matt or as glossy as the surface is.

What matt surfaces scatter is the same for all cameras, so it is computed once, where the projector lights the surface: its image is divided into
cells, each of which sends light and receives it. Only the shadows of the projector need places of their own in every camera.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import cv2
import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray

MOST_CELLS = 2500
SHADOW_PLACES = 54  # over the width of a camera's image
OFFSET_MM = 0.1
LEAST_COSINE = 0.01  # between a normal and the way of the light
REMAPPED = 1024  # places in a row
MOST_PAIRS = 1_000_000  # of receivers and senders looked at together, for their memory

Hidden = Callable[[FloatArray], Any]  # whether rays (N, 6), of the length of their direction, meet the surface


class Places(NamedTuple):
    """Places on a surface, in the scene."""

    points_mm: FloatArray  # (N, 3)
    normals: FloatArray  # (N, 3), unit, towards who sees them
    materials: FloatArray  # (N, 3): albedo, gloss, sharpness


@dataclass(frozen=True, slots=True, eq=False)
class Cells:
    """Cells of the projector's image that light the surface."""

    grid: tuple[int, int]  # rows, columns of the cells that the whole image has
    image: tuple[int, int]  # rows, columns of the image
    rows: IntArray  # (S,) in the grid
    columns: IntArray  # (S,)
    places: Places  # (S,) lit by their middles
    areas_mm2: FloatArray  # (S,) of the surface that they light
    scattered: FloatArray  # (S,) radiance of the surface under the whole light of the projector, relative to a facing white one

    def strengths(self, pattern: FloatArray | None, lamp: float) -> FloatArray:
        """Return the mean light (S,) of a pattern (h, w) over every cell, or that of the head lamp."""
        if pattern is None:
            return np.full(len(self.rows), lamp, np.float32)
        return np.asarray(cv2.resize(pattern, self.grid[::-1], interpolation=cv2.INTER_AREA)[self.rows, self.columns], np.float32)

    def spread(self, values: FloatArray) -> FloatArray:
        """Return values (S,) on the grid; where a cell lights nothing, the mean of its neighbours, so that they interpolate up to outlines."""
        grid, known = np.zeros(self.grid, np.float32), np.zeros(self.grid, np.float32)
        grid[self.rows, self.columns], known[self.rows, self.columns] = values, 1.0
        near, share = (cv2.blur(image, (3, 3), borderType=cv2.BORDER_CONSTANT) for image in (grid, known))
        return np.where(known > 0.0, grid, near / np.maximum(share, 1e-6))

    def on_grid(self, pixels: FloatArray) -> FloatArray:
        """Convert pixels of the projector (..., 2) to places on the grid, of which a cell's middle has whole numbers."""
        size = np.array([self.image[1] / self.grid[1], self.image[0] / self.grid[0]], np.float32)
        return np.asarray((pixels + np.float32(0.5)) / size - np.float32(0.5), np.float32)


@dataclass(frozen=True, slots=True, eq=False)
class Exchange:
    """What the cells of the projector's image light of each other: irradiance at a cell under the light of every other one."""

    cells: Cells
    factors: FloatArray  # (S, S) float32, form factors times what the sender scatters


class Bounce(NamedTuple):
    """Second light of one camera's image.

    Where the projector lights the surface, it is interpolated between its cells; elsewhere between places on a coarse grid of the camera's
    pixels. A glossy receiver adds its lobe, which differs between cameras.
    """

    exchange: Exchange
    glossy: FloatArray | None  # (S, S) float32, radiance by the lobe of the receiver
    shadow: FloatArray  # (R, S) float32, radiance at places in shadow
    rows: IntArray  # (R,) of the coarse grid
    columns: IntArray  # (R,)
    coarse: tuple[int, int]
    shape: tuple[int, int]  # of the image
    lit: IntArray  # (L,) indices of the pixels that the projector lights
    albedo: FloatArray  # (L,) float32
    on_cells: FloatArray  # (L, 2) float32, places on the grid of the cells
    dark: IntArray  # (D,) indices of the pixels in shadow

    def light(self, pattern: FloatArray | None, lamp: float) -> FloatArray:
        """Return the second light (H, W) float32 under a pattern (h, w), or under the head lamp."""
        cells = self.exchange.cells
        strengths = cells.strengths(pattern, lamp)
        at_lit = self.albedo * _interpolated(cells.spread(self.exchange.factors @ strengths), self.on_cells)
        if self.glossy is not None:
            at_lit += _interpolated(cells.spread(self.glossy @ strengths), self.on_cells)
        second = np.zeros(self.shape, np.float32)
        second.reshape(-1)[self.lit] = at_lit
        if len(self.dark):
            grid = np.zeros(self.coarse, np.float32)
            grid[self.rows, self.columns] = self.shadow @ strengths
            second.reshape(-1)[self.dark] = cv2.resize(grid, self.shape[::-1], interpolation=cv2.INTER_LINEAR).reshape(-1)[self.dark]
        return second


def exchange(cells: Cells, hidden: Hidden) -> Exchange | None:
    """Compute what the cells of a projector's image light of each other; None if they do not face each other."""
    factors = form_factors(cells.places, cells, hidden)
    return Exchange(cells, factors) if factors.any() else None


def bounce(
    between: Exchange,
    light_map: FloatArray,
    places: Callable[[IntArray, IntArray], Places],
    position_mm: FloatArray,
    hidden: Hidden,
    strength: float,
) -> Bounce:
    """Compute the second light of a camera at a position (3,) in the scene.

    Parameters
    ----------
    light_map : (H, W, 4) of `Surface.illuminate`
    places : what pixels of the camera see, given by rows and columns
    strength : of the second light; 1: as the albedo has it
    """
    cells = between.cells
    scaled = Exchange(cells, np.float32(strength) * between.factors)
    glossy = _by_gloss(cells.places, cells, scaled.factors, position_mm) if cells.places.materials[:, 1].any() else None
    step = max(1, round(light_map.shape[1] / SHADOW_PLACES))
    coarse = light_map[step // 2 :: step, step // 2 :: step, 3]
    dark = _in_shadow(light_map, cells.image)
    near = cv2.resize(dark.astype(np.float32), coarse.shape[::-1], interpolation=cv2.INTER_AREA) > 0.0
    rows, columns = np.nonzero((cv2.dilate(near.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0) & (coarse > 0.0))
    seen = places(rows * step + step // 2, columns * step + step // 2)
    factors = np.float32(strength) * form_factors(seen, cells, hidden)
    shadow = seen.materials[:, :1].astype(np.float32) * factors
    if seen.materials[:, 1].any():
        shadow += _by_gloss(seen, cells, factors, position_mm)
    flat = light_map.reshape(-1, 4)
    lit = np.flatnonzero((flat[:, 3] > 0.0) & ~dark.reshape(-1))
    seen_cells = cells.on_grid(flat[lit, :2])
    in_shadow = np.flatnonzero(dark)
    return Bounce(scaled, glossy, shadow, rows, columns, coarse.shape, light_map.shape[:2], lit, flat[lit, 3], seen_cells, in_shadow)


def form_factors(receivers: Places, cells: Cells, hidden: Hidden) -> FloatArray:
    """Return the irradiance (R, S) float32 at receivers by every cell: form factors of discs [1]_ times what the cells scatter.

    References
    ----------
    .. [1] M. F. Cohen, J. R. Wallace, Radiosity and Realistic Image Synthesis, Academic Press, 1993, chapter 4.
    """
    points, normals, _ = receivers
    sources, source_normals, _ = cells.places
    factors = np.zeros((len(points), len(sources)), np.float32)
    together = max(1, MOST_PAIRS // max(1, len(points)))  # senders whose rays are cast at once
    for first in range(0, len(sources) if len(points) else 0, together):
        some = slice(first, first + together)
        receiver, sender = _facing(points, normals, sources[some], source_normals[some])
        start = points[receiver] + OFFSET_MM * normals[receiver]
        end = (sources[some] + OFFSET_MM * source_normals[some])[sender]
        open_way = ~hidden(np.hstack([start, end - start]).astype(np.float32))
        receiver, sender = receiver[open_way], sender[open_way] + first
        towards = sources[sender] - points[receiver]
        squared = np.einsum("ij,ij->i", towards, towards)
        received = np.einsum("ij,ij->i", normals[receiver], towards)
        sent = -np.einsum("ij,ij->i", source_normals[sender], towards)
        area = cells.areas_mm2[sender]
        factors[receiver, sender] = area * received * sent / (squared * (np.pi * squared + area)) * cells.scattered[sender]
    return factors


def _facing(points: FloatArray, normals: FloatArray, sources: FloatArray, source_normals: FloatArray) -> tuple[IntArray, IntArray]:
    """Return which receivers (N,) and senders (N,) face each other by more than LEAST_COSINE on both sides."""
    squares = (np.einsum("ij,ij->i", places, places) for places in (points, sources))
    distance = np.sqrt(np.maximum(np.add.outer(*squares) - 2.0 * points @ sources.T, OFFSET_MM**2))
    received = normals @ sources.T - np.einsum("ij,ij->i", normals, points)[:, None]
    sent = points @ source_normals.T - np.einsum("ij,ij->i", sources, source_normals)
    receiver, sender = np.nonzero((received > LEAST_COSINE * distance) & (sent > LEAST_COSINE * distance))
    return receiver, sender


def _by_gloss(receivers: Places, cells: Cells, factors: FloatArray, position_mm: FloatArray) -> FloatArray:
    """Return the radiance (R, S) float32 towards a position (3,) by the Blinn-Phong lobe of `part.Material`."""
    radiance = np.zeros_like(factors)
    receiver, sender = np.nonzero((factors > 0.0) & (receivers.materials[:, 1:2] > 0.0))
    normals, material = receivers.normals[receiver], receivers.materials[receiver]
    to_light = _unit(cells.places.points_mm[sender] - receivers.points_mm[receiver])
    half = _unit(to_light + _unit(position_mm - receivers.points_mm[receiver]))
    lobe = material[:, 1] * np.maximum(np.einsum("ij,ij->i", normals, half), 0.0) ** material[:, 2]
    radiance[receiver, sender] = factors[receiver, sender] * lobe / np.sqrt(np.einsum("ij,ij->i", normals, to_light))
    return radiance


def _unit(vectors: FloatArray) -> FloatArray:
    return np.asarray(vectors / np.maximum(np.linalg.norm(vectors, axis=1, keepdims=True), 1e-9))


def _in_shadow(light_map: FloatArray, image: tuple[int, int]) -> BoolArray:
    """Return the pixels (H, W) of the surface that the projector, of an image of these rows and columns, does not light."""
    column, row = light_map[..., 0], light_map[..., 1]
    lit = (column > -0.5) & (row > -0.5) & (column < image[1] - 0.5) & (row < image[0] - 0.5)
    return np.asarray(~lit & (light_map[..., 3] > 0.0))


def _interpolated(grid: FloatArray, at: FloatArray) -> FloatArray:
    """Interpolate a grid bilinearly at places (N, 2); OpenCV takes them as an image."""
    if not len(at):
        return np.empty(0, np.float32)
    padded = np.resize(at, (-(-len(at) // REMAPPED), REMAPPED, 2))
    values = cv2.remap(grid, padded, None, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)  # type: ignore[call-overload]
    return np.asarray(values).reshape(-1)[: len(at)]
