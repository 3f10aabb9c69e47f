"""Compressed raw images: row differences modulo the pixel range, with Zstandard, one block per image.

The file is a Zstandard stream that any such tool decompresses: first a skippable frame with a JSON index, then one frame per image, whose
rows hold the differences to the row above; the sum along the columns, modulo 256 (or 65536), gives the pixels back. The index has ``dtype``,
``shape``, ``sha256`` of all pixels, ``head`` (what the ``.npy`` file began with, hexadecimal) and ``sizes`` (bytes of every block).
"""

from __future__ import annotations

import hashlib
import json
import math
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import zstandard

from measureapp.arrays import read_only
from measureapp.errors import Damaged, StorageError

COMPRESSED = ".zst"
SKIPPABLE = struct.Struct("<II")
MAGIC, FORMAT, LEVEL = 0x184D2A50, 1, 1
MOST_INDEX_BYTES = 2**20
RESTORE = "Restore the file from a backup, or take the viewpoint again."


def write_compressed(path: Path, images: np.typing.NDArray[Any], head: bytes) -> None:
    """Compress (…, rows, columns) unsigned integers. Raises OSError."""
    frames = np.ascontiguousarray(images).reshape(-1, *images.shape[-2:])
    digest, blocks = hashlib.sha256(), list[bytes]()
    for frame in frames:
        digest.update(frame.data)
        blocks.append(zstandard.compress(_differences(frame).tobytes(), LEVEL))
    index = {
        "schema_version": FORMAT,
        "dtype": str(images.dtype),
        "shape": list(images.shape),
        "sha256": digest.hexdigest(),
        "head": head.hex(),
        "sizes": [len(block) for block in blocks],
    }
    text = json.dumps(index).encode("ascii")
    with path.open("wb") as file:
        file.write(SKIPPABLE.pack(MAGIC, len(text)) + text)
        file.writelines(blocks)


def read_compressed(path: Path) -> Any:
    """Return the images of a compressed file, read-only. Raises Damaged when they are not those that were compressed."""
    index, blocks = _open(path)
    try:
        images = np.empty(index["shape"], index["dtype"])
        frames = images.reshape(-1, *images.shape[-2:])
        digest = hashlib.sha256()
        for frame, block in zip(frames, blocks, strict=True):
            raw = zstandard.ZstdDecompressor().decompress(block, max_output_size=frame.nbytes)
            np.cumsum(np.frombuffer(raw, frame.dtype).reshape(frame.shape), axis=0, dtype=frame.dtype, out=frame)
            digest.update(frame.data)
    except (ValueError, KeyError, TypeError, zstandard.ZstdError) as error:
        raise _damaged(path) from error
    if digest.hexdigest() != index["sha256"]:
        raise _damaged(path)
    return read_only(images)


def head_of(path: Path) -> bytes:
    """Return what the ``.npy`` file began with. Raises Damaged."""
    return bytes.fromhex(_open(path)[0]["head"])


def _open(path: Path) -> tuple[dict[str, Any], Iterator[bytes]]:
    try:
        data = memoryview(path.read_bytes())
        magic, length = SKIPPABLE.unpack_from(data)
        start = SKIPPABLE.size + length
        if magic != MAGIC or length > MOST_INDEX_BYTES:
            raise ValueError("no index")
        index = json.loads(bytes(data[SKIPPABLE.size : start]))
        shape, sizes = index["shape"], index["sizes"]
        plausible = index["dtype"] in ("uint8", "uint16") and len(shape) >= 2 and all(isinstance(n, int) and 0 < n < 2**20 for n in shape)
        if not plausible or math.prod(shape[:-2]) != len(sizes) or start + sum(sizes) != len(data):
            raise ValueError("the index does not fit the file")
    except OSError as error:
        raise StorageError(f"{path} cannot be read: {error.strerror or error}.", RESTORE) from error
    except (ValueError, KeyError, TypeError, struct.error, RecursionError) as error:
        raise _damaged(path) from error
    return index, _blocks(data, start, sizes)


def _blocks(data: memoryview, start: int, sizes: list[int]) -> Iterator[bytes]:
    for size in sizes:
        yield bytes(data[start : start + size])
        start += size


def _differences(frame: np.typing.NDArray[Any]) -> np.typing.NDArray[Any]:
    rows = frame.copy()
    rows[1:] -= frame[:-1]
    return rows


def _damaged(path: Path) -> Damaged:
    return Damaged(f"{path} is damaged: it does not decompress to the images that were stored.", RESTORE)
