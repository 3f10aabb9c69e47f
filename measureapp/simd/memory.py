"""Vectors from arrays and into them. Arrays are contiguous, of one axis, and never asked for their length."""

from __future__ import annotations

from typing import Any

from llvmlite import ir  # type: ignore[import-untyped]
from numba import types
from numba.core.cgutils import get_or_insert_function
from numba.core.errors import RequireLiteralValue
from numba.extending import intrinsic

from measureapp.map_memory import LINE
from measureapp.simd.vectors import PLACE, Vector, spread

WIDE = ir.IntType(64)
BYTE = 8


def literal(count: Any) -> int:
    """Return the length of a vector, which must be a constant; the compiler asks again where it has not yet seen that it is one."""
    if not isinstance(count, types.IntegerLiteral):
        raise RequireLiteralValue("The length of a vector must be a constant.")
    return int(count.literal_value)


def _address(context: Any, builder: Any, kind: Vector, array: Any, value: Any, at: Any) -> Any:
    """Write the address of an element of an array, as that of a vector."""
    data = context.make_array(array)(context, builder, value).data
    return builder.bitcast(builder.gep(data, [at]), kind.machine.as_pointer())


def _load(_typing: Any, array: Any, at: Any, count: Any) -> Any:
    """Return ``count`` elements from ``at`` on."""
    kind = Vector(array.dtype, literal(count))

    def generate(context: Any, builder: Any, made: Any, args: Any) -> Any:
        return builder.load(_address(context, builder, kind, made.args[0], *args[:2]), align=kind.bits // BYTE)

    return kind(array, at, count), generate


def _store(_typing: Any, vector: Any, array: Any, at: Any) -> Any:
    """Write a vector into an array of its type, from ``at`` on."""

    def generate(context: Any, builder: Any, made: Any, args: Any) -> Any:
        builder.store(args[0], _address(context, builder, vector, made.args[1], *args[1:]), align=vector.bits // BYTE)
        return context.get_dummy_value()

    return (types.void(vector, array, at), generate) if vector.element == array.dtype else None


def _store_past_caches(_typing: Any, vector: Any, array: Any, at: Any) -> Any:
    """Write a vector of whole lines of the cache, where a line begins: memory is neither read before, nor kept in the caches."""

    def generate(context: Any, builder: Any, made: Any, args: Any) -> Any:
        written = builder.store(args[0], _address(context, builder, vector, made.args[1], *args[1:]), align=LINE)
        written.set_metadata("nontemporal", builder.module.add_metadata([PLACE(1)]))
        return context.get_dummy_value()

    return (types.void(vector, array, at), generate) if vector.element == array.dtype else None


def _gathered(_typing: Any, table: Any, places: Any) -> Any:
    """Return the elements of an array at ``places``, whole numbers from 0 on."""
    kind, numbers = Vector(table.dtype, places.count), Vector(types.int64, places.count)

    def generate(context: Any, builder: Any, made: Any, args: Any) -> Any:
        first = builder.ptrtoint(context.make_array(made.args[0])(context, builder, args[0]).data, WIDE)
        begin, step = (spread(context, builder, numbers, types.int64, number) for number in (first, WIDE(kind.bits // BYTE)))
        offsets = builder.mul(builder.zext(args[1], numbers.machine), step)
        pointers = builder.inttoptr(builder.add(begin, offsets), ir.VectorType(kind.machine.element.as_pointer(), kind.count))
        everywhere = ir.Constant(ir.VectorType(ir.IntType(1), kind.count), [1] * kind.count)
        operands = [pointers, PLACE(kind.bits // BYTE), everywhere, ir.Constant(kind.machine, ir.Undefined)]
        function = ir.FunctionType(kind.machine, [operand.type for operand in operands])
        name = f"llvm.masked.gather.{kind.suffix}.v{kind.count}p0"
        return builder.call(get_or_insert_function(builder.module, function, name), operands)

    return kind(table, places), generate


load: Any = intrinsic(_load)
store: Any = intrinsic(_store)
store_past_caches: Any = intrinsic(_store_past_caches)
gathered: Any = intrinsic(_gathered)
