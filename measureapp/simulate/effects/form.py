"""A part that is not its drawing: form errors, expansion, and what stands around it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.mesh import Mesh
from measureapp.geometry.transform import rotation_about
from measureapp.simulate.effects.waves import draw_waves
from measureapp.simulate.options import WorldOptions
from measureapp.simulate.part import Material, Part

STEEL_PER_K = 11.5e-6
TABLE_RADIUS_MM, TABLE_SIDES = 250.0, 96
CLAMP_MM = (14.0, 14.0, 22.0)
TABLE_TOP = Material("table", 0.25)
CLAMP = Material("clamp", 0.35, gloss=0.3, sharpness=15.0)


def made_part(nominal: Part, options: WorldOptions, rng: np.random.Generator) -> Part:
    """Return the part as it was made and as warm as it is.

    Its vertices are displaced along their normals by a smooth field whose wavelengths are a quarter to the whole of its size, so that
    faces stay smooth and edges stay where faces meet.
    """
    vertices = nominal.mesh.vertices_mm
    size = float(np.linalg.norm(np.ptp(vertices, axis=0)))
    field = draw_waves(rng, options.part.form_mm, (0.25 * size, size), components=1, dimensions=3)
    expansion = STEEL_PER_K * options.warmth.part_excess_k * rng.uniform(0.5, 1.0)
    if field.rms == 0.0 and expansion == 0.0:
        return nominal
    normals = _vertex_normals(nominal.mesh)
    moved = vertices * (1.0 + expansion) + field.at(vertices) * normals
    return replace(nominal, mesh=replace(nominal.mesh, vertices_mm=moved), expansion=expansion)


def with_surroundings(part: Part) -> Part:
    """Return the part together with the table's top below it and three clamps beside it, as cameras see them."""
    pieces = [part.mesh, _disc(part.mesh.vertices_mm[:, 2].min() - 0.05), *_clamps(part)]
    materials = (*part.materials, TABLE_TOP, CLAMP)
    kinds = [part.material, *(np.full(len(piece.triangles), len(part.materials) + (k > 0), np.uint8) for k, piece in enumerate(pieces[1:]))]
    offsets = np.cumsum([0, *(len(piece.vertices_mm) for piece in pieces[:-1])])
    vertices = np.vstack([piece.vertices_mm for piece in pieces])
    triangles = np.vstack([piece.triangles + offset for piece, offset in zip(pieces, offsets, strict=True)])
    mesh = Mesh(vertices, triangles, part.mesh.frame)
    return Part(part.name, mesh, materials, np.concatenate(kinds), part.dimensions, watertight=False)


def _vertex_normals(mesh: Mesh) -> FloatArray:
    """Unit normals (N, 3) of the vertices; vertices at one place get one normal, so that no gap opens at an edge."""
    corners = mesh.vertices_mm[mesh.triangles]
    faces = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    _, place = np.unique(np.round(mesh.vertices_mm, 6), axis=0, return_inverse=True)
    place = place.reshape(-1)
    sums = np.zeros((place.max() + 1, 3))
    for corner in range(3):
        np.add.at(sums, place[mesh.triangles[:, corner]], faces)
    normals = sums[place]
    return normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)


def _disc(height_mm: float) -> Mesh:
    turn = np.linspace(0.0, 2.0 * np.pi, TABLE_SIDES, endpoint=False)
    rim = np.column_stack([TABLE_RADIUS_MM * np.cos(turn), TABLE_RADIUS_MM * np.sin(turn), np.full(TABLE_SIDES, height_mm)])
    edge = np.arange(1, TABLE_SIDES + 1)
    return Mesh(np.vstack([[0.0, 0.0, height_mm], rim]), np.column_stack([np.zeros(TABLE_SIDES, int), edge, np.roll(edge, -1)]), "nominal")


def _clamps(part: Part) -> list[Mesh]:
    from trimesh.creation import box

    made = []
    for turn in np.deg2rad([20.0, 140.0, 260.0]):
        block = box(CLAMP_MM)
        block.apply_translation([part.radius_mm + CLAMP_MM[0] / 2 + 1.0, 0.0, part.mesh.vertices_mm[:, 2].min() + CLAMP_MM[2] / 2])
        turned = np.asarray(block.vertices) @ rotation_about([0.0, 0.0, 1.0], turn).T
        made.append(Mesh(turned, np.asarray(block.faces), "nominal"))
    return made
