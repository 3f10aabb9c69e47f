"""Long proofs: full sample counts on four parts, of which three are made from parameters and written as STL."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from measureapp.data.mesh import Mesh
from measureapp.planning.coverage.candidates import checked_grid
from measureapp.planning.coverage.extent import extent_on_table, standing
from measureapp.planning.coverage.scene import PartScene
from measureapp.planning.coverage.visibility import seen_by
from measureapp.planning.feasibility import Feasibility
from measureapp.planning.generate import GeneratorSettings, generate_plan
from measureapp.progress import NoProgress
from measureapp.project.geometry.files import read_mesh
from measureapp.project.geometry.mesh_files import write_stl
from measureapp.project.geometry.robot_file import arm_of
from measureapp.project.rig_file import read_rig
from tests.planning.coverage.parts import blade, casting, impeller, torus
from tests.planning.coverage.reference import greedy_cover

RIG = read_rig("paper")
ARM = arm_of(RIG)


@pytest.mark.slow
@pytest.mark.parametrize("make", [impeller, blade, casting, torus], ids=lambda make: make.__name__)
def test_98_percent_of_what_any_candidate_sees_with_at_most_a_tenth_more_viewpoints_than_a_greedy_cover(
    make: Callable[[], Mesh], tmp_path: Path
) -> None:
    path = tmp_path / "part.stl"
    write_stl(path, make().vertices_mm, make().triangles)
    nominal = read_mesh(path)
    start, busy = time.monotonic(), time.process_time()
    part = nominal.seen_from(standing(nominal))
    cell = Feasibility.checked(RIG, ARM, part)
    made = generate_plan(nominal, cell, GeneratorSettings(views=1))
    took, cpu = time.monotonic() - start, time.process_time() - busy
    scene = PartScene.of(part, RIG)
    grid, free = checked_grid(extent_on_table(part, RIG), RIG, ARM, cell.is_free, NoProgress(), GeneratorSettings().candidates)
    seen = seen_by(grid.subset(free).viewpoints, made.samples, RIG, scene).seen
    reference = greedy_cover(seen, made.samples.areas_mm2, 0.98)
    everything = seen.any(axis=0)
    areas = made.samples.areas_mm2
    sys.stdout.write(
        f"\n{make.__name__}: {len(nominal.triangles)} triangles, {len(made.samples)} samples, {made.candidates} candidates; "
        f"{len(made.plan)} viewpoints from {made.stations} robot poses, greedy cover {reference}; "
        f"{made.planned_share:.1%} of the surface, {made.planned_of_allowed:.2%} of measurable; {took:.1f} s, {cpu:.1f} s of one core\n"
    )
    assert areas[made.planned & everything].sum() >= 0.98 * areas[everything].sum() * (1 - 1e-3)
    assert made.planned_of_allowed >= 0.98
    assert len(made.plan) <= 1.1 * reference
    assert made.problems == ()
    assert np.isfinite(made.time_s)
