"""Clouds and meshes from files are measured without a project; what cannot be used is told and changes nothing."""

from __future__ import annotations

import numpy as np
import pytest
import trimesh
from PySide6.QtWidgets import QFileDialog

from measureapp.data.cloud import StitchedCloud
from measureapp.data.length_unit import LengthUnit
from measureapp.data.view_errors import ViewErrors
from measureapp.geometry.transform import RigidTransform
from measureapp.inspection.dimensions import inspect
from measureapp.project.geometry.files import read_cloud_or_mesh, write_cloud
from measureapp.project.program_file import read_program, read_program_nominal
from measureapp.resources import resource
from ui.controllers.files import FilesToMeasure

PATIENCE_MS = 90_000
NOISE_MM = 0.02


@pytest.fixture
def drawing():
    return resource("parts/gypsum/nominal.stl")


def scanned(path, drawing, scale=1.0):
    """Points all over the drawn part, turned and moved, with noise along its normals."""
    mesh = trimesh.load(drawing)
    points, faces = trimesh.sample.sample_surface(mesh, 30_000, seed=3)
    points = points + np.random.default_rng(4).normal(0, NOISE_MM, len(points))[:, None] * mesh.face_normals[faces]
    turn = trimesh.transformations.rotation_matrix(0.2, [0.1, 0.2, 1.0])[:3, :3]
    np.savetxt(path, scale * (points @ turn.T + [5.0, -8.0, 2.0]), "%.6f")
    return path


def settled(application, qtbot):
    qtbot.waitUntil(lambda: not application.controllers.jobs.queue.busy and not application.session.busy_with, timeout=PATIENCE_MS)
    return next(iter(reversed(application.session.messages)), None)


def test_a_cloud_in_inches_is_asked_about_then_compared_with_its_nominal(application, window, qtbot, tmp_path, drawing, monkeypatch):
    chosen = [str(scanned(tmp_path / "scan.xyz", drawing, 1 / 25.4)), str(drawing)]
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (chosen.pop(0), ""))
    window.header.file.click()
    settled(application, qtbot)
    assert window.project_menu.unit_dialog.value() is LengthUnit.INCH and application.session.stitched is None
    window.project_menu.unit_dialog.accept_button.click()
    assert settled(application, qtbot).level == "done"
    page = window.pages["inspection"]
    assert window.page is page and page.shape.value() == "deviation" and not page.is_empty
    found = application.session.comparison.deviation
    assert found.rms_mm == pytest.approx(NOISE_MM, rel=0.1)  # the fit of six numbers to 30 000 points leaves the noise
    assert not page.program.text.isVisible()  # there is no project to keep a program
    window.show_page("clouds")  # there are no views to be shown
    assert window.page.is_empty and application.session.messages[-1].level == "done"


def test_a_file_is_measured_by_a_program_and_a_point_of_it_has_no_invented_figures(application, window, qtbot, tmp_path, drawing):
    cloud = scanned(tmp_path / "scan.xyz", drawing)
    application.controllers.files.measure(FilesToMeasure(cloud, drawing.with_name("program.toml")))
    assert settled(application, qtbot).level == "done"
    dimensions = {found.name: found for found in application.session.inspection.dimensions}
    for name, nominal in (("a", 180.0), ("b", 140.0), ("c", 60.0), ("d", 40.0)):
        assert dimensions[name].measured == pytest.approx(nominal, abs=NOISE_MM / 2)  # hundreds of points on every face
    page = window.pages["inspection"]
    page._show_point(0, 7)
    rows = dict(row for group in page.properties.groups for row in group.rows)
    assert rows["View"] == "scan.xyz" and rows["Standard deviation σ"] == rows["Brightness"] == rows["Measured by"] == "–"
    page.distance.button.setChecked(True)
    for place in (7, 99):
        page._show_point(0, place)
    assert page.distance.distances[0].uncertainty_mm is None and "±" not in page.distance.distances[0].words


def test_a_stitched_cloud_from_a_file_is_as_uncertain_as_the_command_line_says(application, window, qtbot, tmp_path, drawing):
    points = np.loadtxt(scanned(tmp_path / "scan.xyz", drawing))
    count, motions = len(points), np.diag(2 * ([0.004] * 3 + [2e-5] * 3))  # shift and turn of each view by itself
    poses = tuple(RigidTransform.from_vector([0, 0, 0], [0, 0, height], "part", "camera") for height in (-400.0, -500.0))
    errors = ViewErrors(poses, np.zeros((2, 3)), motions, np.zeros((12, 0)))
    view, flat, names = (points[:, 0] > 5).astype(np.int16), np.zeros((count, 3)), ("left", "right")
    cloud = StitchedCloud(
        points, flat, np.full(count, NOISE_MM), np.full(count, 0.5), view, (), view_names=names, sampled_view=view, errors=errors
    )
    path, program = tmp_path / "stitched.ply", drawing.with_name("program.toml")
    write_cloud(path, cloud)
    application.controllers.files.measure(FilesToMeasure(path, program))
    assert settled(application, qtbot).level == "done"
    described = read_program(program)
    told = inspect(read_cloud_or_mesh(path), described, read_program_nominal(program, described)).dimensions
    for found, wanted in zip(application.session.inspection.dimensions, told, strict=True):
        assert found.budget == pytest.approx(wanted.budget) and found.budget["stitching"] > 0
        assert "position of each view" not in found.traceability
    window.pages["inspection"]._show_point(0, int(np.argmax(view)))
    assert dict(row for group in window.pages["inspection"].properties.groups for row in group.rows)["View"] == "right"


@pytest.mark.parametrize(
    ("name", "content", "told"),
    [
        ("empty.ply", "", "is empty"),
        ("one.xyz", "1 2 3\n", ""),
        ("damaged.ply", "ply\nformat ascii 1.0\nelement vertex 9\n", ""),
        ("words.xyz", "these are no points\n", ""),
        ("other.xyz", "sphere", "nominal"),
        ("missing.stl", None, "does not exist"),
    ],
)
def test_a_file_that_cannot_be_measured_is_reported_and_the_project_stays(
    application, window, qtbot, tmp_path, drawing, measurement, monkeypatch, name, content, told
):
    monkeypatch.setattr(application.controllers.documents, "preview", lambda: None)
    application.session.open_project("kept", "gypsum", None)
    application.session.set_measurement(measurement, {})
    path = tmp_path / name
    if content == "sphere":
        np.savetxt(path, measurement.stitched.points_mm[::6], "%.4f")
    elif content is not None:
        path.write_text(content, encoding="ascii")
    application.controllers.files.measure(FilesToMeasure(path, drawing))
    said = settled(application, qtbot)
    assert said.level == "error" and told in said.text and said.text.endswith(".") and said.hint
    assert "program (" not in said.text  # an error of the files, not of the program
    assert application.session.project_name == "kept" and application.session.measurement is measurement
    assert window.header.file.isEnabled()


def test_measuring_a_file_can_be_cancelled(application, window, qtbot, tmp_path, drawing):
    cloud = scanned(tmp_path / "scan.xyz", drawing)
    application.controllers.files.measure(FilesToMeasure(cloud, drawing))
    application.controllers.jobs.cancel()
    assert settled(application, qtbot).text == "Cancelled."
    assert application.session.stitched is None and application.session.inspection is None
