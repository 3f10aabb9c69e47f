"""Random events on every page raise no exception and leave a window that still works."""

from __future__ import annotations

import pytest
from without_pictures import without_pictures

from tests.ui.monkey import Monkey, harmless
from ui.main_window import PAGES

PATIENCE_MS = 20_000
LEAVES = ("Quit", "Exit")


@pytest.mark.parametrize("events", [80, pytest.param(2000, marks=pytest.mark.slow)])
@pytest.mark.parametrize("page", [page.name for page in PAGES])
def test_random_events_raise_nothing(application, filled, qtbot, page, events):
    monkey = Monkey(filled, seed=sum(map(ord, page)), spared=LEAVES)
    with without_pictures():  # of the preview of the report
        with harmless(seed=7):
            monkey.play(page, events)
            qtbot.waitUntil(lambda: not any(runner.queue.busy for runner in application.controllers.runners), timeout=PATIENCE_MS)
        assert len(monkey.sent) == events
        for name in filled.pages:
            filled.show_page(name)
            qtbot.wait(1)
    assert filled.isVisible()
