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


def _apart(builder: Any, context: Any, made: Any, records: Any) -> Any:
    """Write a tuple of vectors, one for each number of a record, from records that lie behind each other in one vector."""
    vectors = []
    for place, kind in enumerate(made):
        places = [PLACE(len(made) * number + place) for number in range(kind.count)]
        nothing = ir.Constant(records.type, ir.Undefined)
        vectors.append(builder.shuffle_vector(records, nothing, ir.Constant(ir.VectorType(PLACE, kind.count), places)))
    return context.make_tuple(builder, made, vectors)


def _behind(builder: Any, vectors: list[Any]) -> Any:
    """Write a vector of the elements of several of one length, one behind the other; anything fills it up where these are not 2, 4, 8, …"""
    while len(vectors) > 1:
        nothing = [ir.Constant(vectors[0].type, ir.Undefined)] * (len(vectors) % 2)
        places = ir.Constant(ir.VectorType(PLACE, 2 * vectors[0].type.count), [PLACE(k) for k in range(2 * vectors[0].type.count)])
        vectors = [builder.shuffle_vector(*two, places) for two in zip(vectors[::2], vectors[1::2] + nothing, strict=True)]
    return vectors[0]


def _load(_typing: Any, array: Any, at: Any, count: Any) -> Any:
    """Return ``count`` elements from ``at`` on."""
    kind = Vector(array.dtype, literal(count))

    def generate(context: Any, builder: Any, made: Any, args: Any) -> Any:
        return builder.load(_address(context, builder, kind, made.args[0], *args[:2]), align=kind.bits // BYTE)

    return kind(array, at, count), generate


def _load_records(_typing: Any, array: Any, at: Any, count: Any, width: Any) -> Any:
    """Return ``count`` records of ``width`` elements from ``at`` on, as a tuple of vectors: all first elements, all second ones, …"""
    kind, every = Vector(array.dtype, literal(count)), Vector(array.dtype, literal(count) * literal(width))

    def generate(context: Any, builder: Any, made: Any, args: Any) -> Any:
        records = builder.load(_address(context, builder, every, made.args[0], *args[:2]), align=kind.bits // BYTE)
        return _apart(builder, context, made.return_type, records)

    return types.UniTuple(kind, literal(width))(array, at, count, width), generate


def _fetch_records(_typing: Any, table: Any, step: Any, places: Any, at: Any, count: Any, width: Any) -> Any:
    """Return records of ``width`` elements of an array, as `load_records`: they begin at ``step`` times each of ``count`` places.

    These are whole numbers from 0 on, in another array from ``at`` on. Each record is loaded by itself, which takes most processors less
    time than instructions that gather single elements.
    """
    kind, record = Vector(table.dtype, literal(count)), Vector(table.dtype, literal(width))

    def generate(context: Any, builder: Any, made: Any, args: Any) -> Any:
        listed = context.make_array(made.args[2])(context, builder, args[2]).data
        records = []
        for number in range(kind.count):
            place = builder.zext(builder.load(builder.gep(listed, [builder.add(args[3], args[3].type(number))])), WIDE)
            begin = builder.mul(place, WIDE(literal(made.args[1])))
            records.append(builder.load(_address(context, builder, record, made.args[0], args[0], begin), align=kind.bits // BYTE))
        return _apart(builder, context, made.return_type, _behind(builder, records))

    return types.UniTuple(kind, literal(width))(table, step, places, at, count, width), generate


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


def _storing_records(past_caches: bool) -> Any:
    """Return the intrinsic that writes records from a tuple of vectors, as `load_records` returns it, into an array of their type."""

    def typed(_typing: Any, vectors: Any, array: Any, at: Any) -> Any:
        kind = vectors.dtype
        every = Vector(kind.element, kind.count * len(vectors))

        def generate(context: Any, builder: Any, made: Any, args: Any) -> Any:
            parts = [builder.extract_value(args[0], number) for number in range(len(vectors))]
            places = [PLACE(part * kind.count + number) for number in range(kind.count) for part in range(len(parts))]
            joined = _behind(builder, parts)
            nothing = ir.Constant(joined.type, ir.Undefined)
            records = builder.shuffle_vector(joined, nothing, ir.Constant(ir.VectorType(PLACE, every.count), places))
            align = LINE if past_caches else kind.bits // BYTE
            written = builder.store(records, _address(context, builder, every, made.args[1], *args[1:]), align=align)
            if past_caches:
                written.set_metadata("nontemporal", builder.module.add_metadata([PLACE(1)]))
            return context.get_dummy_value()

        return (types.void(vectors, array, at), generate) if kind.element == array.dtype else None

    return typed


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
load_records: Any = intrinsic(_load_records)
fetch_records: Any = intrinsic(_fetch_records)
store: Any = intrinsic(_store)
store_records: Any = intrinsic(_storing_records(past_caches=False))
store_past_caches: Any = intrinsic(_store_past_caches)
store_records_past_caches: Any = intrinsic(_storing_records(past_caches=True))
gathered: Any = intrinsic(_gathered)
