from __future__ import annotations

import json
from math import pi
from pathlib import Path

import cv2
import numpy as np
import pytest

from measureapp.data.fringe import PhaseShiftGroup
from measureapp.data.pattern_sets import PATTERN_SETS
from measureapp.errors import InputError, StorageError
from measureapp.fringe.patterns.draw import pattern_images
from measureapp.fringe.patterns.harmonics import Harmonic
from measureapp.fringe.patterns.response import PitchWaveform, ProjectorResponse
from measureapp.project.fringes.pattern_files import export_patterns, read_pattern_set
from measureapp.project.fringes.response_file import read_ramp, read_response, write_response

SIZE = 1024, 768
BOTH = PATTERN_SETS["complementary-gray-both"]


def exported(folder: Path) -> np.ndarray:
    images = pattern_images(BOTH, *SIZE)
    export_patterns(folder, BOTH, images, None, ("left",), (1000,))
    return images


def test_exported_images_are_the_ones_drawn_in_their_order(tmp_path: Path) -> None:
    images = exported(tmp_path / "out")
    files = sorted((tmp_path / "out").glob("*.png"))
    assert [file.name for file in files] == [f"{number:03d}.png" for number in range(22)]
    for file, image in zip(files, images, strict=True):
        assert np.array_equal(cv2.imread(str(file), cv2.IMREAD_UNCHANGED), image)


def test_the_list_says_what_every_image_shows(tmp_path: Path) -> None:
    exported(tmp_path)
    document = json.loads((tmp_path / "patterns.json").read_text())
    images = document["images"]
    assert images[1] == {
        "file": "001.png", "kind": "phase-shift", "direction": "vertical", "pitch_px": 16.0, "step": 1, "steps": 4, "shift_rad": -pi / 2,
    }  # fmt: skip
    assert images[21] == {"file": "021.png", "kind": "gray-code", "direction": "horizontal", "plane": 6, "planes": 7, "complementary": True}
    assert document["projector"] == {"width_px": 1024, "height_px": 768, "corrected_for": None}


def test_an_export_can_be_read_as_the_set_it_shows(tmp_path: Path) -> None:
    exported(tmp_path)
    assert read_pattern_set(str(tmp_path / "patterns.json"), *SIZE) == BOTH


def test_a_set_is_read_from_toml(tmp_path: Path) -> None:
    file = tmp_path / "mine.toml"
    groups = "\n".join(f'[[groups]]\nkind = "phase-shift"\npitch_px = {pitch}\nsteps = 5' for pitch in (20, 21, 40))
    file.write_text(f'name = "mine"\nprojector_px = 400\nshift_sign = 1\n{groups}\n')
    made = read_pattern_set(str(file), *SIZE)
    assert made.groups[1] == PhaseShiftGroup(pitch_px=21, steps=5)
    assert (made.name, made.projector_px, made.shift_sign) == ("mine", 400, 1)


@pytest.mark.parametrize(
    ("name", "content", "reason"),
    [
        ("absent.toml", None, "cannot be read"),
        ("bad.toml", "name = ", "pattern set"),
        ("bad.json", "[1", "pattern set"),
        ("bad.json", "[]", "the pattern set"),
        ("bad.toml", 'name = "x"\nprojector_px = 10\ngroups = []', "groups"),
        ("bad.toml", 'name = "x"\nprojector_px = 10\n[[groups]]\nkind = "moire"', "moire"),
        ("bad.toml", 'name = "x"\nprojector_px = 10\n[[groups]]\nkind = "phase-shift"\npitch_px = 1', "pitch_px"),
        (
            "bad.toml",
            'name = "x"\nprojector_px = 10\n[[groups]]\nkind = "phase-shift"\npitch_px = 16\ndirection = "horizontal"',
            "projector_rows",
        ),
    ],
)
def test_a_file_that_is_no_pattern_set_is_refused_by_its_name(name: str, content: str | None, reason: str, tmp_path: Path) -> None:
    if content is not None:
        (tmp_path / name).write_text(content)
    with pytest.raises(InputError, match=reason) as raised:
        read_pattern_set(str(tmp_path / name), *SIZE)
    assert name in raised.value.message and raised.value.hint


def test_a_name_that_is_not_known_and_a_projector_that_cannot_be_are_refused() -> None:
    with pytest.raises(InputError, match="nonsense") as raised:
        read_pattern_set("nonsense", *SIZE)
    assert "three-close" in raised.value.hint
    with pytest.raises(InputError, match="10 × 768"):
        read_pattern_set("paper", 10, 768)


def test_a_second_export_leaves_no_image_of_the_first(tmp_path: Path) -> None:
    exported(tmp_path)
    small = PATTERN_SETS["paper"]
    export_patterns(tmp_path, small, pattern_images(small, *SIZE), None, ("left",), (1000,))
    assert len(list(tmp_path.glob("*.png"))) == 8


def test_a_folder_that_holds_something_else_is_left_as_it_is(tmp_path: Path) -> None:
    (tmp_path / "letter.txt").write_text("dear reader")
    with pytest.raises(StorageError, match=r"letter\.txt"):
        exported(tmp_path)
    assert [file.name for file in tmp_path.iterdir()] == ["letter.txt"]


RESPONSE = ProjectorResponse(
    name="bench",
    curve=((0.0, 0.0), (100.0, 0.2), (255.0, 1.0)),
    waveforms=(PitchWaveform(pitch_px=32, harmonics=(Harmonic(order=2, share=0.1, phase_rad=0.2, spread=0.01),)),),
)


def test_a_response_comes_back_as_it_was_written(tmp_path: Path) -> None:
    write_response(tmp_path / "response.json", RESPONSE)
    assert read_response(tmp_path / "response.json") == RESPONSE


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (None, "cannot be read"),
        ("{", "not JSON"),
        ("\xff", "response"),
        ("{}", "schema_version"),
        ('{"schema_version": 2, "response": {}}', "schema_version"),
        ('{"schema_version": 1, "response": {}}', "curve or waveforms"),
        ('{"schema_version": 1, "response": {"curve": [[0, 0], [255, 0.9]]}}', "ascend"),
        ('{"schema_version": 1, "response": {"curve": [[0, 0], [255, 1]], "gamma": 2}}', "gamma"),
    ],
)
def test_a_file_that_is_no_response_is_refused_by_its_name(content: str | None, reason: str, tmp_path: Path) -> None:
    file = tmp_path / "response.json"
    if content is not None:
        file.write_text(content, encoding="latin-1")
    with pytest.raises(InputError, match=reason) as raised:
        read_response(file)
    assert "response.json" in raised.value.message and raised.value.hint


def test_a_ramp_is_read_and_one_without_numbers_refused(tmp_path: Path) -> None:
    file = tmp_path / "ramp.csv"
    file.write_text("level,grey\n0,3.5\n255,200\n")
    levels, grey = read_ramp(file)
    assert (levels.tolist(), grey.tolist()) == ([0, 255], [3.5, 200])
    for content, reason in (
        ("a,b\n1,2\n", "no columns"),
        ("level,grey\n1\n", "two numbers"),
        ("level,grey\n1,nan\n", "finite"),
        ("", "no columns"),
    ):
        file.write_text(content)
        with pytest.raises(InputError, match=reason):
            read_ramp(file)
    with pytest.raises(InputError, match="cannot be read"):
        read_ramp(tmp_path / "absent.csv")
