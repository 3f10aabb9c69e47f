"""The values of a result stand beside the true and the earlier ones, matched by what they mean."""

from __future__ import annotations

from dataclasses import replace

import pytest

from ui.controllers.result_values import axis_quantities, rig_quantities, rows_beside


def test_the_same_axis_through_another_of_its_points_has_the_same_values(calibration):
    axis = calibration.axis
    same = replace(axis, point_mm=axis.point_mm + 123.0 * axis.direction)
    first, second = (axis_quantities(one, 40.0) for one in (axis, same))
    assert [one.name for one in first] == ["Direction x", "Direction y", "Direction z", "Position x", "Position y"]
    assert [one.value for one in first] == pytest.approx([one.value for one in second], abs=1e-9)


def test_every_value_of_a_rig_finds_its_partner(calibration):
    found = rig_quantities(calibration, 0.0)
    moved = rig_quantities(replace(calibration, guide=replace(calibration.guide, scale=1.5)), 0.0)
    rows = rows_beside(found, (), moved)
    assert {row.quantity.group for row in rows} == {"Hand–eye", "Linear guide", "Table axis", "Camera left", "Camera right", "Camera upper"}
    assert all(row.true is None and row.previous is not None for row in rows)
    changed = [row.quantity.name for row in rows if row.previous != pytest.approx(row.quantity.value)]
    assert changed == ["Scale"]
    focal = next(row.quantity for row in rows if row.quantity.name == "Focal length x")
    assert (focal.unit, focal.sigma) == ("px", 0.21)
