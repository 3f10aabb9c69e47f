"""Table, fixtures and background are excluded from the clouds; nothing of the part is, and a part by itself stays as it is."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from measureapp.data.calibration import RigCalibration
from measureapp.data.cell import Fixture
from measureapp.data.cloud import CloudQuality
from measureapp.data.measurement import ViewResult
from measureapp.data.mesh import Mesh
from measureapp.data.rig import RigDescription
from measureapp.data.surroundings import ABOVE_TABLE_MM, PART_ELSEWHERE, SURROUNDINGS, Surroundings
from measureapp.data.view_choices import ViewChoices
from measureapp.geometry.transform import RigidTransform
from measureapp.pipeline.assemble import _with_surroundings, _without_surroundings
from measureapp.pipeline.surroundings import BEYOND_MM, FAR_MM, exclude_surroundings
from measureapp.planning.viewpoints import plan_around_part
from measureapp.project.geometry.files import write_mesh
from tests.calibrate.paper_rig import RIG, Cell
from tests.register.conftest import box, cross, seen

GOOD = CloudQuality(1, 1.0, 0.02, 0.0, 1.0, True, "")
LEVEL_MM = float(RIG.table.centre_in_guide_mm[2])
NOISE_MM, STEP_MM = 0.02, 1.8
CLAMP = (14.0, 14.0, 22.0)
CLAMPED_AT = ((68.0, 0.0), (-68.0, 0.0), (45.0, 45.0))


@pytest.fixture(scope="module")
def cell() -> Cell:
    return Cell.of(1)


@pytest.fixture(scope="module")
def calibration(cell: Cell) -> RigCalibration:
    return cell.truth.calibration


@pytest.fixture(scope="module")
def nominal() -> Mesh:
    mesh = cross()
    return Mesh(np.asarray(mesh.vertices), np.asarray(mesh.faces), "nominal")


def scene_of(*meshes: Any) -> Any:
    import open3d as o3d

    scene = o3d.t.geometry.RaycastingScene()
    for mesh in meshes:
        scene.add_triangles(
            o3d.core.Tensor(np.asarray(mesh.vertices + np.array([0, 0, LEVEL_MM]), np.float32)),
            o3d.core.Tensor(np.asarray(mesh.faces, np.uint32)),
        )
    return scene


def views_of(cell: Cell, *meshes: Any) -> list[ViewResult]:
    """Clouds of what stands on the table, from four viewpoints."""
    scene, rng, board, found = scene_of(*meshes), np.random.default_rng(5), cell.truth.table_from_board, []
    for name, read, camera_from_board in cell.placed(tuple(plan_around_part(RIG, "gypsum", radius_mm=60.0, height_mm=80.0, count=4))):
        true = RigidTransform((board @ camera_from_board.inverse()).matrix, "part", "camera")
        cloud = seen(scene, true, STEP_MM, NOISE_MM, rng, name)
        found.append(ViewResult(name, cloud, GOOD, cell.truth.calibration.part_from_camera(read), {}, (), {}, read))
    return found


def table_top() -> Any:
    import trimesh

    return trimesh.creation.cylinder(250.0, 2.0, sections=96, transform=[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, -1.05], [0, 0, 0, 1]])


def clamps() -> list[Any]:
    return [box(CLAMP, (x, y, CLAMP[2] / 2)) for x, y in CLAMPED_AT]


def distances_mm(views: list[ViewResult], mesh: Any) -> np.ndarray:
    """Distances of all points, as the axes place them, from a mesh on the table."""
    import open3d as o3d

    points = np.vstack([view.part_from_camera.apply(view.cloud.points_mm) for view in views])
    return scene_of(mesh).compute_distance(o3d.core.Tensor(points.astype(np.float32))).numpy()


def heights_mm(views: list[ViewResult]) -> np.ndarray:
    return np.concatenate([view.part_from_camera.apply(view.cloud.points_mm)[:, 2] for view in views]) - LEVEL_MM


def test_a_part_by_itself_stays_as_it_is(cell: Cell, calibration: RigCalibration, nominal: Mesh) -> None:
    views = views_of(cell, cross())
    kept, found = exclude_surroundings(views, nominal, None, calibration, RIG)
    assert all(one is other for one, other in zip(kept, views, strict=True))
    assert found == Surroundings() and found.sentence == ""


def test_a_defect_of_a_part_by_itself_stays(cell: Cell, calibration: RigCalibration, nominal: Mesh) -> None:
    views = views_of(cell, cross(), box((20.0, 20.0, 12.0), (50.0, 0.0, 56.0)))  # 12 mm too much on one arm
    kept, _ = exclude_surroundings(views, nominal, None, calibration, RIG)
    assert all(one is other for one, other in zip(kept, views, strict=True))


@pytest.mark.parametrize("moved_mm", [(0.0, 0.0), (15.0, -10.0)])
def test_table_and_clamps_are_excluded_and_nothing_of_the_part(
    cell: Cell, calibration: RigCalibration, nominal: Mesh, moved_mm: tuple[float, float]
) -> None:
    part = cross()
    part.apply_translation([*moved_mm, 0.0])
    holding = clamps()
    for one in holding:
        one.apply_translation([*moved_mm, 0.0])
    views = views_of(cell, part, table_top(), *holding)
    kept, found = exclude_surroundings(views, nominal, None, calibration, RIG)
    before, after = distances_mm(views, part), distances_mm(kept, part)
    assert np.mean(before > FAR_MM) > 0.3  # most of the picture is not the part
    assert np.mean(after > FAR_MM + 1.0) == 0.0
    higher = heights_mm(views) > ABOVE_TABLE_MM + 1.0  # axes err by some 0.3 mm, and the table's plane is found from points beside the part
    assert np.count_nonzero(after < 1.0) >= 0.999 * np.count_nonzero(before[higher] < 1.0)
    counts = dict(found.found)
    assert found.points == len(before) and counts["table"] > counts["far"] > 0
    assert "the table's top" in found.sentence and "clamps" in found.sentence


def test_what_stands_behind_the_table_is_background(cell: Cell, calibration: RigCalibration, nominal: Mesh) -> None:
    wall = box((10.0, 900.0, 600.0), (320.0, 0.0, 100.0))
    views = views_of(cell, cross(), wall)
    kept, found = exclude_surroundings(views, nominal, None, calibration, RIG)
    assert dict(found.found)["background"] > 0
    assert distances_mm(kept, cross()).max() < 2.0


def test_a_described_fixture_is_excluded_even_where_it_touches_the_part(cell: Cell, calibration: RigCalibration, nominal: Mesh) -> None:
    low, high = (60.2, -7.0, 0.0), (74.2, 7.0, 22.0)
    fixture = Fixture(name="stop", low_mm=low, high_mm=high, on_table=True)
    described: RigDescription = RIG.model_copy(update={"cell": RIG.cell.model_copy(update={"fixtures": (fixture,)})})
    views = views_of(cell, cross(), box(CLAMP, (67.2, 0.0, 11.0)))
    kept, found = exclude_surroundings(views, nominal, None, calibration, described)
    assert dict(found.found)["fixtures"] > 100
    assert np.quantile(distances_mm(kept, cross()), 0.999) < 1.0
    without, _ = exclude_surroundings(views, nominal, None, calibration, RIG)
    assert np.quantile(distances_mm(without, cross()), 0.999) > 5.0


def test_the_user_may_keep_the_surroundings_and_is_told_either_way(
    cell: Cell, calibration: RigCalibration, nominal: Mesh, tmp_path: Path
) -> None:
    path = tmp_path / "nominal.stl"
    write_mesh(path, nominal)
    project = SimpleNamespace(path=tmp_path, nominal=path, plan=lambda: None, rig=lambda: RIG)
    views = views_of(cell, cross(), table_top())
    without, found = _without_surroundings(project, calibration, views, ViewChoices())
    assert sum(len(view.cloud) for view in without) < 0.6 * sum(len(view.cloud) for view in views)
    kept, nothing = _without_surroundings(project, calibration, views, ViewChoices(keep_surroundings=True))
    assert kept is views
    former = {"patterns": "three-close", SURROUNDINGS: "of a former choice"}
    assert _with_surroundings(former, found.sentence) == {"patterns": "three-close", SURROUNDINGS: found.sentence}
    assert _with_surroundings(former, nothing.sentence) == {"patterns": "three-close"}


UNDESCRIBED = RIG.model_copy(update={"table": RIG.table.model_copy(update={"diameter_mm": 0.0, "centre_in_guide_mm": (0.0, 0.0, 0.0)})})


def test_without_a_described_table_a_part_stays_at_any_height(cell: Cell, calibration: RigCalibration, nominal: Mesh) -> None:
    views = views_of(cell, cross())
    kept, found = exclude_surroundings(views, nominal, None, calibration, UNDESCRIBED)
    assert LEVEL_MM > BEYOND_MM  # a table at the origin would take its upper part for background
    assert found == Surroundings() and all(one is other for one, other in zip(kept, views, strict=True))


def test_without_a_described_table_its_top_is_found_at_any_height(cell: Cell, calibration: RigCalibration, nominal: Mesh) -> None:
    part = cross()
    views = views_of(cell, part, table_top(), *clamps())
    kept, found = exclude_surroundings(views, nominal, None, calibration, UNDESCRIBED)
    described, _ = exclude_surroundings(views, nominal, None, calibration, RIG)
    assert dict(found.found)["table"] > 1000
    assert [len(one.cloud) for one in kept] == [len(one.cloud) for one in described]


def test_a_flange_that_juts_out_is_no_table(cell: Cell, calibration: RigCalibration, nominal: Mesh) -> None:
    flange = box((300.0, 40.0, 6.0), (0.0, 0.0, 50.0))
    views = views_of(cell, cross(), flange)
    kept, found = exclude_surroundings(views, nominal, None, calibration, UNDESCRIBED)
    assert "table" not in dict(found.found)
    assert heights_mm(kept).min() < 10.0


def test_nothing_is_excluded_where_nothing_would_be_left(cell: Cell, calibration: RigCalibration, nominal: Mesh) -> None:
    centre = (0.0, 0.0, -LEVEL_MM)
    elsewhere = RIG.model_copy(update={"table": RIG.table.model_copy(update={"centre_in_guide_mm": centre})})
    views = views_of(cell, cross())
    kept, found = exclude_surroundings(views, nominal, None, calibration, elsewhere)
    assert all(one is other for one, other in zip(kept, views, strict=True))
    assert found.sentence == PART_ELSEWHERE
