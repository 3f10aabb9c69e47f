"""A kind of calibration that is in the table has its entry in the menu and its wizard."""

from __future__ import annotations

from tests.calibration_session.toy_kind import register


def test_the_window_offers_a_new_kind_and_opens_its_wizard(monkeypatch, calibration_page, application, calibration):
    register(monkeypatch)
    application.session.set_calibration(calibration)
    assert calibration_page.offers["standoff"].isEnabled()
    calibration_page.open_wizard("standoff")
    wizard = calibration_page.wizards["standoff"]
    assert wizard.windowTitle() == "Calibrate the standoff"
    wizard.close()
