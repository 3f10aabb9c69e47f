"""`cameras.json` and the tables: what is written is read back, and what is wrong is named."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest

from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration, LabelledCovariance, Provenance
from measureapp.errors import InputError
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform
from measureapp.project.calibration.board_images import find_board_images
from measureapp.project.calibration.camera_file import cameras_document, read_cameras, write_cameras
from measureapp.project.tables import natural_order, read_angles, read_corners, read_guide, read_poses, require_millimetres, write_poses

MATRIX = np.array([[2045.5, 0, 650], [0, 2044.25, 480], [0, 0, 1]])


@pytest.fixture
def calibration() -> CameraArrayCalibration:
    lens = PinholeCamera(1296, 972, MATRIX, np.array([-0.1, 0.05, 0.001, -0.002, 0.01]))
    right = RigidTransform.from_vector([0, -0.6, 0.01], [330.5, 0.25, 105.125], "camera", "right")
    return CameraArrayCalibration(
        "left",
        {
            "left": CameraCalibration("left", lens, RigidTransform.identity("camera", "left"), {"fx": 0.25}, 0.125, "SN1", blur_px=0.75),
            "right": CameraCalibration("right", lens, right),
        },
        {"left-right": 0.19},
        Provenance("2030-01-02T03:04:05+00:00", "bundle", {"left01.png": "abc"}),
        marks_rms_mm=0.026,
    )


def test_a_written_calibration_reads_back_as_it_was(calibration, tmp_path):
    path = tmp_path / "cameras.json"
    write_cameras(path, calibration)
    again = read_cameras(path)
    assert again.marks_rms_mm == calibration.marks_rms_mm
    assert cameras_document(again) == cameras_document(calibration)
    assert [entry.name for entry in tmp_path.iterdir()] == ["cameras.json"]


def with_covariance(calibration):
    covariance = LabelledCovariance(("left.fx", "right.x_mm"), np.array([[0.0625, 0.01], [0.01, 0.04]]))
    return replace(calibration, covariance=covariance)


def test_the_covariance_of_the_cameras_reads_back_bit_for_bit(calibration, tmp_path):
    write_cameras(tmp_path / "cameras.json", with_covariance(calibration))
    again = read_cameras(tmp_path / "cameras.json").covariance
    assert again.parameters == ("left.fx", "right.x_mm")
    np.testing.assert_array_equal(again.covariance, with_covariance(calibration).covariance.covariance)


def test_files_of_version_1_are_still_read_and_have_no_covariance(calibration, tmp_path):
    document = cameras_document(replace(calibration, marks_rms_mm=0.0)) | {"schema_version": 1}
    (tmp_path / "cameras.json").write_text(json.dumps(document))
    assert read_cameras(tmp_path / "cameras.json").covariance is None
    document["covariance"] = {"parameters": [], "matrix": []}
    (tmp_path / "cameras.json").write_text(json.dumps(document))
    with pytest.raises(InputError, match="unknown field 'covariance'"):
        read_cameras(tmp_path / "cameras.json")


@pytest.mark.parametrize(
    ("parameters", "matrix", "said"),
    [
        (["left.fx"], [[1, 2], [2, 1]], "covariance.matrix is not 1 × 1 numbers"),
        (["left.fx", "left.fx"], [[1, 0], [0, 1]], "twice"),
        (["upper.fx"], [[1]], "without a known camera"),
        (["left.fx", "right.fx"], [[1, 2], [2, 1]], "not a covariance"),
        (["left.fx", "right.fx"], [[1, 0.5], [0.2, 1]], "not a covariance"),
        (["left.fx"], [[-1]], "not a covariance"),
        (["left.fx"], [[None]], "covariance.matrix is not"),
        (None, [[1]], "without a known camera"),
    ],
)
def test_a_covariance_that_cannot_be_one_is_named(calibration, tmp_path, parameters, matrix, said):
    document = cameras_document(calibration) | {"covariance": {"parameters": parameters, "matrix": matrix}}
    (tmp_path / "cameras.json").write_text(json.dumps(document))
    with pytest.raises(InputError, match=said):
        read_cameras(tmp_path / "cameras.json")


def test_a_foreign_file_with_the_needed_fields_only_is_read(calibration, tmp_path):
    document = cameras_document(calibration)
    del document["pair_rms_px"], document["provenance"]
    for camera in document["cameras"].values():
        for name in ("standard_deviations", "rms_px", "serial"):
            del camera[name]
    path = tmp_path / "cameras.json"
    path.write_text(json.dumps(document))
    assert read_cameras(path).names == ("left", "right")


def spoiled(document, place, value):
    *parents, last = place
    for name in parents:
        document = document[name]
    if value is None:
        del document[last]
    else:
        document[last] = value


@pytest.mark.parametrize(
    ("place", "value", "said"),
    [
        (("colour",), "red", "unknown field 'colour'"),
        (("cameras", "right", "focal"), 9, "cameras.right has the unknown field 'focal'"),
        (("cameras", "left", "matrix"), None, "cameras.left.matrix is missing"),
        (("cameras", "left", "matrix"), [[1, 2], [3, 4]], "cameras.left.matrix is not 3 × 3 numbers"),
        (("cameras", "left", "matrix"), [[0, 0, 1], [0, 1, 1], [0, 0, 1]], "not a camera matrix"),
        (("cameras", "right", "distortion"), [0.1, 0.2, 0.3], "has 3 coefficients"),
        (("cameras", "right", "distortion"), ["a", 0, 0, 0], "not a list of numbers"),
        (("cameras", "right", "reference_from_camera"), (2 * np.eye(4)).tolist(), "is not a rigid"),
        (("cameras", "left", "reference_from_camera"), np.diag([1.0, -1, -1, 1]).tolist(), "not the identity"),
        (("cameras", "left", "width"), 12.5, "whole numbers"),
        (("cameras", "left", "blur_px"), -0.5, "cameras.left.blur_px is -0.5, not 0 to 20 px"),
        (("cameras", "left", "blur_px"), float("nan"), "cameras.left.blur_px is nan"),
        (("cameras", "left", "blur_px"), 1e9, "cameras.left.blur_px is 1e\\+09"),
        (("cameras", "left", "standard_deviations"), {"fx": "wide"}, "standard_deviations.fx is not a number"),
        (("cameras",), {}, "names no camera"),
        (("cameras",), [1], "names no camera"),
        (("reference",), "upper", "'upper' is not among the cameras"),
        (("schema_version",), 7, "schema_version is 7"),
    ],
)
def test_what_is_wrong_in_a_file_is_named(calibration, tmp_path, place, value, said):
    document = cameras_document(calibration)
    spoiled(document, place, value)
    path = tmp_path / "cameras.json"
    path.write_text(json.dumps(document))
    with pytest.raises(InputError, match=said.replace("(", r"\(")) as caught:
        read_cameras(path)
    assert "cameras.json" in caught.value.message


@pytest.mark.parametrize("text", ["", "{", "[1, 2]", '{"schema_version": NaN}', "\x00"])
def test_a_file_that_is_no_calibration_is_refused(tmp_path, text):
    path = tmp_path / "cameras.json"
    path.write_text(text)
    with pytest.raises(InputError, match=r"cameras\.json"):
        read_cameras(path)


def test_a_missing_file_is_refused(tmp_path):
    with pytest.raises(InputError, match="cannot be read"):
        read_cameras(tmp_path / "none.json")


def test_poses_read_back_as_written_in_natural_order(tmp_path, generator):
    poses = {
        f"pose{number}": RigidTransform.from_vector(generator.normal(size=3), generator.normal(size=3) * 300, "base", "flange")
        for number in (10, 2, 1)
    }
    write_poses(tmp_path / "poses.csv", poses)
    again = read_poses(tmp_path / "poses.csv", "base", "flange")
    assert list(again) == ["pose1", "pose2", "pose10"]
    for name, pose in poses.items():
        np.testing.assert_allclose(again[name].matrix, pose.matrix, atol=1e-12)


@pytest.fixture
def generator():
    return np.random.default_rng(3)


HEADER = "name,x_mm,y_mm,z_mm,qw,qx,qy,qz\n"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "no rows of values"),
        (HEADER, "no rows of values"),
        ("name,x_mm\nA,1\n", "line 1: the column 'y_mm' is missing"),
        (HEADER.replace("qz", "qz,colour") + "A,1,2,3,1,0,0,0,red\n", "'colour' is unknown"),
        (HEADER + "A,1,2,3,1,0,0\n", "line 2: 7 values under 8 columns"),
        (HEADER + "A,1,2,x,1,0,0,0\n", "line 2: z_mm is 'x'"),
        (HEADER + "A,1,2,3,1,0,0,0\nB,nan,2,3,1,0,0,0\n", "line 3: x_mm is 'nan'"),
        (HEADER + "A,1,2,3,90,0,45,0\n", "line 2: the quaternion"),
        (HEADER + "A,1,2,3,1,0,0,0\nA,1,2,3,1,0,0,0\n", "line 3: the name 'A'"),
    ],
)
def test_what_is_wrong_in_a_pose_table_is_named_with_its_line(tmp_path, text, said):
    (tmp_path / "poses.csv").write_text(text)
    with pytest.raises(InputError, match=said):
        read_poses(tmp_path / "poses.csv", "base", "flange")


def test_poses_in_metres_are_suspected(tmp_path):
    poses = {name: RigidTransform.from_parts(np.eye(3), [0.5, 0.2, 0.7], "base", "flange") for name in "AB"}
    with pytest.raises(InputError, match="metres"):
        require_millimetres(tmp_path / "poses.csv", poses)


def test_guide_and_angle_tables_are_read(tmp_path):
    (tmp_path / "guide.csv").write_text("name,position_mm\nB,-20.5\nA,10\n")
    (tmp_path / "angles.csv").write_text("\ufeffangle_deg,position\n90,2\n-45.0,1\n")
    assert read_guide(tmp_path / "guide.csv") == {"A": 10.0, "B": -20.5}
    assert read_angles(tmp_path / "angles.csv") == pytest.approx({1: -np.pi / 4, 2: np.pi / 2})


def test_corner_tables_keep_the_corners_seen_everywhere(tmp_path):
    lines = ["position,corner,x_mm,y_mm,z_mm,angle_deg"]
    lines += [f"{position},{corner},{position},{corner},7,{position * 30}" for position in (1, 2, 3) for corner in (0, 1, 4)]
    (tmp_path / "corners.csv").write_text("\n".join([*lines, "2,9,0,0,0,60"]))
    table = read_corners(tmp_path / "corners.csv")
    assert table.corners_mm.shape == (3, 3, 3)
    np.testing.assert_allclose(table.corners_mm[1, 2], [2, 4, 7])
    np.testing.assert_allclose(np.rad2deg(table.angles_rad), [30, 60, 90])


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("1,0,1,1,1,0", "corner 0 occurs twice"),
        ("1,2,1,1,1,5", "two different angles"),
        ("1.5,2,1,1,1,0", "whole number"),
        ("2,2,1,1,1,0", "no corner"),
    ],
)
def test_what_is_wrong_in_a_corner_table_is_named(tmp_path, line, said):
    (tmp_path / "corners.csv").write_text(f"position,corner,x_mm,y_mm,z_mm,angle_deg\n1,0,1,1,1,0\n{line}\n")
    with pytest.raises(InputError, match=said):
        read_corners(tmp_path / "corners.csv")


def test_images_are_paired_in_natural_order(tmp_path):
    for name in ("left10.png", "left9.png", "right9.png", "right10.png"):
        (tmp_path / name).write_bytes(b"")
    files = find_board_images([f"left={tmp_path}/left*.png", f"right={tmp_path}/right*.png"])
    assert [path.name for path in files.files["left"]] == ["left9.png", "left10.png"]
    assert sorted(["b2", "b10", "a"], key=natural_order) == ["a", "b2", "b10"]


def test_images_that_do_not_pair_are_refused(tmp_path):
    for name in ("left1.png", "right1.png", "right2.png"):
        (tmp_path / name).write_bytes(b"")
    with pytest.raises(InputError, match="left: 1, right: 2"):
        find_board_images([f"left={tmp_path}/left*.png", f"right={tmp_path}/right*.png"])
    with pytest.raises(InputError, match="No image matches"):
        find_board_images([f"left={tmp_path}/upper*.png"])
    with pytest.raises(InputError, match="names no camera"):
        find_board_images(["left*.png"])


def test_an_empty_image_is_refused(tmp_path):
    (tmp_path / "left1.png").write_bytes(b"")
    files = find_board_images([f"left={tmp_path}/left*.png"])
    with pytest.raises(InputError, match="not a readable image"):
        files.sizes_px()
