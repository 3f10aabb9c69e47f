"""The page Rig: connect, see the state, move by hand, look, stop, reset."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import Qt

from measureapp.devices.status import DeviceStatus

PATIENCE_MS = 60_000


@pytest.fixture
def page(application, window, rig):
    application.session.set_rig(rig.at_resolution("quarter").model_copy(update={"driver_settings": {"part": "flat"}}))
    window.show_page("rig")
    return window.pages["rig"]


@pytest.fixture
def connected(application, page, window, qtbot):
    page.connect_button.click()
    qtbot.waitUntil(lambda: application.session.cell.connected, timeout=PATIENCE_MS)
    qtbot.waitUntil(lambda: window.header.stop.isVisible() and page.pad.isEnabled(), timeout=PATIENCE_MS)
    return page


def states(page):
    return [cells[2].text for cells in page.devices.model().rows]


def test_without_a_connection_nothing_can_be_moved_or_stopped(application, page, window):
    assert not page.pad.isEnabled()
    assert not window.header.stop.isVisible()
    assert page.connect_button.isVisible()
    assert "not connected" in page.state.text()


def test_connecting_shows_the_state_of_every_device_and_the_stop_button(connected, window):
    assert connected.state.text().endswith("All devices are ready.")
    assert any("flange at" in words for words in states(connected))
    assert window.header.stop.isVisible()
    assert connected.disconnect_button.isVisible()


def test_disconnecting_releases_the_devices(application, connected, window, qtbot):
    connected.disconnect_button.click()
    qtbot.waitUntil(lambda: not application.session.cell.connected, timeout=PATIENCE_MS)
    assert application.session.connection is None
    assert not window.header.stop.isVisible()


def test_a_device_that_is_not_ready_is_named_with_its_remedy(application, connected, qtbot):
    application.session.connection.table.status = lambda: DeviceStatus(False, "not referenced.", "Find its reference.")
    application.controllers.rig.refresh()
    qtbot.waitUntil(lambda: "1 device not ready" in connected.state.text(), timeout=PATIENCE_MS)
    assert "not referenced. Find its reference." in states(connected)


def test_a_step_by_hand_moves_the_axis_and_shows_where_it_is(application, connected, qtbot):
    connected.sides.setValue("move")
    connected.pad.step.setValue("10")
    with qtbot.waitSignal(application.controllers.rig.stepped, timeout=PATIENCE_MS):
        qtbot.mouseClick(connected.pad.buttons["guide", 1], Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: application.session.cell.readback.guide_mm == pytest.approx(10.0), timeout=PATIENCE_MS)


def test_steps_follow_each_other_while_a_button_is_held_and_end_with_it(application, connected, qtbot):
    connected.sides.setValue("move")
    button, ended = connected.pad.buttons["table", 1], []
    application.controllers.rig.stepped.connect(lambda: ended.append(1))
    qtbot.mousePress(button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: len(ended) >= 3, timeout=PATIENCE_MS)
    qtbot.mouseRelease(button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: not application.controllers.jobs.queue.busy, timeout=PATIENCE_MS)
    turned = np.degrees(application.session.connection.table.angle_rad())
    assert turned == pytest.approx(len(ended), abs=1e-3)
    qtbot.wait(100)
    assert np.degrees(application.session.connection.table.angle_rad()) == pytest.approx(turned)


def test_live_images_show_every_camera_with_its_levels(application, connected, qtbot):
    connected.views.setValue("live")
    qtbot.waitUntil(lambda: all(not tile.image.is_empty for tile in connected.tiles.values()), timeout=PATIENCE_MS)
    assert all("saturated" in tile.words.text() for tile in connected.tiles.values())
    assert all(tile.histogram.shares.sum() == pytest.approx(1.0) for tile in connected.tiles.values())
    connected.views.setValue("cell")
    qtbot.waitUntil(lambda: not application.controllers.jobs.queue.busy, timeout=PATIENCE_MS)


@pytest.mark.parametrize("way", ["button", "escape"])
def test_stop_latches_and_nothing_moves_before_a_reset(application, connected, window, qtbot, way):
    if way == "button":
        window.header.stop.click()
    else:
        qtbot.keyClick(window, Qt.Key.Key_Escape)
    qtbot.waitUntil(connected.stopped.isVisible, timeout=PATIENCE_MS)
    qtbot.waitUntil(lambda: not connected.pad.isEnabled(), timeout=PATIENCE_MS)
    qtbot.waitUntil(lambda: window.header.devices.text() == "Stopped", timeout=PATIENCE_MS)
    assert "Stop was pressed" in connected.stop_reason.text()
    connected.reset.click()
    qtbot.waitUntil(lambda: not connected.stopped.isVisible() and connected.pad.isEnabled(), timeout=PATIENCE_MS)


def test_a_stop_during_live_images_ends_them(application, connected, window, qtbot):
    connected.views.setValue("live")
    qtbot.waitUntil(lambda: not connected.tiles["left"].image.is_empty, timeout=PATIENCE_MS)
    window.header.stop.click()
    qtbot.waitUntil(lambda: bool(application.session.cell.stopped) and not application.controllers.jobs.queue.busy, timeout=PATIENCE_MS)
    qtbot.waitUntil(lambda: application.session.connection.projector.shown() == -2, timeout=PATIENCE_MS)
    application.controllers.rig.reset()


def test_a_rig_description_with_an_error_is_refused_in_words_and_the_old_one_stays(application, page, tmp_path):
    broken = tmp_path / "mine.toml"
    broken.write_text("name = 3", encoding="utf-8")
    before = application.session.rig
    application.controllers.rig.choose(broken)
    assert application.session.rig is before
    assert "mine.toml" in application.session.messages[-1].text
