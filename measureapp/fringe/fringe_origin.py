"""Where the fringes start: the phase of projector column 0, found from a sample of the image."""

from __future__ import annotations

from collections.abc import Callable
from math import sqrt

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.phase import PixelState
from measureapp.errors import DecodeError
from measureapp.fringe.kernels.structures import CHUNK, RESIDUAL_SCALE, DecodeModel, ImageLayout, PixelMaps
from measureapp.fringe.unwrap import HeterodynePlan

LEAST_TRANSITIONS = 200
JOINT = 9  # px, odd: over which the surface is taken as smooth
JUMP_CYCLES = 0.01  # about the jump of the wrapped phase: above the rounding of eight bits, a small share of the pixels
NEIGHBOURS = 2  # px: a pixel between them may be on the jump
ORIGINS = (0.0, -0.5)  # cycles: the patterns start with a crest, or with a trough
SAMPLED_CHUNKS = (8, 128, 2048)  # the fewest are enough unless the part fills little of the image
LEAST_SAMPLED = 1000  # usable pixels
CLEAR = 6.0  # standard deviations by which the rounding residuals of both origins should differ: those of faint fringes hardly do
GOLDEN_RATIO = (1 + sqrt(5)) / 2  # multiples of it, without their whole part, fill an interval evenly however many they are
USABLE = np.isin(np.arange(len(PixelState)), (PixelState.VALID, PixelState.ORDER_CONFLICT, PixelState.OUT_OF_RANGE))  # by state

Solve = Callable[[DecodeModel, ImageLayout], PixelMaps]  # returns the maps of a sample: whole chunks, one after the other
Sample = Callable[[list[tuple[int, int]]], Solve]  # of chunks of the image


def find_origin(model: DecodeModel, chain: HeterodynePlan | None, layout: ImageLayout, pixels: int, sample: Sample) -> DecodeModel:
    """Return the model with the origin of the phase, determined from as many chunks of the image as necessary.

    Raises
    ------
    DecodeError
        The phase decreases where the Gray code increases: the shift sign of the images is wrong.
    """
    for number in SAMPLED_CHUNKS:
        solve = sample(sampled_chunks(pixels, number))
        origin, is_determined = _gray_origin(model, layout, solve) if chain is None else _chain_origin(model, chain, layout, solve)
        if is_determined:
            break
    return model._replace(origin=np.float32(origin))


def sampled_chunks(pixels: int, number: int) -> list[tuple[int, int]]:
    """Return first pixel and end of about so many chunks all over the image.

    Chunks at equal distances could lie in one column of the image.
    """
    chunks = -(-pixels // CHUNK)
    chosen = np.unique((np.arange(number) * GOLDEN_RATIO % 1.0 * chunks).astype(int)) if number < chunks else np.arange(chunks)
    return [(begin, min(begin + CHUNK, pixels)) for begin in (chosen * CHUNK).tolist()]


def _chain_origin(model: DecodeModel, chain: HeterodynePlan, layout: ImageLayout, solve: Solve) -> tuple[float, bool]:
    """Return the origin with the smaller rounding residuals, and whether there were enough usable pixels for it.

    The residuals of faint fringes are spread over the whole period; those of a few pixels of a row together are less so.
    """
    unwrapping = model.unwrapping._replace(watched=len(chain.combinations) - 1)
    solved = [solve(_keep_conflicts(model)._replace(origin=np.float32(origin), unwrapping=unwrapping), layout) for origin in ORIGINS]
    usable = [USABLE[maps.state] for maps in solved]
    single = [maps.residual[mask] / RESIDUAL_SCALE for maps, mask in zip(solved, usable, strict=True)]
    joint = [_joint_residuals(maps, mask) for maps, mask in zip(solved, usable, strict=True)]
    lead, also = _lead_of_first(*single), _lead_of_first(*joint)
    lead = max(lead, also, key=abs)
    return ORIGINS[int(lead < 0)], min(len(single[0]), len(single[1])) >= LEAST_SAMPLED and abs(lead) >= CLEAR


def _joint_residuals(maps: PixelMaps, usable: BoolArray) -> FloatArray:
    """Return the rounding residuals in cycles of windows of JOINT pixels.

    Phase and residual of a pixel add up to the phase that the coarser one predicts, whose noise is that of the residual: its mean over
    the window is compared with the phase in the middle.
    """
    phase = maps.phase / np.float32(2 * np.pi)
    predicted, known = np.where(usable, phase + maps.residual / np.float32(RESIDUAL_SCALE), 0.0), usable.astype(np.int64)
    total, count = (np.concatenate([[0.0], np.cumsum(values, dtype=float)]) for values in (predicted, known))
    begin = np.arange(0, len(phase) - JOINT + 1, JOINT)
    begin = begin[count[begin + JOINT] - count[begin] == JOINT]
    off = (total[begin + JOINT] - total[begin]) / JOINT - phase[begin + JOINT // 2]
    return np.asarray(off - np.rint(off))


def _lead_of_first(first: FloatArray, second: FloatArray) -> float:
    """Return by how many standard deviations the first residuals are closer to zero than the second; 0 where there are too few."""
    if min(len(first), len(second)) < 2:
        return 0.0
    sizes = [np.abs(residuals) for residuals in (first, second)]
    variance = sum(float(size.var()) / size.size for size in sizes)
    return float(sizes[1].mean() - sizes[0].mean()) / sqrt(max(variance, 1e-12))


def _gray_origin(model: DecodeModel, layout: ImageLayout, solve: Solve) -> tuple[float, bool]:
    """Return the origin at which the Gray code counts on, and whether enough periods end in the sample; raises DecodeError."""
    planes = layout.planes[:-1] if model.unwrapping.complementary else layout.planes
    plain = model.unwrapping._replace(complementary=False)
    maps = solve(_keep_conflicts(model)._replace(unwrapping=plain), layout._replace(planes=planes))
    chunks = range(0, len(maps.state), CHUNK)
    phases, usable = ([every[begin : begin + CHUNK] for begin in chunks] for every in (maps.phase, USABLE[maps.state]))
    origin = _count_on_phase(phases, usable)
    return origin or 0.0, origin is not None


def _keep_conflicts(model: DecodeModel) -> DecodeModel:
    return model._replace(limits=model.limits._replace(keep_conflicts=True))


def _count_on_phase(phases: list[FloatArray], usable: list[BoolArray]) -> float | None:
    """Return the phase in cycles at which the Gray code counts on, None where too few periods end.

    Raises DecodeError when phase and code run against each other.

    Where the wrapped phase jumps, rounding alone decides on which side of the jump a pixel lies, and so its period: neighbours are
    compared across such pixels, never with them. Borders that fall exactly on pixels would otherwise all be misread.
    """
    parts = [_turns(phase[mask] / np.float32(2 * np.pi), np.flatnonzero(mask)) for phase, mask in zip(phases, usable, strict=True)]
    before, step, count_on = (np.concatenate(column) for column in zip(*parts, strict=True))
    smooth = np.abs(step) < 0.25
    border = smooth & (np.abs(count_on) == 1)
    if int(border.sum()) < LEAST_TRANSITIONS:
        return None
    if float(np.sign(count_on[border]).mean()) * float(np.sign(step[smooth]).mean()) < -0.25:
        raise DecodeError(
            "The phase decreases where the Gray code increases.",
            "Change the sign of `shift_sign`, or reverse the order of the shifted images.",
        )
    return 0.0 if float(np.cos(2 * np.pi * before[border]).mean()) >= 0 else -0.5


def _turns(cycles: FloatArray, place: IntArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return for neighbouring pixels the share of a period before the step, the step of it, and by how many periods the code counts on.

    Parameters
    ----------
    cycles : (n,) phase in cycles of usable pixels
    place : (n,) index of these pixels in a row of pixels
    """
    sure = np.abs(cycles - np.rint(cycles)) > JUMP_CYCLES
    cycles, place = cycles[sure], place[sure]
    near = np.diff(place) <= NEIGHBOURS
    period = np.floor(cycles)
    share = cycles - period
    turn = np.diff(share)
    return share[:-1][near], (turn - np.rint(turn))[near], np.diff(period)[near]
