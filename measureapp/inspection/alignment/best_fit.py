"""Best fit of measured points to a nominal mesh: multi-start search, then robust point-to-plane registration."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from measureapp.arrays import FloatArray
from measureapp.data.alignment_program import ByCoordinates
from measureapp.data.measurement import Alignment
from measureapp.data.mesh import Mesh
from measureapp.errors import InspectionError
from measureapp.geometry.transform import RigidTransform, orthonormalise
from measureapp.inspection.alignment.point_to_plane import Registration, cost, register
from measureapp.inspection.alignment.starts import all_round_starts, head_down_starts, upright_starts
from measureapp.inspection.measured_points import HasPoints, MeasuredPoints
from measureapp.inspection.settings import AlignmentSettings
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.inspection.surface.units import check_size
from measureapp.progress import NoProgress, PartOf, Progress

FINALISTS = 4
BOTH_WAYS = "best fit; the part fits upright and on its head equally well"
EQUIVALENT_COST = 1.1  # costs within 10 % are equivalent positions of a symmetric part
STILL_COARSE = 0.05  # difference of the costs of equivalent positions before refinement
CERTAIN_COST = 0.03  # above it an upright part may be one on its head: a gear on its head fits upright with 0.10, a true fit costs 1e-5
POOR_COST = 0.35  # share of the truncated cost above which the fit has failed


@dataclass(frozen=True, slots=True)
class _Candidate:
    matrix: FloatArray
    cost: float

    @property
    def turn_rad(self) -> float:
        """The rotation of the part from its kinematic orientation."""
        return float(np.linalg.norm(Rotation.from_matrix(self.matrix[:3, :3]).as_rotvec()))


def no_alignment(frame: str = "part") -> Alignment:
    """Return the identity alignment: part and nominal frame coincide."""
    return Alignment("none: part frame taken as nominal frame", RigidTransform.identity("nominal", frame), 0.0)


def by_coordinates(requested: ByCoordinates, frame: str = "part") -> Alignment:
    """Return the alignment by known coordinates."""
    rotation = Rotation.from_euler("xyz", requested.rotation_deg, degrees=True).as_matrix()
    placed = RigidTransform.from_parts(rotation, requested.translation_mm, "nominal", frame)
    return Alignment("coordinates as stated in the program", placed, 0.0)


def given_alignment(nominal_from_part: RigidTransform, name: str) -> Alignment:
    """Return a known alignment."""
    return Alignment(name, nominal_from_part, 0.0)


def best_fit(
    measured: MeasuredPoints | HasPoints | Mesh,
    nominal: Mesh | NominalSurface,
    settings: AlignmentSettings = AlignmentSettings(),  # noqa: B008 - frozen
    frame: str = "part",
    progress: Progress = NoProgress(),  # noqa: B008 - stateless
) -> Alignment:
    """Find the rigid motion that best fits points to a nominal mesh, without an initial value.

    Starts are rotations about z (upright part); if these do not fit closely, also those of a part on its head; if they fail, in all
    directions; each is improved coarsely, the best ones finely. Of the equivalent positions of a symmetric part the one with the smallest
    rotation is chosen, so that repeated measurements agree.

    Raises
    ------
    InspectionError
        The cloud is in another unit, of another size, or does not match the nominal.
    """
    points = MeasuredPoints.of(measured)
    surface = nominal if isinstance(nominal, NominalSurface) else NominalSurface(nominal)
    check_size(points.points_mm, surface.vertices_mm)
    best, ambiguous = _search(points, surface, settings, progress)
    fine = register(points.thin(settings.fine_points), surface, best.matrix, settings, progress=progress)
    _refuse_another_part(fine, surface, settings)
    transform = RigidTransform(orthonormalise(fine.matrix), "nominal", frame)
    return Alignment(BOTH_WAYS if ambiguous else "best fit", transform, fine.rms_mm, fine.overlap, fine.undetermined)


def _search(points: MeasuredPoints, surface: NominalSurface, settings: AlignmentSettings, progress: Progress) -> tuple[_Candidate, bool]:
    """Try the starts of an upright part first, on its head if these do not fit closely, all directions only if they fail.

    Returns the best candidate, and whether the part fits upright and on its head equally well.
    """
    sample, finer = points.thin(settings.coarse_points), points.thin(4 * settings.coarse_points)

    def finished(starts: list[FloatArray], part: Progress) -> list[_Candidate]:
        improved = _improve_starts(sample, surface, starts, settings, part)
        return [_finish(finer, surface, candidate, settings, part) for candidate in _select_finalists(improved)]

    finalists = finished(upright_starts(sample.points_mm, surface), PartOf(progress, 0.0, 0.2)) if settings.upright else []
    upright_cost = min((candidate.cost for candidate in finalists), default=np.inf)
    if upright_cost > POOR_COST:
        finalists += finished(all_round_starts(sample.points_mm, surface), PartOf(progress, 0.2, 1.0))
    elif upright_cost > CERTAIN_COST:
        finalists += finished(head_down_starts(sample.points_mm, surface), PartOf(progress, 0.2, 1.0))
    limit = EQUIVALENT_COST * min(candidate.cost for candidate in finalists)
    equal = [candidate for candidate in finalists if candidate.cost <= limit]
    ways = {candidate.matrix[2, 2] > 0 for candidate in equal}
    return min(equal, key=lambda c: c.turn_rad), settings.upright and len(ways) > 1


def _improve_starts(
    sample: MeasuredPoints, surface: NominalSurface, starts: list[FloatArray], settings: AlignmentSettings, progress: Progress
) -> list[_Candidate]:
    """Improve every start by a few coarse steps; return them by cost, without near-duplicates."""
    radius = 0.05 * surface.diagonal_mm
    found = []
    for number, start in enumerate(starts):
        progress.report(number, len(starts), "aligning the points to the nominal")
        matrix = register(sample, surface, start, settings, iterations=10, reach_mm=2 * radius).matrix
        found.append(_Candidate(matrix, cost(sample, surface, matrix, 0.02 * surface.diagonal_mm, settings)))
    distinct: list[_Candidate] = []
    for candidate in sorted(found, key=lambda c: c.cost):
        if all(_differ(candidate.matrix, other.matrix) for other in distinct):
            distinct.append(candidate)
    return distinct


def _select_finalists(improved: list[_Candidate]) -> list[_Candidate]:
    """Return the best few candidates, and of those with nearly equal cost the ones of smallest rotation."""
    best = improved[:FINALISTS]
    equivalent = [candidate for candidate in improved[FINALISTS:] if candidate.cost <= best[0].cost + STILL_COARSE]
    return best + sorted(equivalent, key=lambda c: c.turn_rad)[:FINALISTS]


def _differ(one: FloatArray, other: FloatArray) -> bool:
    turn = Rotation.from_matrix(one[:3, :3].T @ other[:3, :3]).magnitude()
    return bool(turn > np.radians(3.0) or np.linalg.norm(one[:3, 3] - other[:3, 3]) > 5.0)


def _finish(
    sample: MeasuredPoints, surface: NominalSurface, candidate: _Candidate, settings: AlignmentSettings, progress: Progress
) -> _Candidate:
    matrix = register(sample, surface, candidate.matrix, settings, progress=progress).matrix
    return _Candidate(matrix, cost(sample, surface, matrix, 0.005 * surface.diagonal_mm, settings))


def _refuse_another_part(fine: Registration, surface: NominalSurface, settings: AlignmentSettings) -> None:
    near = settings.near_share * surface.diagonal_mm
    if fine.overlap < settings.least_overlap:
        raise InspectionError(
            f"Only {fine.overlap:.0%} of the points lie within {near:.1f} mm of the nominal, in any orientation.",
            "Check that this is the nominal of the part, or crop the surroundings from the cloud.",
        )
