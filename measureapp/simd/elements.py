"""What is done with the elements of vectors: made, converted, chosen, rounded, and summed up in one number."""

from __future__ import annotations

from typing import Any

from llvmlite import ir  # type: ignore[import-untyped]
from numba import types
from numba.extending import intrinsic

from measureapp.simd.memory import WIDE, literal
from measureapp.simd.vectors import PLACE, Vector, call, compare, kind_of, select, spread, spread_all


def _filled(_typing: Any, value: Any, count: Any) -> Any:
    """Return a vector of ``count`` equal numbers."""
    kind = Vector(types.unliteral(value), literal(count))

    def generate(context: Any, builder: Any, made: Any, args: Any) -> Any:
        return spread(context, builder, kind, made.args[0], args[0])

    return kind(value, count), generate


def _converted(_typing: Any, vector: Any, dtype: Any) -> Any:
    """Return the numbers of a vector as another type: without their fraction, with their lowest bits where it has fewer; masks as 1 and 0."""
    wanted = Vector(dtype.dtype, vector.count)

    def generate(_context: Any, builder: Any, _made: Any, args: Any) -> Any:
        if vector == wanted:
            return args[0]
        if wanted.real and vector.real:
            how = builder.fpext if wanted.bits > vector.bits else builder.fptrunc
        elif wanted.real:
            how = builder.sitofp if vector.signed else builder.uitofp
        elif vector.real:
            how = builder.fptosi if wanted.signed else builder.fptoui
        elif vector.bits > wanted.bits:
            how = builder.trunc
        elif vector.bits == wanted.bits:
            how = builder.bitcast
        else:
            how = builder.sext if vector.signed else builder.zext
        return how(args[0], wanted.machine)

    return wanted(vector, dtype), generate


def _where(_typing: Any, mask: Any, chosen: Any, other: Any) -> Any:
    """Return ``chosen`` where a mask is true, else ``other``; one of them may be a number."""
    kind = kind_of((chosen, other))
    if kind is None:
        return None

    def generate(context: Any, builder: Any, made: Any, args: Any) -> Any:
        return select(builder, kind, args[0], spread_all(context, builder, kind, made.args[1:], args[1:]))

    return kind(mask, types.unliteral(chosen), types.unliteral(other)), generate


def _chosen_by(sign: str) -> Any:
    def typed(_typing: Any, first: Any, second: Any) -> Any:
        kind = kind_of((first, second))
        if kind is None:
            return None

        def generate(context: Any, builder: Any, made: Any, args: Any) -> Any:
            both = spread_all(context, builder, kind, made.args, args)
            return select(builder, kind, compare(builder, sign, kind, both), both)

        return kind(types.unliteral(first), types.unliteral(second)), generate

    return typed


def _each(name: str) -> Any:
    def typed(_typing: Any, vector: Any) -> Any:
        return (vector(vector), lambda _context, builder, _made, args: call(builder, name, vector, args)) if vector.real else None

    return typed


def _of_all(name: str) -> Any:
    def typed(_typing: Any, vector: Any) -> Any:
        letter = "f" if vector.real else ("s" if vector.signed else "u")

        def generate(_context: Any, builder: Any, _made: Any, args: Any) -> Any:
            return call(builder, f"vector.reduce.{letter}{name}", vector, args, vector.machine.element)

        return vector.element(vector), generate

    return typed


def _any_of(_typing: Any, mask: Any) -> Any:
    """Tell whether a mask is true anywhere."""

    def generate(_context: Any, builder: Any, _made: Any, args: Any) -> Any:
        bits = ir.IntType(mask.count)
        return builder.icmp_unsigned("!=", builder.bitcast(args[0], bits), bits(0))

    return types.boolean(mask), generate


def _bits_of(_typing: Any, mask: Any) -> Any:
    """Return a number whose bits, the lowest first, are the elements of a mask of up to 32."""

    def generate(_context: Any, builder: Any, _made: Any, args: Any) -> Any:
        bits = builder.bitcast(args[0], ir.IntType(mask.count))
        return builder.zext(bits, PLACE) if mask.count < PLACE.width else bits

    return (types.uint32(mask), generate) if mask.count <= PLACE.width else None


def _lowest_bit(_typing: Any, _bits: Any) -> Any:
    """Return the place of the lowest bit that is set in a number other than 0."""

    def generate(_context: Any, builder: Any, _made: Any, args: Any) -> Any:
        return builder.cttz(args[0], ir.IntType(1)(1))

    return types.uint32(types.uint32), generate


def _count_of(_typing: Any, mask: Any) -> Any:
    """Return at how many places a mask of up to 64 is true."""

    def generate(_context: Any, builder: Any, _made: Any, args: Any) -> Any:
        count = builder.ctpop(builder.bitcast(args[0], ir.IntType(mask.count)))
        return builder.zext(count, WIDE) if mask.count < WIDE.width else count

    return (types.int64(mask), generate) if mask.count <= WIDE.width else None


filled: Any = intrinsic(_filled)
converted: Any = intrinsic(_converted)
where: Any = intrinsic(_where)
larger: Any = intrinsic(_chosen_by(">"))  # of two, element by element; one of them may be a number
smaller: Any = intrinsic(_chosen_by("<"))
rounded_down: Any = intrinsic(_each("floor"))
square_root: Any = intrinsic(_each("sqrt"))
largest: Any = intrinsic(_of_all("max"))  # of all elements
smallest: Any = intrinsic(_of_all("min"))
any_of: Any = intrinsic(_any_of)
bits_of: Any = intrinsic(_bits_of)
lowest_bit: Any = intrinsic(_lowest_bit)
count_of: Any = intrinsic(_count_of)
