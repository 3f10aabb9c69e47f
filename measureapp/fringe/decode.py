"""From a stack of fringe images to the absolute phase of every camera, with the reason of every hole."""

from __future__ import annotations

from measureapp.compiled.buffer_pool import BufferPool
from measureapp.data.fringe import FringeStack
from measureapp.data.phase import PhaseMap
from measureapp.fringe.checks.stack import check_shapes
from measureapp.fringe.patterns.draw import check_determines_phase
from measureapp.fringe.settings import DecodeSettings
from measureapp.fringe.streaming import join_directions, make_decoders
from measureapp.progress import NoProgress, Progress


def decode(
    stack: FringeStack, settings: DecodeSettings | None = None, progress: Progress | None = None, memory: BufferPool | None = None
) -> dict[str, PhaseMap]:
    """Decode the images of every camera.

    Exposures are combined within 2 % of the least phase noise (4 % for brackets of five octaves and more, `exposure_weights`), the
    wrapped phases of all pitches computed and unwrapped, doubtful orders repaired by the vote of their neighbourhood or marked, and the pitches averaged by
    inverse variance into the absolute phase of the finest one. Of a set with fringes of both directions the vertical ones give the
    map, with that of the horizontal ones in `PhaseMap.orthogonal`.

    Parameters
    ----------
    stack : images (exposures, patterns, height, width), uint8 or uint16, per camera
    settings : None for the defaults
    progress : reported after each camera; where the task can be cancelled
    memory : pool of the maps of earlier viewpoints; None: a new one

    Raises
    ------
    DecodeError
        The pattern set does not determine the phase, or the images do not fit the set.
    """
    settings = settings or DecodeSettings()
    progress = progress or NoProgress()
    check_determines_phase(stack.patterns)
    check_shapes(stack)
    maps = {}
    for number, camera in enumerate(stack.images):
        progress.report(number, len(stack.images), f"decoding {camera}")
        maps[camera] = decode_camera(stack, camera, settings, memory)
    progress.report(len(stack.images), len(stack.images), "decoded")
    return maps


def decode_camera(stack: FringeStack, camera: str, settings: DecodeSettings, memory: BufferPool | None = None) -> PhaseMap:
    """Decode the images of one camera; `decode` checks them first."""
    images = stack.images[camera]
    bracket = (stack.exposures_us, float(stack.saturation))
    decoders = make_decoders(stack.patterns, bracket, settings, camera, stack.viewpoint_id, images, memory or BufferPool())
    return join_directions([decoder.decode(images) for decoder in decoders])
