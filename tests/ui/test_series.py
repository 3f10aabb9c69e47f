"""Series of parts in the window: programs, trend and capability, the run chart, adding the open measurement."""

from __future__ import annotations

import pytest

from measureapp.project.series.store import SeriesStore
from tests.report.series.test_capability import runs

PATIENCE_MS = 20_000


@pytest.fixture
def series(window):  # which has a home of its own
    store = SeriesStore("lid 盖 #1")
    for run in runs(30):
        store.add(run)
    return store


def opened(window):
    window.show_page("report")
    window.pages["report"].series.click()
    return window.pages["report"].series_of_parts


def test_without_a_series_the_window_says_how_one_begins(window, qtbot):
    dialog = opened(window)
    assert "No series yet" in dialog.words.text() and not dialog.save.isEnabled() and not dialog.file.isEnabled()
    dialog.close()


def test_a_series_shows_capability_with_its_number_of_parts_and_is_reported(series, window, qtbot, monkeypatch, tmp_path):
    dialog = opened(window)
    qtbot.waitUntil(lambda: dialog.found is not None, timeout=PATIENCE_MS)
    assert dialog.programs.currentText() == "lid 盖 #1" and dialog.words.text().startswith("30 runs")
    cells = [dialog.table.model().index(0, column).data() for column in range(7)]
    assert cells[0] == "width" and cells[1] == "30" and cells[5].startswith("Ppk ") and cells[6].startswith("Cpk ")
    assert "preliminary" in dialog.remark.text().lower()
    trend = dialog.found.trends[0]
    assert dialog.chart.run.values is trend.values and dialog.chart.run.limits == trend.limits
    assert "30 values" in dialog.chart.accessibleDescription()
    monkeypatch.setattr("ui.pages.series.dialog.choose_folder", lambda *_: tmp_path)
    dialog.save.click()
    qtbot.waitUntil(lambda: (tmp_path / "series.pdf").is_file() and (tmp_path / "series.json").is_file(), timeout=PATIENCE_MS)
    dialog.close()


def test_a_damaged_series_is_named(series, window, qtbot):
    from measureapp.project.series.store import series_folder

    (series_folder(series.program) / "results.sqlite").write_bytes(b"not a database")
    dialog = opened(window)
    qtbot.waitUntil(lambda: "damaged" in dialog.words.text(), timeout=PATIENCE_MS)
    dialog.close()
