"""The prediction against the light that the virtual rig calculates, whose lenses, poses and axes differ from the nominal ones."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from measureapp.data.plan import Viewpoint
from measureapp.planning.coverage.extent import standing
from measureapp.planning.coverage.limits import VisibilityLimits
from measureapp.planning.coverage.samples import SurfaceSamples, sample_surface
from measureapp.planning.coverage.scene import PartScene
from measureapp.planning.coverage.visibility import seen_by
from measureapp.planning.feasibility import Feasibility
from measureapp.planning.generate import GeneratorSettings, generate_plan
from measureapp.project.geometry.robot_file import arm_of
from measureapp.project.rig_file import read_rig
from measureapp.simulate.parts import make_part
from measureapp.simulate.world import World

RIG = read_rig("paper").at_resolution("quarter")
SAME_PX = 5.0  # on the projector, between a sample and what a camera's pixel shows, which is about 1.6 columns wide


def lit(world: World, viewpoint: Viewpoint, points_nominal_mm: np.ndarray) -> np.ndarray:
    """Whether at least two cameras have a sample in their image in the projector's light, (N,), by the ground truth."""
    world.turn_table(np.deg2rad(viewpoint.table_deg))
    world.move_guide(viewpoint.guide_mm)
    world.move_robot(viewpoint.flange.transform())
    truth, nominal_from_reference = world.truth(), world.scene_from_camera()
    projector = (nominal_from_reference @ truth.camera_from_projector).inverse()
    shown = truth.projector.project(projector.apply(points_nominal_mm))
    inside = ((shown >= 0.0) & (shown <= [truth.projector.width_px - 1, truth.projector.height_px - 1])).all(axis=1)
    cameras = np.zeros(len(points_nominal_mm), int)
    for name, camera in truth.calibration.cameras.cameras.items():
        pose = (nominal_from_reference @ camera.reference_from_camera).inverse()
        pixels = np.round(camera.pinhole.project(pose.apply(points_nominal_mm)))
        there = ((pixels >= 0) & (pixels < [camera.pinhole.width_px, camera.pinhole.height_px])).all(axis=1)
        column, row = np.where(there[:, None], pixels, 0).astype(int).T
        light = world.true_light(name)[row, column]
        cameras += there & (np.abs(light[:, :2] - shown) < SAME_PX).all(axis=1) & (light[:, 2] > 0.0)
    return inside & (cameras >= 2)


def agreement(name: str, seed: int, settings: GeneratorSettings) -> tuple[float, float]:
    """Fraction of what the plan is predicted to see, view by view and together, that is truly lit and in the images."""
    part = make_part(name)
    world = World(RIG, part, seed)
    world.table_holds = "part"
    place = standing(part.mesh)
    scene = PartScene.of(part.mesh.seen_from(place), RIG)
    made = generate_plan(part.mesh, Feasibility.checked(RIG, arm_of(RIG), scene.part), settings)
    samples: SurfaceSamples = sample_surface(scene, settings.samples, seed + 1)
    matt = VisibilityLimits(mirror_deg=0.0)
    seen = seen_by(tuple(made.plan), samples, RIG, scene, matt).seen
    points = place.inverse().apply(samples.points_mm.astype(float))
    true = np.array([lit(world, one, points) for one in made.plan])
    together = seen.any(axis=0)
    areas = samples.areas_mm2
    return float(true[seen].mean()), float(areas[together & true.any(axis=0)].sum() / areas[together].sum())


def test_what_is_predicted_to_be_seen_is_lit_and_in_the_images_of_the_virtual_rig() -> None:
    by_view, together = agreement("gypsum", 3, GeneratorSettings(samples=600, candidates=150, viewpoints=3))
    assert by_view > 0.95
    assert together > 0.97


@pytest.mark.slow
@pytest.mark.parametrize("name", ["impeller", "gear", "gypsum"])
def test_whole_plans_see_on_the_virtual_rig_what_was_predicted(name: str, record_property: Callable[[str, object], None]) -> None:
    by_view, together = agreement(name, 5, GeneratorSettings(samples=2000, candidates=800))
    record_property("agreement by view and together", (by_view, together))
    assert by_view > 0.95
    assert together > 0.97
