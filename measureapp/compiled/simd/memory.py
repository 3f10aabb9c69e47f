"""Loads, stores and gathers of SIMD vectors, as intrinsics for kernels.

Arrays are one-dimensional and contiguous; indices are not checked. A record is a fixed number of consecutive elements of an array
("array of structures"); records are returned as a tuple of vectors, one per field.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir  # type: ignore[import-untyped]
from numba import types
from numba.core.cgutils import get_or_insert_function
from numba.core.errors import RequireLiteralValue
from numba.extending import intrinsic

from measureapp.compiled.simd.vectors import INT32, Vector, emit_splat

INT64 = ir.IntType(64)


def literal_int(value: Any) -> int:
    """Return the value of a compile-time constant; otherwise numba types the call again, with literals where it has them."""
    if not isinstance(value, types.IntegerLiteral):
        raise RequireLiteralValue("The length of a vector must be a constant.")
    return int(value.literal_value)


def _emit_address(context: Any, builder: Any, vector: Vector, array: Any, value: Any, index: Any) -> Any:
    """Emit the address of an element, cast to a pointer to vectors."""
    data = context.make_array(array)(context, builder, value).data
    return builder.bitcast(builder.gep(data, [index]), vector.llvm_type.as_pointer())


def _emit_deinterleave(builder: Any, context: Any, returned: Any, records: Any) -> Any:
    """Emit the shuffles that turn consecutive records in one vector into a tuple of vectors, one per field."""
    fields = []
    for field, vector in enumerate(returned):
        lanes = [INT32(len(returned) * record + field) for record in range(vector.lanes)]
        undefined = ir.Constant(records.type, ir.Undefined)
        fields.append(builder.shuffle_vector(records, undefined, ir.Constant(ir.VectorType(INT32, vector.lanes), lanes)))
    return context.make_tuple(builder, returned, fields)


def _emit_concatenate(builder: Any, vectors: list[Any]) -> Any:
    """Emit the concatenation of vectors of one length; unless they are 2, 4, 8, …, undefined lanes follow."""
    while len(vectors) > 1:
        padding = [ir.Constant(vectors[0].type, ir.Undefined)] * (len(vectors) % 2)
        lanes = ir.Constant(ir.VectorType(INT32, 2 * vectors[0].type.count), [INT32(k) for k in range(2 * vectors[0].type.count)])
        vectors = [builder.shuffle_vector(*pair, lanes) for pair in zip(vectors[::2], vectors[1::2] + padding, strict=True)]
    return vectors[0]


def _load(_typing: Any, array: Any, index: Any, lanes: Any) -> Any:
    """Load a vector of consecutive elements from ``array[index]`` on."""
    vector = Vector(array.dtype, literal_int(lanes))

    def generate(context: Any, builder: Any, call: Any, args: Any) -> Any:
        return builder.load(_emit_address(context, builder, vector, call.args[0], *args[:2]), align=vector.element_bytes)

    return vector(array, index, lanes), generate


def _load_records(_typing: Any, array: Any, index: Any, lanes: Any, width: Any) -> Any:
    """Load ``lanes`` consecutive records of ``width`` elements from ``array[index]`` on; returns one vector per field."""
    vector, all_fields = Vector(array.dtype, literal_int(lanes)), Vector(array.dtype, literal_int(lanes) * literal_int(width))

    def generate(context: Any, builder: Any, call: Any, args: Any) -> Any:
        records = builder.load(_emit_address(context, builder, all_fields, call.args[0], *args[:2]), align=vector.element_bytes)
        return _emit_deinterleave(builder, context, call.return_type, records)

    return types.UniTuple(vector, literal_int(width))(array, index, lanes, width), generate


def _gather_records(_typing: Any, table: Any, stride: Any, indices: Any, begin: Any, lanes: Any, width: Any) -> Any:
    """Gather records of ``width`` elements of ``table``; returns one vector per field.

    The record of lane k begins at ``table[stride * indices[begin + k]]``; ``indices`` holds integers from 0 on. Each record is one load:
    on most processors that is faster than gather instructions, which fetch single elements.
    """
    vector, record = Vector(table.dtype, literal_int(lanes)), Vector(table.dtype, literal_int(width))

    def generate(context: Any, builder: Any, call: Any, args: Any) -> Any:
        listed = context.make_array(call.args[2])(context, builder, args[2]).data
        records = []
        for lane in range(vector.lanes):
            index = builder.zext(builder.load(builder.gep(listed, [builder.add(args[3], args[3].type(lane))])), INT64)
            first = builder.mul(index, INT64(literal_int(call.args[1])))
            records.append(builder.load(_emit_address(context, builder, record, call.args[0], args[0], first), align=vector.element_bytes))
        return _emit_deinterleave(builder, context, call.return_type, _emit_concatenate(builder, records))

    return types.UniTuple(vector, literal_int(width))(table, stride, indices, begin, lanes, width), generate


def _store(_typing: Any, vector: Any, array: Any, index: Any) -> Any:
    """Store a vector from ``array[index]`` on, into an array of its element type."""

    def generate(context: Any, builder: Any, call: Any, args: Any) -> Any:
        builder.store(args[0], _emit_address(context, builder, vector, call.args[1], *args[1:]), align=vector.element_bytes)
        return context.get_dummy_value()

    return (types.void(vector, array, index), generate) if vector.element == array.dtype else None


def _gather(_typing: Any, table: Any, indices: Any) -> Any:
    """Gather ``table[indices]`` for a vector of integers from 0 on."""
    vector, int64s = Vector(table.dtype, indices.lanes), Vector(types.int64, indices.lanes)

    def generate(context: Any, builder: Any, call: Any, args: Any) -> Any:
        first = builder.ptrtoint(context.make_array(call.args[0])(context, builder, args[0]).data, INT64)
        base, size = (emit_splat(context, builder, int64s, types.int64, number) for number in (first, INT64(vector.element_bytes)))
        offsets = builder.mul(builder.zext(args[1], int64s.llvm_type), size)
        pointers = builder.inttoptr(builder.add(base, offsets), ir.VectorType(vector.llvm_type.element.as_pointer(), vector.lanes))
        all_lanes = ir.Constant(ir.VectorType(ir.IntType(1), vector.lanes), [1] * vector.lanes)
        operands = [pointers, INT32(vector.element_bytes), all_lanes, ir.Constant(vector.llvm_type, ir.Undefined)]
        function = ir.FunctionType(vector.llvm_type, [operand.type for operand in operands])
        name = f"llvm.masked.gather.{vector.suffix}.v{vector.lanes}p0"
        return builder.call(get_or_insert_function(builder.module, function, name), operands)

    return vector(table, indices), generate


load: Any = intrinsic(_load)
load_records: Any = intrinsic(_load_records)
gather_records: Any = intrinsic(_gather_records)
store: Any = intrinsic(_store)
gather: Any = intrinsic(_gather)
