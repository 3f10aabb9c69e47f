from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.data.point_state import PointState
from measureapp.errors import ReconstructError
from measureapp.reconstruct.projector.with_projector import reconstruct_alone
from measureapp.reconstruct.reconstruct import Reconstruction, reconstruct
from measureapp.reconstruct.settings import ReconstructSettings
from measureapp.reconstruct.why import OF_PHASE, OF_POINT, shares_of_region, shares_of_view, why
from tests.reconstruct.conftest import Head, plane
from tests.reconstruct.projector_scene import ProjectorHead
from tests.reconstruct.projector_scene import make_head as make_projector_head

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


@pytest.fixture(scope="module")
def projector_head() -> ProjectorHead:
    return make_projector_head()


def alone(phase_map: PhaseMap, cameras: CameraArrayCalibration | None) -> View:
    return {phase_map.camera: phase_map}, reconstruct_alone(phase_map, cameras)


def test_a_single_camera_without_a_projector_is_explained_up_to_its_phase(projector_head: ProjectorHead) -> None:
    seen = projector_head.phase_maps(plane(550, 0.2, 0.1))["left"]
    row, column = (int(value) for value in np.argwhere(seen.valid)[len(np.argwhere(seen.valid)) // 2])
    for cameras in (None, projector_head.without_projector()):
        view = alone(seen, cameras)
        said = why(*view, "left", row, column)
        assert (said.stage, said.reason) == ("match", "unmatched")
        assert f"projector column {seen.column_at(row, column):.2f}" in said.sentence and "calibrate the projector" in said.sentence
        shares = shares_of_view(*view)["left"]
        assert shares["unmatched"] == pytest.approx(float(seen.valid.mean()))


def test_a_single_camera_with_the_projector_has_points_and_the_reasons_of_their_geometry(projector_head: ProjectorHead) -> None:
    seen = projector_head.phase_maps(plane(550, 0.2, 0.1), across=True)["left"]
    across = seen.orthogonal
    assert across is not None
    row, column = (int(value) for value in np.argwhere(seen.valid)[len(np.argwhere(seen.valid)) // 2])
    box = (slice(row - 8, row + 8), slice(column - 8, column + 8))
    wrong, behind = across.phase_rad.copy(), seen.phase_rad.copy()
    wrong[box] += np.float32(1.5)
    torn = replace(seen, orthogonal=replace(across, phase_rad=wrong))
    made = reconstruct_alone(seen, projector_head.cameras)
    assert (made.states["left"] == PointState.VALID).sum() == len(made.cloud) > 0.9 * seen.valid.sum()
    assert why({"left": seen}, made, "left", row, column).stage == "point"
    said = why(*alone(torn, projector_head.cameras), "left", row, column)
    assert said.reason == "contradicted"
    assert f"column {seen.column_at(row, column):.2f} and row" in said.sentence
    behind[box] = np.float32(200 * np.pi)  # a column that lies behind the camera
    said = why(*alone(replace(seen, phase_rad=behind, orthogonal=None), projector_head.cameras), "left", row, column)
    assert said.reason == "unmatched" and "viewing ray does not meet" in said.sentence


def test_a_camera_and_a_projector_without_any_point_are_explained_all_the_same(projector_head: ProjectorHead) -> None:
    seen = projector_head.phase_maps(plane(550, 0.2, 0.1))["left"]
    beyond = replace(seen, phase_rad=np.where(seen.valid, np.float32(400 * np.pi), np.float32(0)))
    made = reconstruct_alone(beyond, projector_head.cameras)
    assert len(made.cloud) == 0
    assert shares_of_view({"left": beyond}, made)["left"]["unmatched"] == pytest.approx(float(seen.valid.mean()))


def test_horizontal_fringes_are_explained_by_rows_and_by_the_pairs_they_cannot_match(head: Head) -> None:
    maps = {name: replace(each, direction="horizontal") for name, each in head.phase_maps(plane(550, 0.2, 0.1), horizontal=True).items()}
    maps["upper"] = replace(maps["upper"], state=np.full_like(maps["upper"].state, PixelState.SHADOW))
    made = reconstruct(maps, head.cameras)
    row, column = (int(value) for value in np.argwhere(maps["left"].valid)[3000])
    said = why(maps, made, "left", row, column)
    assert said.reason == "unmatched"
    assert f"projector row {maps['left'].column_at(row, column):.2f}" in said.sentence
    assert "left and right were not matched: epipolar lines" in said.sentence


def test_fringes_of_both_directions_state_column_and_row_and_what_one_of_them_lacks(head: Head) -> None:
    across = head.phase_maps(plane(550, 0.2, 0.1), horizontal=True)
    state = across["left"].state.copy()
    state[100:120, 100:140] = PixelState.SATURATED
    across["left"] = replace(across["left"], state=state)
    maps = {
        name: replace(each, orthogonal=replace(across[name], direction="horizontal"))
        for name, each in head.phase_maps(plane(550, 0.2, 0.1)).items()
    }
    made = reconstruct(maps, head.cameras)
    assert "give no row there: saturated" in why(maps, made, "left", 110, 120).sentence
    assert "give no row" not in why(maps, made, "left", 140, 120).sentence
