"""From a stack of fringe images to the absolute phase of every camera, with the reason of every hole."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray, in_bands, read_only
from measureapp.data.fringe import FringeStack
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.errors import DecodeError
from measureapp.fringe import kernels
from measureapp.fringe.absolute import AbsolutePhase, unwrap
from measureapp.fringe.exposure import WrappedPhases, synthesise
from measureapp.fringe.patterns import check_determines_phase
from measureapp.fringe.settings import DecodeSettings
from measureapp.progress import NoProgress, Progress

RANGE_MARGIN_PX = 2.0
LEAST_USABLE, MOST_OUTSIDE = 0.01, 0.8


def decode(stack: FringeStack, settings: DecodeSettings | None = None, progress: Progress | None = None) -> dict[str, PhaseMap]:
    """Decode the images of every camera.

    Exposures are combined, the wrapped phases of all pitches taken and unwrapped, doubtful orders mended by the window or
    marked, and the pitches averaged by inverse variance into the absolute phase of the finest one.

    Parameters
    ----------
    stack : images (exposures, patterns, height, width), uint8 or uint16, per camera
    settings : None for the defaults
    progress : told after each camera; where the task can be cancelled

    Raises
    ------
    DecodeError
        The pattern set does not determine the phase, or the images do not fit the set.
    """
    settings = settings or DecodeSettings()
    progress = progress or NoProgress()
    check_determines_phase(stack.patterns)
    _check_images(stack)
    maps = {}
    for number, camera in enumerate(stack.images):
        progress.report(number, len(stack.images), f"decoding {camera}")
        maps[camera] = decode_camera(stack, camera, settings)
    progress.report(len(stack.images), len(stack.images), "decoded")
    return maps


def decode_camera(stack: FringeStack, camera: str, settings: DecodeSettings) -> PhaseMap:
    """Decode the images of one camera; `decode` checks them first."""
    wrapped = synthesise(stack, camera, settings)
    shape = stack.images[camera].shape[2:]
    saturated = (wrapped.exposure_index < 0).reshape(shape)
    dark = (wrapped.modulation < settings.min_modulation_grey(stack.saturation)).reshape(shape)
    if settings.rule == "paper":
        dark |= wrapped.zero.reshape(shape)
    if not settings.joint:
        saturated |= (wrapped.used == 0).any(axis=0).reshape(shape)
    absolute = unwrap(stack, camera, wrapped, np.asarray(~(saturated | dark)), settings)
    state = _states(stack, camera, absolute, saturated, dark, settings)
    return _phase_map(stack, camera, wrapped, absolute, state)


def _check_images(stack: FringeStack) -> None:
    expected = (len(stack.exposures_us), stack.patterns.count)
    for camera, images in stack.images.items():
        if images.ndim != 4 or images.shape[:2] != expected:
            raise DecodeError(
                f"Camera {camera!r} has images of shape {images.shape}; the set needs {expected[0]} exposures of {expected[1]} images.",
                "Record every pattern at every exposure.",
            )
        if images.dtype not in (np.uint8, np.uint16):
            raise DecodeError(f"Camera {camera!r} has {images.dtype} images.", "Use 8- or 16-bit images without sign.")


def _states(
    stack: FringeStack, camera: str, absolute: AbsolutePhase, saturated: BoolArray, dark: BoolArray, settings: DecodeSettings
) -> IntArray:
    """Give every pixel the first reason that applies."""
    usable = ~(saturated | dark)
    column = (absolute.phase_rad - np.float32(absolute.origin_rad)) * np.float32(stack.patterns.finest_pitch_px / (2 * np.pi))
    outside = (column < -RANGE_MARGIN_PX) | (column > stack.patterns.projector_px + RANGE_MARGIN_PX)
    _check_within(outside, np.asarray(usable), camera)
    state = np.full(saturated.shape, PixelState.VALID, np.uint8)
    state[outside] = PixelState.OUT_OF_RANGE
    state[absolute.conflict] = PixelState.ORDER_CONFLICT
    state[dark | (absolute.sigma_rad > settings.max_sigma_rad)] = PixelState.WEAK_MODULATION
    state[saturated] = PixelState.SATURATED
    state[_edges(absolute.phase_rad, np.asarray(state == PixelState.VALID), settings.edge_step_rad)] = PixelState.EDGE
    return state


def _check_within(outside: BoolArray, usable: BoolArray, camera: str) -> None:
    """Raise DecodeError where nearly all phases lie beyond the projector: the images are not what the set says."""
    if usable.mean() > LEAST_USABLE and outside[usable].mean() > MOST_OUTSIDE:
        raise DecodeError(
            f"{outside[usable].mean():.0%} of the phases of camera {camera!r} lie beyond the projector.",
            "Check shift_sign, the order of the images, the pitches and projector_px.",
        )


def _edges(phase: FloatArray, valid: BoolArray, step_rad: float) -> BoolArray:
    edge = np.empty(valid.shape, np.bool_)
    in_bands(lambda start, stop: kernels.find_edges(phase, valid, np.float32(step_rad), start, stop, edge), len(valid))
    return edge


def _phase_map(stack: FringeStack, camera: str, wrapped: WrappedPhases, absolute: AbsolutePhase, state: IntArray) -> PhaseMap:
    valid = state == PixelState.VALID
    zero = np.float32(0)
    return PhaseMap(
        camera=camera,
        viewpoint_id=stack.viewpoint_id,
        phase_rad=read_only(np.where(valid, absolute.phase_rad, zero), np.float32),
        sigma_rad=read_only(np.where(valid, absolute.sigma_rad, zero), np.float32),
        modulation=read_only(np.where(valid, wrapped.modulation.reshape(state.shape), zero), np.float32),
        grey=read_only(wrapped.grey.reshape(state.shape), np.float32),
        state=read_only(state),
        exposure_index=read_only(wrapped.exposure_index.reshape(state.shape)),
        pitch_px=stack.patterns.finest_pitch_px,
        projector_px=stack.patterns.projector_px,
        valid_ratio_exposures=wrapped.valid_ratio_exposures,
        valid_ratio_composite=wrapped.valid_ratio_composite,
        details=_details(absolute, state),
        saturation=float(stack.saturation),
    )


def _details(absolute: AbsolutePhase, state: IntArray) -> dict[str, float]:
    counts = np.bincount(state.ravel(), minlength=len(PixelState))
    return {
        "decoded_ratio": float(counts[PixelState.VALID] / state.size),
        "order_conflicts": float(counts[PixelState.ORDER_CONFLICT]),
        "orders_repaired": float(absolute.repaired),
        "origin_rad": absolute.origin_rad,
        "order_amplification": absolute.amplification,
        **{name.name.lower(): float(counts[name]) for name in PixelState},
    }
