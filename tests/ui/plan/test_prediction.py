"""What the Plan page checks in the background, and shows of it on the part."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.ui.plan.page_steps import enter, names
from ui.pages.plan import preview
from ui.pages.plan.ray import first_hit


class _Job:
    """Progress of a composer that is run in the test itself."""

    def check(self) -> None:
        """Go on."""


def test_what_cannot_be_scanned_is_marked_with_its_sentence(checked, qtbot):
    assert "nothing prevents the scan" in checked.state.text() and not checked.problem.isVisible()
    checked.tree.select(("hub-03",))
    enter(checked.form.guide, 900)
    qtbot.waitUntil(lambda: checked.planning.prediction.is_current, timeout=20_000)
    assert "1 problem" in checked.state.text()
    assert "hub-03: Guide at 900.0 mm is outside" in checked.problem.text()
    rows = checked.tree.rows
    assert rows._state(rows.find("hub-03")).sign == "fail" and rows._state(rows.find("hub-02")).sign == "pass"
    assert checked.properties.groups[0].heading == "Prevents the scan"
    checked.planning.undo()
    qtbot.waitUntil(lambda: checked.planning.prediction.is_current, timeout=20_000)
    assert not checked.problem.isVisible()


def test_only_the_newest_of_many_edits_is_checked(checked, qtbot):
    checked.tree.select(("hub-03",))
    for value in range(30):
        enter(checked.form.guide, value)
    qtbot.waitUntil(lambda: checked.planning.prediction.is_current, timeout=20_000)
    assert checked.planning.prediction.now.plan is checked.planning.plan


def test_the_coverage_is_predicted_and_drawn_on_the_part(on_impeller, application):
    page = on_impeller
    found = page.planning.prediction.now
    assert 0.5 < found.coverage.predicted < 0.8
    assert page.legend.words.text() == f"Predicted coverage {100 * found.coverage.predicted:.1f}\u00a0%"
    page.tree.select(("hub-01",))
    scenery = page._scenery()
    surfaces = {shown: preview.composer(replace(scenery, shown=shown), page.look.theme)(_Job()).surface for shown in preview.SHOWN}
    colours = {shown: {tuple(colour) for colour in surface.colours.tolist()} for shown, surface in surfaces.items()}
    assert {preview.ONCE, preview.TWICE, preview.OFTEN} <= colours["coverage"]
    assert preview.ONCE not in colours["selected"] and preview.PART["light"] in colours["part"]
    page.shown.setValue("selected")
    assert page.legend.words.text() == "" and page.legend.isVisible()


def test_the_preview_shows_frusta_and_marks_what_cannot_be_scanned_red(on_impeller, qtbot):
    page = on_impeller
    page.tree.select(("hub-01",))
    enter(page.form.guide, 900)
    qtbot.waitUntil(lambda: page.planning.prediction.is_current, timeout=20_000)
    theme = page.look.theme
    picture = preview.composer(page._scenery(), theme)(_Job())
    fail = preview.rgb(theme, "verdict_fail")
    assert fail in {layer.colour for layer in picture.lines} and preview.CAMERA_LINES in {layer.colour for layer in picture.lines}
    assert fail in {tuple(colour) for colour in picture.surface.colours.tolist()}
    assert [label.text for label in picture.labels] == ["hub-01"]


def test_a_click_on_the_part_adds_a_viewpoint_that_faces_it(on_impeller, qtbot):
    page = on_impeller
    part, before = page.planning.part.prepared, names(page)
    page.on_part.setChecked(True)
    turn = preview.guide_from_part(page._scenery())
    top, down = turn @ [0.0, 0.0, 500.0, 1.0], np.array([0.2, 0.1, -1.0])
    page.view.rayClicked.emit(top[:3], down)
    assert len(names(page)) == len(before) + 1
    new = next(name for name in names(page) if name not in before)
    assert page.tree.names() == (new,)
    point, normal = first_hit(part.corners_mm, np.eye(4), np.array([0.0, 0.0, 500.0]), down)
    assert point[2] == pytest.approx(part.mesh.vertices_mm[:, 2].max(), abs=60.0) and normal[2] > 0.5
    page.view.rayClicked.emit(top[:3], np.array([0.0, 0.0, 1.0]))  # misses the part
    page.end_clicking()
    page.view.rayClicked.emit(top[:3], down)
    assert len(names(page)) == len(before) + 1
