from __future__ import annotations

import csv
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from measureapp.cli import main
from measureapp.data.cloud import PointCloud
from measureapp.geometry.transform import RigidTransform
from measureapp.inspection.measured_points import sample_mesh
from measureapp.project.geometry.files import read_mesh, write_cloud, write_mesh
from measureapp.project.geometry.ply import read_ply
from measureapp.resources import resource

NOMINAL = resource("parts/gypsum/nominal.stl")
PLACED = RigidTransform.from_vector([0.01, -0.02, 0.5], [10, -5, 3], "part", "nominal")


@pytest.fixture(scope="module")
def cloud(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("clouds") / "cloud.xyz"
    points = sample_mesh(read_mesh(NOMINAL), 30_000)
    assert points.normals is not None
    noisy = points.points_mm + np.random.default_rng(1).normal(0, 0.02, (len(points), 1)) * points.normals
    np.savetxt(path, PLACED.apply(noisy), fmt="%.6f")
    return path


def answer(capsys: pytest.CaptureFixture[str], *arguments: str) -> dict:
    assert main(["compare", *arguments, "--json"]) == 0
    return json.loads(capsys.readouterr().out)


def test_a_best_fit_finds_the_part_and_leaves_the_noise(cloud: Path, capsys) -> None:
    document = answer(capsys, str(cloud), str(NOMINAL))
    assert set(document["deviation_mm"]) == {"mean", "rms", "p95", "min", "max"}
    assert document["deviation_mm"]["rms"] == pytest.approx(0.02, rel=0.1)
    assert document["unmeasured_share"] < 0.01
    assert document["alignment"]["name"] == "best fit"
    back = np.array(document["alignment"]["matrix"]) @ PLACED.matrix
    half_turn = np.diag([-1.0, -1.0, 1.0, 1.0])
    assert min(np.abs(back - np.eye(4)).max(), np.abs(back - half_turn).max()) < 0.01


@pytest.mark.parametrize("as_json", [True, False])
def test_a_given_alignment_is_used_and_named(as_json: bool, cloud: Path, tmp_path: Path, capsys) -> None:
    path = tmp_path / "matrix.txt"
    matrix = PLACED.inverse().matrix
    if as_json:
        path.write_text(json.dumps({"matrix": matrix.tolist()}))
    else:
        np.savetxt(path, matrix)
    document = answer(capsys, str(cloud), str(NOMINAL), "--align", str(path))
    assert document["alignment"]["name"] == "given: matrix.txt"
    assert document["deviation_mm"]["rms"] == pytest.approx(0.02, rel=0.1)


def test_without_alignment_the_displacement_is_seen(cloud: Path, capsys) -> None:
    document = answer(capsys, str(cloud), str(NOMINAL), "--align", "none")
    assert document["alignment"]["name"].startswith("none")
    assert document["deviation_mm"]["max"] > 1


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ("1 2 3", "16 finite numbers"),
        ("a b", "numbers only"),
        ("2 0 0 0 0 2 0 0 0 0 2 0 0 0 0 1", "not a rigid transform"),
        ("[1, {}]", "numbers only"),
    ],
)
def test_a_matrix_that_is_none_is_refused(text: str, complaint: str, cloud: Path, tmp_path: Path, capsys) -> None:
    path = tmp_path / "matrix.txt"
    path.write_text(text)
    assert main(["compare", str(cloud), str(NOMINAL), "--align", str(path)]) == 2
    err = capsys.readouterr().err
    assert complaint in err and "matrix.txt" in err


def test_a_nominal_that_does_not_exist_is_refused(cloud: Path, capsys) -> None:
    assert main(["compare", str(cloud), "absent.stl"]) == 2
    assert "absent.stl" in capsys.readouterr().err


def test_an_unknown_alignment_is_refused(cloud: Path, capsys) -> None:
    assert main(["compare", str(cloud), str(NOMINAL), "--align", "best"]) == 2
    assert "best-fit" in capsys.readouterr().err


def test_sections_bands_and_the_coloured_nominal_are_written(cloud: Path, tmp_path: Path, capsys) -> None:
    table, document, coloured = tmp_path / "s.csv", tmp_path / "s.json", tmp_path / "map.ply"
    where = ("--section", "z=20", "--section", "r=30")
    told = answer(
        capsys, str(cloud), str(NOMINAL), *where, "--section-file", str(table), "--tolerance", "-0.02", "0.02", "--map", str(coloured)
    )
    assert told["bands"]["within"] == pytest.approx(0.683, abs=0.02)
    assert sum(told["bands"]["counts"]) == told["points"]
    with table.open() as file:
        rows = list(csv.DictReader(file))
    measured = [row for row in rows if row["section"] == "z=20" and row["curve"] == "measured"]
    assert {row["section"] for row in rows} == {"z=20", "r=30"}
    assert all(float(row["z_mm"]) == pytest.approx(20, abs=1e-5) for row in rows if row["section"] == "z=20")
    assert np.std([float(row["deviation_mm"]) for row in measured]) == pytest.approx(0.02, rel=5 / np.sqrt(2 * len(measured)))
    vertex = read_ply(coloured).elements["vertex"]
    assert {"deviation_mm", "measured", "red"} <= set(vertex) and vertex["measured"].mean() > 0.95
    answer(capsys, str(cloud), str(NOMINAL), *where, "--section-file", str(document))
    stored = json.loads(document.read_text())
    assert stored["alignment"] == "best fit" and len(stored["sections"]) == 2


@pytest.mark.parametrize(
    ("options", "complaint"),
    [
        (("--section", "q=3"), "is not a section"),
        (("--section", "z=500"), "intersects neither"),
        (("--section", "z=20", "--section-file", "s.xls"), "Sections cannot be written"),
        (("--map", "m.stl"), "does not end in .ply"),
        (("--align", "cyclic:one"), "must be 2 to 1000"),
        (("--tolerance", "0.1", "-0.1"), "is empty"),
    ],
)
def test_what_cannot_be_written_is_refused(options: tuple[str, ...], complaint: str, cloud: Path, capsys) -> None:
    assert main(["compare", str(cloud), str(NOMINAL), *options]) in (2, 3, 4)
    assert complaint in capsys.readouterr().err


@pytest.mark.parametrize("align", ["best-fit", "matrix"])
def test_another_unit_of_cloud_or_nominal_is_asked_about_and_taken_once_it_is_said(align: str, cloud: Path, tmp_path: Path, capsys) -> None:
    inches, matrix = tmp_path / "inches.xyz", tmp_path / "matrix.txt"
    np.savetxt(inches, np.loadtxt(cloud) / 25.4, fmt="%.7f")
    np.savetxt(matrix, PLACED.inverse().matrix)
    how = ["--align", "best-fit" if align == "best-fit" else str(matrix)]
    if align == "best-fit":  # a matrix moves inches by millimetres: nothing then tells the unit but the size
        assert main(["compare", str(inches), str(NOMINAL), *how]) == 2
        assert "`--unit inch`" in capsys.readouterr().err
    assert answer(capsys, str(inches), str(NOMINAL), *how, "--unit", "inch")["deviation_mm"]["rms"] == pytest.approx(0.02, rel=0.1)
    metres = tmp_path / "metres.ply"
    surface = read_mesh(NOMINAL)
    write_mesh(metres, replace(surface, vertices_mm=surface.vertices_mm / 1000))
    if align == "best-fit":
        assert main(["compare", str(cloud), str(metres), *how]) == 2
        assert "`--nominal-unit m`" in capsys.readouterr().err
    told = answer(capsys, str(cloud), str(metres), *how, "--nominal-unit", "m")
    assert told["deviation_mm"]["rms"] == pytest.approx(0.02, rel=0.1)


def test_points_in_place_but_in_inches_are_asked_about(tmp_path: Path, capsys) -> None:
    path = tmp_path / "inches.xyz"
    np.savetxt(path, sample_mesh(read_mesh(NOMINAL), 5000).points_mm / 25.4, fmt="%.7f")
    assert main(["compare", str(path), str(NOMINAL), "--align", "none"]) == 2
    assert "look like inches" in capsys.readouterr().err


def test_a_file_of_our_own_is_in_millimetres_and_nothing_else(tmp_path: Path, capsys) -> None:
    path = tmp_path / "ours.ply"
    points = sample_mesh(read_mesh(NOMINAL), 500)
    count = len(points)
    flat = (np.full(count, 0.02), np.zeros(count), np.zeros((count, 2)), np.ones(count))
    write_cloud(path, PointCloud(points.points_mm, points.normals, *flat, "part", "v"))
    assert main(["compare", str(path), str(NOMINAL), "--unit", "inch"]) == 2
    assert "written by MeasureApp, in millimetres" in capsys.readouterr().err


def test_statistics_name_confirmed_extremes_the_range_and_areas_without_data(cloud: Path, capsys) -> None:
    document = answer(capsys, str(cloud), str(NOMINAL), "--tolerance", "-0.1", "0.1")
    found = document["deviation_statistics"]
    assert found["range_mm"] == [-0.2, 0.2] and found["tolerance_mm"] == [-0.1, 0.1]
    assert found["below"] + found["inside"] + found["above"] == pytest.approx(1.0)
    assert found["no_data"]["filled"] == 0.0 and found["no_data"]["not_seen"] < 0.01
    assert found["maximum"]["neighbours"] >= 5 and document["deviation_mm"]["min"] <= found["minimum"]["value_mm"] < 0
    assert main(["compare", str(cloud), str(NOMINAL)]) == 0
    assert "Confirmed by neighbours" in capsys.readouterr().out


def test_root_mean_squares_have_no_sign_and_extremes_say_of_which_points_they_are(cloud: Path, capsys) -> None:
    assert main(["compare", str(cloud), str(NOMINAL)]) == 0
    said = capsys.readouterr().out
    assert "rms +" not in said and "p95 +" not in said and "-0.000" not in said
    assert "Deviation of all " in said and "Confirmed by neighbours, as in reports: " in said
    document = answer(capsys, str(cloud), str(NOMINAL))
    every = document["deviation_statistics"]["all_points_mm"]
    assert every == {name: document["deviation_mm"][name] for name in ("min", "max")}
    assert every["min"] <= document["deviation_statistics"]["minimum"]["value_mm"]
