"""Asking for memory before it is needed, and writing to it without reading it first.

Images lie megabytes apart and are used a few kilobytes at a time, which the processor's own prediction does not follow; loops that
wait for every line of the cache take half as long again. Maps are written once and not looked at soon: what goes through the caches is
first read from memory, and pushes out the images asked for.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir  # type: ignore[import-untyped]
from numba import njit, types
from numba.extending import intrinsic

from measureapp.fringe.kernels.options import INLINE
from measureapp.map_memory import LINE

STREAMED = 16  # float32 of a line
READING, NEAREST_CACHE, DATA = 0, 3, 1


def _will_read(_typing: Any, array: Any, index: Any) -> Any:
    """Hint that the cache line of ``array[index]``, a contiguous array, will be read; an index beyond its end does no harm."""

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        byte, number = ir.IntType(8).as_pointer(), ir.IntType(32)
        data = context.make_array(signature.args[0])(context, builder, args[0]).data
        place = builder.bitcast(builder.gep(data, [args[1]]), byte)
        kind = ir.FunctionType(ir.VoidType(), [byte, number, number, number])
        hint = builder.module.declare_intrinsic("llvm.prefetch", (byte,), kind)
        builder.call(hint, [place, number(READING), number(NEAREST_CACHE), number(DATA)])
        return context.get_dummy_value()

    return types.void(array, index), generate


will_read: Any = intrinsic(_will_read)


@njit(**INLINE)
def ask_for_part(images: Any, begin: Any, length: int, part: Any, parts: int) -> None:
    """Ask for one of so many parts of the pixels from ``begin`` on of all images (P, N), none where images end before ``length`` pixels.

    All at once would make the processor wait: it keeps count of a few dozen lines that are on their way.
    """
    if begin + length > images.shape[1]:
        return
    step = LINE // images.itemsize
    of_image = length // step
    lines = images.shape[0] * of_image
    for line in range(lines * part // parts, lines * (part + 1) // parts):
        will_read(images[line // of_image], begin + step * (line % of_image))


def _write_past_caches(_typing: Any, source: Any, target: Any, index: Any) -> Any:
    """Copy STREAMED elements from ``index`` on, both arrays contiguous float32; those of ``target`` must fill a line of the cache."""

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        line = ir.VectorType(ir.FloatType(), STREAMED).as_pointer()
        places = []
        for kind, array in zip(signature.args[:2], args[:2], strict=True):
            data = context.make_array(kind)(context, builder, array).data
            places.append(builder.bitcast(builder.gep(data, [args[2]]), line))
        written = builder.store(builder.load(places[0], align=4), places[1], align=LINE)
        written.set_metadata("nontemporal", builder.module.add_metadata([ir.Constant(ir.IntType(32), 1)]))
        return context.get_dummy_value()

    return types.void(source, target, index), generate


write_past_caches: Any = intrinsic(_write_past_caches)
