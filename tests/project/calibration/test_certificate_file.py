"""Classes and certificates of boards: what they change, and what is refused."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from measureapp.data.certificate import EXACT, lengths_of_class
from measureapp.data.project_settings import DEFAULT_BOARD
from measureapp.errors import InputError
from measureapp.project.calibration.certificate_file import certify, with_lengths

GLASS = """
number = "K 4711"
temperature_c = 20.0
uncertainty_mm = 0.002
over_mm = 200.0
expansion_ppm_per_k = 9.0
scale = 1.0001
board = { marks = [14, 11], spacing_mm = 15.0 }
"""


def written(folder: Path, text: str) -> Path:
    path = folder / "board.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_a_certified_scale_and_the_temperature_of_the_board_move_its_marks(tmp_path: Path) -> None:
    board = with_lengths(DEFAULT_BOARD, written(tmp_path, GLASS), None, "23±0.6")
    assert board.lengths is not None
    np.testing.assert_allclose(board.corners_mm, DEFAULT_BOARD.corners_mm * (1.0001 * (1 + 3 * 9e-6)))
    by_hand = np.linalg.norm([0.002 / 200 / 2, 9e-6 * 0.3, 3 * 0.1 * 9e-6])
    assert board.lengths.sigma == pytest.approx(by_hand)
    assert board.lengths.words == "certificate K 4711, board at 23 ± 0.6 °C"


def test_certified_marks_of_a_certificate_replace_the_grid(tmp_path: Path) -> None:
    marks = DEFAULT_BOARD.nominal_corners_mm * 1.0003
    rows = [f"0,{number},{x!r},{y!r},{z!r}" for number, (x, y, z) in enumerate(marks.tolist())]
    (tmp_path / "corners.csv").write_text("\n".join(["position,corner,x_mm,y_mm,z_mm", *rows]) + "\n", encoding="utf-8")
    board = certify(DEFAULT_BOARD, written(tmp_path, GLASS.replace("scale = 1.0001", 'corners = "corners.csv"')))
    assert np.linalg.norm(board.corners_mm[13] - board.corners_mm[0]) == pytest.approx(13 * 15.0 * 1.0003)
    assert type(board).model_validate_json(board.model_dump_json()) == board


def test_a_class_has_its_uncertainty_and_a_board_without_one_keeps_its_form() -> None:
    printed = with_lengths(DEFAULT_BOARD, None, "printed", None)
    assert printed.lengths is not None
    assert 2 * 180 * printed.lengths.relative_sigma == pytest.approx(0.1)
    assert printed.lengths.sigma > printed.lengths.relative_sigma  # its temperature was not measured
    assert lengths_of_class("ceramic").sigma < lengths_of_class("glass").sigma < printed.lengths.sigma
    assert EXACT.sigma == 0.0 and "lengths" not in DEFAULT_BOARD.model_dump()


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (GLASS.replace("[14, 11]", "[9, 6]"), "certificate of a board of 9 × 6 marks"),
        (GLASS.replace("spacing_mm = 15.0", "spacing_mm = 12.0"), "12 mm apart"),
        (GLASS.replace("temperature_c = 20.0\n", ""), "temperature_c: Field required"),
        (GLASS.replace("temperature_c = 20.0", "temperature_c = 293.15"), "temperature_c"),
        (GLASS.replace("scale = 1.0001", "scale = 25.4"), "scale"),
        (GLASS + 'corners = "corners.csv"\n', "both corners and a scale"),
        (GLASS.replace("over_mm", "over"), "over"),
    ],
)
def test_a_certificate_of_another_board_or_without_its_temperature_is_refused_in_a_sentence(tmp_path: Path, text: str, said: str) -> None:
    with pytest.raises(InputError, match=said) as refused:
        certify(DEFAULT_BOARD, written(tmp_path, text))
    assert refused.value.message.count(". ") == 0 and "board.toml" in refused.value.message


@pytest.mark.parametrize("temperature", ["warm", "295", "21±0", "21±50", ""])
def test_absurd_temperatures_of_a_board_are_refused(temperature: str) -> None:
    with pytest.raises(InputError, match="Temperature of the board"):
        with_lengths(DEFAULT_BOARD, None, "glass", temperature)


def test_statements_that_contradict_each_other_are_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="both state the lengths"):
        with_lengths(DEFAULT_BOARD, written(tmp_path, GLASS), "glass", None)
    with pytest.raises(InputError, match="says nothing without its class"):
        with_lengths(DEFAULT_BOARD, None, None, "21±1")
