"""Sample part programs, and the part that a virtual rig gets on its table."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
import pytest

from measureapp.pipeline.sample_program import SAMPLES, rig_for_program, sample_program, write_sample_programs
from measureapp.project.part_program_file import read_part_program
from measureapp.project.rig_file import read_rig


@pytest.fixture(scope="module")
def programs(tmp_path_factory):
    return [read_part_program(path) for path in write_sample_programs(tmp_path_factory.mktemp("programs"))]


def test_a_sample_program_has_all_that_an_operator_needs(programs):
    assert [program.facts.name for program in programs] == ["Gypsum cross", "Gear"]
    for program, sample in zip(programs, SAMPLES, strict=True):
        assert len(program.plan) == sample.viewpoints and program.facts.remarks and program.facts.code_pattern
        assert program.inspection is not None and program.nominal is not None
        image = cv2.imdecode(np.frombuffer(program.picture, np.uint8), cv2.IMREAD_UNCHANGED)
        assert image.shape[2] == 4 and 0.1 < (image[:, :, 3] > 0).mean() < 0.9  # the part on a transparent background


def test_the_virtual_rig_gets_the_part_of_the_program_on_its_table(programs, tmp_path):
    rig = read_rig("paper")
    used = rig_for_program(rig, programs[1], "quarter", tmp_path)
    assert used.driver_settings["part"] == "gear" and used.cameras[0].width_px == rig.cameras[0].width_px // 4
    again = rig_for_program(used, programs[0], "quarter", tmp_path)
    assert again.driver_settings["part"] == "gypsum" and again.cameras == used.cameras
    other = replace(programs[0], nominal=(".stl", programs[0].nominal[1] + b"\0"))
    path = rig_for_program(rig, other, "full", tmp_path).driver_settings["part"]
    assert path.startswith(str(tmp_path))


def test_any_other_rig_is_used_as_it_is_described(programs, tmp_path):
    rig = read_rig("paper").model_copy(update={"driver": "recorded"})
    assert rig_for_program(rig, programs[0], "quarter", tmp_path) is rig


def test_a_sample_program_is_the_same_every_time(programs):
    assert sample_program(SAMPLES[0]).plan == programs[0].plan
