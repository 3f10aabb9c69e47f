"""Layout of flags in the left and right margins of a picture, ordered by angle, without crossing lines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

MOST_BOXES = 24
GAP_PX = 6.0
PASSES = 60
Box = tuple[float, float, float, float]  # left, top, width, height


@dataclass(frozen=True)
class FlagPlaces:
    """Boxes of the flags that are shown, by their index, and the indices of those that are collapsed."""

    boxes: dict[int, Box]
    collapsed: tuple[int, ...]


def lay_out_flags(
    anchors_px: np.ndarray,
    sizes_px: Sequence[tuple[float, float]],
    free: Box,
    pinned: dict[int, tuple[float, float]] | None = None,
    corner_px: float = 0.0,
) -> FlagPlaces:
    """Place boxes at the left and right of a free rectangle.

    Lines to the left come from anchors left of those to the right, so they cannot cross; within a side, boxes whose lines
    cross are exchanged, which shortens both lines and therefore ends.

    Parameters
    ----------
    anchors_px : (F, 2), from the top left corner; the first flags are the most important ones
    sizes_px : width and height of each box
    free : left, top, width and height of the room for boxes
    pinned : middle of the boxes that were moved by hand, by index; the others do not move for them
    corner_px : height below the left column that something else occupies
    """
    held = {index: _around(middle, sizes_px[index]) for index, middle in (pinned or {}).items()}
    loose = [index for index in range(len(sizes_px)) if index not in held][: max(0, MOST_BOXES - len(held))]
    left, right = _sides(anchors_px, sizes_px, free, loose, corner_px)
    boxes = dict(held)
    for side, indices in (("left", left), ("right", right)):
        room = (free[0], free[1], free[2], free[3] - corner_px) if side == "left" else free
        boxes |= _stack(anchors_px, sizes_px, room, indices, side == "left")
    shown = set(boxes)
    return FlagPlaces(boxes, tuple(index for index in range(len(sizes_px)) if index not in shown))


def _around(middle: tuple[float, float], size: tuple[float, float]) -> Box:
    return middle[0] - size[0] / 2.0, middle[1] - size[1] / 2.0, size[0], size[1]


def _sides(
    anchors: np.ndarray, sizes: Sequence[tuple[float, float]], free: Box, loose: list[int], corner_px: float
) -> tuple[list[int], list[int]]:
    """Divide the flags by a vertical line, near the middle, so that both columns have room for their boxes; the last ones are dropped."""
    tallest = max((sizes[index][1] for index in loose), default=1.0) + GAP_PX
    on_right, on_left = (max(1, int((room + GAP_PX) / tallest)) for room in (free[3], free[3] - corner_px))
    kept = sorted(loose[: on_left + on_right], key=lambda index: float(anchors[index, 0]))
    middle = free[0] + free[2] / 2.0
    wanted = sum(float(anchors[index, 0]) < middle for index in kept)
    at = min(max(wanted, len(kept) - on_right), on_left)
    return kept[:at], kept[at:]


def _stack(anchors: np.ndarray, sizes: Sequence[tuple[float, float]], free: Box, indices: list[int], on_left: bool) -> dict[int, Box]:
    """Stack boxes at one side: ordered by height, relaxed until none overlap, exchanged until no lines cross."""
    if not indices:
        return {}
    order = sorted(indices, key=lambda index: float(anchors[index, 1]))
    for _ in range(PASSES):
        tops = _relax([float(anchors[index, 1]) - sizes[index][1] / 2.0 for index in order], [sizes[index][1] for index in order], free)
        ends = [_join(anchors, sizes, free, index, top, on_left) for index, top in zip(order, tops, strict=True)]
        crossing = _first_crossing(ends)
        if crossing is None:
            break
        first, second = crossing
        order[first], order[second] = order[second], order[first]
    return {
        index: (free[0] if on_left else free[0] + free[2] - sizes[index][0], top, *sizes[index])
        for index, top in zip(order, tops, strict=True)
    }


def _relax(wanted: list[float], heights: list[float], free: Box) -> list[float]:
    """Return tops near the wanted ones, in this order and without overlap: pools of boxes at the mean of what they want."""
    pools: list[list[float]] = []  # sum of wanted tops of the first box, number, height
    for top, height in zip(wanted, heights, strict=True):
        pools.append([top, 1.0, height + GAP_PX])
        while len(pools) > 1 and pools[-2][0] / pools[-2][1] + pools[-2][2] > pools[-1][0] / pools[-1][1]:
            last = pools.pop()
            pools[-1][0] += last[0] - last[1] * pools[-1][2]
            pools[-1][1] += last[1]
            pools[-1][2] += last[2]
    tops: list[float] = []
    place = 0
    for total, count, _height in pools:
        top = total / count
        for _ in range(int(count)):
            tops.append(top)
            top += heights[place] + GAP_PX
            place += 1
    return _inside(tops, heights, free)


def _inside(tops: list[float], heights: list[float], free: Box) -> list[float]:
    """Push boxes into the free room from both ends."""
    low = free[1]
    for place, top in enumerate(tops):
        tops[place] = max(top, low)
        low = tops[place] + heights[place] + GAP_PX
    high = free[1] + free[3]
    for place in reversed(range(len(tops))):
        tops[place] = min(tops[place], high - heights[place])
        high = tops[place] - GAP_PX
    return tops


def _join(
    anchors: np.ndarray, sizes: Sequence[tuple[float, float]], free: Box, index: int, top: float, on_left: bool
) -> tuple[float, float, float, float]:
    width, height = sizes[index]
    x = free[0] + width if on_left else free[0] + free[2] - width
    return x, top + height / 2.0, float(anchors[index, 0]), float(anchors[index, 1])


def _first_crossing(lines: list[tuple[float, float, float, float]]) -> tuple[int, int] | None:
    for first, one in enumerate(lines):
        for second in range(first + 1, len(lines)):
            if lines_cross(one, lines[second]):
                return first, second
    return None


def lines_cross(one: tuple[float, float, float, float], other: tuple[float, float, float, float]) -> bool:
    """Whether two line segments (x, y, x, y) cross within both."""
    ax, ay, bx, by = one
    cx, cy, dx, dy = other
    first = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    second = (bx - ax) * (dy - ay) - (by - ay) * (dx - ax)
    third = (dx - cx) * (ay - cy) - (dy - cy) * (ax - cx)
    fourth = (dx - cx) * (by - cy) - (dy - cy) * (bx - cx)
    return first * second < 0 and third * fourth < 0


def leader_end(box: Box, anchor: tuple[float, float]) -> tuple[float, float]:
    """Return the point of a box's edge from which the line to its anchor begins."""
    left, top, width, height = box
    x, y = anchor
    if left <= x <= left + width:
        return x, top if y < top else top + height
    return left if x < left else left + width, top + height / 2.0
