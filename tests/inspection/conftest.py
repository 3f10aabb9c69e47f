"""Scans of the sample parts: their nominal surfaces, sampled with stated noise at a stated place on the table."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import pytest

from measureapp.data.inspection_program import InspectionProgram
from measureapp.data.mesh import Mesh
from measureapp.geometry.transform import RigidTransform
from measureapp.inspection.measured_points import MeasuredPoints, sample_mesh
from measureapp.inspection.settings import AlignmentSettings, InspectionSettings
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.project.geometry.files import read_mesh
from measureapp.project.program_file import read_program
from measureapp.resources import resource

# A fit of a fifth of the points that a user's has: its six unknowns are known √5 times worse, which bounds of ten deviations leave room for.
THINNED = InspectionSettings(alignment=AlignmentSettings(coarse_points=150, fine_points=4000))
FITTED = [pytest.param(THINNED, id="thinned"), pytest.param(InspectionSettings(), id="usual", marks=pytest.mark.slow)]


@dataclass(frozen=True)
class Sample:
    """One sample part: its nominal and its inspection program."""

    nominal: Mesh
    program: InspectionProgram

    @cached_property
    def surface(self) -> NominalSurface:
        """Its nominal prepared for queries, which takes seconds for thousands of narrow triangles: once for all tests."""
        return NominalSurface(self.nominal)


ScanOf = Callable[..., MeasuredPoints]


@pytest.fixture(scope="session")
def samples() -> Callable[[str], Sample]:
    kept: dict[str, Sample] = {}

    def sample(name: str) -> Sample:
        if name not in kept:
            folder = resource(f"parts/{name}")
            kept[name] = Sample(read_mesh(folder / "nominal.stl"), read_program(folder / "program.toml"))
        return kept[name]

    return sample


@pytest.fixture(scope="session")
def scan() -> ScanOf:
    """Sample a nominal without its underside, with noise along the normals, and place it: part_from_nominal."""

    def scan_of(
        nominal: Mesh,
        placed: RigidTransform,
        noise_mm: float = 0.02,
        seed: int = 1,
        count: int = 150_000,
        seen_from: tuple[float, ...] = (),
    ) -> MeasuredPoints:
        rng = np.random.default_rng(seed)
        points = sample_mesh(nominal, count)
        assert points.normals is not None
        visible = points.normals[:, 2] > -0.5
        if seen_from:
            visible &= points.normals @ np.asarray(seen_from) > 0.1
        points = points.where(visible)
        assert points.normals is not None
        noisy = points.points_mm + noise_mm * rng.standard_normal(len(points))[:, None] * points.normals
        return MeasuredPoints(noisy, points.normals).seen_from(placed)

    return scan_of


@pytest.fixture(scope="session")
def on_table() -> Callable[..., RigidTransform]:
    """A part on the table: turned about z, moved, and tilted by what a table's axis may be off."""

    def placed(turn_deg: float, shift_mm: tuple[float, float, float] = (12.0, -8.0, 3.0)) -> RigidTransform:
        return RigidTransform.from_vector([0.004, -0.003, np.radians(turn_deg)], shift_mm, "part", "nominal")

    return placed
