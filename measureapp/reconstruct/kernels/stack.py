"""Memory on the stack for chunks of pixels.

The compiler knows that an array made here overlaps no other one. So loops that also read and write large arrays become SIMD code
without checks, of which it gives up after eight. Arrays on the stack need no reference counts (`options.LOOP`).
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir  # type: ignore[import-untyped]
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic
from numba.np import arrayobj

from measureapp.compiled.buffer_pool import CACHE_LINE_BYTES

INT = ir.IntType(32)
numba_arrays: Any = arrayobj  # both without types
building: Any = cgutils


def _stack_of(element: Any) -> Any:
    """Return the intrinsic that makes an array of ``count`` (a constant) numbers; it ends with the function and holds anything."""
    made: Any = types.Array(element, 1, "C")

    def on_stack(_typing: Any, count: Any) -> Any:
        if not isinstance(count, types.IntegerLiteral):
            return None

        def generate(context: Any, builder: Any, _signature: Any, _arguments: Any) -> Any:
            with builder.goto_entry_block():
                pointer = builder.alloca(context.get_data_type(element), size=ir.Constant(INT, count.literal_value))
                pointer.align = CACHE_LINE_BYTES
            array = numba_arrays.make_array(made)(context, builder)
            length, size = (context.get_constant(types.intp, value) for value in (count.literal_value, element.bitwidth // 8))
            shape, strides = (building.pack_array(builder, [value]) for value in (length, size))
            numba_arrays.populate_array(array, data=pointer, shape=shape, strides=strides, itemsize=size, meminfo=None)
            return array._getvalue()

        return made(count), generate

    return intrinsic(on_stack)


stack_float32: Any = _stack_of(types.float32)
stack_int32: Any = _stack_of(types.int32)
