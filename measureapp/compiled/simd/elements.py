"""Lane-wise operations and horizontal reductions of SIMD vectors, as intrinsics for kernels."""

from __future__ import annotations

from typing import Any

from llvmlite import ir  # type: ignore[import-untyped]
from numba import types
from numba.extending import intrinsic

from measureapp.compiled.simd.memory import INT64, literal_int
from measureapp.compiled.simd.vectors import (
    INT32,
    Vector,
    common_vector,
    emit_compare,
    emit_intrinsic,
    emit_select,
    emit_splat,
    emit_splats,
)


def _broadcast(_typing: Any, value: Any, lanes: Any) -> Any:
    """Broadcast a scalar to all lanes of a vector."""
    vector = Vector(types.unliteral(value), literal_int(lanes))

    def generate(context: Any, builder: Any, call: Any, args: Any) -> Any:
        return emit_splat(context, builder, vector, call.args[0], args[0])

    return vector(value, lanes), generate


def _convert(_typing: Any, vector: Any, dtype: Any) -> Any:
    """Convert the elements to another type: floats truncate towards zero, integers to their low bits; masks become 1 and 0."""
    wanted = Vector(dtype.dtype, vector.lanes)

    def generate(_context: Any, builder: Any, _call: Any, args: Any) -> Any:
        if vector == wanted:
            return args[0]
        if wanted.floating and vector.floating:
            cast = builder.fpext if wanted.element_bits > vector.element_bits else builder.fptrunc
        elif wanted.floating:
            cast = builder.sitofp if vector.signed else builder.uitofp
        elif vector.floating:
            cast = builder.fptosi if wanted.signed else builder.fptoui
        elif vector.element_bits > wanted.element_bits:
            cast = builder.trunc
        elif vector.element_bits == wanted.element_bits:
            cast = builder.bitcast
        else:
            cast = builder.sext if vector.signed else builder.zext
        return cast(args[0], wanted.llvm_type)

    return wanted(vector, dtype), generate


def _select(_typing: Any, mask: Any, chosen: Any, other: Any) -> Any:
    """Select lane by lane: ``chosen`` where the mask is true, otherwise ``other``; one of them may be a scalar."""
    vector = common_vector((chosen, other))
    if vector is None:
        return None

    def generate(context: Any, builder: Any, call: Any, args: Any) -> Any:
        return emit_select(builder, vector, args[0], emit_splats(context, builder, vector, call.args[1:], args[1:]))

    return vector(mask, types.unliteral(chosen), types.unliteral(other)), generate


def _extremum(sign: str) -> Any:
    def typed(_typing: Any, first: Any, second: Any) -> Any:
        vector = common_vector((first, second))
        if vector is None:
            return None

        def generate(context: Any, builder: Any, call: Any, args: Any) -> Any:
            both = emit_splats(context, builder, vector, call.args, args)
            return emit_select(builder, vector, emit_compare(builder, sign, vector, both), both)

        return vector(types.unliteral(first), types.unliteral(second)), generate

    return typed


def _unary(name: str) -> Any:
    def typed(_typing: Any, vector: Any) -> Any:
        if not vector.floating:
            return None
        return vector(vector), lambda _context, builder, _call, args: emit_intrinsic(builder, name, vector, args)

    return typed


def _any_lane(_typing: Any, mask: Any) -> Any:
    """Tell whether a mask is true in any lane."""

    def generate(_context: Any, builder: Any, _call: Any, args: Any) -> Any:
        bits = ir.IntType(mask.lanes)
        return builder.icmp_unsigned("!=", builder.bitcast(args[0], bits), bits(0))

    return types.boolean(mask), generate


def _bitmask(_typing: Any, mask: Any) -> Any:
    """Return a mask of up to 32 lanes as the bits of an integer, lane 0 the least significant."""

    def generate(_context: Any, builder: Any, _call: Any, args: Any) -> Any:
        bits = builder.bitcast(args[0], ir.IntType(mask.lanes))
        return builder.zext(bits, INT32) if mask.lanes < INT32.width else bits

    return (types.uint32(mask), generate) if mask.lanes <= INT32.width else None


def _count_trailing_zeros(_typing: Any, _bits: Any) -> Any:
    """Return the index of the least significant bit that is set; undefined for 0."""

    def generate(_context: Any, builder: Any, _call: Any, args: Any) -> Any:
        return builder.cttz(args[0], ir.IntType(1)(1))

    return types.uint32(types.uint32), generate


def _popcount(_typing: Any, mask: Any) -> Any:
    """Count the true lanes of a mask of up to 64 lanes."""

    def generate(_context: Any, builder: Any, _call: Any, args: Any) -> Any:
        count = builder.ctpop(builder.bitcast(args[0], ir.IntType(mask.lanes)))
        return builder.zext(count, INT64) if mask.lanes < INT64.width else count

    return (types.int64(mask), generate) if mask.lanes <= INT64.width else None


broadcast: Any = intrinsic(_broadcast)
convert: Any = intrinsic(_convert)
select: Any = intrinsic(_select)
maximum: Any = intrinsic(_extremum(">"))  # lane-wise, of two vectors or a vector and a scalar
minimum: Any = intrinsic(_extremum("<"))
floor: Any = intrinsic(_unary("floor"))
sqrt: Any = intrinsic(_unary("sqrt"))
any_lane: Any = intrinsic(_any_lane)
bitmask: Any = intrinsic(_bitmask)
count_trailing_zeros: Any = intrinsic(_count_trailing_zeros)
popcount: Any = intrinsic(_popcount)
