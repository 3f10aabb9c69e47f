from __future__ import annotations

from pathlib import Path

import pytest

from measureapp.data.inspection_program import InspectionProgram, substitute_index
from measureapp.errors import InputError
from measureapp.project.program_file import read_program, read_program_nominal
from measureapp.resources import resource

FACE = '[[features]]\nname = "f"\nshape = "plane"\npoint_mm = [0, 0, 0]\ndirection = [0, 0, 1]\n'


def written(folder: Path, text: str) -> Path:
    path = folder / "program.toml"
    path.write_text(text)
    return path


@pytest.mark.parametrize(
    ("part", "names"),
    [
        ("gypsum", {"a", "b", "c", "d"}),
        ("impeller", {"outer_diameter", "hub_diameter", "bore_diameter", "blade_height", "blade_thickness", "blade_pitch"}),
        ("gear", {"tip_diameter", "boss_diameter", "bore_diameter", "boss_step"}),
        ("flat", {"top_flatness"}),
    ],
)
def test_the_sample_parts_have_the_dimensions_of_their_nominals(part: str, names: set[str]) -> None:
    path = resource(f"parts/{part}/program.toml")
    described = read_program(path)
    assert {dimension.name for dimension in described.dimensions} == names
    assert read_program_nominal(path, described) is not None


def test_a_program_survives_the_way_through_json() -> None:
    described = read_program(resource("parts/impeller/program.toml"))
    assert InspectionProgram.model_validate_json(described.model_dump_json()) == described


def test_copies_of_a_pattern_are_counted_in_a_ring() -> None:
    assert substitute_index(("mid.{k}", "mid.{k+1}"), 7, 7) == ("mid.7", "mid.1")
    assert substitute_index(("mid.{k+2}",), 6, 7) == ("mid.1",)


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ('name = "p"\nnominal = ]\n', "line 2"),
        ('name = "p"\ncolour = 3\n' + FACE, "colour is not a known key"),
        ('name = "p"\n' + FACE + "colour = 3\n", r"features.0.colour \('f'\) is not a known key"),
        ('name = "p"\n' + FACE + "cut = { band = 3 }\n", r"features.0.cut.band \('f'\) is not a known key"),
        ('name = "p"\n' + FACE.replace('"plane"', '"cube"'), r"features.0 \('f'\): .*'cube'"),
        ('name = "p"\n' + FACE.replace('"plane"', '"sphere"'), "a sphere needs `radius_mm`"),
        ('name = "p"\n' + FACE + FACE, "two features have the name 'f'"),
        ('name = "p"\n' + FACE + "cut = { z_mm = [3, 1] }\n", "z_mm must run from the smaller"),
        ('name = "p"\n' + FACE.replace("point_mm = [0, 0, 0]\n", ""), "needs `point_mm`, or `grow` with a seed"),
        ('name = "p"\n' + FACE.replace("point_mm", "grow.seed_mm"), "a nominal needs `point_mm`"),
        ('name = "p"\n' + FACE.replace('"plane"', '"surface_point"') + "grow = { seed_mm = [0, 0, 0] }\n", "`grow` does not apply"),
        (
            'name = "p"\n' + FACE + '[[dimensions]]\nname = "d"\nkind = "distance"\nfeatures = ["f", "g"]\nnominal = 1\n',
            "dimension 'd' needs feature 'g'",
        ),
        ('name = "p"\n' + FACE + '[[dimensions]]\nname = "d"\nkind = "distance"\nfeatures = ["f"]\nnominal = 1\n', "needs two features"),
        ('name = "p"\n' + FACE + '[[features]]\nname = "m"\nshape = "midpoint"\nof = ["f", "x"]\n', "is constructed from 'x'"),
    ],
)
def test_a_wrong_program_is_refused_with_file_and_place(text: str, complaint: str, tmp_path: Path) -> None:
    path = written(tmp_path, text)
    with pytest.raises(InputError, match=complaint) as caught:
        read_program(path)
    assert str(path) in caught.value.message and caught.value.hint


def test_a_missing_program_or_nominal_is_named(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"absent\.toml"):
        read_program(tmp_path / "absent.toml")
    path = written(tmp_path, 'name = "p"\nnominal = "gone.stl"\n' + FACE)
    with pytest.raises(InputError, match=r"gone\.stl"):
        read_program_nominal(path, read_program(path))
