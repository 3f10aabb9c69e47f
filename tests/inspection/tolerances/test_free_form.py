"""Profile of regions of the nominal mesh, and zones that do not lie evenly about the drawing, on surfaces with known deviations."""

from __future__ import annotations

import numpy as np
import pytest
from inspection.machined_part import BORE_MM, RADIUS_MM, Part, cylinder, plane

from measureapp.data.dimension import Dimension, Verdict
from measureapp.data.inspection_program import InspectionProgram
from measureapp.data.mesh import Mesh
from measureapp.inspection.dimensions import inspect
from measureapp.inspection.settings import InspectionSettings, UncertaintySettings

ONLY_NOISE = InspectionSettings(uncertainty=UncertaintySettings(placement_mm=0, systematic_mm=0, systematic_relative=0))
NOISE_MM, STEP_MM, HALF_MM, HEIGHT_MM = 0.02, 0.5, 30.0, 200.0
DATUMS = [
    plane("base", [0, 0, 0], [0, 0, 1]),
    plane("side", [-80, 0, 40], [-1, 0, 0]),
    plane("front", [0, -120, 40], [0, -1, 0]),
]
WAVE = {"name": "wave", "shape": "free_form", "x_mm": [-28, 28], "y_mm": [-28, 28], "z_mm": [150, 250]}
ASKED = {"kind": "surface_profile", "features": ["wave"], "datums": ["base", "front", "side"], "upper_tolerance": 0.5}
FACET_MM = 0.5 * STEP_MM**2 * 4 / 15**2  # what a facet lies inside the wave at most: half its step squared times half the curvature


def wave(x, y):
    return HEIGHT_MM + 4 * np.sin(x / 15) * np.cos(y / 20)


def normals_at(x, y):
    made = np.column_stack([-4 / 15 * np.cos(x / 15) * np.cos(y / 20), 4 / 20 * np.sin(x / 15) * np.sin(y / 20), np.ones_like(x)])
    return made / np.linalg.norm(made, axis=1, keepdims=True)


def dent(x, y):
    """Into the material by 0.08 mm over a plateau larger than a cell, whose rim is soft."""
    return -0.08 / (1 + np.exp((np.hypot(x - 6, y + 4) - 9) / 0.5))


def sheet(corner, first, second, cells=1) -> tuple[np.ndarray, np.ndarray]:
    share = np.linspace(0, 1, cells + 1)
    v, u = np.meshgrid(share, share, indexing="ij")
    vertices = np.asarray(corner, float) + u.reshape(-1, 1) * np.asarray(first, float) + v.reshape(-1, 1) * np.asarray(second, float)
    at = np.arange((cells + 1) ** 2).reshape(cells + 1, cells + 1)
    a, b, c, d = at[:-1, :-1].ravel(), at[:-1, 1:].ravel(), at[1:, 1:].ravel(), at[1:, :-1].ravel()
    return vertices, np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])


@pytest.fixture(scope="module")
def nominal() -> Mesh:
    top, faces = sheet([-HALF_MM, -HALF_MM, 0], [2 * HALF_MM, 0, 0], [0, 2 * HALF_MM, 0], round(2 * HALF_MM / STEP_MM))
    top[:, 2] = wave(*top[:, :2].T)
    sheets = [
        (top, faces),
        sheet([-HALF_MM, -HALF_MM, 0], [2 * HALF_MM, 0, 0], [0, 2 * HALF_MM, 0]),
        sheet([-80, -HALF_MM, 10], [0, 0, 2 * HALF_MM], [0, 2 * HALF_MM, 0]),
        sheet([-HALF_MM, -120, 10], [2 * HALF_MM, 0, 0], [0, 0, 2 * HALF_MM]),
    ]
    starts = np.cumsum([0, *(len(vertices) for vertices, _ in sheets)])
    triangles = np.vstack([one + start for (_, one), start in zip(sheets, starts, strict=False)])
    return Mesh(np.vstack([one for one, _ in sheets]), triangles, "nominal")


def part(seed: int, noise_mm: float = NOISE_MM, deviation=dent, count: int = 8000) -> Part:
    made = Part(np.random.default_rng(seed), noise_mm)
    made.square([0, 0, 0], [0, 0, 1], [1, 0, 0])
    made.square([-80, 0, 40], [-1, 0, 0], [0, 0, 1])
    made.square([0, -120, 40], [0, -1, 0], [1, 0, 0])
    x, y = made.rng.uniform(-HALF_MM, HALF_MM, (2, count))
    normals = normals_at(x, y)
    made.add(np.column_stack([x, y, wave(x, y)]) + deviation(x, y)[:, None] * normals, normals)
    return made


def measured(points: Part, nominal: Mesh | None, *asked: dict, features=(*DATUMS, WAVE)) -> list[Dimension]:
    dimensions = [{"name": str(number), **one} for number, one in enumerate(asked)]
    document = {"name": "p", "alignment": "none", "features": features, "dimensions": dimensions}
    return list(inspect(points.displaced(), InspectionProgram.model_validate(document), nominal, settings=ONLY_NOISE).dimensions)


def test_the_profile_of_a_free_form_is_twice_its_greatest_deviation_wherever_the_part_lies(nominal):
    (found,) = measured(part(0, 0.0), nominal, ASKED)
    assert found.measured == pytest.approx(0.16, abs=2 * FACET_MM + 1e-3), found.reason
    assert "means of 5 mm cells" in found.traceability and "datums base|front|side" in found.traceability


def test_without_datums_the_alignment_places_it(nominal):
    (found,) = measured(part(0, 0.0, lambda x, y: np.full_like(x, 0.05)), nominal, {**ASKED, "datums": []})
    # the displaced part is not where the drawing has it: z + 0.1 mm + tilts of 0.002 rad over up to 200 mm, all within a millimetre
    assert found.measured is not None and 0.1 < found.measured < 2
    assert "located by the alignment" in found.traceability


@pytest.mark.parametrize(("offset_mm", "truth"), [(0.0, 0.16), (-0.04, 0.08), (-0.1, 0.2), (0.05, 0.26)])
def test_the_middle_of_the_zone_may_lie_off_the_nominal(nominal, offset_mm, truth):
    """The deviations run from −0.08 to 0: a zone into the material by half of that is 0.08 wide, one to either side wider."""
    (found,) = measured(part(0, 0.0), nominal, {**ASKED, "zone_offset_mm": offset_mm})
    assert found.measured == pytest.approx(truth, abs=2 * FACET_MM + 1e-3)
    assert ("the material" in found.traceability) == bool(offset_mm)


def test_a_zone_on_one_side_only_passes_what_lies_there_and_fails_the_other_side(nominal):
    """All deviations lie between −0.11 and −0.03 mm: 0.07 at most from the middle of a zone inside, 0.21 from that of one outside."""
    inside, outside = measured(
        part(1, deviation=lambda x, y: dent(x, y) - 0.03),
        nominal,
        *({**ASKED, "upper_tolerance": 0.2, "zone_offset_mm": offset} for offset in (-0.1, 0.1)),
    )
    assert inside.verdict is Verdict.PASS and outside.verdict is Verdict.FAIL
    assert inside.measured == pytest.approx(0.14, abs=inside.uncertainty) and outside.measured == pytest.approx(
        0.42, abs=outside.uncertainty
    )


@pytest.mark.parametrize("hole", [False, True])
def test_out_of_the_material_is_inwards_in_a_bore(hole):
    made = Part(np.random.default_rng(0), 0.0)
    radius = BORE_MM if hole else RADIUS_MM
    made.round([0, 0, 0], radius + 0.03, hole=hole)
    feature = cylinder("round", [0, 0, 0], radius, hole=hole)
    document = {
        "name": "p", "alignment": "none", "features": [feature],
        "dimensions": [{"name": "d", "kind": "surface_profile", "features": ["round"], "zone_offset_mm": 0.03}],
    }  # fmt: skip
    found = inspect(made.at_its_place(), InspectionProgram.model_validate(document), settings=ONLY_NOISE).dimensions[0]
    assert found.measured == pytest.approx(0.12 if hole else 0.0, abs=1e-3), found.reason


@pytest.mark.parametrize("times", [3, pytest.param(60, marks=pytest.mark.slow)])
def test_the_uncertainty_holds_in_95_of_100_cases(nominal, times):
    made = [measured(part(seed), nominal, ASKED)[0] for seed in range(times)]
    held = [abs(one.measured - 0.16) <= one.uncertainty + 2 * FACET_MM for one in made]
    assert np.count_nonzero(held) >= 0.95 * times - 2.5 * np.sqrt(0.05 * 0.95 * times)


def test_a_line_profile_sees_only_what_its_section_cuts(nominal):
    section = {"point_mm": [0, 18, 0], "normal": [0, 1, 0]}
    beside, through = measured(
        part(0, 0.0),
        nominal,
        {**ASKED, "kind": "line_profile", "section": section},
        {**ASKED, "kind": "line_profile", "section": {**section, "point_mm": [0, -4, 0]}},
    )
    assert beside.measured < 0.01 and through.measured == pytest.approx(0.16, abs=2 * FACET_MM + 1e-3), through.reason


def test_only_surface_facing_the_requested_direction_belongs_to_it(nominal):
    whole = {"name": "wave", "shape": "free_form", "z_mm": [-10, 300]}
    up = {**whole, "facing": [0, 0, 1]}
    named = [measured(part(0, 0.0), nominal, {**ASKED}, features=(*DATUMS, one))[0].traceability for one in (whole, up)]
    counts = [int(one.split("wave: ")[1].split(" points")[0]) for one in named]
    assert counts[0] > counts[1] > 8000  # of four faces two look upwards: the wave and the base


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"datums": ["base", "side"]}, "do not fix the location of wave: free are translation along y"),
        ({"features": ["far"]}, "only 0 points were measured there"),
    ],
)
def test_a_missing_profile_is_refused_with_the_reason(nominal, change, said):
    far = {**WAVE, "name": "far", "z_mm": [400, 500]}
    (found,) = measured(part(0, 0.0), nominal, {**ASKED, **change}, features=(*DATUMS, WAVE, far))
    assert found.verdict is Verdict.NOT_MEASURED and said in found.reason


def test_without_a_nominal_mesh_there_is_no_free_form():
    (found,) = measured(part(0, 0.0), None, ASKED)
    assert found.verdict is Verdict.NOT_MEASURED and "has no `nominal`" in found.reason


@pytest.mark.parametrize(
    ("feature", "dimension", "said"),
    [
        ({**WAVE, "x_mm": [3, 1]}, {}, "smaller to the greater"),
        ({**WAVE, "facing": [0, 0, 0]}, {}, "give the direction"),
        (WAVE, {"kind": "flatness", "datums": []}, "only a surface_profile or line_profile"),
        (WAVE, {"features": ["base"], "datums": ["wave"]}, "only a surface_profile or line_profile"),
        (WAVE, {"kind": "position", "zone_offset_mm": 0.1}, "line_profile or surface_profile only"),
    ],
)
def test_programs_that_cannot_be_meant_are_refused(feature, dimension, said):
    with pytest.raises(ValueError, match=said):
        InspectionProgram.model_validate({"name": "p", "features": [*DATUMS, feature], "dimensions": [{"name": "d", **ASKED, **dimension}]})


def test_nothing_is_made_of_a_free_form_nor_aligned_by_it():
    middle = {"name": "middle", "shape": "midpoint", "of": ["wave", "base"]}
    for change, said in (({"features": [*DATUMS, WAVE, middle]}, "use a plane"), ({"alignment": "datums:base,wave"}, "use another")):
        with pytest.raises(ValueError, match=said):
            InspectionProgram.model_validate({"name": "p", "features": [*DATUMS, WAVE], **change})
