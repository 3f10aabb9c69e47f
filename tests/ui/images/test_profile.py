"""A profile is the array along its line."""

from __future__ import annotations

import numpy as np
import pytest

from tests.ui.images.maps import phase_map
from ui.images.layers import layer_of
from ui.images.profile import profile
from ui.images.profile_panel import ProfilePanel


@pytest.mark.parametrize("ends", [((0, 0), (39, 59)), ((5, 50), (5, 2)), ((30, 7), (3, 7)), ((4, 4), (4, 4))])
def test_a_profile_is_the_array_along_its_line(ends):
    layers = {"a": np.random.default_rng(1).normal(size=(40, 60)), "b": np.arange(2400.0).reshape(40, 60)}
    found = profile(ends, layers)
    assert (found.rows[0], found.columns[0]) == ends[0] and (found.rows[-1], found.columns[-1]) == ends[1]
    for name, layer in layers.items():
        assert np.array_equal(found.values[name], [layer[row, column] for row, column in zip(found.rows, found.columns, strict=True)])
    length = np.hypot(ends[1][0] - ends[0][0], ends[1][1] - ends[0][1])
    assert found.distance_px[-1] == pytest.approx(length)
    steps = np.hypot(np.diff(found.rows), np.diff(found.columns))
    assert (steps <= np.sqrt(2) + 1e-9).all()


def test_a_saved_profile_has_the_same_numbers(tmp_path):
    layer = np.random.default_rng(1).normal(size=(40, 60)).astype(np.float32)
    layer[20, 10] = np.nan
    found = profile(((20, 0), (20, 59)), {"phase_rad": layer})
    found.save(tmp_path / "line 线.csv")
    lines = (tmp_path / "line 线.csv").read_text(encoding="utf-8").splitlines()
    assert lines[0] == "distance_px,row,column,phase_rad" and len(lines) == 61
    assert lines[11].endswith(",")  # no value there
    values = [float(line.rsplit(",", 1)[1]) for line in lines[1:] if not line.endswith(",")]
    assert values == pytest.approx(np.delete(layer[20], 10), rel=1e-6)


def test_the_ends_of_a_line_can_be_typed_and_stay_inside_the_image(qtbot, look):
    panel = ProfilePanel(look)
    qtbot.addWidget(panel)
    panel.fit((40, 60))
    assert panel.value() == ((20, 0), (20, 59))
    with qtbot.waitSignal(panel.lineEdited) as told:
        panel.fields[2].setValue(99)
    assert told.args[0] == ((20, 0), (39, 59)) == panel.value()
    panel.setValue(((1, 2), (3, 4)))
    assert panel.value() == ((1, 2), (3, 4))


def test_a_line_moved_by_the_mouse_tells_its_pixels(qtbot, view):
    view.show_layer(layer_of(phase_map(), "phase"))
    view.show_line(((10, 5), (30, 50)))
    qtbot.wait(30)
    told = []
    view.lineMoved.connect(told.append)
    line = view._items["line"]
    line.movePoint(line.getHandles()[1], (40, 12), coords="parent")
    assert told[-1] == ((10, 5), (12, 40))
    before = len(told)
    view.show_line(((1, 1), (2, 2)))
    assert len(told) == before  # the program's own changes are not told
