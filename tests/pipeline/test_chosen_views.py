"""Views used or refused by hand."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from demo_fixture import Demo, linked_copy

from measureapp.data.cloud import CloudQuality, PointCloud, StitchedCloud
from measureapp.data.fringe import AxisReadback
from measureapp.data.measurement import ViewResult
from measureapp.data.view_choices import ViewChoices
from measureapp.errors import InputError
from measureapp.geometry.transform import RigidTransform
from measureapp.pipeline.chosen_views import REFUSED, add_refused, check_choices, select_views
from measureapp.pipeline.restitch import restitch
from measureapp.progress import NoProgress
from measureapp.project.folder import ProjectFolder


def view(name: str, accepted: bool = True) -> ViewResult:
    nothing = PointCloud(*(np.empty(shape) for shape in ((0, 3), (0, 3), 0, 0, (0, 2), 0)), "camera", name)
    quality = CloudQuality(0, 0.0, 0.0, 0.0, 0.0, accepted, "" if accepted else "too noisy")
    here = RigidTransform.identity("part", "camera")
    return ViewResult(name, nothing, quality, here, {}, (), {}, AxisReadback(RigidTransform.identity("base", "flange"), 0.0, 0.0))


VIEWS = (view("a"), view("b", accepted=False), view("c"))


def test_figures_decide_unless_somebody_did() -> None:
    assert [one.viewpoint_id for one in select_views(VIEWS, ViewChoices())] == ["a", "c"]
    assert [one.viewpoint_id for one in select_views(VIEWS, ViewChoices(used=("b",), refused=("a",)))] == ["b", "c"]


def test_a_refused_view_is_told_behind_those_that_points_refer_to() -> None:
    stitched = StitchedCloud(np.zeros((1, 3)), np.zeros((1, 3)), np.ones(1), np.ones(1), np.zeros(1, int), ())
    told = add_refused(stitched, VIEWS, ViewChoices(refused=("c",)))
    assert [(line.viewpoint_id, line.used, line.verdict) for line in told.placements] == [("c", False, REFUSED)]


def test_a_choice_replaces_the_one_before_and_a_view_is_never_both() -> None:
    choices = ViewChoices().with_choice("a", "use").with_choice("b", "refuse").with_choice("a", "refuse")
    assert (choices.used, choices.refused) == ((), ("a", "b"))
    with pytest.raises(ValueError, match="both used and refused"):
        ViewChoices(used=("a",), refused=("a",))


def test_a_choice_about_a_view_that_is_not_there_is_refused_with_the_names_there_are() -> None:
    with pytest.raises(InputError, match="no view 'z'") as refused:
        check_choices(ViewChoices(used=("z",)), ["a", "b"])
    assert "a, b" in str(refused.value.hint)


@pytest.mark.slow
def test_a_refused_view_leaves_the_results_and_comes_back_when_the_choice_is_taken_back(demo: Demo, tmp_path: Path) -> None:
    project = ProjectFolder.open(linked_copy(demo.folder, tmp_path / "project"))
    before = project.measurement()
    assert before is not None
    name = before.views[2].viewpoint_id
    without = restitch(project, ViewChoices(refused=(name,)), lambda _event: None, NoProgress()).measurement
    lines = {line.viewpoint_id: line for line in without.stitched.placements}
    assert not lines[name].used and lines[name].verdict == REFUSED
    assert len(without.stitched) < len(before.stitched)
    stored = project.measurement()
    assert stored is not None and len(stored.stitched) == len(without.stitched)
    assert project.view_choices().refused == (name,)
    assert without.validity == replace(before.validity)
    with pytest.raises(InputError):
        restitch(project, ViewChoices(refused=("nowhere",)), lambda _event: None, NoProgress())
    assert project.view_choices().refused == (name,)
    again = restitch(project, ViewChoices(), lambda _event: None, NoProgress()).measurement
    assert all(line.used for line in again.stitched.placements)
    assert np.allclose(again.stitched.points_mm, before.stitched.points_mm, atol=1e-3)
