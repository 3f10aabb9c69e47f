"""An explanation of a stored view says what the measurement itself said, and its pictures show it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from demo_fixture import Demo

from measureapp.data.phase import PixelState
from measureapp.data.point_state import PointState
from measureapp.errors import CalibrationError, InputError, ReconstructError
from measureapp.pipeline.why import NO_HOLES, REASONS, ExplainedView, explain_view
from measureapp.pipeline.why_pictures import KINDS, REASON_COLOURS, picture, with_legends
from measureapp.project.folder import ProjectFolder

VIEW = "view02"


@pytest.fixture(scope="module")
def explained(demo: Demo) -> ExplainedView:
    return explain_view(demo.project, VIEW)


def test_the_pixels_with_a_point_are_those_of_the_stored_cloud(demo: Demo, explained: ExplainedView) -> None:
    measurement = demo.project.measurement()
    assert measurement is not None
    cloud = next(view.cloud for view in measurement.views if view.viewpoint_id == VIEW)
    counted = sum(int((explained.codes(camera) == REASONS.index("point")).sum()) for camera in explained.cameras)
    assert counted == len(cloud)
    for place in (0, len(cloud) // 2, -1):
        row, column = (int(value) for value in cloud.pixel[place])
        owner = explained.calibrated[(int(cloud.cameras[place]) & -int(cloud.cameras[place])).bit_length() - 1]
        numbers = {number.what: number.value for number in explained.pixel(owner, row, column).numbers}
        assert numbers["point σ"] == pytest.approx(float(cloud.sigma_mm[place]), rel=1e-3)
        assert numbers["cameras"] == int(cloud.cameras[place]).bit_count()
    reference = explained.codes(explained.cameras[0])
    rows, columns = cloud.pixel[: int((reference == REASONS.index("point")).sum())].T
    assert (reference[rows, columns] == REASONS.index("point")).all()


def test_codes_shares_pixels_and_regions_tell_the_same(explained: ExplainedView) -> None:
    for camera, shares in explained.shares().items():
        assert sum(shares.values()) == pytest.approx(1.0)
        codes = explained.codes(camera)
        for reason, share in shares.items():
            places = np.argwhere(codes == REASONS.index(reason))
            assert len(places) / codes.size == pytest.approx(share)
            assert explained.pixel(camera, *places[0]).found.reason == reason
        whole = explained.region(camera, (0, 0, *codes.shape))
        assert whole.shares == shares
        assert whole.example is not None and whole.example.found.reason == next(one for one in shares if one not in NO_HOLES)


def test_the_numbers_of_a_pixel_stand_beside_the_limits_that_decided(explained: ExplainedView) -> None:
    camera = explained.cameras[0]
    for code in np.unique(explained.codes(camera)):
        row, column = np.argwhere(explained.codes(camera) == code)[0]
        answer = explained.pixel(camera, int(row), int(column))
        numbers = {number.what: number for number in answer.numbers}
        below = numbers["modulation"].value < (numbers["modulation"].least or 0.0)
        if answer.found.reason in ("shadow",):
            assert below
        if answer.found.stage != "decode":
            assert not below
            assert 0 < numbers["phase noise"].value <= (numbers["phase noise"].most or 0.0)
            assert numbers["signal to noise"].value > 0


def test_a_region_beyond_the_image_and_an_unknown_camera_are_refused_in_words(explained: ExplainedView) -> None:
    height = len(explained.codes("left"))
    for box in ((0, 0, height + 1, 5), (-1, 0, 5, 5), (5, 5, 5, 9)):
        with pytest.raises(ReconstructError, match="region"):
            explained.region("left", box)
    with pytest.raises(ReconstructError, match="no camera 'front'"):
        explained.codes("front")


def test_a_view_that_is_not_stored_and_a_project_without_calibration_are_refused(demo: Demo, raw_copy: Path) -> None:
    with pytest.raises(InputError, match="view99") as refused:
        explain_view(demo.project, "view99")
    assert VIEW in refused.value.hint
    with pytest.raises(CalibrationError, match="no calibration"):
        explain_view(ProjectFolder.open(raw_copy), VIEW)


def test_every_reason_has_a_colour_of_its_own_and_only_a_point_lets_the_image_be_seen() -> None:
    assert set(REASON_COLOURS) == set(REASONS)
    assert len(REASONS) == len(PixelState) + len(PointState) - 2
    coloured = [colour for colour in REASON_COLOURS.values() if colour is not None]
    assert len(set(coloured)) == len(coloured) == len(REASONS) - 1


def test_pictures_show_the_colours_their_legends_name(explained: ExplainedView) -> None:
    drawn = {kind: picture(explained, "left", kind) for kind in KINDS}
    codes = explained.codes("left")
    for entry in drawn["reasons"].legend:
        if entry.words not in NO_HOLES:
            shown = (drawn["reasons"].pixels == entry.colour).all(axis=2)
            assert shown[codes == REASONS.index(entry.words)].all()
    assert sum(entry.share or 0.0 for entry in drawn["reasons"].legend) == pytest.approx(1.0)
    assert sum(entry.share or 0.0 for entry in drawn["exposure"].legend) == pytest.approx(1.0)
    assert len(drawn["exposure"].legend) == len(explained.exposures_us) + 1
    bright = drawn["snr"].pixels[explained.phase_maps["left"].valid].sum(axis=1)
    snr = explained.phase_maps["left"].snr[explained.phase_maps["left"].valid]
    assert bright[snr > np.percentile(snr, 95)].mean() > bright[snr < np.percentile(snr, 5)].mean()
    laid = with_legends({"left": drawn["reasons"], "again": drawn["snr"]})
    np.testing.assert_array_equal(laid[: codes.shape[0], : codes.shape[1]], drawn["reasons"].pixels)
    assert laid.shape[0] > codes.shape[0] and laid.shape[1] == 2 * codes.shape[1]
