"""Memory on the stack for chunks of pixels.

The compiler knows that an array made here overlaps no other one. So loops that also read and write large arrays become SIMD code
without checks, of which it gives up after eight.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir  # type: ignore[import-untyped]
from numba import types
from numba.extending import intrinsic

ALIGNMENT = 64


def _on_stack(_typing: Any, count: Any) -> Any:
    """Return a pointer to ``count`` (a constant) float32, for `numba.carray`; it ends with the function."""
    if not isinstance(count, types.IntegerLiteral):
        return None

    def generate(_context: Any, builder: Any, _signature: Any, _arguments: Any) -> Any:
        with builder.goto_entry_block():
            pointer = builder.alloca(ir.FloatType(), size=ir.Constant(ir.IntType(32), count.literal_value))
            pointer.align = ALIGNMENT
        return pointer

    pointer_type: Any = types.CPointer(types.float32)  # type: ignore[no-untyped-call]
    return pointer_type(count), generate


stack_float32: Any = intrinsic(_on_stack)
