"""What a viewpoint sees, against an independent calculation: projection by OpenCV, every triangle tried for every line of sight."""

from __future__ import annotations

from collections.abc import Iterator

import cv2
import numpy as np
import pytest

from measureapp.data.plan import Viewpoint
from measureapp.planning.coverage.extent import standing
from measureapp.planning.coverage.head import Head, heads_at, part_from_head
from measureapp.planning.coverage.limits import VisibilityLimits
from measureapp.planning.coverage.samples import SurfaceSamples, sample_surface
from measureapp.planning.coverage.scene import RAY_OFFSET_MM, PartScene, table_top
from measureapp.planning.coverage.visibility import Unseen, seen_by, seen_from
from measureapp.planning.viewpoints import LookAt, plan_around_part, viewpoint_looking_at
from measureapp.progress import Cancelled
from measureapp.project.rig_file import read_rig
from tests.planning.coverage.parts import casting

RIG = read_rig("paper")
LIMITS = VisibilityLimits()
MATT = LIMITS.without_light()


def scene() -> PartScene:
    part = casting()
    return PartScene.of(part.seen_from(standing(part)), RIG)


def viewpoints() -> tuple[Viewpoint, ...]:
    return tuple(plan_around_part(RIG, "around", radius_mm=110.0, height_mm=70.0, count=9))


def crossed(origins: np.ndarray, ends: np.ndarray, corners: np.ndarray) -> np.ndarray:
    """Whether each segment (N, 3) crosses any triangle (T, 3, 3), by Cramer's rule for every pair."""
    ways = ends - origins
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    hit = np.zeros(len(origins), bool)
    for number, (origin, way) in enumerate(zip(origins, ways, strict=True)):
        across = np.cross(way, second)
        determinant = np.einsum("ti,ti->t", first, across)
        with np.errstate(divide="ignore", invalid="ignore"):
            away = origin - corners[:, 0]
            u = np.einsum("ti,ti->t", away, across) / determinant
            q = np.cross(away, first)
            v = q @ way / determinant
            t = np.einsum("ti,ti->t", second, q) / determinant
        hit[number] = bool(((u >= 0) & (v >= 0) & (u + v <= 1) & (t > 0) & (t < 1)).any())
    return hit


def expected(viewpoint: Viewpoint, samples: SurfaceSamples) -> dict[str, np.ndarray]:
    """Whether a viewpoint sees each sample of a glossy and of a matt surface, point by point, from the rig's description alone."""
    head = part_from_head(viewpoint, RIG)
    table = table_top(RIG)
    part = scene().part
    corners = np.concatenate([mesh.vertices_mm[mesh.triangles] for mesh in (part, table)])
    points, normals = samples.points_mm.astype(float), samples.normals.astype(float)
    depth = head.inverse().apply(points)[:, 2]
    devices = [(one.head_from_camera, one.focal_px, one.width_px, one.height_px, LIMITS.camera_incidence_deg) for one in RIG.cameras]
    light = RIG.projector
    devices.append((light.head_from_projector, light.focal_px, light.width_px, light.height_px, LIMITS.projector_incidence_deg))
    sees, directions = [], []
    for seat, focal_px, width_px, height_px, most_deg in devices:
        part_from_device = head @ seat.transform("head", "device")
        pose = part_from_device.inverse()
        matrix = np.array([[focal_px, 0, width_px / 2], [0, focal_px, height_px / 2], [0, 0, 1]])
        pixels = cv2.projectPoints(points, cv2.Rodrigues(pose.rotation)[0], np.array(pose.translation_mm), matrix, np.zeros(5))[0][:, 0]
        margin = LIMITS.image_margin_px * width_px / 2592
        inside = ((pixels >= margin) & (pixels <= np.array([width_px, height_px]) - margin)).all(axis=1)
        towards = part_from_device.translation_mm - points
        towards /= np.linalg.norm(towards, axis=1)[:, None]
        incidence = np.degrees(np.arccos(np.clip(np.einsum("ni,ni->n", towards, normals), -1, 1)))
        ends = np.broadcast_to(part_from_device.translation_mm, points.shape)
        hidden = crossed(points + RAY_OFFSET_MM * normals, ends, corners)
        sees.append(inside & (incidence <= most_deg) & ~hidden)
        directions.append(towards)
    mirrored = 2 * np.einsum("ni,ni->n", directions[-1], normals)[:, None] * normals - directions[-1]
    off = [np.degrees(np.arccos(np.clip(np.einsum("ni,ni->n", mirrored, direction), -1, 1))) for direction in directions[:-1]]
    near, far = Head.of(RIG).depth_mm
    lit = sees[-1] & (depth >= near) & (depth <= far)
    matt, glossy = np.array(sees[:-1]), np.array(sees[:-1]) & (np.array(off) > LIMITS.mirror_deg)
    return {"matt": lit & (matt.sum(axis=0) >= 2), "glossy": lit & (glossy.sum(axis=0) >= 2)}


@pytest.fixture(scope="module")
def sought() -> tuple[SurfaceSamples, list[dict[str, np.ndarray]]]:
    """Samples of the casting, and what each viewpoint sees of them: every triangle is tried once for both surfaces."""
    samples = sample_surface(scene(), 400)
    return samples, [expected(one, samples) for one in viewpoints()]


@pytest.mark.parametrize(("surface", "limits"), [("glossy", LIMITS), ("matt", MATT)], ids=["glossy", "matt"])
def test_visibility_agrees_with_every_triangle_tried_for_every_line_of_sight(surface: str, limits: VisibilityLimits, sought) -> None:
    samples, seen_as = sought
    found = seen_by(viewpoints(), samples, RIG, scene(), limits).seen
    truth = np.array([each[surface] for each in seen_as])
    assert 0.1 < truth.mean() < 0.6
    assert (found != truth).sum() == 0


def test_standard_deviations_are_given_exactly_where_a_sample_is_seen() -> None:
    samples = sample_surface(scene(), 400)
    found = seen_by(viewpoints(), samples, RIG, scene())
    assert found.sigma_mm.shape == found.reason.shape == (9, len(samples))
    assert np.array_equal(np.isfinite(found.sigma_mm), found.reason == Unseen.SEEN)


def samples_of(*points_and_normals: tuple[tuple[float, float, float], tuple[float, float, float]]) -> SurfaceSamples:
    points, normals = (np.array(column, float) for column in zip(*points_and_normals, strict=True))
    return SurfaceSamples(points, normals, np.ones(len(points)))


def above(elevation_deg: float = 60.0) -> np.ndarray:
    target = np.add(RIG.table.centre_in_guide_mm, (0, 0, 70))
    return heads_at([viewpoint_looking_at(RIG, "above", target, LookAt(0.0, elevation_deg, RIG.standoff_mm))], RIG)


def test_the_first_condition_that_fails_is_the_reason() -> None:
    head, steep = Head.of(RIG), np.array([-np.sin(np.deg2rad(30)), 0, np.cos(np.deg2rad(30))])
    far_away, facing_away = ((240.0, 240.0, 70.0), (0, 0, 1)), ((70.0, 40.0, 70.0), (1.0, 0.0, 0.0))
    on_top, below = ((-70.0, 40.0, 70.0), tuple(steep)), ((-20.0, 0.0, 2.0), (-0.5, 0.0, 0.9))
    found = seen_from(above(), samples_of(far_away, facing_away, on_top, below), head, scene(), MATT)
    assert [Unseen(one) for one in found.reason[0]] == [Unseen.FIELD, Unseen.INCIDENCE, Unseen.SEEN, Unseen.HIDDEN]


def test_a_glossy_surface_is_not_measured_where_it_mirrors_the_projector_into_the_cameras() -> None:
    pose = above(75.0)
    middle = pose[0, :3, 3]
    target = np.array([0.0, 0.0, 70.0])
    eyes = [pose[0, :3, :3] @ one.position_mm + middle for one in Head.of(RIG).cameras[:2]]
    directions = [(eye - target) / np.linalg.norm(eye - target) for eye in (*eyes, middle)]
    bisector = directions[0] + directions[2]
    lone = read_rig("paper")
    lone = lone.model_copy(update={"cameras": lone.cameras[:2]})
    samples = samples_of((tuple(target), tuple(bisector / np.linalg.norm(bisector))))
    empty = PartScene.of(table_top(RIG), RIG)
    assert Unseen(seen_from(pose, samples, Head.of(lone), empty, LIMITS).reason[0, 0]) is Unseen.LIGHT
    assert Unseen(seen_from(pose, samples, Head.of(lone), empty, MATT).reason[0, 0]) is Unseen.SEEN


def test_a_third_camera_sees_what_one_of_the_others_does_not() -> None:
    samples = sample_surface(scene(), 400)
    two = RIG.model_copy(update={"cameras": RIG.cameras[:2]})
    with_two = seen_by(viewpoints(), samples, two, scene()).seen
    with_three = seen_by(viewpoints(), samples, RIG, scene()).seen
    assert with_three.sum() > with_two.sum()
    assert not (with_two & ~with_three).any()


def test_a_rig_with_one_camera_measures_with_the_projector_as_its_partner() -> None:
    samples = sample_surface(scene(), 400)
    one = RIG.model_copy(update={"cameras": RIG.cameras[:1]})
    found = seen_by(viewpoints(), samples, one, scene())
    assert found.seen.mean() > 0.1
    assert np.nanmedian(found.sigma_mm) > np.nanmedian(seen_by(viewpoints(), samples, RIG, scene()).sigma_mm)


def test_binned_cameras_see_the_same() -> None:
    samples = sample_surface(scene(), 400)
    full, quarter = (seen_by(viewpoints(), samples, rig, scene()).seen for rig in (RIG, RIG.at_resolution("quarter")))
    assert (full != quarter).mean() < 1e-3


def test_the_prediction_can_be_cancelled() -> None:
    class Stop:
        def report(self, done: float, total: float, note: str = "") -> None:
            raise Cancelled

        def check(self) -> None: ...

    with pytest.raises(Cancelled):
        seen_by(viewpoints(), sample_surface(scene(), 60), RIG, scene(), progress=Stop())


def tilted_planes() -> Iterator[tuple[float, float]]:
    yield from ((0.0, 0.0), (30.0, 0.0), (0.0, 35.0), (-25.0, 40.0))


@pytest.mark.parametrize(("about_x_deg", "about_y_deg"), list(tilted_planes()))
def test_the_predicted_standard_deviation_is_the_scatter_of_points_matched_by_noisy_phases(about_x_deg: float, about_y_deg: float) -> None:
    """Two cameras on a plane: phases with noise, the match found along the ray, then the scatter of the triangulated points."""
    rig = RIG.model_copy(update={"cameras": RIG.cameras[:2]})
    head = Head.of(rig)
    point = np.array([20.0, -15.0, 560.0])
    turn = cv2.Rodrigues(np.deg2rad([about_x_deg, 0.0, 0.0]))[0] @ cv2.Rodrigues(np.deg2rad([0.0, about_y_deg, 0.0]))[0]
    normal = turn @ np.array([0.0, 0.0, -1.0])
    empty = PartScene.of(table_top(RIG), RIG)
    pose = np.eye(4)
    pose[2, 3] = 5000.0  # far from the table
    lifted = SurfaceSamples(point[None] + [0, 0, 5000.0], normal[None], np.ones(1))
    predicted = float(seen_from(pose[None], lifted, head, empty, MATT).sigma_mm[0, 0])

    def phase(where: np.ndarray) -> np.ndarray:
        return 2 * np.pi / LIMITS.fringes.pitch_px * RIG.projector.focal_px * where[..., 0] / where[..., 2]

    first, second = (camera.position_mm for camera in head.cameras)
    ray = (point - first) / np.linalg.norm(point - first)
    along = np.linspace(-3.0, 3.0, 6001)
    aimed = point + along[:, None] * ray - second
    met = second + aimed * ((point - second) @ normal / (aimed @ normal))[:, None]
    light = -normal @ point / np.linalg.norm(point) * (RIG.standoff_mm / np.linalg.norm(point)) ** 2
    sigma_phase = float(LIMITS.fringes.sigma_at(np.array([light]))[0])
    noise = np.random.default_rng(3).normal(0.0, sigma_phase, (20_000, 2)) * [1.0, 2.0 / 3.0]  # the second is read between four pixels
    slope = np.sign(phase(met)[-1] - phase(met)[0])
    found = np.interp(slope * (phase(point) + noise[:, 0] - noise[:, 1]), slope * phase(met), along)
    assert predicted == pytest.approx(found.std(), rel=0.03)
