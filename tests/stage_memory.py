"""Memory of the stages after the clouds, on clouds of a part and its table: `python -m tests.stage_memory VIEWS STEP_MM FOLDER [LAST_STAGE]`.

The clouds are written to ``FOLDER`` as a project stores them, and a program of its own reads them and measures, so that neither what made
them nor what tests hold counts. It prints one document: points of all views, and of each stage the peak of memory that no file backs, in
bytes, its seconds, and its processor time. `--measure` is that second program.
"""

from __future__ import annotations

import json
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import psutil

from measureapp.data.cloud import CloudQuality
from measureapp.data.measurement import ViewResult
from measureapp.data.mesh import Mesh
from measureapp.project.geometry.files import read_point_cloud, write_cloud

GOOD = CloudQuality(1, 1.0, 0.02, 0.0, 1.0, True, "")
NOISE_MM = 0.02
TABLE_RADIUS_MM = 100.0
SURROUNDINGS, SURFACE = "surroundings", "surface"  # the first and the last stage
SAMPLE_S = 0.005
FEW = 20  # one point in so many, for the run that comes first


@dataclass
class Watched:
    """Peaks of the memory of this program and those it starts, stage by stage."""

    stages: dict[str, dict[str, float]] = field(default_factory=dict)
    _now: str = ""

    def __post_init__(self) -> None:
        threading.Thread(target=self._watch, daemon=True).start()

    @contextmanager
    def stage(self, name: str) -> Iterator[None]:
        self.stages[name] = {"peak": 0.0}
        self._now, start, spent = name, time.monotonic(), time.process_time()
        yield
        self._note()
        self._now = ""
        self.stages[name] |= {"seconds": time.monotonic() - start, "processor": time.process_time() - spent}

    def _watch(self) -> None:
        while True:
            self._note()
            time.sleep(SAMPLE_S)

    def _note(self) -> None:
        if now := self._now:
            self.stages[now]["peak"] = max(self.stages[now]["peak"], _held())


def _held() -> float:
    """Bytes that no file backs; those of a file are given up where memory is short."""
    held = 0
    for process in (own := psutil.Process(), *own.children(recursive=True)):
        try:
            memory = process.memory_info()
            held += memory.rss - getattr(memory, "shared", 0)
        except psutil.Error:
            continue
    return float(held)


def _views(count: int, cloud_of: Callable[[str, Any], Any]) -> list[ViewResult]:
    """Views around the part of the paper's rig, whose clouds ``cloud_of`` returns for a name and the true pose part_from_camera."""
    from measureapp.geometry.transform import RigidTransform
    from measureapp.planning.viewpoints import plan_around_part
    from tests.calibrate.paper_rig import RIG, Cell

    cell = Cell.of(1)
    board, found = cell.truth.table_from_board, []
    for name, read, camera_from_board in cell.placed(tuple(plan_around_part(RIG, "gypsum", radius_mm=60.0, height_mm=80.0, count=count))):
        true = RigidTransform((board @ camera_from_board.inverse()).matrix, "part", "camera")
        found.append(ViewResult(name, cloud_of(name, true), GOOD, cell.truth.calibration.part_from_camera(read), {}, (), {}, read))
    return found


def store(count: int, step_mm: float, folder: Path) -> None:
    """Write the clouds of ``count`` views of a part on its table, with a point every ``step_mm``."""
    import open3d as o3d
    import trimesh

    from tests.calibrate.paper_rig import RIG
    from tests.register.conftest import cross, seen

    level, rng, scene = float(RIG.table.centre_in_guide_mm[2]), np.random.default_rng(5), o3d.t.geometry.RaycastingScene()
    table: Any = trimesh.creation.cylinder(TABLE_RADIUS_MM, 2.0, sections=96)
    table.apply_translation([0.0, 0.0, -1.05])
    meshes: list[Any] = [cross(), table]
    for mesh in meshes:
        placed = np.asarray(mesh.vertices + np.array([0.0, 0.0, level]), np.float32)
        scene.add_triangles(o3d.core.Tensor(placed), o3d.core.Tensor(np.array(mesh.faces, np.uint32)))

    def cloud_of(name: str, true: Any) -> None:
        write_cloud(folder / f"{name}.ply", seen(scene, true, step_mm, NOISE_MM, rng, name))

    _views(count, cloud_of)


def measure(count: int, folder: Path, last: str = SURFACE) -> dict[str, Any]:
    """Stages of `process` from stored clouds to dimensions; returns what the description of this module says.

    They run on few of the points first: libraries and compiled kernels, which no number of points changes, count as the stage "program".
    """
    watched = Watched()
    few = _views(count, lambda name, _: (cloud := read_point_cloud(folder / f"{name}.ply")).where(np.arange(0, len(cloud), FEW)))
    _stages(few, Watched(), last)
    del few
    with watched.stage("program"):
        time.sleep(2 * SAMPLE_S)
    with watched.stage("clouds"):
        views = _views(count, lambda name, _: read_point_cloud(folder / f"{name}.ply"))
    return {**_stages(views, watched, last), "stages": watched.stages}


def _stages(views: list[ViewResult], watched: Watched, last: str) -> dict[str, Any]:
    from measureapp.data.inspection_program import InspectionProgram
    from measureapp.inspection.dimensions import inspect
    from measureapp.pipeline.consistency.check import check_consistency, with_unexplained
    from measureapp.pipeline.surroundings import exclude_surroundings
    from measureapp.register.stitch import stitch
    from measureapp.register.surface.closed import reconstruct_surface
    from tests.calibrate.paper_rig import RIG, Cell
    from tests.register.conftest import cross

    shape = cross()
    nominal, calibration = Mesh(np.asarray(shape.vertices), np.asarray(shape.faces), "nominal"), Cell.of(1).truth.calibration
    program = InspectionProgram(name="the fit alone")
    with watched.stage(SURROUNDINGS):
        part, excluded = exclude_surroundings(views, nominal, None, calibration, RIG)
    found = {"views": len(views), "points": sum(len(view.cloud) for view in views), "excluded": dict(excluded.found)}
    if last == SURROUNDINGS:
        return found
    with watched.stage("stitching"):
        stitched = stitch([view.cloud for view in part], [view.part_from_camera for view in part])
    with watched.stage("checks"):
        stitched = with_unexplained(stitched, check_consistency(part, stitched))
    with watched.stage("inspection"):
        inspected = inspect(stitched, program, nominal)
    with watched.stage(SURFACE):
        mesh = reconstruct_surface(stitched)
    return found | {
        "stitched": len(stitched),
        "sum_mm": float(np.sum(stitched.points_mm)),
        "rms_mm": float(inspected.alignment.rms_mm),
        "triangles": len(mesh.triangles),
    }


def run(count: int, step_mm: float, folder: Path, last: str = SURFACE) -> dict[str, Any]:
    """Write the clouds, and measure them in a program of its own."""
    store(count, step_mm, folder)
    command = [sys.executable, "-m", "tests.stage_memory", "--measure", str(count), str(folder), last]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    found: dict[str, Any] = json.loads(done.stdout.splitlines()[-1])
    return found


if __name__ == "__main__":
    if sys.argv[1] == "--measure":
        sys.stdout.write(json.dumps(measure(int(sys.argv[2]), Path(sys.argv[3]), *sys.argv[4:])) + "\n")
    else:
        sys.stdout.write(json.dumps(run(int(sys.argv[1]), float(sys.argv[2]), Path(sys.argv[3]), *sys.argv[4:]), indent=1) + "\n")
