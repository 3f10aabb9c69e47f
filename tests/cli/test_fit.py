from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from measureapp.cli.main import main


@pytest.fixture
def cone(tmp_path: Path) -> Path:
    rng = np.random.default_rng(1)
    a, h = rng.uniform(0, 6, 200), rng.uniform(-10, 10, 200)
    radius = 30 - h * np.tan(np.radians(20))
    path = tmp_path / "cone.txt"
    np.savetxt(path, np.column_stack([radius * np.cos(a), radius * np.sin(a), h]))
    return path


def test_a_fit_answers_in_one_json_document(cone: Path, capsys: pytest.CaptureFixture[str]):
    assert main(["fit", "cone", str(cone), "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert answer["half_angle_deg"] == pytest.approx(20, abs=1e-9)
    assert answer["radius_mm"] == pytest.approx(30 - answer["point_mm"][2] * np.tan(np.radians(20)), abs=1e-9)
    assert {"form_error_mm", "rms_mm", "direction", "standard_deviations", "left_out"} <= answer.keys()
    assert "half_angle_deg" in answer["standard_deviations"]


def test_a_fit_answers_people_too(cone: Path, capsys: pytest.CaptureFixture[str]):
    assert main(["fit", "plane", str(cone), "--robust"]) == 0
    assert "form_error_mm" in capsys.readouterr().out


def test_a_minimum_zone_is_narrower_than_least_squares(cone: Path, capsys: pytest.CaptureFixture[str]):
    widths = []
    for criterion in ("least-squares", "minimum-zone"):
        assert main(["fit", "plane", str(cone), "--criterion", criterion, "--json"]) == 0
        widths.append(json.loads(capsys.readouterr().out)["form_error_mm"])
    assert widths[1] < widths[0]


def test_a_minimum_zone_shows_its_proof(cone: Path, capsys: pytest.CaptureFixture[str]):
    assert main(["fit", "circle", str(cone), "--criterion", "minimum-zone", "--json"]) == 0
    proof = json.loads(capsys.readouterr().out)["proof"]
    assert len(proof["contacts"]) == len(proof["shares"]) >= 3
    assert sum(proof["shares"]) == pytest.approx(1) and proof["imbalance"] < 1e-7
    assert main(["fit", "line", str(cone), "--criterion", "minimum-zone"]) == 0
    assert "proof" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("content", "arguments", "said"),
    [
        ("1 2 3\n4 5 6\n", ["plane"], "at least 3 points"),
        ("1 2 3\n4 five 6\n7 8 9\n", ["plane"], "line 2"),
        ("", ["plane"], "empty"),
        ("1 2\n3 4\n", ["plane"], "line 1"),
        ("0 0 0\n1 1 1\n2 2 2\n", ["circle"], "do not determine"),
        ("0 0 0\n1 1 1\n2 2 2\n", ["circle", "--criterion", "minimum-zone"], "do not determine"),
        ("0 0 0\n1 0 0\n0 1 0\n", ["circle", "--criterion", "minimum-zone", "--robust"], "contains all points"),
    ],
)
def test_bad_points_are_refused_in_words(tmp_path: Path, capsys: pytest.CaptureFixture[str], content: str, arguments: list[str], said: str):
    path = tmp_path / "points.txt"
    path.write_text(content)
    assert main(["fit", arguments[0], str(path), *arguments[1:], "--json"]) == 2
    refusal = json.loads(capsys.readouterr().out)["error"]
    assert said in refusal["message"] and refusal["hint"]


def test_any_ending_may_hold_points(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    path = tmp_path / "points.dat"
    path.write_text("0 0 1\n1 0 1\n0 1 1\n1 1 1\n")
    assert main(["fit", "plane", str(path)]) == 0
    assert main(["fit", "plane", str(tmp_path / "none.dat")]) == 2
    assert "Traceback" not in capsys.readouterr().err


@pytest.mark.parametrize("separator", [";", "\t", " "])
def test_decimal_commas_are_read_as_spreadsheets_write_them(cone: Path, capsys: pytest.CaptureFixture[str], separator: str) -> None:
    cone.write_text("0 0 0\n" + cone.read_text(), encoding="utf-8")
    assert main(["fit", "cone", str(cone), "--json"]) == 0
    expected = json.loads(capsys.readouterr().out)
    written = cone.with_name("commas.csv")
    written.write_text("x;y;z\n".replace(";", separator) + cone.read_text().replace(" ", separator).replace(".", ","), encoding="utf-8")
    assert main(["fit", "cone", str(written), "--json"]) == 0
    assert json.loads(capsys.readouterr().out) == expected


def test_as_many_points_as_the_shape_needs_prove_no_precision(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    three = tmp_path / "three.txt"
    three.write_text("10 0 0\n0 10 0\n-10 0 0\n", encoding="utf-8")
    assert main(["fit", "circle", str(three), "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert answer["radius_mm"] == pytest.approx(10) and answer["standard_deviations"] is None and answer["covariance"] is None
    assert main(["fit", "circle", str(three)]) == 0
    assert "not determined" in capsys.readouterr().out


def test_points_without_coordinates_are_counted(cone: Path, capsys: pytest.CaptureFixture[str]) -> None:
    cone.write_text(cone.read_text() + "nan nan nan\n1e300 0 0\n", encoding="utf-8")
    assert main(["fit", "cone", str(cone), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["without_coordinates"] == 2
    assert main(["fit", "cone", str(cone)]) == 0
    assert "2 points of the file have no finite coordinates" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("header", "columns", "arguments"),
    [
        ("x_mm,y_mm,z_mm", "xyz", []),
        ("id;Z [mm];X [mm];Y [mm]", "nzxy", []),
        ("# z y x", "zyx", []),
        ("point, quality, x (inch), y (inch), z (inch)", "nnxyz", ["--unit", "inch"]),
    ],
)
def test_columns_are_read_by_their_names(tmp_path: Path, capsys: pytest.CaptureFixture[str], header, columns, arguments):
    angles = np.linspace(0, 6, 50)
    known = {"x": 10 * np.cos(angles), "y": 20 + 10 * np.sin(angles), "z": np.full(50, 5.0), "n": np.arange(50.0)}
    between = ";" if ";" in header else "," if "," in header else " "
    path = tmp_path / "points.csv"
    np.savetxt(path, np.column_stack([known[one] for one in columns]), delimiter=between, header=header, comments="")
    assert main(["fit", "circle", str(path), "--json", *arguments]) == 0
    answer, scale = json.loads(capsys.readouterr().out), 25.4 if arguments else 1.0
    assert answer["radius_mm"] == pytest.approx(10 * scale)
    assert answer["point_mm"] == pytest.approx([0, 20 * scale, 5 * scale], abs=1e-9)


@pytest.mark.parametrize("name", ["points.csv", "points.dat"])
@pytest.mark.parametrize(
    ("header", "arguments", "said"),
    [
        ("X [inch],Y [inch],Z [inch]", [], "Give --unit inch."),
        ("x_mm,y_mm,z_mm", ["--unit", "inch"], "are in millimetres, not in inches"),
        ("x_mm,y_mm,z_in", [], "not one unit of length: x [mm], y [mm], z [in]"),
        ("x_px,y_px,z_px", [], "not one unit of length"),
    ],
)
def test_a_unit_in_the_header_that_contradicts_is_refused(tmp_path: Path, capsys, name, header, arguments, said):
    path = tmp_path / name
    path.write_text(f"{header}\n0,0,0\n1,0,0\n0,1,0\n1,1,0\n", encoding="utf-8")
    assert main(["fit", "plane", str(path), *arguments]) == 2
    assert said in capsys.readouterr().err
