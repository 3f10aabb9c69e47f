from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from measureapp.data.measurement import Alignment
from measureapp.data.mesh import Mesh
from measureapp.errors import InspectionError
from measureapp.geometry.transform import RigidTransform
from measureapp.inspection.alignment.best_fit import best_fit
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.settings import AlignmentSettings, InspectionSettings
from measureapp.progress import CallbackProgress, Cancelled
from tests.inspection.conftest import FITTED, THINNED

NOISE_MM = 0.02
# Noise 0.02 mm over 20 000 points, ten standard deviations and more of any of the six unknowns; four and more where the fit is thinned.
PLACE_BOUND_MM = 0.005


def displacement_mm(found: RigidTransform, placed: RigidTransform, nominal: Mesh, fold: int) -> float:
    """Greatest displacement of the nominal's vertices, over the turns that bring the part back onto itself."""
    vertices = np.asarray(nominal.vertices_mm)
    back = (found @ placed).apply(vertices)
    turns = [Rotation.from_euler("z", 360 * k / fold, degrees=True).as_matrix() for k in range(fold)]
    return min(float(np.linalg.norm(back - vertices @ turn.T, axis=1).max()) for turn in turns)


@dataclass(frozen=True)
class Fitted:
    """A part with its equal positions about z, where it was laid, and where its best fit puts it."""

    nominal: Mesh
    fold: int
    placed: RigidTransform
    alignment: Alignment


@pytest.fixture(scope="module")
def fitted_on_table(samples, scan, on_table) -> Callable[..., Fitted]:
    """The best fit of a part turned on the table, found once for all that is to be said of it."""

    @cache
    def fitted(part: str, fold: int, turn_deg: float, settings: InspectionSettings) -> Fitted:
        nominal, placed = samples(part).nominal, on_table(turn_deg)
        found = best_fit(scan(nominal, placed, NOISE_MM, count=20_000), samples(part).surface, settings.alignment)
        return Fitted(nominal, fold, placed, found)

    return fitted


IMPELLER_ON_TABLE = ("impeller", 7, -95.0)


@pytest.mark.parametrize(
    ("on_table_at", "settings"),
    [
        pytest.param(("gypsum", 2, 137.0), InspectionSettings(), id="gypsum"),
        pytest.param(IMPELLER_ON_TABLE, THINNED, id="impeller thinned"),
        pytest.param(IMPELLER_ON_TABLE, InspectionSettings(), id="impeller", marks=pytest.mark.slow),
        pytest.param(("gear", 24, 51.0), InspectionSettings(), id="gear", marks=pytest.mark.slow),
        pytest.param(("sphere_plate", 2, 20.0), InspectionSettings(), id="sphere_plate", marks=pytest.mark.slow),
    ],
)
def test_a_part_turned_anyhow_on_the_table_is_found(on_table_at, settings: InspectionSettings, fitted_on_table) -> None:
    made = fitted_on_table(*on_table_at, settings)
    assert displacement_mm(made.alignment.nominal_from_part, made.placed, made.nominal, made.fold) < PLACE_BOUND_MM
    assert made.alignment.rms_mm == pytest.approx(NOISE_MM, rel=0.1)
    assert made.alignment.undetermined == ()


@pytest.mark.parametrize("settings", FITTED)
def test_a_part_on_its_head_is_not_taken_for_an_upright_one_that_fits_fairly_well(settings: InspectionSettings, samples, scan) -> None:
    gear = samples("gear")
    over = RigidTransform.from_parts(np.diag([1.0, -1.0, -1.0]), [3.0, -2.0, 40.0], "part", "nominal")
    alignment = best_fit(scan(gear.nominal, over, NOISE_MM, count=20_000), gear.surface, settings.alignment)
    assert alignment.nominal_from_part.rotation[2, 2] < -0.99
    assert alignment.name == "best fit"  # upright it fits with 100 times the cost


def test_a_part_seen_from_one_side_only_is_found(samples, scan, on_table) -> None:
    nominal, placed = samples("gypsum").nominal, on_table(70.0)
    half = scan(nominal, placed, NOISE_MM, count=20_000, seen_from=(0.6, -0.5, 0.6))
    alignment = best_fit(half, nominal)
    assert displacement_mm(alignment.nominal_from_part, placed, nominal, 2) < 2 * PLACE_BOUND_MM


@pytest.mark.parametrize("settings", FITTED)
def test_a_cloud_in_any_frame_is_found(settings: InspectionSettings, samples, scan) -> None:
    nominal = samples("gypsum").nominal
    placed = RigidTransform.from_vector([1.9, -0.7, 1.1], [400, -250, 900], "part", "nominal")
    alignment = best_fit(scan(nominal, placed, NOISE_MM, count=20_000), nominal, settings.alignment)
    assert displacement_mm(alignment.nominal_from_part, placed, nominal, 2) < PLACE_BOUND_MM


@pytest.mark.parametrize("settings", FITTED)
def test_of_the_equal_answers_of_a_symmetric_part_the_nearest_is_taken(settings: InspectionSettings, fitted_on_table) -> None:
    alignment = fitted_on_table(*IMPELLER_ON_TABLE, settings).alignment
    turn = Rotation.from_matrix(alignment.nominal_from_part.rotation).magnitude()
    assert np.degrees(turn) <= 360 / 7 / 2 + 1


def test_points_that_do_not_belong_to_the_part_do_not_pull_it(samples, scan, on_table) -> None:
    nominal, placed = samples("gypsum").nominal, on_table(33.0)
    part = scan(nominal, placed, NOISE_MM, count=20_000)
    rng = np.random.default_rng(5)
    table = np.column_stack([rng.uniform(-60, 60, (3000, 2)), np.full(3000, -2.0)])
    both = MeasuredPoints(np.vstack([part.points_mm, table]))
    alignment = best_fit(both, nominal)
    assert displacement_mm(alignment.nominal_from_part, placed, nominal, 2) < 4 * PLACE_BOUND_MM


def test_a_plate_seen_from_above_leaves_shifts_and_a_turn_open_and_says_so() -> None:
    rng = np.random.default_rng(2)
    corners = np.array([[-50, -40, 0], [50, -40, 0], [50, 40, 0], [-50, 40, 0]], float)
    plate = Mesh(corners, np.array([[0, 1, 2], [0, 2, 3]]), "nominal")
    seen = np.column_stack([rng.uniform(-40, 40, 3000), rng.uniform(-30, 30, 3000), rng.normal(0, 0.01, 3000)])
    alignment = best_fit(MeasuredPoints(seen, np.tile([0.0, 0.0, 1.0], (3000, 1))), plate)
    assert set(alignment.undetermined) == {"rotation about z", "translation along x", "translation along y"}


@pytest.mark.parametrize(("factor", "unit"), [(1e-3, "metres"), (1 / 25.4, "inches"), (0.1, "centimetres")])
def test_a_cloud_in_another_unit_is_refused_and_the_unit_named(factor: float, unit: str, samples, scan, on_table) -> None:
    nominal = samples("gypsum").nominal
    cloud = scan(nominal, on_table(0.0), count=20_000)
    with pytest.raises(InspectionError, match=f"points look like {unit}"):
        best_fit(MeasuredPoints(cloud.points_mm * factor), nominal)
    with pytest.raises(InspectionError, match=f"nominal looks like {unit}"):
        best_fit(cloud, Mesh(nominal.vertices_mm * factor, nominal.triangles, "nominal"))


def test_the_nominal_of_another_part_is_refused(samples, scan, on_table) -> None:
    cloud = scan(samples("impeller").nominal, on_table(10.0), count=20_000)
    with pytest.raises(InspectionError, match="nominal"):
        best_fit(cloud, samples("gypsum").nominal)


def test_an_empty_cloud_is_refused(samples: Callable) -> None:
    with pytest.raises(InspectionError, match="no measured points"):
        best_fit(MeasuredPoints(np.empty((0, 3))), samples("gypsum").nominal)


def test_a_search_in_all_directions_can_be_cancelled(samples, scan, on_table) -> None:
    nominal, heard = samples("gypsum").nominal, list[float]()

    def listen(done: float, total: float, _note: str) -> None:
        heard.append(done / total)
        if done / total > 0.4:
            raise Cancelled

    with pytest.raises(Cancelled):
        best_fit(
            scan(nominal, on_table(70.0), NOISE_MM, count=5_000),
            nominal,
            AlignmentSettings(upright=False),
            progress=CallbackProgress(listen),
        )
    assert heard == sorted(heard) and heard[0] < 0.35 and len(heard) > 3
