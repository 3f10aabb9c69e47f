"""Temperatures and materials as users state them."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.data.part_temperature import part_temperature, read_material, read_temperature


@pytest.mark.parametrize(
    ("text", "expected"), [("23±0.5", (23, 0.5)), ("23", (23, 1)), ("22,5 +- 0,3 °C", (22.5, 0.3)), ("−5 ± 2 C", (-5, 2))]
)
def test_temperatures_are_read(text: str, expected: tuple[float, float]) -> None:
    assert read_temperature(text) == pytest.approx(expected)


@pytest.mark.parametrize("text", ["", "warm", "±1", "296 ± 1", "20 ± -1", "20 ± 30", "nan"])
def test_absurd_temperatures_are_refused(text: str) -> None:
    with pytest.raises(ValueError, match=r".+"):
        read_temperature(text)


def test_materials_are_read_by_name_or_by_their_expansion() -> None:
    assert read_material(" Steel ") == pytest.approx((11.5e-6, 0.575e-6))
    assert read_material("24 ± 2 ppm/K") == pytest.approx((24e-6, 1e-6))
    with pytest.raises(ValueError, match="choose one of steel"):
        read_material("unobtainium")
    with pytest.raises(ValueError, match="not between"):
        read_material("2000 ppm")


def test_lengths_shrink_to_20_degrees_and_say_so() -> None:
    warm = part_temperature("23±0.5", "aluminium")
    assert warm is not None
    assert 280 * (1 / warm.factor - 1) == pytest.approx(280 * 23.5e-6 * 3)
    assert warm.sigma == pytest.approx(np.hypot(23.5e-6 * 0.25, 3 * 0.05 * 23.5e-6))
    assert warm.words == "measured at 23 ± 0.5 °C, corrected to 20 °C with 23.5 ppm/K"
    bare = part_temperature("23±1")
    assert bare is not None and (bare.factor, bare.sigma, bare.words) == (1.0, 0.0, "at 23 ± 1 °C, not corrected")
    assert part_temperature("") is None
