"""Asking for memory before it is needed, and writing to it without reading it first.

What is used in an order that the processor's own prediction does not follow is waited for, line of the cache by line; loops take half as
long again. What is written once and not looked at soon is first read from memory where it goes through the caches, and pushes out what
else is in them.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir  # type: ignore[import-untyped]
from numba import types
from numba.extending import intrinsic

from measureapp.map_memory import LINE

STREAMED = 16  # words of 32 bits of a line
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


def _write_past_caches(_typing: Any, source: Any, target: Any, index: Any) -> Any:
    """Copy a line of the cache from ``index`` on, of contiguous arrays of one type; in ``target`` one must begin there."""

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
