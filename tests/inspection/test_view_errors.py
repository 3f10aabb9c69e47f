"""Dimensions are as uncertain as the views they are measured in: what is common to their features drops out, what is not adds up."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.data.dimension import Verdict
from measureapp.data.part_temperature import PartTemperature
from measureapp.inspection.dimensions import inspect
from measureapp.inspection.point_distance import point_distance
from measureapp.inspection.settings import InspectionSettings, UncertaintySettings
from tests.inspection.drawn_errors import (
    PROGRAM,
    SCALE,
    SCALE_PPM,
    SHIFT_MM,
    VIEWS,
    Drawn,
    drawn,
    errors_of,
    inspected,
    with_common,
    with_form,
    with_scale,
)


@pytest.mark.parametrize("draws", [16, pytest.param(80, marks=pytest.mark.slow)])
@pytest.mark.parametrize(
    "made", [drawn(), with_form(drawn()), with_common(drawn()), with_scale(drawn())], ids=["poses", "form", "common", "scale"]
)
def test_intervals_cover_the_truth_in_95_of_100_cases_of_view_and_calibration_errors(made: Drawn, draws: int) -> None:
    scores = []
    for seed in range(draws):
        found = inspected(made.measured(np.random.default_rng(seed)))
        scores.append([2 * (one.deviation or 0.0) / (one.uncertainty or np.nan) for one in found])
    scores = np.array(scores)
    # dimensions of one draw share errors: as if each draw counted three times, three standard deviations of a share of 95.4 %
    within, spread = np.mean(np.abs(scores) <= 2), 3 * np.sqrt(0.954 * 0.046 / (3 * draws))
    assert abs(within - 0.954) < spread
    worst = np.abs(np.sqrt(np.mean(scores**2, axis=0)) - 1).max()  # of a single kind, over all independent draws
    assert worst < 4 / np.sqrt(2 * draws)


def test_a_motion_of_all_views_together_adds_nothing() -> None:
    for one in inspected(drawn(own=1e-6).exact):
        assert one.uncertainty is not None and one.uncertainty < 1e-3, one.name  # of 0.2 mm and 1e-3 rad


def test_contributions_add_up_and_are_reported() -> None:
    found = {one.name: one for one in inspected(drawn().measured(np.random.default_rng(1)))}
    for one in found.values():
        assert set(one.budget) == {"noise", "stitching", "calibration"}
        assert np.linalg.norm(list(one.budget.values())) == pytest.approx(one.uncertainty)
        assert "assumed" not in one.traceability
    assert found["width"].budget["calibration"] == pytest.approx(2 * SCALE * 80, rel=1e-3)
    assert found["corner"].budget["calibration"] < 1e-6  # a scale turns nothing


@pytest.mark.parametrize(("share", "made"), [("form", with_form(drawn())), ("common", with_common(drawn()))])
def test_form_and_systematic_errors_of_clouds_are_contributions_of_their_own(share: str, made: Drawn) -> None:
    plain, formed = ({one.name: one for one in inspected(each.exact)} for each in (drawn(), made))
    for name, one in formed.items():
        assert set(one.budget) == {"noise", "stitching", "calibration", share}
        assert np.linalg.norm(list(one.budget.values())) == pytest.approx(one.uncertainty)
        assert one.budget["stitching"] == pytest.approx(plain[name].budget["stitching"])
    assert formed["width"].budget[share] > 0.2 * SHIFT_MM


def test_what_checks_leave_unexplained_is_a_contribution_and_a_contradicted_model_proves_nothing() -> None:
    made = with_common(drawn()).exact
    assert made.errors is not None
    plain = {one.name: one for one in inspected(made)}
    for size_mm, contradicted in ((0.5 * SHIFT_MM, False), (8 * SHIFT_MM, True)):
        found = {one.name: one for one in inspected(replace(made, errors=replace(made.errors, unexplained_mm=size_mm)))}
        width = found["width"]
        assert width.budget["unexplained"] == pytest.approx(size_mm / SHIFT_MM * plain["width"].budget["common"], rel=1e-3)
        assert np.linalg.norm(list(width.budget.values())) == pytest.approx(width.uncertainty)
        assert ("contradicted" in width.warning) == contradicted
    assert width.verdict is Verdict.NOT_PROVEN


@pytest.mark.parametrize("errors_known", [True, False])
def test_a_stated_scale_is_a_share_of_lengths_and_named_in_their_origin(errors_known: bool) -> None:
    exact = drawn().exact
    settings = InspectionSettings(uncertainty=UncertaintySettings(scale_ppm=SCALE_PPM))
    found = {
        one.name: one for one in inspect(exact if errors_known else replace(exact, errors=None), PROGRAM, settings=settings).dimensions
    }
    for name, length_mm in {"width": 80, "half width": 40, "pin diameter": 30, "small radius": 4, "pins": 160, "foot to wall": 40}.items():
        assert found[name].budget["scale"] == pytest.approx(2e-6 * SCALE_PPM * length_mm, rel=1e-3), name
        assert "length scale ± 200 ppm (k = 1)" in found[name].traceability
    assert found["corner"].budget.get("scale", 0.0) < 1e-9 and "length scale" not in found["corner"].traceability  # no scale turns anything


def test_where_nothing_is_known_of_the_views_the_result_says_what_was_assumed() -> None:
    plain = replace(drawn().exact, errors=None)
    width = inspected(plain)[0]
    assert "assumed: position of each view ± 0.01 mm (k = 1)" in width.traceability and "assumed: calibration" in width.traceability
    halves = replace(
        plain, errors=replace(errors_of(np.random.default_rng(8)), distortion=None, calibration_motions=np.zeros((6 * VIEWS, 0)))
    )
    width = inspected(halves)[0]
    assert "position of each view" not in width.traceability and "assumed: calibration" in width.traceability


def test_two_clicked_points_stand_off_as_their_views_do() -> None:
    errors = errors_of(np.random.default_rng(8))
    places = np.array([[0.0, 40.0, 0.0], [0.0, -40.0, 0.0]])
    along = np.tile([0.0, -1.0, 0.0], (2, 1))
    for views in ((0, 0), (0, 2)):
        gaps = [columns[1] - columns[0] for columns in errors.along(places, along, np.array(views)).values()]
        length, uncertainty = point_distance(places, (0.0, 0.0), views[0] == views[1], views=views, errors=errors)
        assert length == 80.0 and uncertainty == pytest.approx(2 * np.linalg.norm(np.hstack(gaps)))
    within = point_distance(places, (0.0, 0.0), True, views=(0, 0), errors=errors)[1]
    assert within == pytest.approx(2 * SCALE * 80)  # one view alone errs by the scale only


def test_a_best_fit_alignment_removes_motions_of_the_whole_part() -> None:
    exact = drawn().exact
    assert exact.errors is not None and exact.normals is not None and exact.view is not None
    left = exact.remove_alignment_motion().errors
    assert left is not None
    normals = np.asarray(exact.normals)
    before, after = (errors.along(exact.points_mm, normals, exact.view)["stitching"] for errors in (exact.errors, left))
    common, own = slice(0, 6), slice(6, None)  # of the independent errors: motions of all views together, and of single ones
    assert np.abs(before[:, common]).max() > 0.1
    assert np.abs(after[:, common]).max() < 1e-3 * np.abs(before[:, common]).max()
    arms = exact.points_mm - exact.points_mm.mean(axis=0)
    motions = np.hstack([normals, np.cross(arms, normals)])
    np.testing.assert_allclose(motions.T @ after[:, own], 0, atol=1e-6 * float(np.abs(motions.T @ before[:, own]).max()))
    assert 0.2 < np.linalg.norm(after[:, own]) / np.linalg.norm(before[:, own]) < 1


@pytest.mark.parametrize("errors_known", [True, False])
def test_lengths_are_corrected_to_20_degrees_with_a_share_of_their_own(errors_known: bool) -> None:
    exact = drawn().exact if errors_known else replace(drawn().exact, errors=None)
    heat = PartTemperature(30.0, 1.0, 20e-6, 1e-6)
    cold, warm = (inspect(exact, PROGRAM, settings=InspectionSettings(temperature=state)) for state in (None, heat))
    before = {one.name: one for one in cold.dimensions}
    for one in warm.dimensions:
        if one.unit == "mm" and one.kind in ("distance", "diameter", "length"):
            assert one.measured == pytest.approx((before[one.name].measured or 0) / (1 + 10 * 20e-6), abs=2e-6), one.name
    width = next(one for one in warm.dimensions if one.name == "width")
    assert width.budget["temperature"] == pytest.approx(2 * 80 * np.hypot(20e-6 * 0.5, 10 * 1e-6), rel=1e-3)
    assert "corrected to 20 °C" in width.traceability and "corrected to 20 °C" in warm.lengths[1]
    assert "not stated" in cold.lengths[1] and "temperature" not in before["width"].budget
