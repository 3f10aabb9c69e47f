from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from measureapp.cli.main import main
from measureapp.geometry.fits import fit
from measureapp.geometry.transform import RigidTransform, rotation_about
from measureapp.project.geometry.files import read_mesh, read_points
from measureapp.project.tables import write_poses

HALF_MM = 30.0


@pytest.fixture
def views(tmp_path: Path) -> Path:
    """A cube seen from four corners, as text without normals, with poses 0.3 mm off."""
    rng = np.random.default_rng(1)
    poses = {}
    for k in range(4):
        z = np.array([-np.cos(np.pi / 4 + k * np.pi / 2), -np.sin(np.pi / 4 + k * np.pi / 2), -0.8])
        z /= np.linalg.norm(z)
        x = np.cross([0, 0, 1.0], z)
        x /= np.linalg.norm(x)
        truth = RigidTransform.from_parts(np.column_stack([x, np.cross(z, x), z]), -450 * z, "part", "camera")
        faces = []
        for axis, side in ((0, -np.sign(z[0])), (1, -np.sign(z[1])), (2, 1.0)):
            flat = rng.uniform(-HALF_MM, HALF_MM, (5000, 3))
            flat[:, axis] = side * HALF_MM
            faces.append(flat)
        points = np.vstack(faces) + rng.normal(0, 0.03, (15000, 3))
        np.savetxt(tmp_path / f"view{k}.xyz", truth.inverse().apply(points), "%.5f")
        off = RigidTransform.from_parts(rotation_about([1, 0, 0], 2e-4), rng.normal(0, 0.2, 3), "camera", "camera")
        poses[f"view{k}"] = truth @ off
    write_poses(tmp_path / "poses.csv", poses)
    return tmp_path


def arguments(folder: Path, *more: str) -> list[str]:
    clouds = [str(path) for path in sorted(folder.glob("view*"))]
    return ["stitch", *clouds, "--poses", str(folder / "poses.csv"), "--out", str(folder / "out.ply"), "--json", *more]


def test_clouds_without_normals_are_stitched_and_meshed(views: Path, capsys: pytest.CaptureFixture[str]):
    assert main(arguments(views, "--mesh", str(views / "out.stl"))) == 0
    answer = json.loads(capsys.readouterr().out)
    assert [view["name"] for view in answer["views"]] == ["view0", "view1", "view2", "view3"]
    assert all(view["verdict"] == "good" and view["residual_mm"] < 0.06 for view in answer["views"])
    assert np.array(answer["views"][0]["pose"]).shape == (4, 4)
    points = read_points(views / "out.ply").points_mm
    for axis, side in ((0, 1), (0, -1), (1, 1), (1, -1), (2, 1)):  # each seen by two views or more
        face = points[(side * points[:, axis] > 29) & (np.abs(points[:, :2]) < 31).all(axis=1)]
        inner = face[(np.abs(np.delete(face, axis, axis=1)) < 27).all(axis=1)]
        assert fit("plane", inner).rms_mm < 0.03  # less than the noise of a point
    assert len(read_mesh(views / "out.stl").triangles) > 1000


def test_an_open_patch_is_meshed_without_filling_anything(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    rng = np.random.default_rng(4)
    flat = np.column_stack([rng.uniform(-20, 20, (12000, 2)), np.full(12000, 500.0) + rng.normal(0, 0.02, 12000)])
    np.savetxt(tmp_path / "view0.xyz", flat[np.hypot(*flat[:, :2].T) > 6], "%.5f")
    write_poses(tmp_path / "poses.csv", {"view0": RigidTransform.identity("part", "camera")})
    out = tmp_path / "out.ply"
    assert main(arguments(tmp_path, "--kinematic-only", "--mesh", str(out), "--mesher", "open")) == 0
    mesh = read_mesh(out)
    assert mesh.measured is not None and mesh.measured.all()
    assert np.hypot(*mesh.vertices_mm[mesh.triangles].mean(axis=1)[:, :2].T).min() > 5.5


def test_a_pose_table_without_the_clouds_name_is_refused(views: Path, capsys: pytest.CaptureFixture[str]):
    write_poses(views / "poses.csv", {"other": RigidTransform.identity("part", "camera")})
    assert main(arguments(views)) == 2
    assert "view0" in json.loads(capsys.readouterr().out)["error"]["message"]
    assert not (views / "out.ply").exists()


def test_clouds_in_metres_are_asked_about(views: Path, capsys: pytest.CaptureFixture[str]):
    np.savetxt(views / "view1.xyz", np.loadtxt(views / "view1.xyz") / 1000)
    assert main(arguments(views)) == 2
    refusal = json.loads(capsys.readouterr().out)["error"]
    assert "view1.xyz" in refusal["message"] and "metres" in refusal["message"] and "millimetres" in refusal["hint"]


def test_clouds_that_lie_together_in_inches_only_are_asked_about_and_stitched_once_it_is_said(views: Path, capsys):
    for path in views.glob("view*.xyz"):
        np.savetxt(path, np.loadtxt(path) / 25.4, "%.7f")
    assert main(arguments(views)) == 2
    refusal = json.loads(capsys.readouterr().out)["error"]
    assert "read as inches, they overlap" in refusal["message"] and "`--unit inch`" in refusal["hint"]
    assert main(arguments(views, "--unit", "inch")) == 0
    assert np.abs(read_points(views / "out.ply").points_mm).max() == pytest.approx(HALF_MM, abs=0.5)


def test_an_output_of_unknown_kind_is_refused_before_any_work(views: Path, capsys: pytest.CaptureFixture[str]):
    assert main([*arguments(views), "--out", str(views / "out.las")]) == 2
    assert "out.las" in json.loads(capsys.readouterr().out)["error"]["message"]


def test_clouds_that_share_nothing_are_refused_and_nothing_is_written(views: Path, capsys: pytest.CaptureFixture[str]):
    away = {f"view{k}": RigidTransform.from_parts(np.eye(3), [200.0 * k, 0, 0], "part", "camera") for k in range(4)}
    write_poses(views / "poses.csv", away)
    assert main(arguments(views)) == 2
    refusal = json.loads(capsys.readouterr().out)["error"]
    assert "No two clouds overlap" in refusal["message"] and "--kinematic-only" in refusal["hint"]
    assert not (views / "out.ply").exists()


def test_views_all_around_say_how_well_they_close(views: Path, capsys: pytest.CaptureFixture[str]):
    assert main(arguments(views)) == 0
    loop_closure = json.loads(capsys.readouterr().out)["ring"]
    assert sorted(loop_closure["viewpoints"]) == ["view0", "view1", "view2", "view3"]
    assert loop_closure["gap_mm"] < 3 * loop_closure["sigma_mm"]
