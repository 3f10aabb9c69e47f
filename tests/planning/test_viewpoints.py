from itertools import pairwise

import numpy as np
import pytest

from measureapp.data.plan import FlangePose, Viewpoint
from measureapp.errors import PlanError
from measureapp.planning.calibration_views import PASSES, calibration_viewpoints
from measureapp.planning.reach import check_reach
from measureapp.planning.viewpoints import LookAt, guide_from_head, plan_around_part
from measureapp.project.rig_file import read_rig


@pytest.fixture(scope="module")
def rig():
    return read_rig("paper")


def test_the_head_looks_at_its_target_with_its_image_upright():
    target = np.array([850.0, 20.0, 100.0])
    pose = guide_from_head(target, LookAt(azimuth_deg=10.0, elevation_deg=40.0, distance_mm=550.0))
    assert np.allclose(pose.inverse().apply(target[None])[0], [0, 0, 550])
    assert pose.rotation[2, 1] < 0  # image down is world down
    assert abs(pose.rotation[2, 0]) < 1e-12  # image right is level


@pytest.mark.parametrize("count", [1, 4, 6, 8, 26, 36])
def test_a_plan_around_a_part_has_as_many_viewpoints_as_asked_and_stays_in_reach(rig, count):
    plan = plan_around_part(rig, "impeller", radius_mm=140.0, height_mm=60.0, count=count)
    assert len(plan) == count
    check_reach(plan, rig)


@pytest.mark.parametrize(("count", "height_mm"), [(8, 90.0), (26, 60.0), (26, 600.0)])
def test_the_robot_comes_to_every_station_once(rig, count, height_mm):
    places = [
        (viewpoint.flange, viewpoint.guide_mm)
        for viewpoint in plan_around_part(rig, "part", radius_mm=100.0, height_mm=height_mm, count=count)
    ]
    moves = 1 + sum(one != other for one, other in pairwise(places))
    assert moves == len(set(places)) < count


def test_a_plan_outside_the_axes_limits_is_refused_naming_viewpoint_and_axis(rig):
    far = Viewpoint(id="far", flange=FlangePose(position_mm=(400, 0, 400), quaternion_wxyz=(1, 0, 0, 0)), guide_mm=9000.0, table_deg=0.0)
    with pytest.raises(PlanError, match=r"far: guide at 9000.0 mm is outside"):
        check_reach([far], rig)


def test_no_viewpoints_are_refused(rig):
    with pytest.raises(PlanError, match="0 viewpoints"):
        plan_around_part(rig, "nothing", radius_mm=100.0, height_mm=50.0, count=0)


def test_the_calibration_run_turns_the_head_about_axes_that_are_not_parallel(rig):
    poses = [v for v in calibration_viewpoints(rig) if v.id.startswith("pose")]
    first = poses[0].flange.transform()
    axes = np.array([(first.inverse() @ pose.flange.transform()).rotation_vector for pose in poses[1:]])
    spread = np.linalg.svd(axes, compute_uv=False)
    assert len(poses) >= 15
    assert spread[-1] / spread[0] > 0.15


def test_the_calibration_run_turns_the_table_far_enough(rig):
    assert np.ptp([v.table_deg for v in calibration_viewpoints(rig) if v.id.startswith("axis")]) >= 90.0


@pytest.mark.parametrize("name", list(PASSES))
def test_the_guide_passes_the_board_with_a_robot_that_stands_still(rig, name):
    """For 1e-5 of scale a slide that misses its positions by 1 µm needs Σ (s - s̄)² of (300 mm)² and more over all passes together."""
    views = [v for v in calibration_viewpoints(rig) if v.id.startswith(name)]
    slides = np.array([v.guide_mm for v in views])
    assert len({v.flange for v in views}) == 1
    assert np.ptp(slides) >= 250.0
    assert np.sum((slides - slides.mean()) ** 2) * len(PASSES) > 300.0**2


def test_the_calibration_run_stays_within_twice_the_views_that_determine_the_rig(rig):
    """A view costs a move of 2 to 10 s: the run shall end while the rig is as warm as it began."""
    plan = plan_around_part(rig, "gypsum", radius_mm=60.0, height_mm=80.0, count=8)
    views = calibration_viewpoints(rig, plan)
    approaches = 1 + sum(first.flange != second.flange for first, second in pairwise(views))
    assert len(views) <= 80
    assert approaches <= 40
