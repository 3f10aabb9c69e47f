"""Everything that would stop a scan is told at once, before anything moves."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from measureapp.data.fringe import PatternSet, PhaseShiftGroup
from measureapp.data.plan import ExposureBracket, ScanPlan
from measureapp.data.rig import KeepOutBox, MotionRules
from measureapp.devices.connect import connect_rig
from measureapp.devices.link_budget import LinkCamera
from measureapp.devices.rig import Rig
from measureapp.devices.status import DeviceStatus
from measureapp.errors import DecodeError, DeviceError, InputError, LimitError, PlanError
from measureapp.pipeline.preflight import Preflight, check_connected, check_plan, preflight_lines
from measureapp.planning.viewpoints import plan_around_part
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.rig_file import read_rig


@pytest.fixture
def rig() -> Rig:
    return connect_rig(read_rig("paper").at_resolution("quarter").model_copy(update={"driver_settings": {"part": "flat"}}))


@pytest.fixture
def plan() -> ScanPlan:
    plan = plan_around_part(read_rig("paper"), "two views", radius_mm=100, height_mm=80, count=4)
    return plan.model_copy(update={"viewpoints": plan.viewpoints[:2], "bracket": ExposureBracket(exposures_us=(40_000, 20_000))})


@pytest.fixture
def project(rig: Rig, tmp_path: Path) -> ProjectFolder:
    return ProjectFolder(tmp_path / "project", ProjectSettings(name="p", part="p", rig=rig.description))


def test_a_sound_plan_on_a_ready_rig_has_no_problem_and_tells_time_and_space(rig: Rig, plan: ScanPlan, project: ProjectFolder) -> None:
    found = check_connected(plan, rig, project, None)
    assert not found.problems
    assert found.images_s is not None
    assert found.bytes == 2 * 3 * 648 * 486 * plan.patterns.count * 2
    found.refuse()
    assert preflight_lines(found, plan)[0].startswith("2 viewpoints, 0.0")


def test_a_rig_that_was_stopped_is_a_problem_before_the_scan_starts(rig: Rig, plan: ScanPlan, project: ProjectFolder) -> None:
    rig.latch.set("Stop was pressed.")
    (problem,) = check_connected(plan, rig, project, None).problems
    assert problem.message == "The rig was stopped: Stop was pressed." and "reset the stop" in problem.hint


def test_several_problems_are_told_in_one_error(rig: Rig, plan: ScanPlan, project: ProjectFolder) -> None:
    far = plan.viewpoints[0].model_copy(update={"guide_mm": 5000.0})
    ambiguous = PatternSet(name="one", projector_px=1024, groups=(PhaseShiftGroup(pitch_px=16),))
    bad = plan.model_copy(
        update={"viewpoints": (far,), "patterns": ambiguous, "bracket": ExposureBracket(exposures_us=(2_000_000, 20_000))}
    )
    rig.table.status = lambda: DeviceStatus(False, "not referenced.", "Find its reference.")  # type: ignore[method-assign]
    found = check_connected(bad, rig, project, None)
    assert {type(problem) for problem in found.problems} == {DecodeError, PlanError, LimitError, DeviceError}
    with pytest.raises(DeviceError, match=r"4 things prevent the scan: \(1\).*5000.*table \(rotary table\) is not ready: not referenced"):
        found.refuse()
    assert sum(line.startswith("Prevents the scan") for line in preflight_lines(found, bad)) == 4


def test_a_keep_out_box_is_checked_without_a_connection(rig: Rig, plan: ScanPlan, project: ProjectFolder) -> None:
    first = plan[0].flange.transform().translation_mm
    crane = KeepOutBox(name="crane", low_mm=tuple(first - 50.0), high_mm=tuple(first + 50.0))
    boxed = rig.description.model_copy(update={"motion": MotionRules(keep_out=(crane,))})
    with pytest.raises(PlanError, match="crane"):
        check_plan(plan, boxed, project).refuse()


def test_a_keep_out_box_that_no_pose_avoids_is_a_mistake_of_the_rig_description(rig: Rig, plan: ScanPlan, project: ProjectFolder) -> None:
    everywhere = KeepOutBox(name="crane", low_mm=(-9e3, -9e3, -9e3), high_mm=(9e3, 9e3, 9e3))
    boxed = rig.description.model_copy(update={"motion": MotionRules(keep_out=(everywhere,))})
    with pytest.raises(InputError, match=r"crane and .* touch whatever the joint angles"):
        check_plan(plan, boxed, project).refuse()


def test_cameras_that_overload_their_link_are_a_problem_and_slow_ones_a_warning(rig: Rig, plan: ScanPlan, project: ProjectFolder) -> None:
    for camera in rig.cameras.values():
        camera.link = LinkCamera(camera.name, 5_038_848)  # type: ignore[attr-defined]
    found = check_connected(plan, rig, project, None)
    assert any("lose packets: set an inter-packet delay" in str(problem) for problem in found.problems)
    for camera in rig.cameras.values():
        camera.link = LinkCamera(camera.name, 5_038_848, delay_ticks=3_076)  # type: ignore[attr-defined]
    found = check_connected(plan, rig, project, None)
    assert not found.problems
    assert any("the sequence slows down" in warning for warning in found.warnings)


def test_a_projector_that_cannot_trigger_is_refused_where_the_rig_asks_for_it(rig: Rig, plan: ScanPlan, project: ProjectFolder) -> None:
    class Plain:
        name, frame_us = "beamer", 16_667

        def status(self) -> DeviceStatus:
            return DeviceStatus(True, "ready")

    hardware = rig.description.model_copy(update={"head": rig.description.head.model_copy(update={"sequence": "hardware"})})
    other = replace(rig, description=hardware, projector=Plain())  # type: ignore[arg-type]
    found = check_connected(plan, other, project, None)
    words = " ".join(map(str, found.problems))
    assert "beamer cannot trigger cameras" in words
    assert "not a whole number of the frames of beamer" in words


def test_one_problem_keeps_its_own_words() -> None:
    problem = PlanError("The table ends at 360°.", "Choose less.")
    with pytest.raises(PlanError) as raised:
        Preflight((problem,), (), 0, None).refuse()
    assert raised.value is problem
