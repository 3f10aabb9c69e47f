"""The numba type of a SIMD vector, and the emission of LLVM code for it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from llvmlite import ir  # type: ignore[import-untyped]
from numba import types
from numba.core.cgutils import get_or_insert_function
from numba.extending import models, register_model

FAST_MATH = ("fast",)  # flags of floating-point instructions
INT32 = ir.IntType(32)
BOOLEAN_BITS = 1


class Vector(types.Type):
    """Numba type of a vector of ``lanes`` elements of one scalar type."""

    def __init__(self, element: Any, lanes: int) -> None:
        self.element, self.lanes = element, lanes
        super().__init__(f"Vector({element}, {lanes})")

    @property
    def floating(self) -> bool:
        """Whether the elements are floating-point numbers."""
        return isinstance(self.element, types.Float)

    @property
    def signed(self) -> bool:
        """Whether the elements have a sign."""
        return self.floating or bool(getattr(self.element, "signed", False))

    @property
    def element_bits(self) -> int:
        """Width of an element."""
        return BOOLEAN_BITS if self.element is types.boolean else int(self.element.bitwidth)

    @property
    def element_bytes(self) -> int:
        """Size of an element in memory, its natural alignment."""
        return self.element_bits // 8

    @property
    def llvm_type(self) -> Any:
        """LLVM type of the vector."""
        floating = ir.FloatType() if self.element is types.float32 else ir.DoubleType()
        return ir.VectorType(floating if self.floating else ir.IntType(self.element_bits), self.lanes)

    @property
    def suffix(self) -> str:
        """Suffix of overloaded LLVM intrinsics for the vector, such as ``v16f32``."""
        return f"v{self.lanes}{'f' if self.floating else 'i'}{self.element_bits}"


@register_model(Vector)
class _VectorModel(models.PrimitiveModel):
    """Data model: a vector is passed by value, in registers."""

    def __init__(self, manager: Any, vector: Vector) -> None:
        super().__init__(manager, vector, vector.llvm_type)


def common_vector(operands: Sequence[Any]) -> Vector | None:
    """Return the one vector type among operand types that are otherwise scalars; None where the operands do not match."""
    vectors = [operand for operand in operands if isinstance(operand, Vector)]
    scalars = [operand for operand in operands if isinstance(operand, types.Number | types.Boolean)]
    match = len(vectors) + len(scalars) == len(operands) and all(vector == vectors[0] for vector in vectors)
    return vectors[0] if vectors and match else None


def emit_splat(context: Any, builder: Any, vector: Vector, given: Any, value: Any) -> Any:
    """Emit the broadcast of a scalar of type ``given`` to all lanes; a vector stays as it is."""
    if isinstance(given, Vector):
        return value
    undefined = ir.Constant(vector.llvm_type, ir.Undefined)
    first = builder.insert_element(undefined, context.cast(builder, value, given, vector.element), INT32(0))
    return builder.shuffle_vector(first, undefined, ir.Constant(ir.VectorType(INT32, vector.lanes), [0] * vector.lanes))


def emit_splats(context: Any, builder: Any, vector: Vector, given: Any, args: Any) -> list[Any]:
    """Emit the broadcast of every scalar among the operands of a call."""
    return [emit_splat(context, builder, vector, kind, value) for kind, value in zip(given, args, strict=True)]


def emit_intrinsic(builder: Any, name: str, vector: Vector, args: Sequence[Any], result: Any = None) -> Any:
    """Emit the call of an LLVM intrinsic that is overloaded for vectors."""
    function_type = ir.FunctionType(result or vector.llvm_type, [arg.type for arg in args])
    function = get_or_insert_function(builder.module, function_type, f"llvm.{name}.{vector.suffix}")
    return builder.call(function, args, fastmath=FAST_MATH if vector.floating else ())


def emit_compare(builder: Any, sign: str, vector: Vector, args: Sequence[Any]) -> Any:
    """Emit a comparison, lane by lane; gives a mask."""
    if vector.floating:
        return builder.fcmp_ordered(sign, *args, flags=FAST_MATH)
    return (builder.icmp_signed if vector.signed else builder.icmp_unsigned)(sign, *args)


def emit_select(builder: Any, vector: Vector, mask: Any, args: Sequence[Any]) -> Any:
    """Emit the selection between two vectors by a mask."""
    return builder.select(mask, *args, flags=FAST_MATH if vector.floating else ())
