"""False-colour pictures of the pixel states: reasons, exposures and signal-to-noise ratio, with a legend."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil
from pathlib import Path
from typing import Literal

import cv2
import numpy as np

from measureapp.arrays import FloatArray, ImageArray, IntArray
from measureapp.data.phase import PhaseMap
from measureapp.errors import StorageError
from measureapp.pipeline.why import REASONS, SEEN_BY_ANOTHER, ExplainedView
from measureapp.project.atomic import replacing

Kind = Literal["reasons", "exposure", "snr"]
KINDS: tuple[Kind, ...] = ("reasons", "exposure", "snr")
Colour = tuple[int, int, int]  # red, green, blue

# After Okabe & Ito and Tol: stages differ in hue (light: blue and yellow, match: red, clean: green and violet), reasons of a stage in
# lightness, which colour-blind people can distinguish as well. None: the grey image is shown.
REASON_COLOURS: dict[str, Colour | None] = {
    "point": None,
    "saturated": (240, 228, 66),
    "weak modulation": (86, 180, 233),
    "shadow": (0, 68, 136),
    "order conflict": (204, 51, 17),
    "out of range": (136, 34, 85),
    "edge": (230, 159, 0),
    "blooming": (255, 247, 188),
    "unmatched": (204, 121, 167),
    "ambiguous": (170, 51, 119),
    "contradicted": (255, 102, 85),
    "uncertain": (0, 158, 115),
    "flying": (148, 203, 190),
    "outlier": (68, 101, 48),
    "grazing": (153, 136, 221),
    "partner grazing": (204, 196, 240),
    "island": (181, 168, 0),
    "seen by another": (110, 170, 172),
    "rim": (205, 235, 139),
}
# from long (blue) to short (yellow), increasing in lightness; interpolated in between
EXPOSURE_ENDS: tuple[Colour, ...] = ((44, 90, 168), (90, 140, 190), (150, 170, 160), (205, 185, 110), (254, 232, 56))
BEHIND = 0.45  # brightness of the grey image where there is no colour
THROUGH = 0.55  # weight of the grey image under the colours of exposures and of surfaces measured by another camera
SNR_STEPS = 256
SNR_TOP_PERCENT = 99.0
LINE_PX, MARGIN_PX = 28, 12


@dataclass(frozen=True, slots=True)
class LegendEntry:
    """Meaning of a colour."""

    words: str
    colour: Colour
    share: float | None = None  # of the pixels


@dataclass(frozen=True, slots=True, eq=False)
class Picture:
    """A false-colour picture of one camera with its legend."""

    pixels: ImageArray  # (H, W, 3) uint8, red green blue
    legend: tuple[LegendEntry, ...]


def grey_picture(phase_map: PhaseMap) -> ImageArray:
    """Return the camera's image without fringes, (H, W) uint8, with dark areas brightened."""
    grey = phase_map.grey.astype(np.float32)
    top = max(1.0, float(np.percentile(grey[::4, ::4], 99.5)))
    return np.asarray(np.sqrt(np.clip(grey / top, 0.0, 1.0)) * 255.0).astype(np.uint8)


def picture(view: ExplainedView, camera: str, kind: Kind) -> Picture:
    """Colour the image of a camera by reason, exposure or signal-to-noise ratio. Raises ReconstructError for another camera."""
    codes = view.codes(camera)
    phase_map = view.phase_maps[camera]
    grey = np.repeat(grey_picture(phase_map)[..., None], 3, axis=2)
    if kind == "reasons":
        return _reasons(codes, grey)
    return _exposures(phase_map, view.exposures_us, grey) if kind == "exposure" else _signal(phase_map, (grey * BEHIND).astype(np.uint8))


def share_words(share: float) -> str:
    """Format a fraction in per cent; a positive one is never shown as zero."""
    return "< 0.01 %" if 0 < share < 0.00005 else f"{share * 100:.2f} %"


def with_legends(pictures: dict[str, Picture]) -> ImageArray:
    """Compose the pictures of several cameras side by side, each with its name and legend below, (H, W, 3) uint8."""
    tallest = max(one.pixels.shape[0] for one in pictures.values())
    lines = 1 + max(len(one.legend) for one in pictures.values())
    panels = []
    for name, one in pictures.items():
        height, width = one.pixels.shape[:2]
        scale = max(1.0, width / 1000.0)
        below = ceil((lines * LINE_PX + 2 * MARGIN_PX) * scale)
        panel = np.full((tallest + below, max(width, 320), 3), 255, np.uint8)
        panel[:height, :width] = one.pixels
        _write_legend(panel, name, one.legend, tallest, scale)
        panels.append(panel)
    bottom = max(panel.shape[0] for panel in panels)
    return np.hstack([np.pad(panel, ((0, bottom - panel.shape[0]), (0, 0), (0, 0)), constant_values=255) for panel in panels])


def _reasons(codes: IntArray, grey: ImageArray) -> Picture:
    colours = np.array([REASON_COLOURS[reason] or (0, 0, 0) for reason in REASONS], np.uint8)
    seen = np.array([REASON_COLOURS[reason] is None for reason in REASONS])
    pixels = np.where(seen[codes][..., None], grey, colours[codes])
    another = codes == REASONS.index(SEEN_BY_ANOTHER)
    pixels[another] = _through(pixels[another], grey[another])
    counts = np.bincount(codes.ravel(), minlength=len(REASONS)) / codes.size
    legend = [
        LegendEntry(reason, REASON_COLOURS[reason] or (128, 128, 128), float(counts[place]))
        for place, reason in enumerate(REASONS)
        if counts[place]
    ]
    return Picture(pixels, tuple(sorted(legend, key=lambda entry: -(entry.share or 0.0))))


def _exposures(phase_map: PhaseMap, exposures_us: tuple[int, ...], grey: ImageArray) -> Picture:
    places = np.linspace(0.0, 1.0, len(exposures_us)) if len(exposures_us) > 1 else np.array([0.5])
    ends = np.linspace(0.0, 1.0, len(EXPOSURE_ENDS))
    colours = np.stack([np.interp(places, ends, [end[band] for end in EXPOSURE_ENDS]) for band in range(3)], axis=1).astype(np.uint8)
    taken = phase_map.exposure_index
    pixels = np.where((taken >= 0)[..., None], _through(colours[np.maximum(taken, 0)], grey), (grey * BEHIND).astype(np.uint8))
    legend = [
        LegendEntry(f"{exposure / 1000:g} ms", _plain(colours[place]), float(np.mean(taken == place)))
        for place, exposure in enumerate(exposures_us)
    ]
    return Picture(pixels, (*legend, LegendEntry("none", (70, 70, 70), float(np.mean(taken < 0)))))


def _signal(phase_map: PhaseMap, behind: ImageArray) -> Picture:
    valid, snr = phase_map.valid, phase_map.snr
    top = max(1.0, float(np.percentile(snr[valid], SNR_TOP_PERCENT))) if valid.any() else 1.0
    colours = signal_colours()
    steps = np.clip(snr / top * (SNR_STEPS - 1), 0, SNR_STEPS - 1).astype(np.int32)
    pixels = np.where(valid[..., None], colours[steps], behind)
    legend = [LegendEntry(f"{share * top:.0f}", _plain(colours[round(share * (SNR_STEPS - 1))])) for share in (0.0, 0.25, 0.5, 0.75, 1.0)]
    return Picture(pixels, (*legend, LegendEntry("no phase", (70, 70, 70), float(np.mean(~valid)))))


def signal_colours() -> ImageArray:
    """Return the colour scale of the signal-to-noise ratio, (256, 3) uint8, from low to high, perceptually uniform."""
    ramp = cv2.applyColorMap(np.arange(SNR_STEPS, dtype=np.uint8)[:, None], cv2.COLORMAP_VIRIDIS)
    return np.asarray(ramp[:, 0, ::-1])


def _through(colours: ImageArray, grey: ImageArray) -> ImageArray:
    """Modulate colours by the grey image, so that the part stays visible."""
    return np.asarray(colours * (1.0 - THROUGH + THROUGH / 255.0 * grey)).astype(np.uint8)


def _plain(colour: FloatArray | ImageArray) -> Colour:
    red, green, blue = (int(value) for value in colour)
    return red, green, blue


def _write_legend(panel: ImageArray, name: str, legend: tuple[LegendEntry, ...], top: int, scale: float) -> None:
    """Draw camera name and legend below a picture, in place."""
    thickness = max(1, round(scale))
    line, margin, box = LINE_PX * scale, round(MARGIN_PX * scale), round(18 * scale)
    font, size = cv2.FONT_HERSHEY_SIMPLEX, 0.55 * scale
    cv2.putText(panel, name, (margin, round(top + line)), font, size, (0, 0, 0), thickness + 1, cv2.LINE_AA)
    for place, entry in enumerate(legend):
        base = round(top + (place + 2) * line)
        cv2.rectangle(panel, (margin, base - box), (margin + box, base), entry.colour, cv2.FILLED)
        cv2.rectangle(panel, (margin, base - box), (margin + box, base), (90, 90, 90), thickness)
        share = "" if entry.share is None else f"  {share_words(entry.share)}"
        cv2.putText(panel, entry.words + share, (margin + 2 * box, base - box // 6), font, size, (0, 0, 0), thickness, cv2.LINE_AA)


def write_picture(path: Path, pixels: ImageArray) -> None:
    """Write a picture (H, W, 3) as PNG. Raises StorageError."""
    made, encoded = cv2.imencode(".png", pixels[..., ::-1])
    if not made:
        raise StorageError(
            f"{path} cannot be written: {pixels.shape[1]} × {pixels.shape[0]} px is too large for PNG.", "Draw one camera only: --camera."
        )
    with replacing(path) as temporary:
        temporary.write_bytes(encoded.tobytes())
