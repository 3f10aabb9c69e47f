from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from measureapp.cli.main import main
from measureapp.data.cloud import PointCloud, StitchedCloud
from measureapp.project.geometry.files import read_point_cloud, read_points, read_stitched, write_cloud


@pytest.fixture
def cloud(tmp_path: Path) -> Path:
    """A plate with a patch above it and one point far away."""
    u, v = np.meshgrid(np.arange(0, 20, 0.5), np.arange(0, 20, 0.5))
    plate = np.column_stack([u.ravel(), v.ravel(), np.zeros(u.size)])
    points = np.vstack([plate, plate[(plate < 2.6).all(axis=1)] + np.array([0, 0, 15]), [[10.0, 10, 300]]])
    count = len(points)
    normals = np.tile([0.0, 0, -1], (count, 1))
    pixel = np.column_stack([np.arange(count), np.zeros(count)])
    write_cloud(
        tmp_path / "view.ply",
        PointCloud(points, normals, np.full(count, 0.03), np.full(count, 0.4), pixel, np.full(count, 3), "camera", "view"),
    )
    return tmp_path / "view.ply"


def run(cloud: Path, capsys: pytest.CaptureFixture[str], *options: str) -> tuple[int, dict]:
    code = main(["filter", str(cloud), "--out", str(cloud.with_name("out.ply")), *options, "--json"])
    return code, json.loads(capsys.readouterr().out)


def test_every_filter_says_what_it_removed_and_the_rest_keeps_all_it_had(cloud: Path, capsys: pytest.CaptureFixture[str]):
    code, answer = run(
        cloud, capsys, "--box", "-1,30,-1,15,-1,400", "--plane", "0,0,-1,-100",
        "--radius-mm", "0.8", "--least", "2", "--statistical", "20", "--neighbours", "8", "--islands-mm2", "20",
    )  # fmt: skip
    assert code == 0
    assert list(answer["removed"]) == ["box", "plane", "radius", "statistical", "islands"]
    assert (answer["removed"]["plane"], answer["removed"]["islands"]) == (1, 36)
    kept = read_point_cloud(cloud.with_name("out.ply"))
    assert len(kept) == answer["points"] == answer["before"] - sum(answer["removed"].values())
    assert (kept.frame, kept.viewpoint_id) == ("camera", "view")
    assert np.allclose(kept.sigma_mm, 0.03) and set(kept.cameras) == {3}
    whole = read_point_cloud(cloud)
    assert np.array_equal(whole.points_mm[kept.pixel[:, 0]], kept.points_mm)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ((), "No filter is given"),
        (("--box", "900,901,0,1,0,1"), "The filter 'box' removes all points"),
        (("--box", "5,1,0,1,0,1"), "box is empty"),
        (("--plane", "0,0,0,1"), "normal is 0 0 0"),
        (("--plane", "0,0,1"), "4 numbers are expected"),
        (("--box", "a,b"), "6 numbers are expected"),
        (("--statistical", "2", "--neighbours", "9000"), "no point with 9000 neighbours"),
    ],
)
def test_what_makes_no_sense_is_refused_and_nothing_is_written(cloud: Path, capsys: pytest.CaptureFixture[str], options, words):
    code, answer = run(cloud, capsys, *options)
    assert code == 2
    assert words in answer["error"]["message"] and answer["error"]["hint"]
    assert not cloud.with_name("out.ply").exists()


def test_points_without_anything_else_can_be_filtered(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    np.savetxt(tmp_path / "plain.xyz", np.random.default_rng(0).uniform(0, 10, (200, 3)))
    code, answer = run(tmp_path / "plain.xyz", capsys, "--plane", "1,0,0,5")
    assert code == 0
    assert (read_points(tmp_path / "out.ply").points_mm[:, 0] >= 5).all() and answer["removed"]["plane"] > 50


def test_a_filtered_stitched_cloud_still_names_its_views(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    points = np.random.default_rng(1).uniform(0, 10, (100, 3))
    normals, view = np.tile([0.0, 0, 1], (100, 1)), np.arange(100) % 3
    names = ("front", "the back side", "top")
    write_cloud(
        tmp_path / "all.ply",
        StitchedCloud(points, normals, np.full(100, 0.02), np.full(100, 0.5), view, (), "part", view_names=names),
    )
    code, _ = run(tmp_path / "all.ply", capsys, "--box", "0,5,0,10,0,10")
    kept = read_stitched(tmp_path / "out.ply")
    assert code == 0 and kept.view_names == names and 0 < len(kept) < 100
    assert np.array_equal(kept.view, view[points[:, 0] <= 5])
