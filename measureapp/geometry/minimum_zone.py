"""Minimum-zone (Chebyshev) fits: the least greatest distance, by a sequence of linear programs in a trust region.

G. T. Anthony et al., Chebyshev best-fit geometric elements, NPL report DITC 221/93, 1993.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.optimize import linprog

from measureapp.arrays import FloatArray
from measureapp.errors import FitError
from measureapp.geometry.feature import Feature, Shape
from measureapp.geometry.fits import Scaled, described, fit, state_of
from measureapp.geometry.shapes import MODELS, Model, State

ITERATIONS = 200
CONVERGED = 1e-12  # gain that the linear program still promises, relative to the size of the data
LEAST_STEP = 1e-13
ACTIVE = 400  # points in one linear program: the furthest on both sides
POSSIBLE: tuple[Shape, ...] = ("plane", "sphere", "cylinder", "cone", "torus")


def fit_minimum_zone(shape: Shape, points_mm: FloatArray) -> Feature:
    """Fit ``shape`` so that the greatest distance of any point is least; starts at the least-squares fit.

    ``form_error_mm`` is then the width of the minimum zone. The search ends when a linear program over all contacts
    proves that no small change narrows the zone further.

    Raises
    ------
    FitError
        As `fit`; also for lines and circles in space, whose zones are not offered, or when the proof is not reached.
    """
    if shape not in POSSIBLE:
        raise FitError(
            f"A minimum zone is not offered for a {shape} in space.", "Use least-squares, or one of: " + ", ".join(POSSIBLE) + "."
        )
    begin = fit(shape, points_mm)
    points = np.asarray(points_mm, np.float64)
    scaled = Scaled.of(points)
    state = _narrowed(MODELS[shape], state_of(begin, scaled), scaled.points)
    keep = np.ones(len(points), np.bool_)
    made = described(shape, state, scaled, np.ones(len(points)), keep)
    return replace(made, standard_deviations={})


def _narrowed(model: Model, state: State, points: FloatArray) -> State:
    radius, width = 0.1, _width(model, state, points)
    for _ in range(ITERATIONS):
        step, promised = _linear_program(model, state, points, radius)
        gain = width - promised
        if gain < CONVERGED:
            return state
        trial = model.moved(state, step)
        narrower = width - _width(model, trial, points)
        if narrower > 0.1 * gain:
            state, width = trial, width - narrower
            radius = min(2 * radius, 1.0) if narrower > 0.75 * gain else radius
        else:
            radius = 0.25 * min(radius, float(np.abs(step).max()))
        if radius < LEAST_STEP:
            return state
    raise FitError("The minimum zone was not found.", "Use the least-squares criterion, or leave out outliers first.")


def _width(model: Model, state: State, points: FloatArray) -> float:
    distances, _ = model.evaluate(state, points)
    return float(np.abs(distances[0]).max())


def _linear_program(model: Model, state: State, points: FloatArray, radius: float) -> tuple[FloatArray, float]:
    """Return the step within ``radius`` that narrows the linearised zone most, and the half width it promises."""
    distances, derivatives = model.evaluate(state, points)
    distance, slope = distances[0], derivatives[0]
    chosen = np.argsort(-np.abs(distance))[:ACTIVE] if len(distance) > ACTIVE else np.arange(len(distance))
    for _ in range(20):
        rows = np.vstack(
            [np.column_stack([slope[chosen], -np.ones(len(chosen))]), np.column_stack([-slope[chosen], -np.ones(len(chosen))])]
        )
        right = np.concatenate([-distance[chosen], distance[chosen]])
        cost = np.append(np.zeros(model.parameters), 1.0)
        bounds = [(-radius, radius)] * model.parameters + [(0, None)]
        found = linprog(cost, rows, right, bounds=bounds, method="highs-ds", options={"primal_feasibility_tolerance": 1e-10})
        if not found.success:
            return np.zeros(model.parameters), np.inf
        step, promised = found.x[:-1], float(found.x[-1])
        exceeded = np.flatnonzero(np.abs(distance + slope @ step) > promised + 1e-12)
        missing = np.setdiff1d(exceeded, chosen)
        if len(missing) == 0:
            return step, promised
        worst = missing[np.argsort(-np.abs(distance + slope @ step)[missing])[:ACTIVE]]
        chosen = np.concatenate([chosen, worst])
    return step, promised
