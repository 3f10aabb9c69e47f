"""Pictures of scan plans."""

from __future__ import annotations

from xml.etree import ElementTree

import numpy as np
import pytest

from measureapp.data.plan import ScanPlan
from measureapp.errors import InputError
from measureapp.planning import edit
from measureapp.project.plan_file import read_plan
from measureapp.project.rig_file import read_rig
from measureapp.report.plan_picture import RED, plan_svg, write_plan_picture
from measureapp.report.svg import Panel, svg
from measureapp.resources import resource

RIG = read_rig("paper")
SAMPLE = read_plan(resource("plans/paper_impeller.toml"))


def texts(drawing: str) -> list[str]:
    return [element.text or "" for element in ElementTree.fromstring(drawing).iter() if element.tag.endswith("text")]


def test_every_viewpoint_has_its_number_and_stations_that_hide_each_other_share_a_text():
    words = texts(plan_svg(SAMPLE, RIG))
    assert {str(number) for number in range(1, 37)} <= set(words)
    assert {"1–10", "11–20", "21–29", "30–36"} <= set(words)
    assert "1–10, 11–20" in words  # from the side, the guide is not seen


def test_what_cannot_be_scanned_is_red():
    assert RED not in plan_svg(SAMPLE, RIG)
    assert RED in plan_svg(SAMPLE, RIG, bad=frozenset({"hub-03"}))


def test_a_drawing_escapes_its_texts_and_keeps_everything_in_the_panel():
    panel = Panel((10.0, 20.0, 100.0, 50.0), (0.0, 0.0, 1000.0, 1000.0))
    panel.text((500.0, 500.0), '<b>&"\x00')
    assert texts(svg(200, 100, [panel])) == ['<b>&"?']
    assert panel.at((500.0, 500.0)) == pytest.approx((60.0, 45.0))
    assert panel.at((500.0, 1000.0)) == pytest.approx((60.0, 20.0))


def test_a_plan_of_thousands_of_viewpoints_is_drawn_without_numbers():
    single = edit.ungroup(SAMPLE, "hub").viewpoints[0]
    many = ScanPlan(name="many", viewpoints=tuple(single.model_copy(update={"id": f"v{n}", "table_deg": n * 0.1}) for n in range(1000)))
    words = texts(plan_svg(many, RIG))
    assert "999" not in words and "1–1000" in words


def test_only_pictures_are_written(tmp_path):
    with pytest.raises(InputError, match="not the name of a picture"):
        write_plan_picture(tmp_path / "plan.pdf", SAMPLE, RIG)


def test_many_lines_are_one_path_at_their_places_on_the_page() -> None:
    panel = Panel((0, 0, 200, 100), (0, 0, 20, 10))
    panel.lines(np.array([[[0.0, 0.0], [20.0, 10.0]], [[10.0, 5.0], [10.0, 0.0]]]), RED, 2.0)
    panel.lines(np.empty((0, 2, 2)), RED)
    (path,) = panel.parts
    assert 'd="M0.0,100.0L200.0,0.0M100.0,50.0L100.0,100.0"' in path and f'stroke="{RED}" stroke-width="2"' in path
