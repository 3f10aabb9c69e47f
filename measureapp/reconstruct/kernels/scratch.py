"""Memory on the stack for chunks of pixels, and what brings scattered pixels there.

The compiler knows that an array made here overlaps no other one. So loops that also read and write large arrays become SIMD code
without checks, of which it gives up after eight. Arrays on the stack need no reference counts (`options.LOOP`).

Pixels at scattered places are copied as vectors of a few numbers and regrouped afterwards: the compiler's own choice for them, gather
instructions, is slower than single loads on many processors.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir  # type: ignore[import-untyped]
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic
from numba.np import arrayobj

from measureapp.map_memory import LINE

GROUP = 16  # records regrouped at once; chunks are padded to a multiple
INT, FLOAT = ir.IntType(32), ir.FloatType()
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
                pointer.align = LINE
            array = numba_arrays.make_array(made)(context, builder)
            length, size = (context.get_constant(types.intp, value) for value in (count.literal_value, element.bitwidth // 8))
            shape, strides = (building.pack_array(builder, [value]) for value in (length, size))
            numba_arrays.populate_array(array, data=pointer, shape=shape, strides=strides, itemsize=size, meminfo=None)
            return array._getvalue()

        return made(count), generate

    return intrinsic(on_stack)


def _pointer(context: Any, builder: Any, kind: Any, array: Any, index: Any, to: Any) -> Any:
    return builder.bitcast(builder.gep(numba_arrays.make_array(kind)(context, builder, array).data, [index]), to.as_pointer())


def _copier(count: int) -> Any:
    """Return the intrinsic for ``target[i : i + count] = source[j : j + count]`` of 32-bit numbers, as one vector."""

    def copy(_typing: Any, target: Any, i: Any, source: Any, j: Any) -> Any:
        def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            into, _i, of, _j = signature.args
            vector = ir.VectorType(INT, count)
            read = builder.load(_pointer(context, builder, of, arguments[2], arguments[3], vector), align=4)
            builder.store(read, _pointer(context, builder, into, arguments[0], arguments[1], vector), align=4)
            return context.get_dummy_value()

        return types.void(target, i, source, j), generate

    return intrinsic(copy)


def _splitter(count: int) -> Any:
    """Return the intrinsic for ``target[i + k * lane + m] = source[j + count * m + k]``, all k below ``count`` and m below GROUP."""

    def split(_typing: Any, target: Any, i: Any, lane: Any, source: Any, j: Any) -> Any:
        def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            into, _i, _lane, of, _j = signature.args
            records, part = ir.VectorType(FLOAT, GROUP * count), ir.VectorType(FLOAT, GROUP)
            read = builder.load(_pointer(context, builder, of, arguments[3], arguments[4], records), align=4)
            for k in range(count):
                places = ir.Constant(ir.VectorType(INT, GROUP), [ir.Constant(INT, count * m + k) for m in range(GROUP)])
                chosen = builder.shuffle_vector(read, ir.Constant(records, ir.Undefined), places)
                at = builder.add(arguments[1], builder.mul(arguments[2], ir.Constant(arguments[2].type, k)))
                builder.store(chosen, _pointer(context, builder, into, arguments[0], at, part), align=4)
            return context.get_dummy_value()

        return types.void(target, i, lane, source, j), generate

    return intrinsic(split)


def _joiner(past_caches: bool) -> Any:
    """Return the intrinsic for ``target[i + 4 * m + k] = source[j + k * lane + m]``, all k below 4 and m below GROUP: `split_4` reversed.

    Past the caches the 4 * GROUP numbers of ``target`` must fill lines of the cache.
    """

    def join(_typing: Any, target: Any, i: Any, source: Any, j: Any, lane: Any) -> Any:
        def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            into, _i, of, _j, _lane = signature.args
            part, records = ir.VectorType(FLOAT, GROUP), ir.VectorType(FLOAT, 4 * GROUP)
            parts = []
            for k in range(4):
                at = builder.add(arguments[3], builder.mul(arguments[4], ir.Constant(arguments[4].type, k)))
                parts.append(builder.load(_pointer(context, builder, of, arguments[2], at, part), align=4))
            halves = [
                builder.shuffle_vector(a, b, ir.Constant(ir.VectorType(INT, 2 * GROUP), [ir.Constant(INT, m) for m in range(2 * GROUP)]))
                for a, b in (parts[:2], parts[2:])
            ]
            places = ir.Constant(ir.VectorType(INT, 4 * GROUP), [ir.Constant(INT, k * GROUP + m) for m in range(GROUP) for k in range(4)])
            joined = builder.shuffle_vector(halves[0], halves[1], places)
            pointer = _pointer(context, builder, into, arguments[0], arguments[1], records)
            written = builder.store(joined, pointer, align=LINE if past_caches else 4)
            if past_caches:
                written.set_metadata("nontemporal", builder.module.add_metadata([ir.Constant(INT, 1)]))
            return context.get_dummy_value()

        return types.void(target, i, source, j, lane), generate

    return intrinsic(join)


def _equal_bits(_typing: Any, array: Any, i: Any, value: Any) -> Any:
    """Return a number whose bit m says whether ``array[i + m] == value``, all m below GROUP."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        part = ir.VectorType(FLOAT, GROUP)
        read = builder.load(_pointer(context, builder, signature.args[0], arguments[0], arguments[1], part), align=4)
        first = builder.insert_element(ir.Constant(part, ir.Undefined), arguments[2], ir.Constant(INT, 0))
        everywhere = builder.shuffle_vector(first, ir.Constant(part, ir.Undefined), ir.Constant(ir.VectorType(INT, GROUP), [0] * GROUP))
        return builder.zext(builder.bitcast(builder.fcmp_ordered("==", read, everywhere), ir.IntType(GROUP)), INT)

    return types.uint32(array, i, value), generate


def _lowest_bit(_typing: Any, _bits: Any) -> Any:
    """Return the place of the lowest bit that is set in a number other than 0."""

    def generate(_context: Any, builder: Any, _signature: Any, arguments: Any) -> Any:
        return builder.cttz(arguments[0], ir.Constant(ir.IntType(1), 1))

    return types.uint32(types.uint32), generate


stack_float32: Any = _stack_of(types.float32)
stack_float64: Any = _stack_of(types.float64)
stack_int32: Any = _stack_of(types.int32)
stack_uint8: Any = _stack_of(types.uint8)
copy_1: Any = _copier(1)
copy_2: Any = _copier(2)
copy_4: Any = _copier(4)
split_2: Any = _splitter(2)
split_4: Any = _splitter(4)
join_4: Any = _joiner(False)
join_4_past_caches: Any = _joiner(True)
equal_bits: Any = intrinsic(_equal_bits)
lowest_bit: Any = intrinsic(_lowest_bit)
