from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from measureapp.cli import main
from measureapp.inspection.measured_points import sample_mesh
from measureapp.project.geometry.files import read_mesh
from measureapp.resources import resource

PROGRAM = resource("parts/gypsum/program.toml")


@pytest.fixture(scope="module")
def clouds(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    folder = tmp_path_factory.mktemp("clouds")
    points = sample_mesh(read_mesh(resource("parts/gypsum/nominal.stl")), 40_000)
    rng = np.random.default_rng(2)
    seen = points.points_mm[points.points_mm[:, 2] > 0.01] + rng.normal(0, 0.01, (int(np.sum(points.points_mm[:, 2] > 0.01)), 3))
    made = {"good": seen, "grown": seen * [1.002, 1.0, 1.0], "metres": seen / 1000, "inches": seen / 25.4}
    for name, values in made.items():
        np.savetxt(folder / f"{name}.xyz", values, fmt="%.6f")
    return {name: folder / f"{name}.xyz" for name in made}


def test_measuring_a_good_part_answers_its_dimensions_and_ends_with_0(clouds, capsys) -> None:
    assert main(["measure", str(clouds["good"]), str(PROGRAM), "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert [dimension["name"] for dimension in document["dimensions"]] == ["a", "b", "c", "d"]
    assert all(dimension["verdict"] == "pass" and abs(dimension["error"]) < 0.01 for dimension in document["dimensions"])
    assert document["alignment"]["name"] == "best fit"
    assert "ISO 14253-1" in document["verdict_rule"]


def test_the_uncertainty_of_all_lengths_can_be_stated(clouds, capsys) -> None:
    shares = []
    for scale_ppm in ("0", "50"):
        assert main(["measure", str(clouds["good"]), str(PROGRAM), "--json", "--scale-ppm", scale_ppm]) == 0
        shares.append({one["name"]: one["uncertainty_budget"].get("scale") for one in json.loads(capsys.readouterr().out)["dimensions"]})
    assert set(shares[0].values()) == {None}
    assert shares[1]["a"] == pytest.approx(2 * 50e-6 * 180, rel=1e-3)
    for rubbish in ("-1", "nan", "inf", "1e9"):
        assert main(["measure", str(clouds["good"]), str(PROGRAM), "--scale-ppm", rubbish]) == 2


def test_a_dimension_out_of_tolerance_ends_with_1(clouds, capsys) -> None:
    assert main(["measure", str(clouds["grown"]), str(PROGRAM)]) == 1
    out = capsys.readouterr().out
    assert "✗ a" in out and "✓ b" in out


def test_a_cloud_in_metres_is_bad_input_and_the_unit_is_named(clouds, capsys) -> None:
    assert main(["measure", str(clouds["metres"]), str(PROGRAM), "--json"]) == 2
    error = json.loads(capsys.readouterr().out)["error"]
    assert error["type"] == "UnitQuestion" and "metres" in error["message"] and error["hint"]


@pytest.mark.parametrize("how", ["best-fit", "none"])
def test_a_cloud_in_inches_is_asked_about_and_measured_once_it_is_said(how: str, clouds, capsys) -> None:
    asked = ["measure", str(clouds["inches"]), str(PROGRAM), "--alignment", how, "--json"]
    assert main(asked) == 2
    error = json.loads(capsys.readouterr().out)["error"]
    assert "look like inches" in error["message"] and "`--unit inch`" in error["hint"]
    assert main([*asked, "--unit", "inch"]) == 0
    said = json.loads(capsys.readouterr().out)
    assert main(["measure", str(clouds["good"]), str(PROGRAM), "--alignment", how, "--json"]) == 0
    plain = json.loads(capsys.readouterr().out)
    for one, other in zip(said["dimensions"], plain["dimensions"], strict=True):
        assert one["measured"] == pytest.approx(other["measured"], abs=2e-4)  # six decimals of an inch in the file
    assert main([*asked, "--unit", "m"]) != 0  # said, but not so


def test_a_missing_program_is_bad_input(clouds, capsys) -> None:
    assert main(["measure", str(clouds["good"]), "absent.toml"]) == 2
    assert "absent.toml" in capsys.readouterr().err


def test_geometrical_tolerances_are_answered_with_their_datums_and_origin(tmp_path, capsys) -> None:
    folder, program = resource("parts/gear"), tmp_path / "position.toml"
    described, *dimensions = (folder / "tolerances.toml").read_text(encoding="utf-8").split("[[dimensions]]")
    asked = next(one for one in dimensions if 'name = "boss_position"\n' in one).partition("#")[0]
    features = [one for one in described.split("[[features]]") if 'name = "teeth"' not in one]
    program.write_text("[[dimensions]]".join(["[[features]]".join(features), asked]), encoding="utf-8")
    (tmp_path / "nominal.stl").write_bytes((folder / "nominal.stl").read_bytes())
    assert main(["measure", str(folder / "nominal.stl"), str(program), "--json"]) == 0
    found = {entry["name"]: entry for entry in json.loads(capsys.readouterr().out)["dimensions"]}
    position = found["boss_position"]
    assert position["kind"] == "position" and position["datums"] == ["gear face", "bore"]
    assert position["tolerance"] == [0.0, 0.2] and position["nominal"] == 0.0
    assert "datums gear face|bore" in position["origin"] and "points" in position["origin"]


def test_the_alignment_can_be_chosen_and_is_named(clouds, capsys) -> None:
    main(["measure", str(clouds["good"]), str(PROGRAM), "--alignment", "none", "--json"])
    assert json.loads(capsys.readouterr().out)["alignment"]["name"].startswith("none")
    assert main(["measure", str(clouds["good"]), str(PROGRAM), "--alignment", "cyclic:2"]) == 0
    assert "Alignment: best fit, 2 positions about the axis" in capsys.readouterr().out


@pytest.mark.parametrize("words", ["nearest", "datums:nothing", "rps:a"])
def test_an_alignment_that_is_none_is_refused(words: str, clouds, capsys) -> None:
    assert main(["measure", str(clouds["good"]), str(PROGRAM), "--alignment", words]) == 2
    err = capsys.readouterr().err
    assert f"--alignment {words}" in err and "3-2-1:PLANE,LINE,POINT" in err


GROWN = """
name = "grown faces"
alignment = "none"
[[features]]
name = "face"
shape = "plane"
grow = { seed_mm = [50, 0, 30] }
[[features]]
name = "bore"
shape = "cylinder"
grow = { seed_mm = [20, 0, 15] }
[[dimensions]]
name = "bore_diameter"
kind = "diameter"
features = ["bore"]
nominal = 40
"""


def test_features_grown_from_a_seed_are_answered_with_their_points_and_why_they_stopped(tmp_path, capsys) -> None:
    program = tmp_path / "grown.toml"
    program.write_text(GROWN)
    assert main(["measure", str(resource("parts/gear/nominal.stl")), str(program), "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    features = {entry["name"]: entry for entry in document["features"]}
    assert features["face"]["shape"] == "plane" and features["bore"]["radius_mm"] == pytest.approx(20, abs=0.01)
    assert "grown from seed to" in features["face"]["how"] and "border: " in features["face"]["how"]
    assert features["bore"]["how"] in document["dimensions"][0]["origin"]


def test_a_seed_beside_the_part_leaves_the_dimension_unmeasured_with_the_reason(tmp_path, capsys) -> None:
    program = tmp_path / "grown.toml"
    program.write_text(GROWN.replace("[20, 0, 15]", "[0, 0, 15]"))
    assert main(["measure", str(resource("parts/gear/nominal.stl")), str(program)]) == 1
    assert "not measured: bore: no measured surface lies within 2 mm of its seed" in capsys.readouterr().out


WORKBENCH = """
schema_version = 1
name = "workbench"
alignment = "none"
[[alignments]]
name = "on top"
alignment = "datums:arm tops"
[[features]]
name = "arm tops"
shape = "plane"
point_mm = [0, 0, 50]
direction = [0, 0, 1]
[[features]]
name = "end"
shape = "plane"
point_mm = [90, 0, 25]
direction = [1, 0, 0]
[[features]]
name = "edge"
shape = "edge"
point_mm = [90, 0, 50]
direction = [0, 1, 0]
normals = [[0, 0, 1], [1, 0, 0]]
length_mm = 40
strip_mm = 8
[[features]]
name = "raised"
shape = "offset"
of = ["arm tops"]
distance_mm = 10
[[dimensions]]
name = "gap"
kind = "distance"
features = ["raised", "arm tops"]
nominal = 10
tolerance = ""
[[dimensions]]
name = "edge height"
kind = "distance"
features = ["edge", "raised"]
nominal = 10
tolerance = "2768-c"
alignment = "on top"
[[dimensions]]
name = "flat"
kind = "flatness"
features = ["end"]
tolerance = "max 0.05"
"""


def test_texts_of_tolerances_edges_and_further_alignments_are_measured_from_a_file(clouds, tmp_path, capsys) -> None:
    (tmp_path / "program.toml").write_text(WORKBENCH, encoding="utf-8")
    assert main(["measure", str(clouds["good"]), str(tmp_path / "program.toml"), "--json"]) in (0, 1)
    document = json.loads(capsys.readouterr().out)
    gap, height, flat = document["dimensions"]
    assert gap["verdict"] == "no tolerance" and gap["tolerance"] == [None, None] and gap["measured"] == pytest.approx(10)
    assert height["tolerance_source"] == "2768-c" and height["tolerance"] == [-0.5, 0.5] and height["alignment"] == "on top"
    assert height["measured"] == pytest.approx(10, abs=0.02)
    assert flat["tolerance"] == [0.0, 0.05]
    assert document["alignments"]["on top"]["fixed"] == 3 and document["alignments"]["on top"]["method"] == "datums"
    assert main(["measure", str(clouds["good"]), str(tmp_path / "program.toml")]) in (0, 1)
    said = capsys.readouterr().out
    assert "no tolerance" in said and "2768-c" in said and "3 of 6 degrees of freedom" in said


def test_an_unknown_alignment_lists_the_known_ones_once(tmp_path: Path, capsys) -> None:
    program = tmp_path / "program.toml"
    program.write_text('name = "p"\n', encoding="utf-8")
    assert main(["measure", "cloud.ply", str(program), "--alignment", "egg"]) == 2
    said = capsys.readouterr().err
    assert said.count("best-fit") == 1 and "'egg' is not an alignment" in said
