"""Every alignment of a program: it recovers a displaced part and states its name, its residuals and the motions it does not fix."""

from __future__ import annotations

import numpy as np
import pytest
from pydantic import ValidationError

from measureapp.data.inspection_program import InspectionProgram
from measureapp.data.measurement import Alignment
from measureapp.data.mesh import Mesh
from measureapp.errors import InspectionError
from measureapp.geometry.transform import RigidTransform
from measureapp.inspection.alignment.align import align
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.surface.nominal import NominalSurface
from tests.inspection.conftest import FITTED
from tests.inspection.machined_part import Part, cylinder, plane

NOISE_MM = 0.01
PLACED = RigidTransform.from_vector([0.002, -0.0015, 0.0025], [0.15, -0.2, 0.1], "part", "nominal")
# Planes of 4000 points: 0.01 / sqrt(4000) mm. Surface points of a 5 mm patch: about 90 points and six unknowns, 0.003 mm.
FEATURE_BOUND_MM = 0.005
PATCH_BOUND_MM = 0.03
POINTS = 20_000  # of an impeller: as many as a fit takes at most


def block(lifted_mm: float = 0.0, only: str = "") -> MeasuredPoints:
    """Top, front and side of a block 60 mm wide; a quarter of the top may be lifted."""
    part = Part(np.random.default_rng(4), NOISE_MM)
    if only in ("", "top"):
        part.square([0, 0, 30], [0, 0, 1], [1, 0, 0], height=lambda u, v: lifted_mm * (u > 0))
    if only == "":
        part.square([0, -30, 0], [0, -1, 0], [1, 0, 0])
        part.square([30, 0, 0], [1, 0, 0], [0, 1, 0])
    return part.displaced()


FEATURES = [plane("top", [0, 0, 30], [0, 0, 1]), plane("front", [0, -30, 0], [0, -1, 0]), plane("side", [30, 0, 0], [1, 0, 0])]
SPOTS = {
    "t1": ([-20, -20, 30], [0, 0, 1]), "t2": ([20, -20, 30], [0, 0, 1]), "t3": ([0, 20, 30], [0, 0, 1]),
    "f1": ([-20, -30, 0], [0, -1, 0]), "f2": ([20, -30, 0], [0, -1, 0]), "s1": ([30, 0, 0], [1, 0, 0]),
}  # fmt: skip
SPOT_FEATURES = [
    {"name": name, "shape": "surface_point", "point_mm": point, "direction": direction, "patch_mm": 5}
    for name, (point, direction) in SPOTS.items()
]
RPS = {"method": "rps", "points": [{"feature": name} for name in SPOTS]}


def aligned(points: MeasuredPoints, alignment: object, features: list | None = None, surface: NominalSurface | None = None) -> Alignment:
    program = InspectionProgram.model_validate({"name": "block", "alignment": alignment, "features": features or FEATURES + SPOT_FEATURES})
    return align(points, program, surface, InspectionSettings(), "part")


def off_mm(alignment: Alignment) -> float:
    """How far the corners of the block end from their places."""
    corners = 30.0 * np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    return float(np.linalg.norm((alignment.nominal_from_part @ PLACED).apply(corners) - corners, axis=1).max())


@pytest.mark.parametrize(
    ("alignment", "named", "bound"),
    [
        ("3-2-1:top,front,side", "3-2-1", FEATURE_BOUND_MM),
        ("3-2-1:top,front,s1", "3-2-1", PATCH_BOUND_MM),
        ("datums:top,front,side", "datum system top|front|side", FEATURE_BOUND_MM),
        (RPS, "RPS (6 points: t1, t2, t3, f1, f2, s1)", PATCH_BOUND_MM),
    ],
)
def test_a_displaced_block_is_aligned_by_its_features(alignment, named, bound) -> None:
    found = aligned(block(), alignment)
    assert off_mm(found) < bound
    assert found.name.startswith(named)
    assert found.undetermined == ()
    assert found.residuals_mm and max(found.residuals_mm.values()) < bound


@pytest.mark.parametrize(
    ("alignment", "left_open"),
    [
        ("datums:top", {"translation along x", "translation along y", "rotation about z"}),
        ("datums:top,front", {"translation along x"}),
        ("rps:t1,t2,t3", {"translation along x", "translation along y", "rotation about z"}),
        ("rps:t1,t2,t3,f1,f2", {"translation along x"}),
    ],
)
def test_motions_not_fixed_by_the_features_are_named(alignment: str, left_open: set[str]) -> None:
    found = aligned(block(), alignment)
    assert set(found.undetermined) == left_open
    assert any("Motions not fixed by the features: from none" in note for note in found.notes)


def test_more_reference_points_than_needed_leave_their_residuals() -> None:
    """A fourth point of the top that lies 0.2 mm too high: a quarter of it stays at each corner of the rectangle, by least squares."""
    part = Part(np.random.default_rng(1), NOISE_MM)
    part.square([0, 0, 30], [0, 0, 1], [1, 0, 0], height=lambda u, v: 0.2 * ((u > 0) & (v > 0)), count=16000)
    spots = [
        {"name": f"p{k}", "shape": "surface_point", "point_mm": [x, y, 30], "direction": [0, 0, 1], "patch_mm": 6}
        for k, (x, y) in enumerate([(-20, -20), (20, -20), (20, 20), (-20, 20)])
    ]
    found = aligned(part.at_its_place(), "rps:p0,p1,p2,p3", spots)
    assert all(residual == pytest.approx(0.05, abs=PATCH_BOUND_MM / 3) for residual in found.residuals_mm.values())


def test_a_centre_can_be_constrained_along_chosen_directions() -> None:
    part = Part(np.random.default_rng(2), NOISE_MM)
    places = {"a": [0, 0, 0], "b": [100, 0, 0], "c": [0, 80, 0]}
    for place in places.values():
        part.ball(place)
    balls = [{"name": name, "shape": "sphere", "point_mm": place, "radius_mm": 15} for name, place in places.items()]
    held = [
        {"feature": "a", "along": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]},
        {"feature": "b", "along": [[0, 1, 0], [0, 0, 1]]},
        {"feature": "c", "along": [[0, 0, 1]]},
    ]
    found = aligned(part.displaced(), {"method": "rps", "points": held}, balls)
    assert found.undetermined == ()
    assert off_mm(found) < PATCH_BOUND_MM
    assert max(found.residuals_mm.values()) < 1e-3


def test_a_missing_feature_refuses_the_alignment_and_says_which() -> None:
    with pytest.raises(InspectionError, match=r"3-2-1.*failed: front: only 0 points"):
        aligned(block(only="top"), "3-2-1:top,front,side")


@pytest.mark.parametrize(
    ("alignment", "reason"),
    [
        ("3-2-1:t1,front,side", "t1 is a point: 3-2-1 needs a plane"),
        ("3-2-1:top,t1,side", "t1 is a point: 3-2-1 needs a line, an axis"),
        ("3-2-1:top,bore,s1", "do not fix rotation about z, and the surface point s1 fixes a translation only"),
        ("rps:t1,t2,bore", "bore is a cylinder: as a reference point it needs `along`"),
        ("datums:top,bore,bore", "constrains nothing"),
        ("datums:t1", "a datum must be a plane, an axis or a centre"),
    ],
)
def test_features_that_cannot_fix_the_part_are_refused_with_the_reason(alignment: str, reason: str) -> None:
    part = Part(np.random.default_rng(4), NOISE_MM)
    part.square([0, 0, 30], [0, 0, 1], [1, 0, 0])
    part.square([0, -30, 0], [0, -1, 0], [1, 0, 0])
    part.square([30, 0, 0], [1, 0, 0], [0, 1, 0])
    part.round([0, 0, 0], 10, hole=True, length_mm=40)
    features = [*FEATURES, *SPOT_FEATURES, cylinder("bore", [0, 0, 0], 10, hole=True)]
    with pytest.raises(InspectionError, match=reason):
        aligned(part.displaced(), alignment, features)


@pytest.mark.parametrize(
    ("alignment", "reason"),
    [
        ("local:", "is not an alignment"),
        ("datums:top,none", "needs feature 'none'"),
        ({"method": "best-fit", "fold": 7, "features": ["top"]}, "remove `features`"),
        ({"method": "best-fit", "regions": [{}]}, "a region needs at least one of"),
        ({"method": "rps", "points": [{"feature": "t1"}]}, "at least 3"),
    ],
)
def test_an_alignment_that_makes_no_sense_is_refused_when_the_program_is_read(alignment: object, reason: str) -> None:
    with pytest.raises(ValidationError, match=reason):
        InspectionProgram.model_validate({"name": "block", "alignment": alignment, "features": FEATURES + SPOT_FEATURES})


@pytest.mark.parametrize("settings", FITTED)
@pytest.mark.parametrize(
    "alignment", ["local:plate top,bore", {"method": "best-fit", "regions": [{"radial_mm": [0, 60]}, {"z_mm": [11.5, 12.5]}]}]
)
def test_a_local_best_fit_is_not_pulled_by_bent_blades(alignment: object, settings: InspectionSettings, samples, scan, on_table) -> None:
    """The blades lean by 0.4 mm at their tops: that pulls the global fit, not one to the plate and the hub."""
    sample, placed = samples("impeller"), on_table(3.0)
    straight = scan(sample.nominal, RigidTransform.identity("part", "nominal"), count=POINTS)
    bent = straight.points_mm.copy()
    blades = (bent[:, 2] > 12.5) & (np.hypot(bent[:, 0], bent[:, 1]) > 46)
    bent[blades, 0] += 0.4 * (bent[blades, 2] - 12) / 40
    points = MeasuredPoints(bent, straight.normals).seen_from(placed)
    document = {**sample.program.model_dump(exclude_unset=True), "alignment": alignment}
    found = align(points, InspectionProgram.model_validate(document), sample.surface, settings, "part")
    assert found.name.startswith("local best fit (")
    places = np.array([[0.0, 0, 12], [100, 0, 12], [0, 100, 12], [-100, 0, 12]])
    back = (found.nominal_from_part @ placed).apply(places)  # the bore's axis and the plate's height; nothing holds the rotation about z
    assert np.abs(back[:, 2] - 12).max() < 0.005
    assert np.linalg.norm(back[0, :2]) < 0.01


@pytest.mark.parametrize("settings", FITTED)
def test_the_positions_of_a_true_impeller_are_indistinguishable(settings: InspectionSettings, samples, scan, on_table) -> None:
    impeller = samples("impeller")
    found = _cyclic(scan(impeller.nominal, on_table(3.0), count=POINTS), impeller.surface, settings)
    assert found.undetermined == ("which of 7 positions about the axis",)
    assert "All 7 positions about the axis are indistinguishable" in found.notes[0]
    assert found.name == "best fit, 7 positions about the axis"


@pytest.mark.parametrize("settings", FITTED)
def test_a_mark_on_one_blade_distinguishes_the_positions(settings: InspectionSettings, samples, scan) -> None:
    """One blade of the nominal is 4 mm lower than the others, and so is that of the part, laid down two positions on."""
    nominal = samples("impeller").nominal
    marked = _with_a_low_blade(nominal)
    placed = RigidTransform.from_vector([0, 0, np.radians(2 * 360 / 7 + 2)], [5, -3, 1], "part", "nominal")
    found = _cyclic(scan(marked, placed, count=POINTS), NominalSurface(marked), settings)
    assert found.undetermined == ()
    assert "One of 7 positions about the axis fits" in found.notes[0]
    assert np.abs((found.nominal_from_part @ placed).matrix - np.eye(4)).max() < 0.01


def _with_a_low_blade(nominal):
    vertices = np.array(nominal.vertices_mm)
    angle = np.degrees(np.arctan2(vertices[:, 1], vertices[:, 0])) % 360
    tops = np.isclose(vertices[:, 2], 52) & (np.hypot(vertices[:, 0], vertices[:, 1]) > 100)
    first = np.flatnonzero(tops)[np.argsort(angle[tops])]
    gap = int(np.argmax(np.diff(angle[first]) > 15))  # the tops of one blade lie together
    vertices[first[: gap + 1], 2] -= 4.0
    return Mesh(vertices, nominal.triangles, "nominal")


def _cyclic(points: MeasuredPoints, surface: NominalSurface, settings: InspectionSettings) -> Alignment:
    program = InspectionProgram.model_validate({"name": "p", "alignment": "cyclic:7", "features": FEATURES})
    return align(points, program, surface, settings, "part")
