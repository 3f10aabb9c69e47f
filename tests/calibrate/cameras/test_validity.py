"""A calibration knows its cameras, its day and its temperature."""

from __future__ import annotations

import json
from dataclasses import replace
from datetime import UTC, datetime

import numpy as np
import pytest

from measureapp.calibrate.cameras.array import solve
from measureapp.calibrate.cameras.validity import check_fits, shortfalls
from measureapp.data.calibration import CameraArrayCalibration, Provenance
from measureapp.errors import CalibrationError, InputError
from measureapp.project.calibration.camera_inputs import CameraInputs, read_camera_inputs, write_camera_inputs
from tests.calibrate import paper_head

NOW = datetime(2031, 5, 20, 12, tzinfo=UTC)


@pytest.fixture
def calibration() -> CameraArrayCalibration:
    head = paper_head.drawn_head(np.random.default_rng(0))
    return replace(head, cameras={name: replace(camera, serial=f"SN-{name}") for name, camera in head.cameras.items()})


def given(calibration: CameraArrayCalibration) -> tuple[dict[str, str], dict[str, tuple[int, int]]]:
    return {name: camera.serial for name, camera in calibration.cameras.items()}, dict.fromkeys(calibration.cameras, paper_head.SIZE)


def test_the_same_cameras_fit(calibration):
    check_fits(calibration, *given(calibration))


def test_a_camera_without_serial_number_is_not_compared(calibration):
    serials, sizes = given(calibration)
    check_fits(calibration, serials | {"left": ""}, sizes)
    unknown = replace(calibration, cameras={name: replace(camera, serial="") for name, camera in calibration.cameras.items()})
    check_fits(unknown, serials, sizes)


def test_another_camera_is_refused_by_name_and_number(calibration):
    serials, sizes = given(calibration)
    with pytest.raises(CalibrationError, match="camera 'upper' has serial number 77, SN-upper was calibrated"):
        check_fits(calibration, serials | {"upper": "77"}, sizes)


def test_exchanged_cables_are_named(calibration):
    serials, sizes = given(calibration)
    swapped = serials | {"left": "SN-right", "right": "SN-left"}
    with pytest.raises(CalibrationError) as caught:
        check_fits(calibration, swapped, sizes)
    assert "'left' has serial number SN-right, which was calibrated as 'right'" in caught.value.message
    assert "'right' has serial number SN-left" in caught.value.message


def test_another_image_size_and_a_missing_camera_are_named_together(calibration):
    serials, sizes = given(calibration)
    with pytest.raises(CalibrationError) as caught:
        check_fits(calibration, serials | {"fourth": "4"}, sizes | {"left": (640, 480)})
    assert "640 × 480 px, 2592 × 1944 px were calibrated" in caught.value.message
    assert "no camera 'fourth'" in caught.value.message


@pytest.mark.parametrize(
    ("provenance", "temperature_c", "said"),
    [
        (Provenance("2031-05-01T08:00:00+00:00", valid_days=30, temperature_c=21), 22.0, ""),
        (Provenance("2031-05-01T08:00:00+00:00"), None, ""),
        (Provenance("2031-03-01T08:00:00+00:00", valid_days=30), None, "has expired"),
        (Provenance("2031-03-01T08:00:00", valid_days=30), None, "has expired"),
        (Provenance("yesterday", valid_days=30), None, "cannot be read"),
        (Provenance("2035-01-01T08:00:00+00:00"), None, "future"),
        (Provenance("2031-05-01T08:00:00+00:00", temperature_c=21), 26.5, "26.5 °C at the head"),
        (Provenance("2031-01-01T08:00:00+00:00", temperature_c=21), 22.0, "valid for 90 days and has expired"),
    ],
)
def test_age_and_temperature_are_checked(provenance, temperature_c, said):
    reasons = shortfalls(provenance, NOW, temperature_c)
    assert (said in " ".join(reasons)) if said else reasons == ()


def test_solving_the_stored_inputs_again_gives_the_same_numbers(tmp_path):
    generator = np.random.default_rng(3)
    drawn = paper_head.problem(paper_head.drawn_head(generator), 6, 0.1, generator)
    problem = replace(drawn, sightings=tuple(replace(one, edge_px=2.5) for one in drawn.sightings))
    images = {(one.camera, one.view): f"{one.camera}{one.view}.png" for one in problem.sightings}
    write_camera_inputs(tmp_path / "inputs.json", CameraInputs(problem, images))
    stored = read_camera_inputs(tmp_path / "inputs.json")
    assert stored.images == images
    first, again = solve(problem), solve(stored.problem)
    assert first.parameters == again.parameters
    np.testing.assert_array_equal(first.covariance, again.covariance)
    for name, camera in first.calibration.cameras.items():
        other = again.calibration.cameras[name]
        np.testing.assert_array_equal(camera.pinhole.matrix, other.pinhole.matrix)
        np.testing.assert_array_equal(camera.pinhole.distortion, other.pinhole.distortion)
        np.testing.assert_array_equal(camera.reference_from_camera.matrix, other.reference_from_camera.matrix)
        assert camera.blur_px == other.blur_px > 0


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (lambda file: file["sightings"][0].update(camera="middle"), "the size of the images of middle"),
        (lambda file: file["sizes_px"].update(left=[0, 1944]), "images of left are 0 × 1944 px"),
        (lambda file: file["board"].update(columns=13), "are not those of the board of 13 × 11 corners"),
        (lambda file: file["sightings"][0]["ids"].__setitem__(0, 154), "are not those of the board of 14 × 11 corners"),
    ],
)
def test_a_file_whose_parts_do_not_belong_together_is_refused(tmp_path, change, said):
    generator = np.random.default_rng(3)
    problem = paper_head.problem(paper_head.drawn_head(generator), 6, 0.1, generator)
    path = tmp_path / "inputs.json"
    write_camera_inputs(path, CameraInputs(problem, {(one.camera, one.view): "an image" for one in problem.sightings}))
    document = json.loads(path.read_text())
    change(document)
    path.write_text(json.dumps(document))
    with pytest.raises(InputError, match=said):
        read_camera_inputs(path)


def test_a_file_that_holds_no_corners_is_refused(tmp_path):
    with pytest.raises(InputError, match="cannot be read"):
        read_camera_inputs(tmp_path / "absent.json")
    (tmp_path / "other.json").write_text('{"schema_version": 1}')
    with pytest.raises(InputError, match="does not hold the corners"):
        read_camera_inputs(tmp_path / "other.json")
