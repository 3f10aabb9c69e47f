"""The chip's noise is the camera model's: shot noise, read noise, quantisation, saturation."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.simulate.sensor import SensorSettings, read_out

SHAPE = (300, 400)


@pytest.mark.parametrize("level", [5.3, 40.7, 127.2, 200.4])
def test_a_uniform_image_scatters_as_the_noise_model_says(level: float) -> None:
    image = read_out(np.full(SHAPE, level / 255.0, np.float32), 8, SensorSettings(), key=1).astype(float)
    electrons_per_level = 6000.0 / 255.0
    variance = level / electrons_per_level + (7.0 / electrons_per_level) ** 2 + 1.0 / 12.0
    count = image.size
    assert image.mean() == pytest.approx(level, abs=5 * np.sqrt(variance / count))
    assert image.var() == pytest.approx(variance, rel=5 * np.sqrt(2.0 / count) + 0.01)


def test_neighbouring_pixels_and_images_are_independent() -> None:
    mean = np.full(SHAPE, 0.5, np.float32)
    first, second = (read_out(mean, 8, SensorSettings(), key=key).astype(float) - 127.5 for key in (8, 9))
    bound = 5.0 * first.var() / np.sqrt(first.size)
    for shift in range(1, 5):
        assert abs(np.mean(first[:, shift:] * first[:, :-shift])) < bound
    assert abs(np.mean(first * second)) < bound


def test_the_same_key_gives_the_same_image_and_another_key_another() -> None:
    mean = np.full(SHAPE, 0.5, np.float32)
    first, again, other = (read_out(mean, 8, SensorSettings(), key=key) for key in (8, 8, 9))
    np.testing.assert_array_equal(first, again)
    assert np.mean(first != other) > 0.5


def test_light_beyond_full_scale_saturates() -> None:
    image = read_out(np.full(SHAPE, 1.3, np.float32), 8, SensorSettings(), key=1)
    assert image.min() == 255


@pytest.mark.parametrize(("bit_depth", "dtype"), [(8, np.uint8), (12, np.uint16)])
def test_without_noise_the_mean_is_rounded(bit_depth: int, dtype: type) -> None:
    image = read_out(np.full(SHAPE, 0.31, np.float32), bit_depth, SensorSettings(noise=False), key=1)
    assert image.dtype == dtype
    assert np.unique(image).tolist() == [round(0.31 * (2**bit_depth - 1))]
