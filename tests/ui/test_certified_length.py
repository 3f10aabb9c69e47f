"""A measured length is stated to be certified in the table of dimensions, and corrects the others."""

from PySide6.QtWidgets import QMenu

from tests.ui.test_dimension_table import page, project, row_named, settled  # noqa: F401 - fixtures


def opened(page, name):  # noqa: F811
    page.side.table.select(row_named(page, name).id)
    menu = QMenu(page.side.table)
    page.side.table.menuAsked.emit(menu)
    action = next(one for one in menu.actions() if one.text().startswith("Certified"))
    action.trigger()
    return action, getattr(page.side.actions, "dialog", None)


def test_a_length_is_certified_by_its_menu_and_told_in_its_origin(application, page, qtbot):  # noqa: F811
    action, dialog = opened(page, "size")
    assert action.isEnabled() and dialog.form.raw()["certified_mm"] == row_named(page, "size").nominal
    assert not dialog.use.isEnabled() and dialog.remove.isHidden()  # its uncertainty is missing
    dialog.form.set_raw({"certified_mm": 120.013, "uncertainty_mm": 0.002, "number": "4711"})
    dialog.form.edited.emit()
    dialog.use.click()
    settled(application, qtbot)
    found = row_named(page, "size").found
    assert row_named(page, "size").nominal == 120.013
    assert "certified length of 120.0130" in found.traceability and "certificate 4711" in found.traceability
    _, dialog = opened(page, "size")
    assert not dialog.remove.isHidden() and dialog.form.value().number == "4711"
    dialog.remove.click()
    settled(application, qtbot)
    assert row_named(page, "size").entry.certificate is None


def test_a_tolerance_zone_cannot_be_certified(page):  # noqa: F811
    action, _ = opened(page, "flat")
    assert not action.isEnabled()
