"""The whole job on the virtual rig, as the command line runs it."""

from __future__ import annotations

import csv
from collections.abc import Mapping
from math import degrees, hypot
from pathlib import Path

import numpy as np
import pytest
from demo_fixture import Demo

from measureapp.data.dimension import Verdict
from measureapp.inspection.surface.deviation import signed_distances
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.project.geometry.files import read_mesh, read_stitched

DIMENSION_LIMIT_MM = 0.1
RMS_LIMIT_MM = 0.12  # at a quarter of the resolution, where a pixel is 2 mm² large
BIAS_LIMIT_MM = RMS_LIMIT_MM / 4
FLOAT32_MM = 1e-4  # what a PLY file rounds coordinates of this size to, and then some
SIGMAS = 3.0


def norm(deviations: Mapping[str, float], *names: str) -> float:
    return float(np.linalg.norm([deviations[name] for name in names]))


def test_it_answers_with_every_key_that_is_promised(demo: Demo) -> None:
    document = demo.document
    assert {"calibration", "views", "stitch", "dimensions", "truth_deviation", "timings", "files"} <= document.keys()
    assert set(document["files"]) >= {"project", "stitched_cloud", "mesh", "truth_mesh", "report_pdf", "report_csv"}
    assert {"rms", "p95", "bias"} <= document["truth_deviation"].keys()
    assert {"axis", "cameras", "guide", "hand_eye", "truth"} <= document["calibration"].keys()
    for dimension in document["dimensions"]:
        assert {"name", "nominal", "measured", "error", "relative_error", "uncertainty", "verdict"} <= dimension.keys()
    assert demo.messages == ""


def test_all_views_were_taken_and_stitched(demo: Demo) -> None:
    assert [view["name"] for view in demo.document["views"]] == list(demo.project.stored_viewpoints())
    assert len(demo.document["views"]) == 6
    assert [view["verdict"] for view in demo.document["views"]] == ["good"] * 6
    assert demo.document["stitch"]["views_used"] == 6


def test_every_dimension_is_within_a_tenth_of_a_millimetre_and_no_further_off_than_its_uncertainty_says(demo: Demo) -> None:
    assert [dimension["name"] for dimension in demo.document["dimensions"]] == ["a", "b", "c", "d"]
    for dimension in demo.document["dimensions"]:
        assert abs(dimension["error"]) <= DIMENSION_LIMIT_MM
        assert dimension["error"] == pytest.approx(dimension["measured"] - dimension["nominal"])
        assert dimension["relative_error"] == pytest.approx(dimension["error"] / dimension["nominal"])
        assert abs(dimension["error"]) <= SIGMAS / 2 * dimension["uncertainty"]  # stated for two standard deviations


def test_the_exit_code_is_the_verdict(demo: Demo) -> None:
    passed = all(dimension["verdict"] == Verdict.PASS.value for dimension in demo.document["dimensions"])
    assert demo.code == (0 if passed else 1)


def test_the_cloud_lies_on_the_true_surface(demo: Demo) -> None:
    deviation = demo.document["truth_deviation"]
    assert deviation["rms"] <= RMS_LIMIT_MM
    assert abs(deviation["bias"]) <= BIAS_LIMIT_MM
    assert abs(deviation["bias"]) <= deviation["rms"]
    assert deviation["points"] == demo.document["stitch"]["points"] > 50_000


def test_the_figure_without_fine_stitching_stands_beside_it(demo: Demo) -> None:
    by_axes = demo.document["truth_deviation"]["kinematic_only"]
    assert {"rms", "p95", "bias"} <= by_axes.keys()
    assert 0 < by_axes["rms"] < 1  # the calibrated chain alone stays below the largest error that fine stitching may undo


def test_the_true_mesh_lies_in_the_frame_of_the_cloud(demo: Demo) -> None:
    files, deviation = demo.document["files"], demo.document["truth_deviation"]
    cloud = read_stitched(Path(files["stitched_cloud"]))
    surface = read_mesh(Path(files["truth_mesh"]))
    distances = signed_distances(cloud.points_mm, NominalSurface(surface))
    assert len(cloud) == deviation["points"]
    assert np.sqrt(np.mean(distances**2)) == pytest.approx(deviation["rms"], abs=FLOAT32_MM)
    assert np.mean(distances) == pytest.approx(deviation["bias"], abs=FLOAT32_MM)
    assert np.percentile(np.abs(distances), 95) == pytest.approx(deviation["p95"], abs=FLOAT32_MM)


def test_the_mesh_can_be_read_back_and_lies_on_the_true_surface_where_it_was_measured(demo: Demo) -> None:
    mesh = read_mesh(Path(demo.document["files"]["mesh"]))
    assert mesh.frame == "part"
    assert mesh.measured is not None
    surface = NominalSurface(read_mesh(Path(demo.document["files"]["truth_mesh"])))
    distances = np.abs(signed_distances(mesh.vertices_mm[mesh.measured], surface))
    assert np.median(distances) <= RMS_LIMIT_MM
    assert len(mesh.triangles) == demo.document["triangles"]


def test_the_cameras_are_within_three_standard_deviations_of_the_hidden_ones(demo: Demo) -> None:
    calibration = demo.document["calibration"]
    for name, true in calibration["truth"]["cameras"].items():
        sigma = calibration["cameras"][name]["standard_deviations"]
        assert abs(true["focal_error_px"]) <= SIGMAS * sigma["fx"]
        assert abs(true["centre_error_px"][0]) <= SIGMAS * sigma["cx"]
        assert abs(true["centre_error_px"][1]) <= SIGMAS * sigma["cy"]
        if name != "left":  # the reference, whose frame all others are given in
            assert true["position_error_mm"] <= SIGMAS * norm(sigma, "x_mm", "y_mm", "z_mm")
            assert true["direction_error_deg"] <= SIGMAS * degrees(norm(sigma, "rotation_x_rad", "rotation_y_rad", "rotation_z_rad"))


def test_the_rig_is_within_three_standard_deviations_of_the_hidden_one(demo: Demo) -> None:
    found, true = demo.document["calibration"], demo.document["calibration"]["truth"]
    lens = found["cameras"]["left"]["standard_deviations"]
    frame_rad = norm(lens, "cx", "cy") / true["cameras"]["left"]["true_focal_px"]  # turns the reference camera's frame itself
    hand_eye, guide, axis = found["hand_eye"], found["guide"], found["axis"]
    assert true["hand_eye"]["direction_error_deg"] <= SIGMAS * degrees(hypot(hand_eye["rotation_sigma_rad"], frame_rad))
    assert true["hand_eye"]["position_error_mm"] <= SIGMAS * hand_eye["translation_sigma_mm"]
    assert true["guide"]["direction_error_deg"] <= SIGMAS * degrees(guide["direction_sigma_rad"])
    assert abs(true["guide"]["scale_error"]) <= SIGMAS * guide["scale_sigma"]
    assert true["axis"]["direction_error_deg"] <= SIGMAS * degrees(axis["direction_sigma_rad"])
    assert true["axis"]["position_error_mm"] <= SIGMAS * axis["point_sigma_mm"]


def test_the_standard_deviations_are_small_enough_to_mean_something(demo: Demo) -> None:
    calibration = demo.document["calibration"]
    for camera in calibration["cameras"].values():
        assert camera["standard_deviations"]["fx"] < 0.5  # of 1000 px
        assert camera["rms_px"] < 0.1
    assert calibration["hand_eye"]["translation_sigma_mm"] < 0.5
    assert calibration["axis"]["point_sigma_mm"] < 0.5
    assert calibration["guide"]["scale_sigma"] < 1e-4


def test_the_report_is_a_pdf_and_a_table_of_the_same_dimensions(demo: Demo) -> None:
    files = demo.document["files"]
    assert Path(files["report_pdf"]).read_bytes().startswith(b"%PDF")
    rows = list(csv.DictReader(Path(files["report_csv"]).read_text(encoding="utf-8-sig").splitlines()))
    assert [row["name"] for row in rows] == [dimension["name"] for dimension in demo.document["dimensions"]]
    for row, dimension in zip(rows, demo.document["dimensions"], strict=True):
        assert float(row["measured"]) == pytest.approx(dimension["measured"], abs=1e-3)
        assert row["verdict"] == dimension["verdict"]


def test_the_stored_measurement_says_what_was_printed(demo: Demo) -> None:
    measurement = demo.project.measurement()
    assert measurement is not None and measurement.inspection is not None
    printed = {dimension["name"]: dimension for dimension in demo.document["dimensions"]}
    for dimension in measurement.inspection.dimensions:
        assert dimension.measured == pytest.approx(printed[dimension.name]["measured"], abs=1e-9)
        assert dimension.verdict.value == printed[dimension.name]["verdict"]
    assert [view.viewpoint_id for view in measurement.views] == [view["name"] for view in demo.document["views"]]
    assert len(measurement.stitched) == demo.document["points"]
