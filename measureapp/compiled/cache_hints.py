"""Software prefetch and non-temporal copy, as intrinsics for kernels.

Hardware prefetchers follow regular access patterns only; with others a loop stalls at every cache line and takes half as long again. An
ordinary store first reads its cache line from memory and evicts others; a non-temporal store does neither.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir  # type: ignore[import-untyped]
from numba import types
from numba.extending import intrinsic

from measureapp.compiled.buffer_pool import CACHE_LINE_BYTES

WORDS_PER_LINE = CACHE_LINE_BYTES // 4  # of 32 bits
READ, HIGH_LOCALITY, DATA_CACHE = 0, 3, 1  # operands of llvm.prefetch


def _prefetch(_typing: Any, array: Any, index: Any) -> Any:
    """Prefetch the cache line of ``array[index]`` of a contiguous array for reading; an index out of bounds is harmless."""

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        byte, int32 = ir.IntType(8).as_pointer(), ir.IntType(32)
        data = context.make_array(signature.args[0])(context, builder, args[0]).data
        address = builder.bitcast(builder.gep(data, [args[1]]), byte)
        function_type = ir.FunctionType(ir.VoidType(), [byte, int32, int32, int32])
        function = builder.module.declare_intrinsic("llvm.prefetch", (byte,), function_type)
        builder.call(function, [address, int32(READ), int32(HIGH_LOCALITY), int32(DATA_CACHE)])
        return context.get_dummy_value()

    return types.void(array, index), generate


prefetch: Any = intrinsic(_prefetch)


def _stream_line(_typing: Any, source: Any, target: Any, index: Any) -> Any:
    """Copy one cache line by a non-temporal store, from ``source[index]`` to ``target[index]``.

    Both are contiguous arrays of one type; ``target[index]`` must begin a cache line.
    """

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        line = ir.VectorType(ir.FloatType(), WORDS_PER_LINE).as_pointer()
        addresses = []
        for array_type, array in zip(signature.args[:2], args[:2], strict=True):
            data = context.make_array(array_type)(context, builder, array).data
            addresses.append(builder.bitcast(builder.gep(data, [args[2]]), line))
        store = builder.store(builder.load(addresses[0], align=4), addresses[1], align=CACHE_LINE_BYTES)
        store.set_metadata("nontemporal", builder.module.add_metadata([ir.Constant(ir.IntType(32), 1)]))
        return context.get_dummy_value()

    return types.void(source, target, index), generate


stream_line: Any = intrinsic(_stream_line)
