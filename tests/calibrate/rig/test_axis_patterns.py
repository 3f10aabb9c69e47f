"""The patterns of doubted axes are how the cameras' poses truly change."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.calibrate.rig.axis_patterns import axis_patterns
from measureapp.calibrate.rig.stitch_uncertainty import motions_in_cameras, uncertainty_of
from measureapp.geometry.transform import RigidTransform
from tests.calibrate.paper_rig import calibrated
from tests.calibrate.rig.test_stitch_uncertainty import readback_of, views

STEP = 1e-5


@pytest.fixture(scope="module")
def rig():
    return uncertainty_of(calibrated(21, camera_errors=False, stations=False).solution)


def test_motions_of_table_and_base_move_the_cameras_as_the_chain_says(rig) -> None:
    read, calibration = readback_of(views()[1]), rig.calibration
    by_table, by_guide, _ = (found[0] for found in motions_in_cameras(rig, [read]))
    before, point = calibration.part_from_camera(read), calibration.axis.point_mm
    for part in range(6):
        turn, shift = np.split(STEP * np.eye(6)[part], 2)
        lift = RigidTransform.from_vector(turn, shift, "guide", "guide")
        lift = RigidTransform.from_parts(lift.rotation, point - lift.rotation @ point + shift, "guide", "guide")
        part_from_guide = before @ calibration.guide_from_camera(read).inverse()
        table = before.inverse() @ part_from_guide @ lift.inverse() @ calibration.guide_from_camera(read)
        slip = RigidTransform.from_vector(turn, shift, "base", "base")
        slid = replace(read, base_from_flange=slip @ read.base_from_flange)
        guide = before.inverse() @ calibration.part_from_camera(slid)
        for moved, predicted in ((table, by_table), (guide, by_guide)):
            np.testing.assert_allclose(
                np.concatenate([moved.translation_mm, moved.rotation_vector]) / STEP, predicted[:, part], rtol=1e-3, atol=0.02
            )


def test_axes_that_did_not_move_have_no_pattern(rig) -> None:
    turned = [readback_of(view) for view in views()[:3]]
    assert set(axis_patterns(rig, turned)) == {"table", "views"}
    found = axis_patterns(rig, [readback_of(view) for view in views()])
    assert {name: len(motions) for name, motions in found.items()} == dict.fromkeys(("table", "guide", "robot", "views"), 24)
