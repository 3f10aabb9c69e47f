"""Read-backs that disagree with the images are named before views are stitched; sound ones never."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
import pytest

from measureapp.data.calibration import RigCalibration
from measureapp.data.cloud import CloudQuality
from measureapp.data.fringe import AxisReadback
from measureapp.data.measurement import ViewResult
from measureapp.errors import RegistrationError
from measureapp.geometry.transform import RigidTransform
from measureapp.pipeline.axes_check import without_contradictions
from measureapp.planning.viewpoints import plan_around_part
from tests.calibrate.paper_rig import RIG, Cell
from tests.register.conftest import cross, seen

Readbacks = list[AxisReadback]
GOOD = CloudQuality(1, 1.0, 0.02, 0.0, 1.0, True, "")


@pytest.fixture(scope="module")
def cell() -> Cell:
    return Cell.of(1)


@pytest.fixture(scope="module")
def calibration(cell: Cell) -> RigCalibration:
    return cell.truth.calibration


@pytest.fixture(scope="module")
def views(cell: Cell) -> tuple[ViewResult, ...]:
    """Clouds of the cross from eight viewpoints, with what the axes of a rig read back, which errs by some 0.3 mm."""
    import open3d as o3d

    mesh = cross()
    mesh.apply_translation([0, 0, float(RIG.table.centre_in_guide_mm[2])])
    scene = o3d.t.geometry.RaycastingScene()
    scene.add_triangles(o3d.core.Tensor(np.asarray(mesh.vertices, np.float32)), o3d.core.Tensor(np.asarray(mesh.faces, np.uint32)))
    rng, board, found = np.random.default_rng(5), cell.truth.table_from_board, []
    for name, read, camera_from_board in cell.placed(tuple(plan_around_part(RIG, "gypsum", radius_mm=60.0, height_mm=80.0, count=8))):
        true = RigidTransform((board @ camera_from_board.inverse()).matrix, "part", "camera")
        cloud = seen(scene, true, 0.9, 0.02, rng, name)
        found.append(ViewResult(name, cloud, GOOD, cell.truth.calibration.part_from_camera(read), {}, (), {}, read))
    return tuple(found)


def with_reads(views: Sequence[ViewResult], change: Callable[[Readbacks], Readbacks]) -> list[ViewResult]:
    reads = [view.readback for view in views]
    return [replace(view, readback=read) for view, read in zip(views, change(reads), strict=True)]


def exchanged(reads: Readbacks) -> Readbacks:
    return [reads[0], reads[2], reads[1], *reads[3:]]


def test_sound_read_backs_change_nothing(calibration: RigCalibration, views: tuple[ViewResult, ...]) -> None:
    assert without_contradictions(views, calibration) == views
    tilted = with_reads(views, lambda reads: [replace(read, table_rad=read.table_rad + 1e-3) for read in reads])
    assert all(view.quality.accepted for view in without_contradictions(tilted, calibration))


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda reads: [replace(read, table_rad=-read.table_rad) for read in reads], "the table turned the other way"),
        (lambda reads: [*reads[1:], reads[0]], "read-back of the one before"),
        (lambda reads: [reads[-1], *reads[:-1]], "read-back of the next one"),
    ],
)
def test_a_mistake_that_all_views_share_is_named_with_its_remedy(
    calibration: RigCalibration, views: tuple[ViewResult, ...], change: Callable[[Readbacks], Readbacks], words: str
) -> None:
    with pytest.raises(RegistrationError, match=words) as refused:
        without_contradictions(with_reads(views, change), calibration)
    assert "mm in the middle" in str(refused.value)
    assert "Correct the read-backs" in str(refused.value)


def test_two_exchanged_views_are_left_out_with_the_reason(calibration: RigCalibration, views: tuple[ViewResult, ...]) -> None:
    found = without_contradictions(with_reads(views, exchanged), calibration)
    out = [view.viewpoint_id for view in found if not view.quality.accepted]
    assert out == [views[1].viewpoint_id, views[2].viewpoint_id]
    assert all("contradict the images" in view.quality.reason and "mm" in view.quality.reason for view in found if view.viewpoint_id in out)


def test_a_single_view_at_another_angle_is_left_out(calibration: RigCalibration, views: tuple[ViewResult, ...]) -> None:
    found = without_contradictions(
        with_reads(views, lambda reads: [*reads[:4], replace(reads[4], table_rad=reads[4].table_rad + np.deg2rad(30)), *reads[5:]]),
        calibration,
    )
    assert [view.viewpoint_id for view in found if not view.quality.accepted] == [views[4].viewpoint_id]
