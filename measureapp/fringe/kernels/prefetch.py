"""Asking for memory before it is needed.

Images lie megabytes apart and are used a few kilobytes at a time, which the processor's own prediction does not follow; loops that
wait for every line of the cache take half as long again.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic

LINE = 64  # bytes of a cache line
NEAREST_CACHE, DATA = 3, 1


def _hint(array: Any, index: Any, writing: int) -> Any:
    """Return signature and code generator of a hint that ``array[index]`` will be read, or written."""

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        byte, number = ir.IntType(8).as_pointer(), ir.IntType(32)
        data = context.make_array(signature.args[0])(context, builder, args[0]).data
        place = builder.bitcast(builder.gep(data, [args[1]]), byte)
        kind = ir.FunctionType(ir.VoidType(), [byte, number, number, number])
        hint = cgutils.get_or_insert_function(builder.module, kind, "llvm.prefetch.p0i8")
        builder.call(hint, [place, number(writing), number(NEAREST_CACHE), number(DATA)])
        return context.get_dummy_value()

    return types.void(array, index), generate


@intrinsic  # type: ignore[untyped-decorator]
def will_read(_typing: Any, array: Any, index: Any) -> Any:
    """Hint that the cache line of ``array[index]``, a contiguous array, will be read; an index beyond its end does no harm."""
    return _hint(array, index, 0)


@intrinsic  # type: ignore[untyped-decorator]
def will_write(_typing: Any, array: Any, index: Any) -> Any:
    """Hint that the cache line of ``array[index]``, a contiguous array, will be written."""
    return _hint(array, index, 1)
