"""Minimum-zone (Chebyshev) fits: the least greatest distance, by linear programs in a trust region and Newton steps on their contacts.

G. T. Anthony et al., Chebyshev best-fit geometric elements, NPL report DITC 221/93, 1993; the two kinds of steps as in
R. Fletcher and E. Sainz de la Maza, Nonlinear programming and nonsmooth optimization by successive linear programming,
Mathematical Programming 43, 1989.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.optimize import linprog, nnls

from measureapp.arrays import FloatArray, IntArray
from measureapp.errors import FitError
from measureapp.geometry.feature import Feature, Shape
from measureapp.geometry.fits import Scaled, described, fit, state_of
from measureapp.geometry.shapes import Model, State
from measureapp.geometry.zone_models import ZONES

ITERATIONS = 200
CONVERGED = 1e-12  # gain that the linear program still promises, relative to the size of the data
LEAST_STEP = 1e-13
ACTIVE = 400  # points in one linear program: the furthest on both sides
CONTACT = 1e-10  # a point this close to the border of the zone touches it, relative to the size of the data
PROVEN = 1e-7  # greatest slope that the forces of the contacts may leave unbalanced
PROBE = 1e-4  # step of the second differences, relative to the radius of curvature of the distances


@dataclass(frozen=True, slots=True, eq=False)
class MinimumZone:
    """A minimum-zone feature and the proof that no small change makes its zone narrower.

    Forces of sizes ``shares``, which sum to 1, at the ``contacts``, pushing outwards on the upper side and inwards on the
    lower, are in balance: for every small change of the feature at least one contact comes to lie further out. By a change that
    moves the feature by δ mm the half width could fall by at most ``imbalance``·δ, to first order.
    """

    feature: Feature
    contacts: IntArray  # (K,), indices of the points that touch the border of the zone and hold it
    shares: FloatArray  # (K,), positive, sum 1
    imbalance: float


def fit_minimum_zone(shape: Shape, points_mm: FloatArray) -> MinimumZone:
    """Fit ``shape`` so that the greatest distance of any point is least; starts at the least-squares fit.

    ``form_error_mm`` is then the width of the minimum zone: for a line the diameter of the narrowest cylinder about all
    points, for a circle the radial width of the narrowest ring within the least-squares plane.

    Raises
    ------
    FitError
        As `fit`; also when the proof is not reached.
    """
    begin = fit(shape, points_mm)
    points = np.asarray(points_mm, np.float64)
    scaled, model = Scaled.of(points), ZONES[shape]
    state = _narrowed(model, state_of(begin, scaled), scaled.points)
    contacts, shares, imbalance = _certificate(model, state, scaled.points)
    if imbalance > PROVEN:
        raise _not_found()
    made = described(shape, state, scaled, np.ones(len(points)), np.ones(len(points), np.bool_))
    return MinimumZone(replace(made, standard_deviations={}, covariance=None), contacts, shares, imbalance)


def _not_found() -> FitError:
    return FitError("The minimum zone was not found.", "Use the least-squares criterion, or leave out outliers first.")


def _narrowed(model: Model, state: State, points: FloatArray) -> State:
    radius, width = 0.1, _width(model, state, points)
    for _ in range(ITERATIONS):
        step, promised, forces = _linear_program(model, state, points, radius)
        gain = width - promised
        if gain < CONVERGED:
            return state
        trials = [model.moved(state, found) for found in (step, _newton_step(model, state, points, forces)) if found is not None]
        widths = [_width(model, trial, points) for trial in trials]
        best = int(np.argmin(widths))
        narrower = width - widths[best]
        if narrower > 0.1 * gain or (best == 1 and narrower > 0):
            state, width = trials[best], widths[best]
            radius = min(2 * radius, 1.0) if best == 0 and narrower > 0.75 * gain else radius
        else:
            radius = 0.25 * min(radius, float(np.abs(step).max()))
        if radius < LEAST_STEP:
            return state
    return state


def _width(model: Model, state: State, points: FloatArray) -> float:
    distances, _ = model.evaluate(state, points)
    width = float(np.abs(distances[0]).max())
    return width if np.isfinite(width) else np.inf


def _linear_program(model: Model, state: State, points: FloatArray, radius: float) -> tuple[FloatArray, float, FloatArray]:
    """Return the step within ``radius`` that narrows the linearised zone most, its half width, and the forces (N,) of the contacts."""
    distances, derivatives = model.evaluate(state, points)
    distance, slope = distances[0], derivatives[0]
    chosen = np.argsort(-np.abs(distance))[:ACTIVE] if len(distance) > ACTIVE else np.arange(len(distance))
    forces = np.zeros(len(distance))
    for _ in range(20):
        rows = np.vstack(
            [np.column_stack([slope[chosen], -np.ones(len(chosen))]), np.column_stack([-slope[chosen], -np.ones(len(chosen))])]
        )
        right = np.concatenate([-distance[chosen], distance[chosen]])
        cost = np.append(np.zeros(model.parameters), 1.0)
        bounds = [(-radius, radius)] * model.parameters + [(0, None)]
        found = linprog(cost, rows, right, bounds=bounds, method="highs-ds", options={"primal_feasibility_tolerance": 1e-10})
        if not found.success:
            return np.zeros(model.parameters), np.inf, forces
        step, promised = found.x[:-1], float(found.x[-1])
        upper, lower = -found.ineqlin.marginals.reshape(2, -1)
        forces = np.zeros(len(distance))
        forces[chosen] = upper - lower
        exceeded = np.flatnonzero(np.abs(distance + slope @ step) > promised + 1e-12)
        missing = np.setdiff1d(exceeded, chosen)
        if len(missing) == 0:
            break
        worst = missing[np.argsort(-np.abs(distance + slope @ step)[missing])[:ACTIVE]]
        chosen = np.concatenate([chosen, worst])
    return step, promised, forces


def _newton_step(model: Model, state: State, points: FloatArray, forces: FloatArray) -> FloatArray | None:
    """Return the step that brings the contacts to one distance where the curvature of their distances is balanced too.

    Fewer contacts than parameters hold a zone when distances are curved (a circle about two points); the linear program
    alone then creeps.
    """
    contacts = np.flatnonzero(np.abs(forces) > 1e-9)
    held, force = points[contacts], forces[contacts]
    distances, derivatives = model.evaluate(state, held)
    side = np.sign(force)
    count, many = model.parameters, len(contacts)
    if many == 0:
        return None
    system = np.zeros((count + 1 + many, count + 1 + many))
    system[:count, :count] = _curvature(model, state, held, force)
    rows = np.column_stack([side[:, None] * derivatives[0], -np.ones(many)])
    system[: count + 1, count + 1 :], system[count + 1 :, : count + 1] = rows.T, rows
    right = np.concatenate([np.zeros(count), [-1.0], -side * distances[0]])
    solution = np.linalg.lstsq(system, right, rcond=1e-12)[0][:count]
    return np.asarray(solution) if np.isfinite(solution).all() and np.abs(solution).max() < 1 else None


def _curvature(model: Model, state: State, held: FloatArray, force: FloatArray) -> FloatArray:
    """Second derivatives (P, P) of the sum of the contacts' distances, each times its force."""

    def total(step: FloatArray) -> float:
        return float(model.evaluate(model.moved(state, step), held)[0][0] @ force)

    reach = (
        float(np.abs(model.evaluate(state, held)[0]).max()) if model is ZONES["line"] else 1.0
    )  # distances from an axis curve over their length
    probe = PROBE * max(reach, PROBE)
    probes = probe * np.eye(model.parameters)
    made = np.empty((model.parameters, model.parameters))
    for i, one in enumerate(probes):
        for j, other in enumerate(probes[: i + 1]):
            corners = total(one + other) - total(one - other) - total(other - one) + total(-one - other)
            made[i, j] = made[j, i] = corners / (4 * probe**2)
    return made


def _certificate(model: Model, state: State, points: FloatArray) -> tuple[IntArray, FloatArray, float]:
    """Find the shares of the contacts whose forces balance best (non-negative least squares)."""
    distances, derivatives = model.evaluate(state, points)
    far = np.abs(distances[0])
    touching = np.flatnonzero(far >= far.max() - CONTACT)
    forces = (np.sign(distances[0][touching])[:, None] * derivatives[0][touching]).T
    shares, _ = nnls(np.vstack([forces, np.ones(len(touching))]), np.append(np.zeros(model.parameters), 1.0))
    total = float(shares.sum())
    imbalance = float(np.linalg.norm(forces @ shares)) / total if total > 0 else np.inf
    used = shares > 0
    return touching[used], shares[used] / max(total, 1e-300), imbalance
