"""The values of a result stand beside the true and the previous ones, matched by name."""

from __future__ import annotations

from dataclasses import replace

import pytest

from measureapp.calibrate.draft.draft import Known
from measureapp.calibrate.kinds.axis import axis_at_height
from measureapp.calibrate.kinds.table import KINDS
from ui.controllers.result import pair_values


def test_the_same_axis_through_another_of_its_points_has_the_same_values(calibration):
    axis = calibration.axis
    same = replace(axis, point_mm=axis.point_mm + 123.0 * axis.direction)
    first, second = (axis_at_height(one, 40.0) for one in (axis, same))
    assert [one.label for one in first] == ["Direction x", "Direction y", "Direction z", "Position x", "Position y"]
    assert [one.value for one in first] == pytest.approx([one.value for one in second], abs=1e-9)


def test_every_value_of_a_rig_finds_its_partner(calibration):
    now = Known(calibration.cameras, calibration)
    moved = Known(calibration.cameras, replace(calibration, guide=replace(calibration.guide, scale=1.5)))
    rows = pair_values(KINDS["rig"].shown(now, now), (), KINDS["rig"].shown(moved, now))
    assert {row.estimate.group for row in rows} == {"Hand–eye", "Linear guide", "Table axis", "Camera left", "Camera right", "Camera upper"}
    assert all(row.true is None and row.previous is not None for row in rows)
    changed = [row.estimate.label for row in rows if row.previous != pytest.approx(row.estimate.value)]
    assert changed == ["Scale"]
    focal = next(row.estimate for row in rows if row.estimate.label == "Focal length x")
    assert (focal.unit, focal.sigma) == ("px", 0.21)
