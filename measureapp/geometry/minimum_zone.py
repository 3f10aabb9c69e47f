"""Minimum-zone (Chebyshev) fits: minimise the greatest distance by sequential linear programming in a trust region.

G. T. Anthony et al., Chebyshev best-fit geometric elements, NPL report DITC 221/93, 1993.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.optimize import linprog, minimize, nnls

from measureapp.arrays import FloatArray, IntArray
from measureapp.errors import FitError
from measureapp.geometry.feature import Feature, Shape
from measureapp.geometry.fits import Scaled, fit, state_of, to_feature
from measureapp.geometry.shapes import MODELS, Distances, State
from measureapp.geometry.zone_models import ZONES

ITERATIONS = 200
CONVERGED = 1e-12  # improvement predicted by the linear program, relative to the size of the data
LEAST_STEP = 1e-13
ACTIVE = 400  # points in one linear program: the furthest on both sides
CONTACT = 1e-10  # distance of a contact point from the border of the zone, relative to the size of the data
PROVEN = 1e-7  # greatest residual of the optimality condition
NEAR = 60  # points in one search for the smallest enclosing cylinder: the furthest


@dataclass(frozen=True, slots=True, eq=False)
class MinimumZone:
    """A minimum-zone feature with its certificate of local optimality.

    The ``multipliers`` of the ``contacts``, positive and of sum 1, satisfy the first-order (Karush-Kuhn-Tucker) condition: the
    gradients of the contact distances, outwards on the upper and inwards on the lower side, balance. A change of the feature
    by δ mm can reduce the half width of the zone by at most ``imbalance``·δ, to first order.
    """

    feature: Feature
    contacts: IntArray  # (K,), indices of the contact points
    multipliers: FloatArray  # (K,), positive, sum 1
    imbalance: float  # norm of the residual of the condition


def fit_minimum_zone(shape: Shape, points_mm: FloatArray) -> MinimumZone:
    """Fit ``shape`` by the minimum-zone (minimax) criterion, starting at the least-squares fit.

    ``form_error_mm`` is the width of the minimum zone: for a line the diameter of the smallest enclosing cylinder, for a circle
    the radial width of the narrowest annulus in the least-squares plane.

    Raises
    ------
    FitError
        As `fit`; also when optimality cannot be certified.
    """
    begin = fit(shape, points_mm)
    points = np.asarray(points_mm, np.float64)
    scaled, model = Scaled.of(points), ZONES[shape]
    state = _narrow(model, state_of(begin, scaled), scaled.points)
    contacts, multipliers, imbalance = _certify(model, state, scaled.points)
    if imbalance > PROVEN:
        raise _not_found()
    made = to_feature(shape, state, scaled, np.ones(len(points)), np.ones(len(points), np.bool_))
    return MinimumZone(replace(made, standard_deviations={}, covariance=None), contacts, multipliers, imbalance)


def _not_found() -> FitError:
    return FitError("The minimum-zone fit did not converge.", "Use the least-squares criterion, or remove outliers first.")


def _narrow(model: Distances, state: State, points: FloatArray) -> State:
    radius, width = 0.1, _width(model, state, points)
    for _ in range(ITERATIONS):
        step, predicted = _linear_program(model, state, points, radius)
        gain = width - predicted
        if gain < CONVERGED:
            return state
        trial = _enclose(state, points) if model is ZONES["line"] else model.move(state, step)
        narrower = width - _width(model, trial, points)
        if narrower > 0.1 * gain or (model is ZONES["line"] and narrower > 0):
            state, width = trial, width - narrower
            radius = min(2 * radius, 1.0) if narrower > 0.75 * gain else radius
        else:
            radius = 0.25 * min(radius, float(np.abs(step).max()))
        if radius < LEAST_STEP:
            return state
    return state


def _width(model: Distances, state: State, points: FloatArray) -> float:
    distances, _ = model.evaluate(state, points)
    width = float(np.abs(distances[0]).max())
    return width if np.isfinite(width) else np.inf


def _linear_program(model: Distances, state: State, points: FloatArray, radius: float) -> tuple[FloatArray, float]:
    """Solve the linearised problem within the trust ``radius``; return the step and the predicted half width."""
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
        step, predicted = found.x[:-1], float(found.x[-1])
        exceeded = np.flatnonzero(np.abs(distance + slope @ step) > predicted + 1e-12)
        missing = np.setdiff1d(exceeded, chosen)
        if len(missing) == 0:
            break
        worst = missing[np.argsort(-np.abs(distance + slope @ step)[missing])[:ACTIVE]]
        chosen = np.concatenate([chosen, worst])
    return step, predicted


def _enclose(state: State, points: FloatArray) -> State:
    """Return the axis of the smallest enclosing cylinder, to first order in the tilt.

    Distances from an axis are strongly curved near zero, where linear programs converge slowly. Projected along the axis the
    problem is convex: the smallest circle around points that shift in proportion to their height as the axis tilts.
    """
    distances, _ = ZONES["line"].evaluate(state, points)
    width = float(distances[0].max())
    near = np.argsort(-distances[0])[:NEAR]
    across, slopes = MODELS["line"].evaluate(state, points[near])
    across, slopes = across / width, np.moveaxis(slopes, 2, 0)

    def offsets(step: FloatArray) -> FloatArray:
        return np.asarray(across + np.tensordot(step[:4], slopes, 1))

    def slack(step: FloatArray) -> FloatArray:
        return np.asarray(step[4] ** 2 - np.sum(offsets(step) ** 2, axis=0))

    def slack_slopes(step: FloatArray) -> FloatArray:
        return np.column_stack([-2 * np.sum(offsets(step) * slopes, axis=1).T, np.full(len(near), 2 * step[4])])

    found = minimize(
        lambda step: step[4],
        np.array([0.0, 0.0, 0.0, 0.0, 1.0]),
        jac=lambda _: np.array([0.0, 0.0, 0.0, 0.0, 1.0]),
        constraints={"type": "ineq", "fun": slack, "jac": slack_slopes},
        method="SLSQP",
        options={"ftol": 1e-15, "maxiter": 200},
    )
    return ZONES["line"].move(state, width * found.x[:4])


def _certify(model: Distances, state: State, points: FloatArray) -> tuple[IntArray, FloatArray, float]:
    """Find the multipliers of the contacts that satisfy the optimality condition best (non-negative least squares)."""
    distances, derivatives = model.evaluate(state, points)
    far = np.abs(distances[0])
    touching = np.flatnonzero(far >= far.max() - CONTACT)
    gradients = (np.sign(distances[0][touching])[:, None] * derivatives[0][touching]).T
    multipliers, _ = nnls(np.vstack([gradients, np.ones(len(touching))]), np.append(np.zeros(model.parameters), 1.0))
    total = float(multipliers.sum())
    imbalance = float(np.linalg.norm(gradients @ multipliers)) / total if total > 0 else np.inf
    used = multipliers > 0
    return touching[used], multipliers[used] / max(total, 1e-300), imbalance
