"""A certified length that is measured with the part corrects the others by what they share, as far as it is known, and says so."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from pydantic import ValidationError

from measureapp.data.dimension import Dimension, Verdict
from measureapp.data.inspection_program import InspectionProgram
from measureapp.data.length_certificate import LengthCertificate
from measureapp.data.part_temperature import PartTemperature
from measureapp.inspection.dimensions import inspect
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.session.session import InspectionSession
from measureapp.inspection.settings import InspectionSettings, UncertaintySettings
from tests.inspection.drawn_errors import DIMENSIONS, FEATURES, PROGRAM, Drawn, drawn, with_common, with_scale

CERTIFIED_MM = 0.002  # U of a certificate
SHARING = ("width", "half width", "wall")  # that have the scale in common with the certified length


def certifying(name: str = "pins", uncertainty_mm: float = CERTIFIED_MM, **more: object) -> InspectionProgram:
    certificate = {"uncertainty_mm": uncertainty_mm, "number": "4711"}
    made = [{**one, "certificate": certificate} if one["name"] == name else one for one in DIMENSIONS]
    return InspectionProgram.model_validate({"name": "test", "alignment": "none", "features": FEATURES, "dimensions": made, **more})


def settings_of(points: MeasuredPoints) -> InspectionSettings:
    return InspectionSettings(uncertainty=UncertaintySettings(scale_ppm=0.0 if points.errors is None else points.errors.scale * 1e6))


def measured(points: MeasuredPoints, program: InspectionProgram) -> dict[str, Dimension]:
    return {one.name: one for one in inspect(points, program, settings=settings_of(points)).dimensions}


@pytest.mark.parametrize("draws", [16, pytest.param(80, marks=pytest.mark.slow)])
@pytest.mark.parametrize("made", [with_common(drawn()), with_scale(drawn())], ids=["common", "scale"])
def test_corrected_lengths_are_as_uncertain_as_stated(made: Drawn, draws: int) -> None:
    program, scores = certifying(uncertainty_mm=1e-6), []  # the pins are as far apart as they are drawn
    few, of = {"width", "wall", "pins", "pin diameter"}, {"right", "left", "spot", "back", "pin", "small pin"}
    dimensions, features = (
        tuple(one for one in all_of if one.name in kept) for all_of, kept in ((program.dimensions, few), (program.features, of))
    )
    program = program.model_copy(update={"dimensions": dimensions, "features": features})
    for seed in range(draws):
        found = measured(made.measured(np.random.default_rng(seed)), program)
        scores.append([2 * one.deviation / one.uncertainty for one in found.values() if one.name != "pins"])
    scores = np.array(scores)
    within, spread = np.mean(np.abs(scores) <= 2), 3 * np.sqrt(0.954 * 0.046 / (3 * draws))
    assert abs(within - 0.954) < spread
    assert np.abs(np.sqrt(np.mean(scores**2, axis=0)) - 1).max() < 4 / np.sqrt(2 * draws)


def test_a_scale_that_is_hardly_known_is_taken_from_the_certified_length() -> None:
    points = with_scale(drawn(own=0.01)).measured(np.random.default_rng(5))
    plain, corrected = measured(points, PROGRAM), measured(points, certifying())
    for name in SHARING:
        assert corrected[name].uncertainty < plain[name].uncertainty / 3
        assert abs(corrected[name].deviation) < corrected[name].uncertainty
        # half of the scale's share of the certificate for half of its length
        assert corrected[name].budget["certificate"] == pytest.approx(CERTIFIED_MM * corrected[name].nominal / 160, rel=0.05)
        assert "by the certified length pins" in corrected[name].traceability
    assert corrected["pins"].measured == plain["pins"].measured  # itself stays as measured
    assert corrected["corner"].measured == plain["corner"].measured  # as do angles


def test_a_certificate_that_knows_less_than_the_measurement_corrects_nothing() -> None:
    points = drawn().measured(np.random.default_rng(2))
    plain, corrected = measured(points, PROGRAM), measured(points, certifying(uncertainty_mm=1.0))
    assert all(one.measured == plain[name].measured and one.uncertainty == plain[name].uncertainty for name, one in corrected.items())


def test_a_certified_length_that_is_off_by_more_than_its_uncertainty_proves_nothing_and_is_named() -> None:
    points = drawn().exact
    longer = replace(points, points_mm=points.points_mm * 1.001)
    result = inspect(longer, certifying(), settings=settings_of(longer))
    found = {one.name: one for one in result.dimensions}
    plain = measured(longer, PROGRAM)
    assert found["width"].measured == plain["width"].measured
    assert "certified length pins is off by +0.16" in found["width"].warning
    decided = [name for name, one in plain.items() if one.verdict in (Verdict.PASS, Verdict.FAIL) and one.unit == "mm" and name != "pins"]
    assert len(decided) >= 5 and all(found[name].verdict is Verdict.NOT_PROVEN for name in decided)
    assert any("nothing is corrected" in one for one in result.lengths)


def test_what_is_assumed_of_a_foreign_cloud_does_not_contradict_a_certificate() -> None:
    foreign = replace(drawn().exact, errors=None)
    longer = replace(foreign, points_mm=foreign.points_mm * (1 + 0.02 / 160))  # within the calibration that is assumed
    plain, certified = measured(longer, PROGRAM), measured(longer, certifying())
    assert plain["pins"].uncertainty > 0.02 and not certified["width"].warning
    assert certified["width"].verdict is plain["width"].verdict is Verdict.PASS


def test_a_certified_length_that_was_not_measured_is_named_and_corrects_nothing() -> None:
    points = drawn().exact
    assert points.view is not None and points.normals is not None
    kept = np.flatnonzero(points.points_mm[:, 0] > -70)  # without the small pin
    result = inspect(points.where(kept), certifying(), settings=settings_of(points))
    found = {one.name: one for one in result.dimensions}
    assert found["pins"].measured is None and "certified" not in found["width"].traceability
    assert any("pins" in one and "not measured" in one for one in result.lengths)


def test_lengths_in_an_alignment_of_their_own_are_corrected_too() -> None:
    points = with_scale(drawn(own=0.01)).measured(np.random.default_rng(5))
    aligned = [
        {**one, "alignment": "by datums"} if one["name"] == "width" else one for one in certifying().model_dump(mode="json")["dimensions"]
    ]
    program = certifying(
        dimensions=aligned, alignments=[{"name": "by datums", "alignment": {"method": "datums", "datums": ["top", "right", "pin"]}}]
    )
    found = measured(points, program)["width"]
    assert found.measured == pytest.approx(measured(points, certifying())["width"].measured, abs=2e-5)
    assert "by the certified length pins" in found.traceability


def test_two_certified_lengths_know_more_than_one() -> None:
    points = drawn().measured(np.random.default_rng(3))
    both = certifying().model_dump(mode="json")
    for one in both["dimensions"]:
        if one["name"] == "half width":
            one["certificate"] = {"uncertainty_mm": CERTIFIED_MM}
    one, two = measured(points, certifying())["width"], measured(points, InspectionProgram.model_validate(both))["width"]
    assert two.uncertainty < 0.95 * one.uncertainty


def test_a_changed_certificate_is_evaluated_anew_and_a_tolerance_is_not() -> None:
    points = with_scale(drawn()).measured(np.random.default_rng(4))
    session = InspectionSession(points, settings=settings_of(points))
    first = session.measure(certifying())
    tolerance = certifying().model_dump(mode="json")
    tolerance["dimensions"][0]["upper_tolerance"] = 0.2
    assert not session.measure(InspectionProgram.model_validate(tolerance)).measured
    other = session.measure(certifying(uncertainty_mm=0.05))
    assert {node.kind for node in other.measured} == {"dimension"}
    width = [result.inspection.dimensions[0] for result in (first, other)]
    assert width[0].uncertainty < width[1].uncertainty


def test_a_standard_of_another_material_has_another_length_at_the_parts_temperature() -> None:
    steel = PartTemperature(23.0, 0.5, 11.5e-6, 0.6e-6)
    own = LengthCertificate(uncertainty_mm=0.001)
    assert own.known_length(200.0, steel).length_mm == 200.0
    zirconia = LengthCertificate(uncertainty_mm=0.001, material="10±1 ppm/K").known_length(200.0, steel)
    assert zirconia.length_mm == pytest.approx(200.0 * (1 + 10e-6 * 3) / (1 + 11.5e-6 * 3), abs=1e-9)
    by_heat = 200.0 * np.hypot(1.5e-6 * 0.25, 0.5e-6 * 3)
    assert zirconia.sigma_mm == pytest.approx(np.hypot(0.0005, by_heat), rel=1e-6)
    assert LengthCertificate(uncertainty_mm=0.001, material="zirconia").known_length(200.0, None).length_mm == 200.0


@pytest.mark.parametrize(
    ("name", "changes", "words"),
    [
        ("corner", {}, "belongs to one length"),
        ("width", {"nominal": 0.0}, "above 0 mm"),
        ("width", {"certificate": {"uncertainty_mm": 0}}, "greater than 0"),
        ("width", {"certificate": {"uncertainty_mm": 0.01, "material": "cheese"}}, "expansion of 'cheese' is not known"),
    ],
)
def test_what_cannot_be_certified_is_refused(name: str, changes: dict[str, object], words: str) -> None:
    entry = next(one for one in DIMENSIONS if one["name"] == name)
    changed = {**entry, "certificate": {"uncertainty_mm": 0.01}, **changes}
    with pytest.raises(ValidationError, match=words):
        InspectionProgram.model_validate({"name": "test", "alignment": "none", "features": FEATURES, "dimensions": [changed]})
