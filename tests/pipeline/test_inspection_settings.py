"""What the inspection of a project takes from its rig, its board and its header."""

from __future__ import annotations

from dataclasses import replace

import pytest

from measureapp.data.certificate import lengths_of_class
from measureapp.data.identification import Identification
from measureapp.data.rig import DriverChoice, RigDescription
from measureapp.pipeline.assemble import inspection_settings
from measureapp.pipeline.lengths import length_scale, temperature_of
from tests.calibrate.paper_rig import RIG
from tests.report.conftest import calibration


def real_rig() -> RigDescription:
    """The rig of the paper with a real robot."""
    drivers = {name: DriverChoice(driver="virtual_rig") for name in RIG.drivers}
    return RIG.model_copy(update={"driver": "", "devices": drivers | {"robot": DriverChoice(driver="robot_abb")}})


def test_lengths_are_as_uncertain_as_the_rules_of_the_rig_say() -> None:
    assert inspection_settings(calibration(), RIG, ()).uncertainty.scale_ppm == 0
    rules = RIG.calibration_rules.model_copy(update={"scale_ppm": 4.0})
    rig = RIG.model_copy(update={"calibration_rules": rules})
    assert inspection_settings(calibration(), rig, ()).uncertainty.scale_ppm == 4.0


def test_a_real_rig_that_states_nothing_has_the_uncertainty_of_a_printed_board() -> None:
    stated = inspection_settings(calibration(), real_rig(), ()).uncertainty
    assert 2 * 180 * stated.scale_ppm * 1e-6 == pytest.approx(0.1, rel=0.05)
    assert "not stated" in stated.scale_source


def test_the_board_that_was_calibrated_with_counts_before_what_the_rig_states() -> None:
    cameras = replace(calibration().cameras, lengths=lengths_of_class("ceramic").at(21.0, 0.4))
    rig = real_rig()
    rig = rig.model_copy(update={"calibration_rules": rig.calibration_rules.model_copy(update={"scale_ppm": 400.0})})
    scale = length_scale(cameras, rig)
    assert scale.ppm == pytest.approx(cameras.lengths.sigma * 1e6) and scale.ppm < 10  # type: ignore[union-attr]
    assert "ceramic" in scale.source and "21 ± 0.4 °C" in scale.source


def test_the_header_states_the_temperature_and_an_unknown_material_is_not_corrected() -> None:
    assert temperature_of(Identification()) is None
    warm = temperature_of(Identification(part_temperature="23±0.5", material="steel"))
    assert warm is not None and warm.factor < 1
    odd = temperature_of(Identification(part_temperature="23±0.5", material="kryptonite"))
    assert odd is not None and odd.words.endswith("not corrected")
    with pytest.raises(ValueError, match="not a temperature"):
        Identification(part_temperature="hot")
