from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.data.phase import PhaseMap, PixelState
from measureapp.data.point_state import PointState
from measureapp.errors import ReconstructError
from measureapp.reconstruct.reconstruct import Reconstruction, reconstruct
from measureapp.reconstruct.settings import ReconstructSettings
from measureapp.reconstruct.why import OF_PHASE, OF_POINT, shares_of_region, shares_of_view, why
from tests.reconstruct.conftest import Head, plane

View = tuple[dict[str, PhaseMap], Reconstruction]
SETTINGS = ReconstructSettings(min_island_px=100)


@pytest.fixture(scope="module")
def view(head: Head) -> View:
    maps = head.phase_maps(plane(550, 0.2, 0.1))
    state = maps["left"].state.copy()
    state[20:40, 30:60] = PixelState.SATURATED
    state[60:81, 60:81] = PixelState.SHADOW
    state[66:75, 66:75] = PixelState.VALID
    maps["left"] = replace(maps["left"], state=state)
    return maps, reconstruct(maps, head.cameras, SETTINGS)


def test_a_pixel_without_phase_is_explained_by_the_decoder_with_its_numbers(view: View) -> None:
    said = why(*view, "left", 30, 40)
    assert (said.stage, said.reason) == ("decode", "saturated")
    assert "102 of 255" in said.sentence and "shorter exposure" in said.sentence


def test_a_pixel_with_a_phase_is_explained_by_the_stage_that_dropped_it(view: View) -> None:
    said = why(*view, "left", 70, 70, SETTINGS)
    assert (said.stage, said.reason) == ("clean", "island")
    assert "100 pixels" in said.sentence
    assert why(*view, "left", 100, 100).stage == "point"
    assert why(*view, "right", 100, 150).reason == "seen by another"


def test_the_shares_of_a_region_and_of_a_view_sum_to_one(view: View) -> None:
    box = shares_of_region(*view, "left", (20, 20, 40, 60))
    assert box == pytest.approx({"saturated": 0.75, "point": 0.25}, abs=0.02)
    mask = np.zeros(view[0]["left"].state.shape, bool)
    mask[60:81, 60:81] = True
    assert shares_of_region(*view, "left", mask) == pytest.approx({"shadow": 360 / 441, "island": 81 / 441})
    for shares in shares_of_view(*view).values():
        assert sum(shares.values()) == pytest.approx(1.0)


def test_every_state_has_a_sentence() -> None:
    assert set(OF_PHASE) == set(PixelState) - {PixelState.VALID}
    assert set(OF_POINT) == set(PointState) - {PointState.NO_PHASE}


def test_places_outside_the_view_are_refused_in_words(view: View) -> None:
    with pytest.raises(ReconstructError, match="no pixel in row 999"):
        why(*view, "left", 999, 0)
    with pytest.raises(ReconstructError, match="no camera 'front'"):
        why(*view, "front", 0, 0)
    with pytest.raises(ReconstructError, match="region has no pixel"):
        shares_of_region(*view, "left", (5, 5, 5, 9))
