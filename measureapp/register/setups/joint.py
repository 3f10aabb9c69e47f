"""Joint of all set-ups: relative positions from all pairs, least squares over the graph of set-ups."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.view_errors import POSE, RANK_TOLERANCE
from measureapp.errors import RegistrationError
from measureapp.geometry.transform import RigidTransform
from measureapp.register.pairs.icp import PairMeasurement, apply_motion
from measureapp.register.pairs.observability import find_unconstrained_motions
from measureapp.register.setups.setup_cloud import PreparedSetUp
from measureapp.register.setups.spheres import Sphere, SphereMatch

ORIGIN = np.zeros(3)
WEAK_MM = 0.2  # greatest standard deviation of a set-up's points by the joint


@dataclass(frozen=True, slots=True, eq=False)
class SurfacePoints:
    """Points of one set-up that determine its position, in the common part frame."""

    points_mm: FloatArray  # (N, 3)
    normals: FloatArray  # (N, 3)
    view: IntArray  # (N,), of that set-up


@dataclass(frozen=True, slots=True, eq=False)
class JointEdge:
    """Measured relative position of two set-ups; motions are translations and rotations about the part frame's origin."""

    target: int
    source: int
    change: FloatArray  # (6,), remaining correction of the source relative to the target
    information: FloatArray  # (6, 6), its inverse covariance
    target_points: SurfacePoints
    source_points: SurfacePoints
    residual_mm: float


@dataclass(frozen=True, slots=True, eq=False)
class Joint:
    """Positions of all set-ups; the first one defines the part frame."""

    part_from_setup: tuple[RigidTransform, ...]
    covariance: FloatArray  # (6S, 6S), of motions about the origin; zero for the first set-up
    edges: tuple[JointEdge, ...]

    def gains(self) -> FloatArray:
        """Return the motions (6S, 6E) of all set-ups by the changes of all edges."""
        rows = [_incidence(edge, len(self.part_from_setup)).T @ edge.information for edge in self.edges]
        return np.asarray(self.covariance @ np.hstack(rows))


def _incidence(edge: JointEdge, count: int) -> FloatArray:
    """Return the change of an edge (6, 6S) by the motions of all set-ups."""
    rows = np.zeros((POSE, POSE * count))
    rows[:, POSE * edge.source : POSE * (edge.source + 1)] = np.eye(POSE)
    rows[:, POSE * edge.target : POSE * (edge.target + 1)] = -np.eye(POSE)
    return rows


def solve_joint(setups: Sequence[PreparedSetUp], poses: Sequence[RigidTransform], edges: Sequence[JointEdge]) -> Joint:
    """Weighted least squares over all edges, linearised at ``poses`` (part_from_setup); the first set-up stays.

    Raises
    ------
    RegistrationError
        The edges do not determine the position of a set-up; names it and the motions.
    """
    count = len(poses)
    matrix, right = np.zeros((POSE * count,) * 2), np.zeros(POSE * count)
    for edge in edges:
        rows = _incidence(edge, count)
        matrix += rows.T @ edge.information @ rows
        right += rows.T @ edge.information @ edge.change
    free = matrix[POSE:, POSE:]
    for number in range(1, count):
        _require_determined(setups[number], poses[number], _marginal(free, number - 1))
    size = np.sqrt(np.diag(free))
    covariance = np.zeros_like(matrix)
    covariance[POSE:, POSE:] = np.linalg.inv(free / np.outer(size, size)) / np.outer(size, size)
    motions = (covariance @ right).reshape(count, POSE)
    moved = tuple(apply_motion(pose, motion, ORIGIN) for pose, motion in zip(poses, motions, strict=True))
    return Joint(moved, (covariance + covariance.T) / 2, tuple(edges))


def _marginal(information: FloatArray, number: int) -> FloatArray:
    """Return the information (6, 6) about one set-up, whatever the positions of the others (Schur complement)."""
    own = np.arange(POSE * number, POSE * (number + 1))
    others = np.setdiff1d(np.arange(len(information)), own)
    across = information[np.ix_(own, others)]
    return np.asarray(information[np.ix_(own, own)] - across @ np.linalg.pinv(information[np.ix_(others, others)]) @ across.T)


def _require_determined(setup: PreparedSetUp, pose: RigidTransform, information: FloatArray) -> None:
    centre = pose.apply(setup.prepared.centroid_mm)
    back = np.linalg.inv(shift_origin(centre))
    weak = find_unconstrained_motions(back.T @ information @ back, centre, setup.prepared.radius_mm, WEAK_MM)
    if weak:
        raise RegistrationError(
            f"The surface that {setup.name} has in common with the other set-ups does not determine: {'; '.join(weak)}.",
            "Add a set-up that sees more of both (the part on its edge), or join by the nominal or by at least three reference spheres.",
        )


def edge_by_surface(
    pair: PairMeasurement, indices: tuple[int, int], setups: Sequence[PreparedSetUp], poses: Sequence[RigidTransform]
) -> JointEdge:
    """Return a measured pair as an edge in the part frame."""
    i, j = indices
    rotation = poses[i].rotation
    centre = poses[i].apply(pair.centre_mm)
    turned = np.kron(np.eye(2), rotation)
    about_centre = shift_origin(centre)
    information = about_centre.T @ turned @ pair.information @ turned.T @ about_centre
    return JointEdge(
        i,
        j,
        np.asarray(np.linalg.solve(about_centre, turned @ pair.change)),
        information,
        _points(setups[i], poses[i], pair.matched_target),
        _points(setups[j], poses[j], pair.matched_source),
        pair.residual_mm,
    )


def shift_origin(centre_mm: FloatArray) -> FloatArray:
    """Return the matrix (6, 6) from a motion about the origin to the same motion about ``centre_mm``."""
    x, y, z = centre_mm
    matrix = np.eye(POSE)
    matrix[:3, 3:] = -np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return matrix


def _points(setup: PreparedSetUp, pose: RigidTransform, chosen: IntArray) -> SurfacePoints:
    prepared = setup.prepared
    return SurfacePoints(pose.apply(prepared.points_mm[chosen]), pose.rotate(prepared.normals[chosen]), setup.view[chosen])


def edge_by_spheres(
    match: SphereMatch,
    indices: tuple[int, int],
    setups: Sequence[PreparedSetUp],
    spheres: Sequence[Sequence[Sphere]],
    poses: Sequence[RigidTransform],
) -> JointEdge:
    """Return the position by reference spheres as an edge: their centres, weighted by their covariances."""
    i, j = indices
    information, right, squares = np.zeros((POSE, POSE)), np.zeros(POSE), []
    for a, b in zip(match.target, match.source, strict=True):
        ours, theirs = spheres[i][a], spheres[j][b]
        covariance = sum(
            (pose.rotation @ one.covariance_mm2 @ pose.rotation.T for pose, one in ((poses[i], ours), (poses[j], theirs))), np.zeros((3, 3))
        )
        place = poses[j].apply(theirs.centre_mm)
        gap = poses[i].apply(ours.centre_mm) - place
        rows, weight = shift_origin(place)[:3], np.linalg.inv(covariance)
        information += rows.T @ weight @ rows
        right += rows.T @ weight @ gap
        squares.append(float(gap @ gap))
    own = [_sphere_points(setups[k].given.stitched, poses[k], spheres[k], chosen) for k, chosen in ((i, match.target), (j, match.source))]
    return JointEdge(i, j, np.linalg.solve(information, right), information, own[0], own[1], float(np.sqrt(np.mean(squares))))


def _sphere_points(cloud: object, pose: RigidTransform, spheres: Sequence[Sphere], chosen: Sequence[int]) -> SurfacePoints:
    from measureapp.data.cloud import StitchedCloud

    assert isinstance(cloud, StitchedCloud)
    rows = np.concatenate([spheres[number].points for number in chosen])
    view = np.asarray(cloud.view if cloud.sampled_view is None else cloud.sampled_view)[rows]
    return SurfacePoints(pose.apply(cloud.points_mm[rows]), pose.rotate(np.asarray(cloud.normals[rows], float)), view)


def rigid_gain(surface: SurfacePoints) -> FloatArray:
    """Return the motion (6, N) about the origin that displacements of the points along their normals cause in a point-to-plane fit."""
    middle = surface.points_mm.mean(axis=0)
    arms = surface.points_mm - middle
    length = max(1.0, float(np.sqrt(np.mean(np.sum(arms**2, axis=1)))))
    scale = np.array([1.0, 1.0, 1.0, length, length, length])
    jacobian = np.hstack([surface.normals, np.cross(arms, surface.normals)]) / scale
    about_middle = np.linalg.pinv(jacobian, rcond=RANK_TOLERANCE) / scale[:, None]
    return np.asarray(np.linalg.solve(shift_origin(middle), about_middle))
