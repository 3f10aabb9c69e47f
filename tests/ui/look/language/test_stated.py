"""What the core says of a measurement, or refuses, is displayed in Chinese as a whole, whatever values are in it."""

from __future__ import annotations

import re
import tomllib
from typing import get_args

import numpy as np
import pytest
from pydantic import ValidationError

from measureapp.data.cloud import PointCloud
from measureapp.data.consistency import Consistency, ConsistencyCheck
from measureapp.data.dimension import CONTRIBUTION_LABELS, CONTRIBUTIONS
from measureapp.data.dimension_program import BladeKind, SizeKind, ZoneKind
from measureapp.data.fringe import Direction
from measureapp.data.inspection_program import InspectionProgram
from measureapp.data.model import first_problem
from measureapp.data.phase import PixelState
from measureapp.data.point_state import PointState
from measureapp.data.surroundings import KINDS, SURROUNDINGS_KEPT, Surroundings
from measureapp.data.tolerance_text import parse_tolerance
from measureapp.errors import FitError
from measureapp.geometry.fits import fit
from measureapp.inspection.features.found_feature import find_feature
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.settings import InspectionSettings
from measureapp.language.catalogue import read_catalogue
from measureapp.language.translator import Translator
from measureapp.pipeline.consistency.check import PROPERTIES
from measureapp.pipeline.sample import SampleScan, sample_request
from measureapp.register.clouds.quality import assess_cloud
from measureapp.resources import resource
from ui.look.language.sources import catalogue_file
from ui.look.wording import POINT_REASONS, keep_units, sentence, sentence_case

KEPT = re.compile(
    r"`[^`]*`|'[^']*'|\w+_\w+|dimensions\.\d+|\b(?:bore|diameter|position|length|max|ISO)\b"
)  # names, keys of the program, standards


@pytest.fixture(scope="module")
def chinese() -> Translator:
    made = Translator()
    made.use(read_catalogue(catalogue_file("zh_CN")))
    return made


def left_in_english(translator: Translator, text: str) -> list[str]:
    """Return the words that stay as they are when a text is displayed."""
    return re.findall(r"[A-Za-z]{3,}", KEPT.sub("", translator.renewed(text)))


def program(**of_the_dimension: object) -> dict[str, object]:
    bore = {"name": "bore", "shape": "cylinder", "point_mm": [0, 0, 0], "direction": [0, 0, 1], "radius_mm": 5}
    dimension = {"name": "bore diameter", "kind": "diameter", "features": ["bore"], "nominal": 10, "tolerance": "±0.1"}
    return {"name": "part", "features": [bore], "dimensions": [{**dimension, **of_the_dimension}]}


def test_why_a_feature_was_not_found(chinese):
    (described,) = InspectionProgram.model_validate(program()).features
    found = find_feature(described, MeasuredPoints(np.array([[5.0, 0, 0], [0, 5, 0], [-5, 0, 0]])), None, InspectionSettings())["bore"]
    assert found.feature is None and found.reason.startswith("bore: only 3 points were measured there")
    assert chinese.renewed(found.reason).startswith("bore：该处只测到 3 个点")
    assert not left_in_english(chinese, found.reason)
    assert not left_in_english(chinese, "bore: the fitted cylinder is tilted by 12° against its nominal")


def test_why_points_could_not_be_fitted(chinese):
    flat = np.stack([*np.meshgrid(np.arange(6.0), np.arange(6.0)), np.zeros((6, 6))], axis=-1).reshape(-1, 3)
    for shape, points in (("sphere", flat[:3]), ("sphere", flat), ("cone", flat)):
        with pytest.raises(FitError) as refused:
            fit(shape, points)
        assert not left_in_english(chinese, f"bore: {refused.value.message}")


@pytest.mark.parametrize("name", CONTRIBUTIONS)
def test_what_contributes_to_the_uncertainty(chinese, name):
    label = sentence_case(CONTRIBUTION_LABELS.get(name, name))
    assert chinese.renewed(label) != label


def test_several_reasons_of_a_view_follow_the_language_there_and_back():
    quality = assess_cloud(rough_cloud(), completeness=0.02)
    reasons = len(quality.reason.split("; "))
    assert reasons > 1, quality.reason
    translator, catalogue = Translator(), read_catalogue(catalogue_file("zh_CN"))
    shown = translator.renewed(sentence(quality.reason))
    for _ in range(2):
        translator.use(catalogue)
        shown = translator.renewed(shown)
        assert not left_in_english(translator, shown) and len(re.split("; |；", shown)) == reasons
        translator.use(None)
        shown = translator.renewed(shown)
        assert shown == sentence(quality.reason)


def rough_cloud() -> PointCloud:
    """Return a cloud of noisy points."""
    rng, count = np.random.default_rng(2), 3000
    points = np.column_stack([rng.uniform(-8, 8, (count, 2)), rng.normal(0, 0.8, count)])
    ones = np.ones(count)
    return PointCloud(points, np.tile([0.0, 0, 1], (count, 1)), 0.02 * ones, ones, np.full((count, 2), -1), 3 * ones, "camera", "view-01")


def test_what_was_excluded_around_the_part(chinese):
    said = Surroundings(10_000, tuple((kind, 120 * place) for place, kind in enumerate(KINDS, start=1))).sentence
    assert "1.2% background; 2.4% the table's top, and all within 1 mm above it; 3.6% fixtures" in said
    assert "1.2% 为背景；2.4% 为转台台面及其上方 1 mm 以内的所有点" in chinese.renewed(said)
    assert not left_in_english(chinese, said) and not left_in_english(chinese, SURROUNDINGS_KEPT)


@pytest.mark.parametrize("name", [*PROPERTIES, "loop closure"])
def test_what_the_error_model_does_not_explain(chinese, name):
    causes = {
        **{kind: cause for kind, (_, cause) in PROPERTIES.items()},
        "loop closure": "error motions of the table, or a part that moved",
    }
    check = ConsistencyCheck(name, 0.0123, 0.0045, 0.0114, 1e-6, causes[name])
    fine = ConsistencyCheck(name, 0.0046, 0.0045, 0.0, 0.4, causes[name])
    for said in (check.sentence, fine.sentence, Consistency((check,)).sentence, Consistency((fine,)).sentence):
        assert not left_in_english(chinese, said), chinese.renewed(said)
    tip = chinese.translate("{name:upper}: {sentence}", {"name": name, "sentence": check.sentence})
    assert not re.findall(r"[A-Za-z]{3,}", tip) and "0.0114 mm 无法解释" in tip


@pytest.mark.parametrize(
    ("kind", "text"),
    [
        *(
            ("length", text)
            for text in ("0.1", "+0.1/+0.1", "0.1/0.2", "2768-x", "2768-mK", "H3", "A99", "wide", "max 0.1", "±0", "ISO 22081")
        ),
        ("angle", "H7"),
        ("flatness", "±0.1"),
    ],
)
def test_why_a_tolerance_cannot_be_used(chinese, kind, text):
    with pytest.raises(ValueError, match=r".{20}") as refused:
        parse_tolerance(text, kind=kind, nominal=20.0, is_zone=kind == "flatness")
    for said in (str(refused.value), sentence(str(refused.value))):
        assert not left_in_english(chinese, said), chinese.renewed(said)


@pytest.mark.parametrize(
    "changed",
    [
        {"features": ["rim"]},
        {"features": ["bore", "bore"]},
        {"datums": ["bore"]},
        {"alignment": "other"},
        {"kind": "position", "nominal": 0},
        {"tolerance": None, "lower_tolerance": 0.2, "upper_tolerance": 0.1},
        {"features": ["bore{k}"]},
    ],
    ids=str,
)
def test_why_a_change_of_the_program_is_not_possible(chinese, changed):
    with pytest.raises(ValidationError) as refused:
        InspectionProgram.model_validate(program(**changed))
    said = f"The change is not possible: {first_problem(refused.value, 'the program')}."
    assert not left_in_english(chinese, said), chinese.renewed(said)


def test_the_names_of_demos_and_of_their_programs(chinese, tmp_path):
    for part in ("gypsum", "impeller", "gear", "sphere_plate"):
        title = sample_request(SampleScan(part, "quarter", 4, 1, conditions="usual"), tmp_path).created.name
        assert not left_in_english(chinese, title)
        assert not re.findall(r"[A-Za-z]{3,}", KEPT.sub("", chinese.translate("{name} is open.", {"name": title})))
    for file in sorted(resource("parts").glob("*/*.toml")):
        name = tomllib.loads(file.read_text(encoding="utf-8")).get("name")
        assert name is None or not left_in_english(chinese, name), file


def test_a_verdict_whose_units_are_kept_is_translated_and_follows_the_language(chinese, monkeypatch):
    monkeypatch.setattr("ui.look.wording.tr", lambda source, **values: chinese.translate(source, values))
    english = "Adds 0.021 mm (k = 2), at worst 0.131 mm, to a length of 300 mm in this volume: usable."
    said = keep_units(english)
    assert said.endswith("可用。") and "300\u00a0mm" in said and chinese.renewed("Distortion k1") == "畸变 k1"
    catalogue = chinese.catalogue
    chinese.use(None)
    assert chinese.renewed(said) == english.replace(" mm", "\u00a0mm")
    chinese.use(catalogue)
    assert chinese.renewed(english.replace(" mm", "\u00a0mm")) == said


@pytest.mark.parametrize("kind", [*get_args(SizeKind), *get_args(ZoneKind), *get_args(BladeKind), *get_args(Direction)])
def test_kinds_of_dimensions_and_directions_of_fringes(chinese, kind):
    words = kind if kind in get_args(Direction) else sentence_case(kind)
    assert not left_in_english(chinese, words)


@pytest.mark.parametrize("state", [*PixelState, *PointState], ids=lambda state: state.name)
def test_why_a_pixel_has_no_point(chinese, state):
    name = state.name.lower().replace("_", " ")
    words = POINT_REASONS.get(name) or sentence_case(name)
    assert state is PointState.NO_PHASE or not left_in_english(chinese, words)  # whose reason is that of the phase
