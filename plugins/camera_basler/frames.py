"""What counts as an image: complete, in sequence, exposed as requested."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from measureapp.arrays import ImageArray
from measureapp.errors import FrameError, SequenceError

UNKNOWN = 2**64 - 1  # what pylon reports for a block id that the transport does not have
LAST_16_BIT = 65_535  # GigE Vision 1.x: 1 follows 65535
MOST_LOST = 1_000  # images in a row; a larger step is no gap


@dataclass(frozen=True, slots=True, eq=False)
class Received:
    """One grab result, copied out of pylon's buffer."""

    succeeded: bool
    error: str  # of pylon; empty for some damaged images, whose error code is 0
    block_id: int | None
    payload_bytes: int
    pixels: ImageArray | None  # None if it did not succeed
    ticks: int  # time stamp; 0 if the camera has none
    exposure_us: float | None = None  # the following as sent with the image; None if the camera does not
    ignored_triggers: int | None = None
    crc_ok: bool = True


def read_result(result: Any) -> Received:
    """Copy a valid grab result. A damaged one has error code 0 and its full shape: only `GrabSucceeded` tells."""
    succeeded = bool(result.GrabSucceeded())
    block_id = int(result.GetBlockID())
    error = f"{int(result.GetErrorCode()):#x} {result.GetErrorDescription()}".strip() if result.GetErrorCode() else ""
    payload = int(result.GetPayloadSize())
    if not succeeded:
        return Received(False, error, None if block_id == UNKNOWN else block_id, payload, None, 0)
    return Received(
        True,
        error,
        None if block_id == UNKNOWN else block_id,
        payload,
        result.GetArray(),
        int(result.GetTimeStamp()),
        _chunk(result, "ChunkExposureTime"),
        None if (ignored := _chunk(result, "ChunkFrameTriggerIgnoredCounter")) is None else int(ignored),
        bool(result.CheckCRC()) if result.HasCRC() else True,
    )


def _chunk(result: Any, name: str) -> float | None:
    if not result.IsChunkDataAvailable():
        return None
    node = result.GetChunkDataNodeMap().GetNode(name)
    return float(node.GetValue()) if node is not None and node.IsReadable() else None


class BlockCounter:
    """Numbers the images of a sequence by the differences of their block ids.

    The first id of a sequence depends on the transport (1 on GigE Vision 1.x, 0 elsewhere). It is learnt from the sequences before: where
    ids restart with every sequence, one that begins higher has lost its first images.
    """

    def __init__(self) -> None:
        self._first: int | None = None
        self._last: int | None = None
        self._restarts = True
        self.begin()

    def begin(self) -> None:
        """Begin a sequence."""
        self._number = -1  # of the last image
        self._damaged = 0  # images since then
        self._before, self._last = self._last, None  # last id of the sequence before, and of this one

    def skip(self) -> None:
        """Count a damaged image, whose id is not to be relied on."""
        self._damaged += 1

    def number(self, block_id: int | None) -> int:
        """Return the number of an image: a lost one before it leaves a gap, a repeated or older one has no number.

        Raises
        ------
        SequenceError
            The id is not after the one before.
        """
        damaged, self._damaged = self._damaged, 0
        if block_id is None:
            self._number += 1 + damaged
        elif self._last is None:
            self._number = self._first_number(block_id, damaged)
        else:
            self._number += self._step(block_id, self._last)
        self._last = block_id
        return self._number

    def _step(self, block_id: int, last: int) -> int:
        step = block_id - last
        if step < 0 and last <= LAST_16_BIT and step + LAST_16_BIT <= MOST_LOST:
            step += LAST_16_BIT
        if step <= 0:
            raise SequenceError(f"image {block_id} came after image {last}")
        return step

    def _first_number(self, block_id: int, damaged: int) -> int:
        if self._first is None:
            self._first = block_id - damaged
        elif self._before is not None and self._before > self._first and block_id == self._before + 1 + damaged:
            self._restarts = False
        self._first = min(self._first, block_id)
        return block_id - self._first if self._restarts else damaged


def check_complete(received: Received, image_bytes: int) -> None:
    """Refuse a damaged or incomplete image; the message is the end of a sentence.

    Raises
    ------
    FrameError
    """
    if not received.succeeded:
        raise FrameError(f"the image is damaged or incomplete ({received.error or f'{received.payload_bytes} of {image_bytes} bytes'})")
    if received.payload_bytes < image_bytes:
        raise FrameError(f"the image has {received.payload_bytes} of {image_bytes} bytes")
    if not received.crc_ok:
        raise FrameError("the check sequence of the image does not fit its pixels")
