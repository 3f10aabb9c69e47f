"""Run chart of one dimension as SVG: values in order of measurement, limits, mean, and moving ranges below."""

from __future__ import annotations

import numpy as np

from measureapp.report.series.capability import Trend

WIDTH, HEIGHT, RANGES = 640, 150, 44
LEFT, RIGHT = 6, 6
INK, QUIET, LIMIT, POINT, BEYOND = "#1F2933", "#9AA5B1", "#D1495B", "#0F8B8D", "#D1495B"


def run_chart(trend: Trend) -> str:
    """Return the chart; gaps where a part was not measured."""
    there = np.flatnonzero(np.isfinite(trend.values))
    if not len(there):
        return _svg([])
    shown = [*trend.values[there], *(limit for limit in trend.limits if limit is not None)]
    low, high = min(shown), max(shown)
    margin = 0.08 * (high - low) or 1e-3
    low, high = low - margin, high + margin
    across = LEFT + (WIDTH - LEFT - RIGHT) * (np.arange(len(trend.values)) + 0.5) / len(trend.values)

    def down(value: float) -> float:
        return 4 + (HEIGHT - 8) * (high - value) / (high - low)

    parts = [_level(down(limit), LIMIT, 1.4, "") for limit in trend.limits if limit is not None]
    if trend.mean is not None:
        parts.append(_level(down(trend.mean), QUIET, 1.0, "5 4"))
    points = " ".join(f"{across[k]:.1f},{down(float(trend.values[k])):.1f}" for k in there)
    parts.append(f'<polyline points="{points}" fill="none" stroke="{QUIET}" stroke-width="1"/>')
    lower, upper = trend.limits
    for k in there:
        value = float(trend.values[k])
        beyond = (lower is not None and value < lower) or (upper is not None and value > upper)
        parts.append(f'<circle cx="{across[k]:.1f}" cy="{down(value):.1f}" r="2.6" fill="{BEYOND if beyond else POINT}"/>')
    return _svg([*parts, *_moving_ranges(trend, there, across)])


def _moving_ranges(trend: Trend, there: np.typing.NDArray[np.intp], across: np.typing.NDArray[np.float64]) -> list[str]:
    ranges = np.abs(np.diff(trend.values[there]))
    top = float(ranges.max(initial=0.0)) or 1.0
    width = max(1.0, 0.5 * (WIDTH - LEFT - RIGHT) / len(trend.values))
    return [
        f'<rect x="{across[k] - width / 2:.1f}" y="{HEIGHT + RANGES - height:.1f}" width="{width:.1f}" height="{height:.1f}" fill="{QUIET}"/>'
        for k, height in zip(there[1:], (RANGES - 6) * ranges / top, strict=True)
    ]


def _level(y: float, colour: str, width: float, dash: str) -> str:
    dashes = f' stroke-dasharray="{dash}"' if dash else ""
    return f'<line x1="0" y1="{y:.1f}" x2="{WIDTH}" y2="{y:.1f}" stroke="{colour}" stroke-width="{width}"{dashes}/>'


def _svg(parts: list[str]) -> str:
    size = f'width="{WIDTH}" height="{HEIGHT + RANGES}" viewBox="0 0 {WIDTH} {HEIGHT + RANGES}"'
    base = f'<line x1="0" y1="{HEIGHT + RANGES - 0.5}" x2="{WIDTH}" y2="{HEIGHT + RANGES - 0.5}" stroke="{INK}" stroke-width="0.6"/>'
    return f'<svg xmlns="http://www.w3.org/2000/svg" {size}><rect width="100%" height="100%" fill="#fff"/>{"".join(parts)}{base}</svg>'
