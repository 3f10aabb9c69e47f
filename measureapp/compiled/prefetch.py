"""Software prefetch, as an intrinsic for kernels.

Hardware prefetchers follow regular access patterns only; with others a loop stalls at every cache line and takes half as long again.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir  # type: ignore[import-untyped]
from numba import types
from numba.extending import intrinsic

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
