"""Joining of set-ups: positions, joint least squares, one merged cloud with one error model."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.cloud import StitchedCloud, ViewPlacement
from measureapp.data.setups import JoinedSetUp, JoinMethod
from measureapp.errors import RegistrationError
from measureapp.geometry.transform import RigidTransform
from measureapp.progress import NoProgress, PartOf, Progress
from measureapp.register.merge import merge
from measureapp.register.pairs.icp import measure_pair
from measureapp.register.settings import StitchSettings
from measureapp.register.setups.coarse import all_starts, contradicted, starts_near, starts_turned
from measureapp.register.setups.errors import join_errors
from measureapp.register.setups.joint import Joint, JointEdge, edge_by_spheres, edge_by_surface, shift_origin, solve_joint
from measureapp.register.setups.position import HINT_WITHIN_DEG, MOST_CONTRADICTED, Position, check, find_position, weakest_information
from measureapp.register.setups.setup_cloud import PreparedSetUp, SetUpCloud, prepare_setups
from measureapp.register.setups.spheres import Sphere, SphereMatch, as_transform, find_spheres, match_spheres

ROUNDS = 4
FINE_SEARCH = 2.0  # in voxels
CONVERGED_MM = 1e-4
NOMINAL = "nominal"


@dataclass(frozen=True, slots=True, eq=False)
class NominalFit:
    """The nominal, sampled, and the best fit of every set-up to it."""

    surface: StitchedCloud  # in frame `nominal`
    nominal_from_part: Mapping[str, RigidTransform]  # by set-up


@dataclass(frozen=True, slots=True, eq=False)
class JoinRequest:
    """How set-ups are to be joined."""

    method: JoinMethod = "overlap"
    turned: Mapping[str, FloatArray] | None = None  # rough rotation (3, 3) of the part from the first set-up to this one, by name
    sphere_diameter_mm: float | None = None
    nominal: NominalFit | None = None


@dataclass(frozen=True, slots=True, eq=False)
class JoinedCloud:
    """Result of joining."""

    stitched: StitchedCloud  # of all set-ups, in the part frame of the first one
    setups: tuple[JoinedSetUp, ...]
    joint: Joint


def join_setups(
    setups: Sequence[SetUpCloud],
    calibrations: Sequence[str],
    request: JoinRequest,
    settings: StitchSettings = StitchSettings(),  # noqa: B008 - frozen
    progress: Progress = NoProgress(),  # noqa: B008 - stateless
) -> JoinedCloud:
    """Join the clouds of several set-ups of one part.

    Parameters
    ----------
    calibrations : id of the calibration of each set-up

    Raises
    ------
    RegistrationError
        The set-ups have too little in common, contradict each other, or fit in several positions; names them.
    """
    for one in setups:
        if one.stitched.errors is None:
            raise RegistrationError(f"{one.name} has no error model.", "Compute it again: measureapp process PROJECT.")
    progress.report(0, 1, "preparing set-ups")
    prepared = prepare_setups(setups)
    joint, positions = _by_spheres(prepared, request) if request.method == "spheres" else _by_surface(prepared, request, progress)
    errors = join_errors([one.stitched.errors for one in setups if one.stitched.errors is not None], calibrations, joint)
    stitched = _merge(setups, joint, settings, PartOf(progress, 0.7, 1.0))
    joined = tuple(_describe(number, prepared, joint, positions, request.method) for number in range(len(setups)))
    return JoinedCloud(replace(stitched, errors=errors), joined, joint)


def _by_surface(setups: Sequence[PreparedSetUp], request: JoinRequest, progress: Progress) -> tuple[Joint, dict[int, Position]]:
    """Find the position of every set-up relative to an earlier one, then solve all pairs that overlap jointly, with the nominal if given."""
    poses = [RigidTransform.identity("part", setups[0].name)]
    for number in range(1, len(setups)):
        progress.report(0.1 + 0.5 * number / len(setups), 1, f"finding the position of {setups[number].name}")
        poses.append(_place(setups, poses, number, request))
    count, everything = len(setups), list(setups)
    if request.nominal is not None:
        fitted = _fit(request.nominal, setups[0]).inverse()
        everything.append(PreparedSetUp.of(SetUpCloud(NOMINAL, request.nominal.surface, ()), setups[0].prepared.voxel_mm))
        poses.append(RigidTransform(fitted.matrix, "part", NOMINAL))
    for _ in range(ROUNDS):
        before, joint = poses, solve_joint(everything, poses, _surface_edges(everything, poses, count))
        poses = list(joint.part_from_setup)
        moved = [np.linalg.norm((a.inverse() @ b).translation_mm) for a, b in zip(before, poses, strict=True)]
        if max(moved) < CONVERGED_MM:
            break
    final = solve_joint(everything, poses, _surface_edges(everything, poses, count))
    return Joint(tuple(poses), final.covariance, final.edges), _positions(setups, poses)


def _fit(nominal: NominalFit, setup: PreparedSetUp) -> RigidTransform:
    return RigidTransform(nominal.nominal_from_part[setup.name].matrix, NOMINAL, setup.name)


def _place(setups: Sequence[PreparedSetUp], poses: Sequence[RigidTransform], number: int, request: JoinRequest) -> RigidTransform:
    """Find a set-up relative to the earlier one that determines it best; raises the reason for the first if it fits none."""
    source, reasons = setups[number], []
    found: list[tuple[float, RigidTransform]] = []
    for earlier, pose in enumerate(poses):
        target = setups[earlier]
        rough = _rough_rotation(request, source.name, pose)
        if request.nominal is not None:
            between = _fit(request.nominal, target).inverse() @ _fit(request.nominal, source)
            starts = starts_turned(target, between.matrix)
        elif rough is not None:
            starts = starts_near(target, source, rough, HINT_WITHIN_DEG)
        else:
            starts = all_starts(target, source)
        try:
            pair = find_position(target, source, starts, rough).pair
        except RegistrationError as error:
            reasons.append(error)
            continue
        found.append((weakest_information(pair, source.prepared.radius_mm), pose @ pair.target_from_source))
    if not found:
        raise reasons[0]
    return max(found, key=lambda one: one[0])[1]


def _rough_rotation(request: JoinRequest, source: str, part_from_target: RigidTransform) -> FloatArray | None:
    """Return the rough rotation target_from_source, if that of the source is stated; the rotations are from the first set-up."""
    if request.turned is None or source not in request.turned:
        return None
    return np.asarray(part_from_target.rotation.T @ request.turned[source].T)


def _surface_edges(setups: Sequence[PreparedSetUp], poses: Sequence[RigidTransform], count: int) -> list[JointEdge]:
    """Measure all pairs that overlap; those of the ``count`` set-ups among each other have to fit, the nominal only has to be near."""
    search = FINE_SEARCH * setups[0].prepared.voxel_mm
    edges = []
    for i, j in combinations(range(len(setups)), 2):
        pair = measure_pair(setups[i].prepared, setups[j].prepared, poses[i].inverse() @ poses[j], (i, j), search)
        if pair.is_valid and (j >= count or check(setups[i], setups[j], pair).is_possible):
            edges.append(edge_by_surface(pair, (i, j), setups, poses))
    return edges


def _positions(setups: Sequence[PreparedSetUp], poses: Sequence[RigidTransform]) -> dict[int, Position]:
    """Return the best checked position of every set-up but the first, for the report."""
    search = FINE_SEARCH * setups[0].prepared.voxel_mm
    found: dict[int, Position] = {}
    for j in range(1, len(setups)):
        for i in range(len(setups)):
            if i == j:
                continue
            pair = measure_pair(setups[i].prepared, setups[j].prepared, poses[i].inverse() @ poses[j], (i, j), search)
            position = check(setups[i], setups[j], pair)
            if j not in found or position.overlap > found[j].overlap:
                found[j] = position
    return found


def _by_spheres(setups: Sequence[PreparedSetUp], request: JoinRequest) -> tuple[Joint, dict[int, Position]]:
    if request.sphere_diameter_mm is None:
        raise RegistrationError("The diameter of the reference spheres is missing.", "State it: --sphere-diameter-mm.")
    spheres = [find_spheres(one.given.stitched, request.sphere_diameter_mm) for one in setups]
    poses, matches = [RigidTransform.identity("part", setups[0].name)], {}
    for number in range(1, len(setups)):
        match = _unique_match(setups, spheres, number, request)
        matches[0, number] = match
        poses.append(poses[0] @ as_transform(match, setups[0].name, setups[number].name))
    for _ in range(ROUNDS):
        edges = [edge_by_spheres(match, pair, setups, spheres, poses) for pair, match in matches.items()]
        joint = solve_joint(setups, poses, edges)
        poses = list(joint.part_from_setup)
    return joint, _positions(setups, poses)


def _unique_match(setups: Sequence[PreparedSetUp], spheres: Sequence[list[Sphere]], number: int, request: JoinRequest) -> SphereMatch:
    """Return the only assignment of the spheres that nothing contradicts, or the one nearest to the stated rotation."""
    target, source = setups[0], setups[number]
    found = match_spheres(spheres[0], spheres[number], (target.name, source.name))
    possible = [one for one in found if contradicted(target, source, one.target_from_source) <= MOST_CONTRADICTED]
    if not possible:
        raise RegistrationError(
            f"By their reference spheres, {target.name} and {source.name} contradict each other: points of one are where the other one saw "
            "empty space.",
            "Check that the spheres were not moved between the set-ups and that both are of one part.",
        )
    rough = _rough_rotation(request, source.name, RigidTransform.identity("part", target.name))
    if rough is not None:
        return max(possible, key=lambda one: float(np.trace(one.target_from_source[:3, :3] @ rough.T)))
    if len(possible) > 1:
        raise RegistrationError(
            f"The reference spheres of {target.name} and {source.name} can be assigned in {len(possible)} ways.",
            f"Place the spheres at unequal distances, or state --turned {source.name}=X,Y,Z.",
        )
    return possible[0]


def _merge(setups: Sequence[SetUpCloud], joint: Joint, settings: StitchSettings, progress: Progress) -> StitchedCloud:
    """Merge the clouds of all used views at their joint positions."""
    placements = tuple(
        _placed(one.name, placement, pose)
        for one, pose in zip(setups, joint.part_from_setup, strict=False)  # the nominal may follow
        for placement in one.stitched.placements
    )
    clouds = [cloud for one in setups for cloud in one.clouds]
    used = [number for number, placement in enumerate(placements) if placement.used]
    spacing = max(float(one.stitched.notes["spacing_mm"]) for one in setups)
    voxel = max(float(one.stitched.notes["merge_voxel_mm"]) for one in setups)
    merged = merge(
        [clouds[number] for number in used],
        [placements[number].part_from_camera.translation_mm for number in used],
        voxel,
        poses=[placements[number].part_from_camera for number in used],
        views=used,
        island_mm2=settings.island_mm2,
        progress=progress,
    )
    notes = {"spacing_mm": spacing, "merge_voxel_mm": voxel, "views_used": float(len(used)), "set-ups": float(len(setups))}
    return StitchedCloud(
        merged.points_mm,
        merged.normals,
        merged.sigma_mm,
        merged.grey,
        merged.view,
        placements,
        "part",
        notes,
        sampled_view=merged.sampled_view,
    )


def _placed(name: str, placement: ViewPlacement, part_from_setup: RigidTransform) -> ViewPlacement:
    """Return a placement in the common part frame, under a name that is unique among all set-ups."""
    part_from_camera, kinematic = (
        part_from_setup @ RigidTransform(pose.matrix, part_from_setup.from_frame, "camera")
        for pose in (placement.part_from_camera, placement.kinematic)
    )
    named = view_name(name, placement.viewpoint_id)
    return replace(placement, viewpoint_id=named, part_from_camera=part_from_camera, kinematic=kinematic)


def view_name(setup: str, viewpoint_id: str) -> str:
    """Return the name of a view among those of all set-ups."""
    return f"{setup}.{viewpoint_id}"


def _describe(
    number: int, setups: Sequence[PreparedSetUp], joint: Joint, positions: Mapping[int, Position], method: JoinMethod
) -> JoinedSetUp:
    block = joint.covariance[6 * number : 6 * number + 6, 6 * number : 6 * number + 6]
    centre = joint.part_from_setup[number].apply(setups[number].prepared.centroid_mm)
    about = shift_origin(centre)
    local = about @ block @ about.T
    edges = [edge for edge in joint.edges if number in (edge.target, edge.source)]
    position = positions.get(number)
    return JoinedSetUp(
        name=setups[number].name,
        part_from_setup=joint.part_from_setup[number],
        method="reference" if number == 0 else method,
        sigma_mm=float(np.sqrt(np.linalg.eigvalsh(local[:3, :3])[-1])) if number else 0.0,
        sigma_deg=float(np.degrees(np.sqrt(np.linalg.eigvalsh(local[3:, 3:])[-1]))) if number else 0.0,
        residual_mm=max((edge.residual_mm for edge in edges), default=0.0) if number else 0.0,
        overlap=1.0 if position is None else position.overlap,
    )
