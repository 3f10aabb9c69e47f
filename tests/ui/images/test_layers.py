"""A layer has the numbers of the decoded camera, and tells them with their unit."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.data.phase import PixelState
from tests.ui.images.maps import phase_map
from ui.images.layers import KINDS, layer_of, legend_words


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind != "fringes"])
def test_a_layer_has_the_values_of_the_map_and_none_where_it_has_none(kind):
    found = phase_map()
    layer, valid = layer_of(found, kind), found.state == 0
    truth = {
        "phase": np.where(valid, found.phase_rad, np.nan),
        "wrapped": np.where(valid, np.mod(found.phase_rad.astype(float), 2 * np.pi), np.nan),
        "modulation": np.where(found.modulation > 0, found.modulation, np.nan),
        "sigma": np.where(valid, found.sigma_rad, np.nan),
        "exposure": np.where(found.exposure_index >= 0, found.exposure_index, np.nan),
        "state": found.state,
    }[kind]
    assert np.allclose(layer.values, truth, atol=2e-5, equal_nan=True)
    low, high = layer.span
    assert np.isfinite([low, high]).all() and low < high


def test_the_words_of_a_pixel_are_its_value_with_unit(look):
    found = phase_map()
    assert layer_of(found, "phase").words_at(7, 30).replace("\u00a0", " ") == f"{found.phase_rad[7, 30]:.3f} rad"
    assert layer_of(found, "phase").words_at(0, PixelState.SHADOW) == "–"
    assert layer_of(found, "state").words_at(0, PixelState.SHADOW) == "Shadow"
    row, column = np.argwhere(found.exposure_index == 1)[0]
    assert layer_of(found, "exposure").words_at(row, column).replace("\u00a0", " ") == "20 ms"


def test_shares_in_the_legend_are_those_of_the_map(look):
    found = phase_map()
    layer = layer_of(found, "state")
    assert sum(one.share for one in layer.categories) == pytest.approx(1.0)
    assert layer.categories[PixelState.SATURATED].share == pytest.approx(1 / 60)
    assert "Saturated" in legend_words(layer)
