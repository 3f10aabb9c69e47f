"""What images say against a part at rest in steady light, in words with what it costs."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from measureapp.data.cloud import PointCloud
from measureapp.data.phase import PhaseMap, StackEvidence
from measureapp.pipeline.stack_findings import blur_findings, stack_findings
from tests.reconstruct.test_discontinuities import cameras

QUIET = StackEvidence(6000.0, 7.0, True)
SIGMA_RAD, SIGMA_MM = 0.02, 0.05


def a_map(evidence: StackEvidence | None) -> PhaseMap:
    shape = (4, 5)
    flat = np.zeros(shape, np.float32)
    return PhaseMap(
        "left",
        "v",
        flat,
        flat + np.float32(SIGMA_RAD),
        flat,
        flat,
        flat.astype(np.uint8),
        flat.astype(np.int8),
        32.0,
        1024,
        evidence=evidence,
    )


def a_cloud() -> PointCloud:
    points = np.zeros((20, 3))
    grey = np.zeros(20)
    return PointCloud(points, points, np.full(20, SIGMA_MM), grey, np.zeros((20, 2), np.int32), np.zeros(20, np.uint8), "camera", "v")


def said(evidence: StackEvidence | None) -> tuple[str, ...]:
    return stack_findings({"left": a_map(evidence), "right": a_map(QUIET)}, a_cloud())


def test_images_at_rest_have_no_finding() -> None:
    assert said(QUIET) == ()
    assert said(None) == ()


def test_vibration_is_named_with_what_it_costs() -> None:
    (sentence,) = said(replace(QUIET, vibration_rad=0.018))
    assert "camera left" in sentence
    assert "vibration" in sentence
    assert "0.045 mm" in sentence


def test_a_lamp_that_was_switched_on_is_named_with_its_exposure_and_cost() -> None:
    (sentence,) = said(replace(QUIET, light_rad=0.004, light_step=0.25, light_exposure_us=60_000.0))
    assert "+25%" in sentence
    assert "60 ms" in sentence
    assert "0.010 mm" in sentence


def test_phases_that_scatter_more_than_their_images_are_named() -> None:
    (sentence,) = said(replace(QUIET, scatter=1.9))
    assert "1.9 times" in sentence


def test_a_part_less_sharp_than_the_board_is_named_with_both_blurs() -> None:
    assert (
        blur_findings({"one": 0.8}, cameras(0.757)) == blur_findings({"one": 0.8}, cameras(0.0)) == blur_findings({}, cameras(0.757)) == ()
    )
    (sentence,) = blur_findings({"one": 1.04}, cameras(0.757))
    assert "camera one" in sentence
    assert "1.04 px instead of 0.76 px" in sentence
