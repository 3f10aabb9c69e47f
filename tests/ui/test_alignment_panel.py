"""The alignment is chosen by its elements, with what they leave free in sight."""

from __future__ import annotations

from PySide6.QtWidgets import QLabel

from tests.ui.test_dimension_table import page, project, settled  # noqa: F401 - fixtures


def test_an_alignment_that_would_be_refused_says_so_before_it_is_applied(page):  # noqa: F811
    page.side.list.setValue("alignment")
    panel = page.side.alignment
    panel.method.setValue("3-2-1")
    panel._add("ball")
    said = " ".join(one.text() for one in panel.findChildren(QLabel))
    assert "3-2-1 needs a plane there." in said and panel.lamps.fixed == 0
    panel.method.setValue("datums")
    assert panel.lamps.fixed == 3 and panel.apply.isEnabled()


def test_the_alignment_is_chosen_by_its_elements_with_lamps_for_what_they_fix(application, page, qtbot):  # noqa: F811
    page.side.list.setValue("alignment")
    panel = page.side.alignment
    panel.method.setValue("datums")
    assert panel.lamps.fixed == 0 and not panel.apply.isEnabled()
    panel._add("plate")
    assert panel.lamps.fixed == 3 and panel.count.text().startswith("3/6; free: ") and panel.apply.isEnabled()
    panel._add("ball")
    assert panel.lamps.fixed == 5 and panel.value() == {"method": "datums", "datums": ["plate", "ball"]}
    panel.apply.click()
    settled(application, qtbot)
    assert not application.session.inspection.alignment.name.startswith("none") and "plate" in panel.result.text().lower()
    page.undo_last()
    settled(application, qtbot)
    assert application.session.inspection.alignment.name.startswith("none") and panel.value() == {"method": "none"}
