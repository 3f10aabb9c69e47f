"""Dimensions are as uncertain as the views they are measured in: what is common to their features drops out, what is not adds up."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import pytest

from measureapp.data.dimension import Dimension, Verdict
from measureapp.data.inspection_program import InspectionProgram
from measureapp.data.part_temperature import PartTemperature
from measureapp.data.view_errors import POWERS, CloudDistortion, FormErrors, SystematicErrors, ViewErrors
from measureapp.geometry.transform import RigidTransform
from measureapp.inspection.dimensions import inspect
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.point_distance import point_distance
from measureapp.inspection.settings import InspectionSettings, UncertaintySettings

VIEWS = 4
NOISE_MM, SHIFT_MM, TURN_RAD, SCALE = 0.01, 0.004, 3e-5, 3e-5
SCALE_PPM = 200.0
COMMON_MM, COMMON_RAD = 0.2, 1e-3  # of all views together: no dimension shows it


def plane(name: str, point: list[float], direction: list[float]) -> dict[str, object]:
    return {"name": name, "shape": "plane", "point_mm": point, "direction": direction, "cut": {"band_mm": 3}}


FEATURES = [
    plane("right", [0, 40, 0], [0, 1, 0]),
    plane("left", [0, -40, 0], [0, -1, 0]),
    plane("top", [0, 0, 60], [0, 0, 1]),
    {"name": "pin", "shape": "cylinder", "point_mm": [80, 0, 0], "direction": [0, 0, 1], "radius_mm": 15, "cut": {"band_mm": 3}},
    {"name": "small pin", "shape": "cylinder", "point_mm": [-80, 0, 0], "direction": [0, 0, 1], "radius_mm": 4, "cut": {"band_mm": 2}},
    {"name": "ball", "shape": "sphere", "point_mm": [0, 0, 120], "radius_mm": 20, "cut": {"band_mm": 3}},
    {"name": "spot", "shape": "surface_point", "point_mm": [5, 40, 3], "direction": [0, 1, 0], "patch_mm": 12, "cut": {"band_mm": 3}},
    {"name": "back", "shape": "surface_point", "point_mm": [5, -40, 3], "direction": [0, -1, 0], "patch_mm": 12, "cut": {"band_mm": 3}},
    {"name": "middle", "shape": "midplane", "of": ["right", "left"]},
    {"name": "foot", "shape": "intersection", "of": ["pin", "top"]},
]
DIMENSIONS = [
    {"name": "width", "kind": "distance", "features": ["right", "left"], "nominal": 80},
    {"name": "half width", "kind": "distance", "features": ["right", "middle"], "nominal": 40},
    {"name": "corner", "kind": "angle", "features": ["right", "top"], "nominal": 90},
    {"name": "pin diameter", "kind": "diameter", "features": ["pin"], "nominal": 30},
    {"name": "small radius", "kind": "radius", "features": ["small pin"], "nominal": 4},
    {"name": "pins", "kind": "distance", "features": ["pin", "small pin"], "nominal": 160},
    {"name": "ball diameter", "kind": "diameter", "features": ["ball"], "nominal": 40},
    {"name": "ball over top", "kind": "distance", "features": ["ball", "top"], "nominal": 60},
    {"name": "wall", "kind": "thickness", "features": ["spot", "back"], "nominal": 80},
    {"name": "foot to wall", "kind": "distance", "features": ["foot", "right"], "nominal": 40},
]
PROGRAM = InspectionProgram.model_validate({"name": "test", "alignment": "none", "features": FEATURES, "dimensions": DIMENSIONS})


@dataclass(frozen=True)
class Drawn:
    """Points without error, which view measured each, and how views and calibration err."""

    exact: MeasuredPoints

    def measured(self, rng: np.random.Generator) -> MeasuredPoints:
        errors, points, view = self.exact.errors, self.exact.points_mm, self.exact.view
        assert errors is not None and view is not None and self.exact.normals is not None
        chosen = [rng.standard_normal(columns.shape[1]) for columns in (errors.stitching_motions, errors.calibration_motions)]
        moved, normals = np.zeros_like(points), np.asarray(self.exact.normals, float)
        for axis, direction in enumerate(np.eye(3)):
            along = errors.along(points, np.tile(direction, (len(points), 1)), view)
            moved[:, axis] = along["stitching"] @ chosen[0] + along["calibration"] @ chosen[1]
        out = NOISE_MM * rng.standard_normal(len(points))
        for share, columns in errors.along(points, normals, view).items():
            if share in ("form", "common"):
                out += columns @ rng.standard_normal(columns.shape[1])
        if errors.scale:
            points = points * (1 + errors.scale * rng.standard_normal())
        return replace(self.exact, points_mm=points + moved + out[:, None] * normals)


def surfaces(rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    u, v = rng.uniform(-25, 25, (2, 300))
    flat = np.zeros(300)
    turn, height = rng.uniform(0, 2 * np.pi, 300), rng.uniform(-20, 20, 300)
    round_ = np.column_stack([np.cos(turn), np.sin(turn), flat])
    ball = rng.standard_normal((300, 3))
    ball /= np.linalg.norm(ball, axis=1, keepdims=True)
    parts = [
        (np.column_stack([u, flat + 40, v]), [0, 1, 0]),
        (np.column_stack([u, flat - 40, v]), [0, -1, 0]),
        (np.column_stack([u, v, flat + 60]), [0, 0, 1]),
        (15 * round_ + np.column_stack([flat + 80, flat, height]), round_),
        (4 * round_ + np.column_stack([flat - 80, flat, height]), round_),
        (20 * ball + [0, 0, 120], ball),
    ]
    return np.vstack([points for points, _ in parts]), np.vstack([np.broadcast_to(normal, (300, 3)) for _, normal in parts])


def errors_of(rng: np.random.Generator, own: float = 1.0) -> ViewErrors:
    poses = tuple(RigidTransform.from_vector(rng.normal(size=3), rng.normal(0, 400, 3), "part", "camera") for _ in range(VIEWS))
    centres = rng.uniform(-40, 40, (VIEWS, 3))
    common = np.zeros((6 * VIEWS, 6))
    for number, centre in enumerate(centres):
        block = common[6 * number : 6 * number + 6]
        block[:3, :3], block[3:, 3:] = COMMON_MM * np.eye(3), COMMON_RAD * np.eye(3)
        block[:3, 3:] = COMMON_RAD * np.cross(np.eye(3), centre).T  # about the origin
    rows = rng.normal(size=(6 * VIEWS, 6 * VIEWS))  # correlated among views
    sizes = own * np.tile([SHIFT_MM] * 3 + [TURN_RAD] * 3, VIEWS)
    mixed = sizes[:, None] * rows / np.linalg.norm(rows, axis=1, keepdims=True)
    grown = np.zeros((len(POWERS), 3, 1))
    for axis, power in enumerate(((1, 0, 0), (0, 1, 0), (0, 0, 1))):
        grown[POWERS.index(power), axis, 0] = SCALE * own * 100.0
    held = np.zeros((6 * VIEWS, 1))  # the poses follow the scale so that the middle of the part stays in its place
    for number, pose in enumerate(poses):
        held[6 * number : 6 * number + 3, 0] = SCALE * own * pose.translation_mm
    return ViewErrors(poses, centres, np.hstack([common, mixed]), held, CloudDistortion(np.zeros(3), np.full(3, 100.0), grown))


def drawn(own: float = 1.0) -> Drawn:
    rng = np.random.default_rng(8)
    points, normals = surfaces(rng)
    faced = np.arctan2(normals[:, 1], normals[:, 0]) / (2 * np.pi) * VIEWS
    view = np.floor(faced + np.arange(len(points)) % 2 + 0.5).astype(int) % VIEWS  # two views see each place
    return Drawn(MeasuredPoints(points, normals, np.full(len(points), NOISE_MM), view, errors_of(rng, own)))


def with_form(made: Drawn) -> Drawn:
    """Add errors of form as large as those by the poses, that change over less than the part."""
    points, view = made.exact.points_mm, made.exact.view
    assert made.exact.errors is not None and view is not None
    nodes = [points[view == number][::60] for number in range(VIEWS)]
    of = np.repeat(np.arange(VIEWS), [len(each) for each in nodes])
    motions = np.random.default_rng(2).normal(size=(6 * VIEWS, len(of))) * np.tile([SHIFT_MM / 9] * 3 + [TURN_RAD / 9] * 3, VIEWS)[:, None]
    form = FormErrors(np.vstack(nodes), of, np.full(VIEWS, SHIFT_MM), np.full(VIEWS, 30.0), motions)
    return Drawn(replace(made.exact, errors=replace(made.exact.errors, form=form)))


def with_common(made: Drawn) -> Drawn:
    """Add errors that all views have in common, as large as those by the poses."""
    assert made.exact.errors is not None
    nodes = np.random.default_rng(3).normal(size=(12, 3))
    nodes /= np.linalg.norm(nodes, axis=1, keepdims=True)
    motions = np.random.default_rng(4).normal(size=(6 * VIEWS, 12)) * np.tile([SHIFT_MM / 4] * 3 + [TURN_RAD / 4] * 3, VIEWS)[:, None]
    return Drawn(replace(made.exact, errors=replace(made.exact.errors, systematic=SystematicErrors(nodes, SHIFT_MM, motions))))


def with_scale(made: Drawn) -> Drawn:
    """Add a scale of everything that errs more than all else together over 100 mm."""
    assert made.exact.errors is not None
    return Drawn(replace(made.exact, errors=replace(made.exact.errors, scale=SCALE_PPM * 1e-6)))


def inspected(points: MeasuredPoints) -> tuple[Dimension, ...]:
    scale_ppm = 0.0 if points.errors is None else points.errors.scale * 1e6
    return inspect(points, PROGRAM, settings=InspectionSettings(uncertainty=UncertaintySettings(scale_ppm=scale_ppm))).dimensions


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
