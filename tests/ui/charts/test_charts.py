"""Charts show their data in the stated unit, in the colours of the theme, and survive data that are none."""

from __future__ import annotations

import numpy as np
import pyqtgraph as pg
import pytest

from tests.ui.heartbeat import Heartbeat, load_themes
from ui.charts.bar_chart import Bar, BarChart
from ui.charts.deviation_histogram import BINS, DeviationHistogram
from ui.charts.level_histogram import LevelHistogram
from ui.charts.run_chart import Run, RunChart
from ui.images.live_tile import LiveTile
from ui.look.look import Look
from ui.look.theme import Theme
from ui.viewport.overlay.legend import Legend

BARS = (Bar("Cameras", 0.004), Bar("Hand–eye", 0.021), Bar("Together", 0.0214, strong=True))


@pytest.fixture
def look(qapp):
    return Look("light")


def drawn(chart, kind) -> list:
    return [item for item in chart.plot.getPlotItem().items if isinstance(item, kind)]


def shown(qtbot, chart, width=480, height=200):
    qtbot.addWidget(chart)
    chart.resize(width, height)
    chart.show()
    qtbot.waitExposed(chart)
    return chart


def begun(qtbot, chart):
    """Wait until the axes are made, which charts do in turn."""
    qtbot.waitUntil(lambda: chart.plot is not None)


def test_bars_have_the_lengths_of_their_values_with_names_and_unit(qtbot, look):
    chart = shown(qtbot, BarChart(look, "Contribution"))
    chart.show_bars(BARS)
    begun(qtbot, chart)
    (bars,) = drawn(chart, pg.BarGraphItem)
    assert bars.opts["width"] == [bar.value for bar in BARS]
    bottom, left = chart.plot.axes
    assert bottom.labelText == "Contribution [mm]"
    assert [name for _, name in left._tickLevels[0]] == [bar.name for bar in BARS]
    values = [item.toPlainText().replace("\u00a0", " ") for item in drawn(chart, pg.TextItem)]
    assert values == ["0.004 mm", "0.021 mm", "0.021 mm"]
    assert "Hand–eye 0.021" in chart.accessibleDescription() and chart.accessibleName() == "Contribution"
    chart.show_bars(BARS[:1])
    assert len(drawn(chart, pg.TextItem)) == 1
    chart.show_bars(())
    assert not drawn(chart, pg.BarGraphItem)


def test_no_percentage_beyond_the_whole_is_written_at_an_axis(qtbot, look):
    chart = shown(qtbot, BarChart(look, "Valid pixels", "%", lambda value: f"{value:.1f} %", most=100.0), 320)
    chart.show_bars([Bar("80 ms", 96.8), Bar("Composite", 99.9)])
    begun(qtbot, chart)
    bottom = chart.plot.axes[0]
    assert bottom.range[1] > 100.0  # room for the numbers behind the bars
    assert bottom.tickStrings([0, 50, 100, 150], 1.0, 50.0) == ["0", "50", "100", ""]


def test_the_deviation_histogram_counts_finite_values_on_the_range_of_the_legend(qtbot, look):
    values = np.random.default_rng(4).normal(0.0, 0.02, 5000)
    values[:7] = np.nan
    legend = Legend("Deviation", -0.05, 0.05, tolerance=(-0.03, 0.03))
    chart = shown(qtbot, DeviationHistogram(look))
    chart.show_values(values, legend)
    begun(qtbot, chart)
    heights, strip = drawn(chart, pg.BarGraphItem)
    expected, _ = np.histogram(np.clip(values[7:], -0.05, 0.05), BINS, (-0.05, 0.05))
    assert heights.opts["y1"] == pytest.approx(expected)
    assert [item.value() for item in drawn(chart, pg.InfiniteLine)] == [-0.03, 0.03]
    centres = (chart.edges[1:] + chart.edges[:-1]) / 2
    assert [colour.getRgb()[:3] for colour in strip.opts["brushes"]] == [tuple(colour) for colour in legend.colours(centres)]
    assert chart.plot.axes[0].labelText == "Deviation [mm]"
    (low, high), _ = chart.plot.viewRange()
    assert (low, high) == pytest.approx((-0.05, 0.05))


@pytest.mark.parametrize("values", [np.zeros(0), np.full(9, np.nan)])
def test_a_histogram_of_nothing_is_empty(qtbot, look, values):
    chart = shown(qtbot, DeviationHistogram(look))
    chart.show_values(values, Legend("Deviation", -0.05, 0.05))
    assert not chart.counts.any()
    assert not chart.grab().isNull()


def test_levels_are_shares_and_saturation_is_marked_only_where_it_is_much(qtbot, look):
    chart = shown(qtbot, LevelHistogram(look), 240, 90)
    pixels = np.full((64, 64), 100, np.uint8)
    chart.show_levels(pixels, 255)
    begun(qtbot, chart)
    (bars,) = drawn(chart, pg.BarGraphItem)
    assert chart.shares.sum() == pytest.approx(1.0) and int(np.argmax(chart.shares)) == 25
    fail = look.theme.colour("verdict_fail")
    assert bars.opts["brushes"][-1] != fail and chart.saturated == 0.0
    pixels[:32] = 255
    chart.show_levels(pixels, 255)
    (bars,) = drawn(chart, pg.BarGraphItem)
    assert bars.opts["brushes"][-1] == fail and chart.saturated == pytest.approx(0.5)
    chart.show_levels(np.zeros((0, 0), np.uint8), 255)
    assert chart.saturated == 0.0


def test_a_live_image_says_the_share_of_saturated_pixels(qtbot, look):
    tile = LiveTile(look, "left", 255)
    qtbot.addWidget(tile)
    pixels = np.full((120, 160), 100, np.uint8)
    pixels[:60] = 255
    tile.show_pixels(pixels, 20_000)
    assert "saturated 50.0" in tile.words.text() and "too bright" in tile.words.text()
    assert tile.histogram.saturated == pytest.approx(0.5)


def test_a_run_chart_has_every_value_at_its_part_and_marks_those_beyond_a_limit(qtbot, look):
    chart = shown(qtbot, RunChart(look))
    values = np.array([10.0, 10.02, np.nan, 10.06, 9.99])
    chart.show_run(Run("width", "mm", values, (9.95, 10.05), 10.0175))
    begun(qtbot, chart)
    (points,) = drawn(chart, pg.PlotDataItem)
    assert points.xData.tolist() == [1, 2, 4, 5] and points.yData.tolist() == [10.0, 10.02, 10.06, 9.99]
    fail, usual = look.theme.colour("verdict_fail"), look.theme.colour("accent")
    assert points.opts["symbolBrush"] == [usual, usual, fail, usual]
    assert sorted(line.value() for line in drawn(chart, pg.InfiniteLine)) == [9.95, 10.0175, 10.05]
    (ranges,) = drawn(chart, pg.BarGraphItem)
    heights = np.asarray(ranges.opts["y1"]) - ranges.opts["y0"]
    assert heights / heights.max() == pytest.approx(np.array([0.02, 0.04, 0.07]) / 0.07)
    assert max(ranges.opts["y1"]) < 9.95 and chart.plot.axes[1].labelText == "width [mm]"
    assert "5 values" in chart.accessibleDescription() and "1 beyond" in chart.accessibleDescription()
    chart.show_run(None)
    assert not drawn(chart, pg.PlotDataItem)


@pytest.mark.parametrize("values", [[], [np.nan, np.nan], [4.0], [4.0, 4.0]])
def test_a_run_of_few_or_equal_values_is_drawn(qtbot, look, values):
    chart = shown(qtbot, RunChart(look))
    chart.show_run(Run("width", "mm", np.array(values)))
    assert not chart.grab().isNull()


def test_charts_follow_the_theme_without_new_data(qtbot, look):
    chart = shown(qtbot, BarChart(look, "Contribution"))
    chart.show_bars(BARS)
    begun(qtbot, chart)
    for shade in ("dark", "light"):
        look.set_shade(shade)
        theme = Theme.load(shade)
        assert chart.plot.backgroundBrush().color() == theme.colour("surface")
        assert chart.plot.axes[0].textPen().color() == theme.colour("soft")
        (bars,) = drawn(chart, pg.BarGraphItem)
        assert bars.opts["brushes"][0] == theme.colour("faint")
        corner = chart.grab().toImage().pixelColor(chart.width() - 2, 2)
        assert corner == theme.colour("surface")


def test_a_chart_that_cannot_be_seen_takes_the_theme_when_it_is_shown(qtbot, look):
    chart = shown(qtbot, BarChart(look, "Contribution"))
    chart.show_bars(BARS)
    begun(qtbot, chart)
    chart.hide()
    look.set_shade("dark")
    assert chart.plot.backgroundBrush().color() == Theme.load("light").colour("surface")
    chart.show()
    assert chart.plot.backgroundBrush().color() == Theme.load("dark").colour("surface")
    (bars,) = drawn(chart, pg.BarGraphItem)
    assert bars.opts["brushes"][0] == Theme.load("dark").colour("faint")


def test_data_that_arrive_out_of_sight_are_drawn_when_the_chart_is_shown(qtbot, look):
    chart = shown(qtbot, BarChart(look, "Contribution"))
    chart.hide()
    chart.show_bars(BARS)
    assert chart.plot is None and "Hand–eye 0.021" in chart.accessibleDescription()
    chart.show()
    qtbot.waitUntil(lambda: chart.plot is not None)
    assert len(drawn(chart, pg.TextItem)) == len(BARS)
    chart.hide()
    chart.show_bars(BARS[:1])
    assert len(drawn(chart, pg.TextItem)) == len(BARS)
    chart.show()
    assert len(drawn(chart, pg.TextItem)) == 1


def test_negative_numbers_have_a_true_minus_sign_and_no_prefix(qtbot, look):
    chart = shown(qtbot, DeviationHistogram(look))
    chart.show_values(np.zeros(3), Legend("Deviation", -0.0005, 0.0005))
    begun(qtbot, chart)
    texts = chart.plot.axes[0].tickStrings([-0.0004, 0.0004], 1.0, 0.0001)
    assert texts == ["\u22120.0004", "0.0004"]


def test_the_wheel_over_a_chart_reaches_the_page_below(qtbot, look):
    chart = shown(qtbot, BarChart(look, "Contribution"))
    chart.show_bars(BARS)
    assert chart.childAt(chart.rect().center()) is None


@pytest.mark.slow
@pytest.mark.timed
def test_a_theme_switch_with_six_charts_does_not_stall_the_window(qtbot, look):
    """No page has more: the live images and histograms of three cameras."""
    charts = [shown(qtbot, DeviationHistogram(look)) for _ in range(6)]
    for chart in charts:
        chart.show_values(np.random.default_rng(1).normal(0, 0.02, 100_000), Legend("Deviation", -0.05, 0.05))
    load_themes(qtbot, look)
    with Heartbeat() as heart:
        look.set_shade("dark")
        qtbot.wait(60)
        look.set_shade("light")
        qtbot.wait(60)
    heart.check()
