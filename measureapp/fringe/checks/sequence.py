"""Whether the images of one group can be its patterns in order: nothing blank, repeated, foreign or exchanged."""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, ImageArray
from measureapp.data.fringe import GrayCodeGroup
from measureapp.errors import DecodeError
from measureapp.fringe.phase_shift import shift_weights

LEAST_PIXELS, MOST_PIXELS = 200, 2000
LEAST_RANGE = 0.05  # by which a pixel with fringes changes, share of saturation
SAME_POWER = 0.06  # of the difference of two images over what it must be: they are one
ALWAYS = 0.99  # share of pixels in which an image is the brightest
SOMETIMES = 0.08  # share of pixels that counts for "also happens"
GRAY_STEP_PX = 6  # along a row, wider than the blurred border of two bits
LEAST_FLIPS = 60
UNSEEN = 1e-3  # of B²: an exchange that only turns the sense of the shift, as of two opposite steps of four
BUSY_CHANGES, BUSY_ROWS = 3, 3

Name = Callable[[int], str]
RECORD_AGAIN = "Record this group again, or correct the order of its files."


def clear_range(saturation: float) -> float:
    """Return by how many grey levels a pixel with fringes must change."""
    return LEAST_RANGE * saturation


def check_steps(images: ImageArray, saturation: float, name: Name, spread_elsewhere: bool) -> None:
    """Refuse a group of shifted sinusoids of which an image is blank, repeated, foreign or out of order.

    Parameters
    ----------
    images : (N, pixels) grey levels
    name : from the number of an image to its name in a message
    spread_elsewhere : other images show that the phase takes all values on these pixels

    Raises
    ------
    DecodeError
        Names the image.
    """
    _check_blank(images, saturation, name, spread_elsewhere)
    values = _lit_values(images, saturation)
    if values is None:
        return
    leading = _count_brightest(values)
    products = _products(values)
    if leading == len(images):
        _check_repeated(products, name)
    if len(images) >= 4 and leading == len(images):
        _check_order(products, name)
    if len(images) >= 5 and leading >= len(images) - 1:
        _check_foreign(products, name)


def phase_is_spread(images: ImageArray, saturation: float) -> bool:
    """Whether every image of a group is the brightest of its group somewhere, as it is when the phase takes all values."""
    values = _lit_values(images, saturation)
    return values is not None and _count_brightest(values) == len(values)


def _lit_values(images: ImageArray, saturation: float) -> FloatArray | None:
    """Return the unsaturated pixels with fringes, (N, pixels) float32; None where there are too few."""
    high, low = images.max(axis=0), images.min(axis=0)
    lit = np.flatnonzero((high - low > clear_range(saturation)) & (high < saturation))
    if len(lit) < LEAST_PIXELS:
        return None
    return images[:, lit[:: max(1, len(lit) // MOST_PIXELS)]].astype(np.float32)


def _count_brightest(values: FloatArray) -> int:
    """Return how many images are the brightest somewhere; equally bright ones lead together, so that a repeated one does as well."""
    share = (values >= values.max(axis=0)).mean(axis=1)
    return int((share > 0.25 / len(values)).sum())


def _check_blank(images: ImageArray, saturation: float, name: Name, spread_elsewhere: bool) -> None:
    """An image that is the brightest (or darkest) everywhere while the others are still the darkest (brightest) by turns.

    In a good group that is impossible: where one image always leads, the phase is confined to one step, and the other
    end is always one of the one or two images opposite. With three steps that is all of them, so another group must
    show that the phase is not confined.
    """
    count = len(images)
    if count < 4 and not spread_elsewhere:
        return
    for image in _always_extreme(images, saturation):
        others = np.delete(images, image, axis=0)
        high, low = others.max(axis=0), others.min(axis=0)
        lit = np.flatnonzero((high - low > clear_range(saturation)) & (high < saturation))
        if len(lit) < LEAST_PIXELS:
            continue
        lit = lit[:: max(1, len(lit) // MOST_PIXELS)]
        own, ahead, behind = images[image, lit], high[lit], low[lit]
        turns = 2 if count == 3 else 3
        slack = 0.05 * (ahead.astype(np.float32) - behind)
        white = (own >= ahead - slack).mean() > ALWAYS and _count_extreme(others[:, lit], behind) >= turns
        black = (own <= behind + slack).mean() > ALWAYS and _count_extreme(others[:, lit], ahead) >= turns
        if white or black:
            raise DecodeError(
                f"{name(image)} is {'brighter' if white else 'darker'} everywhere than the others of its group: it shows no fringes.",
                "Check that no image was lost or taken without the pattern; record this group again.",
            )


def _always_extreme(images: ImageArray, saturation: float) -> list[int]:
    """Return the images that may be the brightest or darkest everywhere: those that are nearly so where anything changes at all."""
    high, low = images.max(axis=0), images.min(axis=0)
    lit = np.flatnonzero(high - low > clear_range(saturation))
    if len(lit) < LEAST_PIXELS:
        return []
    lit = lit[:: max(1, len(lit) // MOST_PIXELS)]
    high, low, images = high[lit], low[lit], images[:, lit]
    slack = ((high - low) // 10).astype(images.dtype)
    leads, trails = images >= high - slack, images <= low + slack
    extreme = np.maximum(np.count_nonzero(leads, axis=1), np.count_nonzero(trails, axis=1)) > 0.9 * len(lit)
    return [int(image) for image in np.flatnonzero(extreme)]


def _count_extreme(images: ImageArray, extreme: ImageArray) -> int:
    """Return how many images are the extreme one in a good share of the pixels."""
    return int(((images == extreme).mean(axis=1) > SOMETIMES).sum())


def _check_repeated(products: FloatArray, name: Name) -> None:
    """Two images with hardly any difference although the phase takes all values: that must be 2B² sin²(δ/2) in the mean."""
    count = len(products)
    power = _power(products)
    for first, second in combinations(range(count), 2):
        expected = 2 * power * np.sin(np.pi * (second - first) / count) ** 2
        if _difference(products, first, second) < SAME_POWER * expected:
            raise DecodeError(
                f"{name(second)} shows the same pattern as {lower_first(name(first))}.",
                "Check that the projector stepped on; record again.",
            )


def check_between_groups(one: ImageArray, other: ImageArray, saturation: float, name_one: Name, name_other: Name) -> None:
    """Refuse a step of one pitch that was recorded in place of a step of another pitch.

    Images of two pitches are similar where a part is confined to a few columns, but then every pair of steps with the same
    distance is; here one pair is similar and the others are not.

    Parameters
    ----------
    one, other : (N, pixels) grey levels of two groups with the same number of steps
    """
    values = _lit_values(np.concatenate([one, other]), saturation)
    if values is None:
        return
    first, second = values[: len(one)], values[len(one) :]
    if _count_brightest(first) < len(one) or _count_brightest(second) < len(other) - 1:
        return
    products = _products(values)
    own = np.diag(products)
    difference = (own[: len(one), None] + own[None, len(one) :] - 2 * products[: len(one), len(one) :]) / _power(products)
    for i, j in zip(*np.nonzero(difference < SAME_POWER), strict=True):
        parallel = [difference[k, (k + j - i) % len(second)] for k in range(len(first)) if k != i]
        if np.median(parallel) > 5 * SAME_POWER:
            raise DecodeError(
                f"{name_other(int(j))} shows the same pattern as {lower_first(name_one(int(i)))}.",
                "Check that the projector stepped on; record again.",
            )


def _residual_maker(count: int) -> FloatArray:
    """Return the projection (N, N) onto what mean, sine and cosine do not explain."""
    sine, cosine = shift_weights(count, 1)
    basis = np.stack([np.full(count, count**-0.5), sine * (2 / count) ** 0.5, cosine * (2 / count) ** 0.5])
    return np.asarray(np.eye(count) - basis.T @ basis)


def _check_foreign(products: FloatArray, name: Name) -> None:
    """One image that alone makes the group disagree: without it the others fit sinusoids."""
    maker = _residual_maker(len(products))
    residual = maker @ products @ maker
    power, energy, freedom = _power(products), float(np.trace(residual)), float(maker[0, 0])
    gains = np.diag(residual) / freedom
    image = int(gains.argmax())
    if gains[image] > 0.25 * freedom * power and energy - gains[image] < 0.25 * energy:
        raise DecodeError(f"{name(image)} does not fit the other steps of its group.", RECORD_AGAIN)


def _check_order(products: FloatArray, name: Name) -> None:
    """Two images whose exchange makes the group agree: N ≥ 4 steps have N − 3 redundant sums, for four I₀ + I₂ = I₁ + I₃.

    The harmonics of a projector's response stay in the residual in any order, hence the comparison with what an exchange
    of ideal steps would leave.
    """
    count = len(products)
    maker = _residual_maker(count)
    energy, power = float(np.trace(maker @ products)), _power(products)
    best, pair = energy, (0, 0)
    for first, second in combinations(range(count), 2):
        order = np.arange(count)
        order[[first, second]] = second, first
        left = float(np.vdot(maker, products[np.ix_(order, order)]))
        between = 2 * float(maker[0, 0] - maker[first, second])
        ideal = between * 2 * power * np.sin(np.pi * (second - first) / count) ** 2
        if ideal > UNSEEN * power and energy - left > 0.5 * ideal and left < best:
            best, pair = left, (first, second)
    if best < 0.5 * energy and pair != (0, 0):
        raise DecodeError(
            f"The steps of the group are out of order: {lower_first(name(pair[0]))} and {lower_first(name(pair[1]))} appear to be exchanged.",
            RECORD_AGAIN,
        )


def _products(values: FloatArray) -> FloatArray:
    """Return the mean products of all pairs of images (N, N), without the mean of the images: all checks follow from them."""
    swing = values - values.mean(axis=0)
    return np.asarray(swing @ swing.T, float) / values.shape[1]


def _power(products: FloatArray) -> float:
    """Return the mean of B²."""
    return 2 * float(np.trace(products)) / len(products)


def _difference(products: FloatArray, first: int, second: int) -> float:
    """Return the mean square of the difference of two images."""
    return float(products[first, first] + products[second, second] - 2 * products[first, second])


def mean_and_swing(images: ImageArray, saturation: float) -> FloatArray:
    """Return mean and swing (twice the modulation) of a group, (2, pixels) float32; the swing is 0 without fringes."""
    values = images.astype(np.float32)
    high = values.max(axis=0)
    swing = np.sqrt(8.0 * values.var(axis=0))
    swing[(swing < clear_range(saturation)) | (high >= saturation)] = 0.0
    return np.asarray(np.stack([values.mean(axis=0), swing]))


def check_planes(images: ImageArray, group: GrayCodeGroup, reference: FloatArray, row_px: int, name: Name) -> None:
    """Refuse Gray code planes of which one shows the bits of another, or none although a coarser one changes back and forth.

    Two planes never change at the same column. Only planes finer than the first two are compared: those change so
    rarely on a part that an edge between two surfaces can imitate it. Planes of horizontal fringes change across the rows
    that are sampled and are left alone.

    Parameters
    ----------
    images : (planes, pixels) grey levels, whole rows one after the other
    reference : of `mean_and_swing`, (2, pixels)
    row_px : pixels in a row
    """
    if group.direction != "vertical" or row_px <= GRAY_STEP_PX:
        return
    bits, clear, lit = plane_bits(images, reference, row_px)
    _check_blank_planes(bits, clear, lit, name)
    for first, second in combinations(range(len(images)), 2):
        if second < 2:
            continue
        both = clear[first] & clear[second]
        if both.sum() < LEAST_PIXELS or (bits[first] == bits[second])[both].mean() < ALWAYS:
            continue
        if _flips(bits[first], both, lit) >= LEAST_FLIPS:
            raise DecodeError(
                f"{name(second)} shows the same Gray code plane as {lower_first(name(first))}.",
                "Check that the projector stepped on; record this group again.",
            )


def plane_bits(images: ImageArray, reference: FloatArray, row_px: int) -> tuple[BoolArray, BoolArray, BoolArray]:
    """Return the bits of planes, and where they are clear, (planes, rows, row_px) both; and which pixels have fringes, (rows, row_px)."""
    mean, swing = (part.reshape(-1, row_px) for part in reference)
    level = (images.reshape(len(images), -1, row_px) - mean) / np.where(swing > 0, swing, np.inf)
    return level > 0, np.abs(level) > 0.2, swing > 0


def _check_blank_planes(bits: BoolArray, clear: BoolArray, lit: BoolArray, name: Name) -> None:
    """Between two changes of a coarser plane every finer one changes too; three changes in a row leave no doubt."""
    busy = False
    for plane in range(len(bits)):
        share = bits[plane][clear[plane]].mean() if clear[plane].sum() >= LEAST_PIXELS else 0.5
        if busy and plane >= 2 and not 1 - ALWAYS <= share <= ALWAYS:
            raise DecodeError(
                f"{name(plane)} is {'black' if share < 0.5 else 'white'} everywhere where a coarser Gray code plane has stripes.",
                "Check that no image was lost or taken without the pattern; record this group again.",
            )
        changes = mark_changes(bits[plane], clear[plane], lit).sum(axis=1)
        busy = busy or int((changes >= BUSY_CHANGES * GRAY_STEP_PX).sum()) >= BUSY_ROWS


def _flips(bits: BoolArray, clear: BoolArray, lit: BoolArray) -> int:
    return int(mark_changes(bits, clear, lit).sum())


def mark_changes(bits: BoolArray, clear: BoolArray, lit: BoolArray) -> BoolArray:
    """Mark the changes of a bit along the rows between clear pixels with lit ones between them; each is found up to GRAY_STEP_PX times."""
    step = GRAY_STEP_PX
    changed = (bits[:, step:] != bits[:, :-step]) & clear[:, step:] & clear[:, :-step]
    for offset in range(1, step):
        changed &= lit[:, offset : offset - step]
    return np.asarray(changed)


def lower_first(text: str) -> str:
    """Return a name for the middle of a sentence."""
    return text[:1].lower() + text[1:]
