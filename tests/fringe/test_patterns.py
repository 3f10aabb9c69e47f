from __future__ import annotations

import numpy as np
import pytest

from measureapp.data.fringe import PAPER_PATTERNS, GrayCodeGroup, PatternSet, PhaseShiftGroup
from measureapp.errors import DecodeError
from measureapp.fringe.decode import decode
from measureapp.fringe.patterns import check_determines_phase, pattern_images
from measureapp.fringe.unwrap import plan_heterodyne
from tests.fringe.conftest import stack_of


def pitches(*values: float, projector_px: int = 1024) -> PatternSet:
    return PatternSet(name="t", projector_px=projector_px, groups=tuple(PhaseShiftGroup(pitch_px=value) for value in values))


def test_a_camera_that_sees_the_patterns_as_drawn_decodes_the_columns(sets: dict[str, PatternSet]) -> None:
    for name, patterns in sets.items():
        drawn = pattern_images(patterns, 1024, 6)
        assert drawn.shape == (patterns.count, 6, 1024)
        assert drawn.dtype == np.uint8
        seen = np.rint(drawn * 0.8 + 20).astype(np.uint8)[None]
        decoded = decode(stack_of(seen, patterns))["left"]
        assert decoded.valid.mean() > 0.995, name
        error = (decoded.column_px - np.arange(1024))[decoded.valid]
        assert np.abs(error).max() < 0.06, name  # rounding to whole grey levels


def test_the_noise_of_the_papers_order_decision_is_46_times_that_of_the_phase() -> None:
    assert plan_heterodyne(PAPER_PATTERNS).amplification == pytest.approx(45.97, abs=0.01)


def test_three_pitches_are_unwrapped_by_the_quietest_chain() -> None:
    plan = plan_heterodyne(pitches(1920 / 64, 1920 / 58, 1920 / 53, projector_px=1920))
    assert plan.amplification < 14.5
    assert plan.combinations[-1] == (1, 0, 0)


@pytest.mark.parametrize(
    ("patterns", "reason"),
    [
        (pitches(32), "single pitch"),
        (pitches(32, 34), "beat"),
        (PatternSet(name="g", projector_px=1024, groups=(PhaseShiftGroup(pitch_px=32), GrayCodeGroup(planes=4))), "planes"),
        (
            PatternSet(name="c", projector_px=1024, groups=(PhaseShiftGroup(pitch_px=32), GrayCodeGroup(planes=5, complementary=True))),
            "planes",
        ),
        (PatternSet(name="s", projector_px=1024, groups=(GrayCodeGroup(planes=10),)), "sinusoids"),
    ],
)
def test_a_set_that_does_not_determine_the_phase_is_refused_with_the_reason(patterns: PatternSet, reason: str) -> None:
    with pytest.raises(DecodeError, match=reason) as raised:
        check_determines_phase(patterns)
    assert raised.value.hint


def test_a_projector_wider_than_the_set_is_refused() -> None:
    with pytest.raises(DecodeError, match="1280 px wide"):
        pattern_images(PAPER_PATTERNS, 1280, 4)
