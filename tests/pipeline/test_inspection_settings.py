"""What the inspection of a project takes from its rig."""

from __future__ import annotations

from measureapp.pipeline.assemble import inspection_settings
from tests.calibrate.paper_rig import RIG
from tests.report.conftest import calibration


def test_lengths_are_as_uncertain_as_the_rules_of_the_rig_say() -> None:
    assert inspection_settings(calibration(), RIG, ()).uncertainty.scale_ppm == 0
    rules = RIG.calibration_rules.model_copy(update={"scale_ppm": 4.0})
    rig = RIG.model_copy(update={"calibration_rules": rules})
    assert inspection_settings(calibration(), rig, ()).uncertainty.scale_ppm == 4.0
