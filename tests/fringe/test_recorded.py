"""Recorded sets that others made; skipped where they are absent."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from recorded import recorded

from measureapp.data.fringe import FringeStack, GrayCodeGroup, PatternSet, PhaseShiftGroup
from measureapp.data.phase import PhaseMap
from measureapp.errors import DecodeError
from measureapp.fringe.decode import decode
from measureapp.fringe.settings import DecodeSettings
from measureapp.project.images import read_image


def decoded(folder: Path, files: list[str], patterns: PatternSet, settings: DecodeSettings | None = None) -> PhaseMap:
    images = np.array([read_image(folder / file) for file in files])[None]
    return decode(FringeStack("v", patterns, (1000,), {"one": images}, 255), settings)["one"]


def numbered(*numbers: int) -> list[str]:
    return [f"{number:02d}.png" for number in numbers]


def test_three_frequencies_of_the_rendered_set_give_the_recorded_phase() -> None:
    groups = tuple(PhaseShiftGroup(pitch_px=1920 / periods) for periods in (64, 58, 53))
    patterns = PatternSet(name="3", projector_px=1920, groups=groups, shift_sign=1)
    found = decoded(recorded("slmaster_render_3freq"), numbered(*range(12)), patterns)
    assert found.phase_rad[470, 590] + np.pi == pytest.approx(191.95, abs=0.1)
    assert (found.valid & (found.modulation > 30)).sum() == pytest.approx(256_792, rel=0.01)


def test_the_real_camera_gives_a_phase_without_jumps() -> None:
    groups = (PhaseShiftGroup(pitch_px=60, steps=12), GrayCodeGroup(planes=6, complementary=True))
    patterns = PatternSet(name="real", projector_px=1920, groups=groups, shift_sign=1)
    folder = recorded("slmaster_real_mono")
    bright = decoded(folder, numbered(*range(18)), patterns, DecodeSettings(faint_modulation=10.0))
    assert bright.valid.sum() == pytest.approx(214_654, rel=0.001)  # those above 10 grey levels
    found = decoded(folder, numbered(*range(18)), patterns)
    assert found.valid[bright.valid].all()
    both = found.valid[:, 1:] & found.valid[:, :-1]
    assert np.abs(np.diff(found.phase_rad, axis=1)[both]).max() < np.pi


@pytest.fixture(scope="module")
def statue() -> Path:
    return recorded("cfpe_statue")


def statue_phase(folder: Path, every: int, settings: DecodeSettings) -> PhaseMap:
    groups = tuple(PhaseShiftGroup(pitch_px=pitch, steps=12 // every) for pitch in (42, 45, 48))
    files = [f"06{start + n:02d}h.png" for start in (0, 12, 24) for n in range(0, 12, every)]
    return decoded(folder, files, PatternSet(name="statue", projector_px=1920, groups=groups, shift_sign=1), settings)


def test_four_steps_of_the_statue_agree_with_twelve(statue: Path) -> None:
    raw = DecodeSettings(vote_radius=0, residual_gate=0.5, edge_step_rad=1e6)
    truth = statue_phase(statue, 1, DecodeSettings())
    few = statue_phase(statue, 3, raw)
    mended = statue_phase(statue, 3, DecodeSettings())
    assert truth.valid.sum() == pytest.approx(282_846, rel=0.03)
    both = truth.valid & few.valid
    off = (few.phase_rad - truth.phase_rad)[both]
    wrong = np.abs(off) > np.pi
    assert off[~wrong].std() < 0.022
    assert wrong.mean() < 0.003
    both = truth.valid & mended.valid
    assert (np.abs(mended.phase_rad - truth.phase_rad)[both] > np.pi).mean() < wrong.mean() / 2


def test_the_wrong_shift_sign_of_the_statue_is_recognised(statue: Path) -> None:
    groups = tuple(PhaseShiftGroup(pitch_px=pitch, steps=12) for pitch in (42, 45, 48))
    with pytest.raises(DecodeError, match="beyond the projector") as raised:
        decoded(statue, [f"06{n:02d}h.png" for n in range(36)], PatternSet(name="statue", projector_px=1920, groups=groups, shift_sign=-1))
    assert "shift_sign" in raised.value.hint
