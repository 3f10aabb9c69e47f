"""Asking for memory before it is needed.

Images lie megabytes apart and are used a few kilobytes at a time, which the processor's own prediction does not follow; loops that
wait for every line of the cache take half as long again.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir  # type: ignore[import-untyped]
from numba import types
from numba.extending import intrinsic

LINE = 64  # bytes of a cache line
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
