"""Marks that are not where the board has them are measured by the images that calibrate the cameras, and U says what is left."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.calibrate.cameras import array
from measureapp.calibrate.cameras.array import CameraArrayProblem, solve
from measureapp.calibrate.cameras.marks import MarkScatter
from measureapp.calibrate.cameras.validation import cross_validate
from measureapp.calibrate.kinds.lenses import mark_warnings
from measureapp.data.certificate import lengths_of_class
from tests.calibrate.cameras.test_array import errors_over_sigma

SIZES = dict.fromkeys(("left", "right", "upper"), (1296, 972))
NOISE_PX = 0.05
SMOOTH = MarkScatter(own_mm=0.004, shared_mm=0.02, length_mm=40.0)
ROUGH = MarkScatter(own_mm=0.02)


def printed(board, scatter: MarkScatter, seed: int):
    """Return the board with displaced marks as it was truly printed."""
    marks = board.flat_corners_mm[:, :2]
    drawn = np.random.default_rng(seed).multivariate_normal(np.zeros(len(marks)), scatter.covariance(marks), 2).T
    return board.model_copy(update={"displaced_mm": tuple(map(tuple, drawn.tolist()))})


def seen(head, board, true, simulate, seed: int, views: int = 16) -> CameraArrayProblem:
    return CameraArrayProblem(board, "left", SIZES, simulate.sightings(head, true, views, NOISE_PX, np.random.default_rng(seed)))


def shape_error_mm(found, true) -> float:
    """Rms distance of the marks found to the true ones, whichever way the board is laid onto itself and however large it is."""
    one, other = (np.array(marks.flat_corners_mm[:, :2]) @ [1, 1j] for marks in (found, true))
    one, other = one - one.mean(), other - other.mean()
    fit = np.vdot(one, other) / np.vdot(one, one)
    return float(np.sqrt(np.mean(np.abs(fit * one - other) ** 2) / 2))


@pytest.mark.parametrize("scatter", [ROUGH, SMOOTH])
def test_displaced_marks_are_found_and_no_longer_move_the_cameras(head, board, simulate, scatter):
    """Each of about 40 images shows a mark to 0.05 px = 0.02 mm: its place is known to some 3 µm, of 20."""
    true = printed(board, scatter, 1)
    problem = seen(head, board, true, simulate, 2)
    stiff, free = solve(replace(problem, free_marks=False)), solve(problem)
    assert free.scatter is not None and stiff.scatter is None
    assert free.scatter.rms_mm == pytest.approx(scatter.rms_mm, rel=0.25)
    assert shape_error_mm(board, true) > 0.015 and shape_error_mm(free.board, true) < 0.006
    before, after = (np.sqrt(np.mean(np.square(list(errors_over_sigma(one, head).values())))) for one in (stiff, free))
    assert before > 1.6 and after < 1.4
    assert free.sigma_px == pytest.approx(NOISE_PX, rel=0.05)
    assert free.calibration.marks_rms_mm == pytest.approx(np.sqrt(2) * scatter.rms_mm, rel=0.25)
    assert stiff.calibration.marks_rms_mm == 0.0


def test_a_board_whose_neighbours_share_displacements_is_of_less_certain_size(head, board, simulate):
    """No image shows a board's size: what its marks have in common is left to U."""
    rough, smooth = (solve(seen(head, board, printed(board, one, 3), simulate, 4)).calibration.cameras["right"] for one in (ROUGH, SMOOTH))
    assert smooth.standard_deviations["x_mm"] > 1.3 * rough.standard_deviations["x_mm"]


def test_marks_in_their_places_are_left_there(head, board, simulate):
    problem = seen(head, board, board, simulate, 5)
    solution = solve(problem)
    assert solution.scatter is None and solution.board.displaced_mm is None
    np.testing.assert_array_equal(solution.covariance, solve(replace(problem, free_marks=False)).covariance)


def test_displaced_marks_are_named_unless_the_class_of_the_board_explains_them(head, board, simulate):
    solution = solve(seen(head, board, printed(board, ROUGH, 12), simulate, 13))
    (said,) = mark_warnings(solution)
    worst = int(np.argmax(np.linalg.norm(solution.board.displaced_mm, axis=1)))
    assert f"row {worst // board.columns + 1}, column {worst % board.columns + 1}" in said
    for name, words in (("ceramic", "chrome on glass or ceramic"), ("printed", None)):
        described = solution.board.model_copy(update={"lengths": lengths_of_class(name)})
        said = mark_warnings(replace(solution, board=described))
        assert not said if words is None else words in said[0]


def test_a_board_of_another_size_looks_like_the_one_described(head, board, simulate):
    """All marks 100 ppm farther apart: 20 µm at the border, and no residual that could show it."""
    larger = board.model_copy(update={"square_mm": board.square_mm * 1.0001})
    assert solve(seen(head, board, larger, simulate, 6)).scatter is None


def test_held_back_views_agree_with_the_marks_found(head, board, simulate):
    problem = seen(head, board, printed(board, SMOOTH, 7), simulate, 8)
    checked = cross_validate(problem, solve(problem), folds=3)
    assert checked.healthy, checked.verdict


def test_beside_cameras_that_are_known_marks_are_judged_as_well(head, board, simulate):
    """Parameters that stay as they are given follow no mark."""
    known = replace(head, cameras={name: head.cameras[name] for name in ("left", "right")})
    sound = replace(seen(head, board, board, simulate, 14), known=known)
    assert solve(sound).scatter is None
    found = solve(replace(seen(head, board, printed(board, SMOOTH, 15), simulate, 16), known=known)).scatter
    assert found is not None and found.rms_mm == pytest.approx(SMOOTH.rms_mm, rel=0.25)


def test_derivatives_by_the_marks(head, board, simulate, monkeypatch):
    """The gradient of the normal equations is half that of the cost, and their matrix its change."""
    kept = {}

    def keep(adjusted, *rest):
        kept["adjusted"] = adjusted
        return solution_of(adjusted, *rest)

    solution_of = array._solution
    monkeypatch.setattr(array, "_solution", keep)
    solve(seen(head, board, printed(board, SMOOTH, 9), simulate, 10, views=6))
    bundle = replace(kept["adjusted"].bundle, huber=np.inf)
    state, layout = kept["adjusted"].minimum.state, bundle.layout
    assert layout.marks == 2 * board.count
    normal = bundle.linearise(state)
    rng = np.random.default_rng(11)
    for _ in range(5):
        step = np.zeros(len(normal.gradient))
        step[layout.marks_at : layout.boards_at] = 1e-4 * rng.standard_normal(layout.marks)
        there, back = (bundle.apply_step(state, way * step) for way in (1.0, -1.0))
        slope = (bundle.cost(there) - bundle.cost(back)) / 2.0
        assert slope == pytest.approx(2.0 * normal.gradient @ step, rel=1e-4, abs=1e-6 * normal.cost)
        change = (bundle.linearise(there).gradient - bundle.linearise(back).gradient) / 2.0
        np.testing.assert_allclose(change, normal.hessian @ step, atol=0.02 * np.abs(change).max())
