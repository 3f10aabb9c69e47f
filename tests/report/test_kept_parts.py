"""Deviation and pictures kept in a project: taken where nothing has changed, and never where anything has."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from measureapp.data.deviation_scale import DeviationScale
from measureapp.data.dimension import Verdict
from measureapp.data.feature import Feature
from measureapp.data.measurement import Measurement
from measureapp.data.mesh import Mesh
from measureapp.geometry.transform import RigidTransform, rotation_about
from measureapp.inspection.surface.deviation import Deviation, compute_deviation
from measureapp.project import kept_deviation
from measureapp.project.atomic import replacing
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.rig_file import read_rig
from measureapp.project.upkeep import verify
from measureapp.report.compose import compose
from measureapp.report.drawing import Drawing
from measureapp.report.json_document import report_document
from measureapp.report.kept import Afresh, KeptIn, arrays_of, pictures_from
from measureapp.report.model import Details, DimensionPicture, Flag, Picture, Pictures, ReportModel
from measureapp.resources import resource

AT = Details(created_at="2026-05-04T12:00:00+00:00")
MICROMETRE = 1e-3
Given = tuple[Measurement, Mesh, Details]


@pytest.fixture
def project(tmp_path: Path) -> ProjectFolder:
    return ProjectFolder.create(tmp_path / "p", ProjectSettings(name="p", part="part", rig=read_rig(resource("rigs/paper.toml"))))


@pytest.fixture
def part(measured: Callable[..., Measurement]) -> Measurement:
    """A measurement of the block of which a dimension that fails has a feature to be pictured."""
    found = measured()
    assert found.inspection is not None
    boundary = np.array([[-40.0, -30, 20], [40, 30, 20]])
    top = Feature("top", "plane", (0.0, 0.0, 20.0), (0.0, 0.0, 1.0), boundary_mm=boundary)
    first, second, *rest = found.inspection.dimensions
    dimensions = (first, replace(second, features=("top",)), *rest)
    return replace(found, inspection=replace(found.inspection, features=(top,), dimensions=dimensions))


@pytest.fixture
def made(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[str]]:
    """What was computed or drawn, and not taken from what is kept; a drawing says what it was made from, in place of seconds of pictures."""
    found: list[str] = []

    def compute(*given: object, **named: object) -> Deviation:
        found.append("deviation")
        return compute_deviation(*given, **named)  # type: ignore[arg-type]

    def drawn(drawing: Drawing, _progress: object) -> Pictures:
        found.append("pictures")
        return Pictures((Picture(drawing.made_from(), b"png"),))

    monkeypatch.setattr(kept_deviation, "compute_deviation", compute)
    monkeypatch.setattr(Drawing, "draw", drawn)
    yield found


def report(project: ProjectFolder, measurement: Measurement, nominal: Mesh, details: Details = AT) -> ReportModel:
    return compose(measurement, nominal, details=details, parts=KeptIn(ProjectFolder.open(project.path)))


def assert_equal(one: ReportModel, other: ReportModel) -> None:
    assert report_document(one) == report_document(other)
    assert one.deviation is not None and other.deviation is not None
    assert (one.deviation.pictures, one.deviation.histogram) == (other.deviation.pictures, other.deviation.histogram)
    assert (one.pictures, one.failing, one.cross_sections) == (other.pictures, other.failing, other.cross_sections)
    assert one.compared is not None and other.compared is not None
    for name in ("points_mm", "distances_mm", "nominal_normals"):
        assert getattr(one.compared, name).tobytes() == getattr(other.compared, name).tobytes()


def test_a_second_report_computes_and_draws_nothing_and_is_equal_to_one_without_anything_kept(project, part, block, monkeypatch) -> None:
    first = report(project, part, block)
    with monkeypatch.context() as patch:
        patch.setattr(kept_deviation, "compute_deviation", None)
        patch.setattr(Drawing, "draw", None)
        second = report(project, part, block)
    assert_equal(first, second)
    assert_equal(second, compose(part, block, details=AT, parts=Afresh()))
    assert second.failing and second.deviation is not None and any(picture.flags for picture in second.deviation.pictures)
    assert verify(project.path).whole


def moved_point(measurement: Measurement, nominal: Mesh, details: Details) -> Given:
    points = measurement.stitched.points_mm.copy()
    points[7, 2] += MICROMETRE
    return replace(measurement, stitched=replace(measurement.stitched, points_mm=points)), nominal, details


def turned_normal(measurement: Measurement, nominal: Mesh, details: Details) -> Given:
    normals = measurement.stitched.normals.copy()
    normals[7] = -normals[7]
    return replace(measurement, stitched=replace(measurement.stitched, normals=normals)), nominal, details


def moved_nominal(measurement: Measurement, nominal: Mesh, details: Details) -> Given:
    vertices = nominal.vertices_mm.copy()
    vertices[3, 0] += MICROMETRE
    return measurement, replace(nominal, vertices_mm=vertices), details


def other_triangles(measurement: Measurement, nominal: Mesh, details: Details) -> Given:
    return measurement, replace(nominal, triangles=nominal.triangles[1:]), details


def other_alignment(measurement: Measurement, nominal: Mesh, details: Details) -> Given:
    assert measurement.inspection is not None
    turn = RigidTransform.from_parts(rotation_about([0, 0, 1], 1e-6), np.zeros(3), "part", "part")
    inspection = measurement.inspection
    pose = inspection.alignment.nominal_from_part @ turn
    return (
        replace(measurement, inspection=replace(inspection, alignment=replace(inspection.alignment, nominal_from_part=pose))),
        nominal,
        details,
    )


def other_scale(measurement: Measurement, nominal: Mesh, details: Details) -> Given:
    return measurement, nominal, replace(details, deviation_scale=DeviationScale(ramp="rainbow"))


def other_surface(measurement: Measurement, nominal: Mesh, details: Details) -> Given:
    assert measurement.mesh is not None and measurement.mesh.measured is not None
    return replace(measurement, mesh=replace(measurement.mesh, measured=~measurement.mesh.measured)), nominal, details


def other_verdict(measurement: Measurement, nominal: Mesh, details: Details) -> Given:
    assert measurement.inspection is not None
    first, *rest = measurement.inspection.dimensions
    dimensions = (replace(first, verdict=Verdict.FAIL), *rest)
    return replace(measurement, inspection=replace(measurement.inspection, dimensions=dimensions)), nominal, details


ALL, DRAWN = ["deviation", "pictures"], ["pictures"]


@pytest.mark.parametrize(
    ("change", "expected"),
    [
        *((change, ALL) for change in (moved_point, moved_nominal, other_triangles, other_alignment)),
        (turned_normal, ["deviation"]),  # which comes out as it was: the point lies on its nominal either way
        *((change, DRAWN) for change in (other_scale, other_surface, other_verdict)),
    ],
)
def test_each_change_has_that_made_again_which_depends_on_it(
    project: ProjectFolder,
    part: Measurement,
    block: Mesh,
    made: list[str],
    change: Callable[[Measurement, Mesh, Details], Given],
    expected: list[str],
) -> None:
    report(project, part, block)
    made.clear()
    measurement, nominal, details = change(part, block, AT)
    changed = report(project, measurement, nominal, details)
    assert made == expected
    assert_equal(changed, compose(measurement, nominal, details=details))


def test_another_program_keeps_nothing(project, part, block, made, monkeypatch) -> None:
    report(project, part, block)
    monkeypatch.setattr("measureapp.project.kept_arrays.fingerprint", lambda: "another program")
    made.clear()
    report(project, part, block)
    assert made == ALL


@pytest.mark.parametrize(("name", "expected"), [("deviation.npz", ["deviation"]), ("report_pictures.npz", DRAWN)])
@pytest.mark.parametrize("damage", ["flipped bit", "cut off", "of another time", "gone", "no archive"])
def test_what_is_damaged_is_made_again_and_kept_whole(project, part, block, made, name: str, expected: list[str], damage: str) -> None:
    report(project, *moved_point(part, block, AT)[:2])
    path = project.results / name
    former = path.read_bytes()
    whole = report(project, part, block)
    kept = bytearray(path.read_bytes())
    made.clear()
    if damage == "flipped bit":
        kept[len(kept) // 2] ^= 1
    ends = {"cut off": bytes(kept[: len(kept) // 2]), "of another time": former, "no archive": b"PK\x03\x04 no archive"}
    path.unlink()
    if damage != "gone":
        path.write_bytes(ends.get(damage, bytes(kept)))
    assert_equal(report(project, part, block), whole)
    assert made == expected
    made.clear()
    assert_equal(report(project, part, block), whole)
    assert made == [] and verify(project.path).whole


@pytest.mark.parametrize(
    "rubbish", [{}, {"distances_mm": np.zeros(3), "nominal_normals": np.zeros((3, 3)), "unmeasured_share": np.array(0.1)}]
)
def test_arrays_that_only_claim_to_be_what_is_kept_are_not_used(project, part, block, made, rubbish: dict[str, np.ndarray]) -> None:
    whole = report(project, part, block)
    for name in ("deviation.npz", "report_pictures.npz"):
        path = project.results / name
        with np.load(path) as arrays:
            made_from = arrays["made_from"]
        with replacing(path) as temporary, temporary.open("wb") as file:
            np.savez(file, made_from=made_from, document=np.array('{"part": [[]]}'), **rubbish)
    made.clear()
    assert_equal(report(project, part, block), whole)
    assert made == ALL


def test_damage_of_what_is_kept_does_not_keep_the_measurement_from_being_read(project, part, block, made) -> None:
    report(project, part, block)
    for name in ("deviation.npz", "report_pictures.npz"):
        (project.results / name).write_bytes(b"no archive")
    assert not verify(project.path).whole
    assert ProjectFolder.open(project.path).measurement() is None  # none is stored; damage would have been raised


def test_where_nothing_can_be_kept_the_report_is_composed_all_the_same(project, part, block, made) -> None:
    project.results.write_bytes(b"a file where the folder should be")
    assert_equal(report(project, part, block), compose(part, block, details=AT))
    assert project.results.is_file()


def test_pictures_are_read_as_they_were_kept() -> None:
    flag = Flag((0.1, 0.2), ("one", "件"), "#112233", ((0.3, 0.4), (0.5, 0.6)))
    pictures = Pictures((Picture("a", b"\x00\xff"), Picture("b", b"1", (flag,))), (DimensionPicture("d", Picture("c", b"2")),))
    assert pictures_from(arrays_of(pictures)) == pictures
