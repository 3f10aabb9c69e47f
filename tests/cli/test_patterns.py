from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest

from measureapp.cli.main import main
from measureapp.data.pattern_sets import PATTERN_SETS
from measureapp.fringe.patterns.response import response_of_ramp
from measureapp.project.fringes.response_file import write_response
from tests.cli.refusal import refused_with


def answered(capsys: pytest.CaptureFixture[str], *arguments: object) -> dict[str, Any]:
    capsys.readouterr()
    assert main([*map(str, arguments), "--json"]) == 0
    return json.loads(capsys.readouterr().out)


def test_the_list_has_every_named_set_with_its_predicted_performance(capsys: pytest.CaptureFixture[str]) -> None:
    sets = answered(capsys, "patterns", "list")["sets"]
    assert set(sets) == set(PATTERN_SETS)
    paper, ours = sets["paper"]["directions"]["vertical"], sets["three-close"]["directions"]["vertical"]
    assert paper["order_error_probability"] == pytest.approx(4.6e-4, rel=0.1)
    assert ours["order_error_probability"] < 1e-9
    assert ours["column_sigma_px"] < paper["column_sigma_px"] / 2
    assert main(["patterns", "list", "--width", "1920", "--height", "1080"]) == 0
    assert "44 and 45 px" in capsys.readouterr().out


def test_a_check_says_range_guard_band_noise_and_order_errors(capsys: pytest.CaptureFixture[str]) -> None:
    answer = answered(capsys, "patterns", "check", "paper-both", "--mean", 60, "--modulation", 40)
    assert set(answer["directions"]) == {"vertical", "horizontal"}
    upright = answer["directions"]["vertical"]
    assert (upright["range_px"], upright["guard_px"]) == pytest.approx((1056, 32))
    assert upright["phase_sigma_rad"][0] == pytest.approx(0.0291, abs=5e-4)
    assert upright["order_error_probability"] == pytest.approx(2e-2, rel=0.1)
    quieter = answered(capsys, "patterns", "check", "paper-both", "--mean", 60, "--modulation", 40, "--exposures", "1,0.8,0.6,0.4,0.2")
    assert quieter["directions"]["vertical"]["order_error_probability"] == pytest.approx(1e-4, rel=0.5)
    assert main(["patterns", "check", "three-wide"]) == 0
    said = capsys.readouterr().out
    assert "guard band" in said and "wrong fringe orders" in said and "σ of the result" in said


def test_an_export_holds_the_images_their_list_and_a_manifest(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    answer = answered(capsys, "patterns", "export", "three-close", "--out", tmp_path / "out", "--cameras", "one,two", "--exposures", "500")
    assert len(answer["files"]) == 12
    assert 'two = ["two/500/000.png"' in Path(answer["manifest"]).read_text()
    assert main(["patterns", "check", answer["list"]]) == 0


def test_an_export_for_a_projector_of_gamma_2_is_darker_nowhere_and_brighter_between(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    levels = np.linspace(0, 255, 52)
    write_response(tmp_path / "response.json", response_of_ramp(levels, 200 * (levels / 255) ** 2, name="bench"))
    for name, extra in (("plain", ()), ("corrected", ("--response", tmp_path / "response.json"))):
        answered(capsys, "patterns", "export", "paper", "--out", tmp_path / name, *extra)
    plain, corrected = (cv2.imread(str(tmp_path / name / "000.png"), cv2.IMREAD_GRAYSCALE).astype(float) for name in ("plain", "corrected"))
    assert np.abs(corrected - 255 * np.sqrt(plain / 255)).max() < 4  # the curve is straight between its 52 points
    document = json.loads((tmp_path / "corrected" / "patterns.json").read_text())
    assert document["projector"]["corrected_for"] == "bench"


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        (("check", "nonsense"), "nonsense"),
        (("check", "paper", "--mean", "300"), "380"),
        (("check", "paper", "--modulation", "-3"), "-3"),
        (("check", "paper", "--modulation", "1e-300"), "1e-300"),
        (("check", "paper", "--exposures", "1,x"), "1,x"),
        (("check", "paper", "--exposures", "1,-1"), "-1"),
        (("check", "paper", "--full-well", "0"), "full well"),
        (("check", "paper", "--width", "9"), "9 × 768"),
        (("list", "--width", "0"), "0 × 768"),
        (("export", "paper", "--out", "OUT", "--cameras", "a,a"), "a,a"),
        (("export", "paper", "--out", "OUT", "--cameras", "a b"), "a b"),
        (("export", "paper", "--out", "OUT", "--response", "absent.json"), "absent.json"),
        (("export", "paper", "--out", "OUT", "--exposures", "0"), "0"),
        (("export", "paper", "--out", "OUT", "--exposures", "0.4"), "whole"),
    ],
)
def test_what_cannot_be_is_refused_and_nothing_written(
    arguments: tuple[str, ...], reason: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    filled = [str(tmp_path / "out") if word == "OUT" else word for word in arguments]
    assert reason in refused_with(capsys, "patterns", *filled)
    assert list(tmp_path.iterdir()) == []


def test_a_set_that_is_ambiguous_on_the_projector_is_refused_with_the_reason(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "mine.toml"
    groups = "\n".join(f'[[groups]]\nkind = "phase-shift"\npitch_px = {pitch}' for pitch in (32, 34))
    file.write_text(f'name = "mine"\nprojector_px = 1024\n{groups}\n')
    assert "beat of the pitches 32, 34 px is 544 px" in refused_with(capsys, "patterns", "check", file)
    assert "beat" in refused_with(capsys, "patterns", "export", file, "--out", tmp_path / "out")
    assert not (tmp_path / "out").exists()
