"""Registration of Python's operators for SIMD vectors."""

from __future__ import annotations

import operator
from collections.abc import Callable, Sequence
from typing import Any

from llvmlite import ir  # type: ignore[import-untyped]
from numba import types
from numba.core.typing.templates import AbstractTemplate, infer_global, signature
from numba.extending import lower_builtin

from measureapp.compiled.simd.vectors import FAST_MATH, Vector, common_vector, emit_compare, emit_intrinsic, emit_splats

Emit = Callable[[Any, Vector, Sequence[Any]], Any]  # emit(builder, vector, operands)
MINIMUM_IS_DEFINED = ir.IntType(1)(0)  # operand of llvm.abs: the lowest integer wraps to itself

ARITHMETIC = {  # LLVM instructions for floating-point and integer elements
    operator.add: ("fadd", "add"),
    operator.sub: ("fsub", "sub"),
    operator.mul: ("fmul", "mul"),
    operator.truediv: ("fdiv", None),
    operator.and_: (None, "and_"),
    operator.or_: (None, "or_"),
}
COMPARISONS = {operator.lt: "<", operator.le: "<=", operator.gt: ">", operator.ge: ">=", operator.eq: "==", operator.ne: "!="}


def _register(function: Any, result: Callable[[Vector], Vector | None], emit: Emit, operands: int) -> None:
    """Register typing and lowering of a function for vectors: ``result`` gives its return type, None where it is not defined."""

    class Operator(AbstractTemplate):
        def generic(self, args: Any, _kws: Any) -> Any:
            vector = common_vector(args) if len(args) == operands else None
            returned = vector and result(vector)
            return signature(returned, *args) if returned else None

    def lower(context: Any, builder: Any, call: Any, args: Any) -> Any:
        vector = common_vector(call.args)
        assert vector is not None
        return emit(builder, vector, emit_splats(context, builder, vector, call.args, args))

    infer_global(function)(Operator)
    for shape in ((Vector, Vector), (Vector, types.Any), (types.Any, Vector)) if operands == 2 else ((Vector,),):
        lower_builtin(function, *shape)(lower)


def _register_arithmetic(function: Any, floating: str | None, integer: str | None) -> None:
    def result(vector: Vector) -> Vector | None:
        return vector if (floating if vector.floating else integer) else None

    def emit(builder: Any, vector: Vector, args: Sequence[Any]) -> Any:
        return getattr(builder, str(floating))(*args, flags=FAST_MATH) if vector.floating else getattr(builder, str(integer))(*args)

    _register(function, result, emit, 2)


def _register_comparison(function: Any, sign: str) -> None:
    def mask(vector: Vector) -> Vector:
        return Vector(types.boolean, vector.lanes)

    _register(function, mask, lambda builder, vector, args: emit_compare(builder, sign, vector, args), 2)


def _negate(builder: Any, vector: Vector, args: Sequence[Any]) -> Any:
    return builder.fneg(args[0], flags=FAST_MATH) if vector.floating else builder.neg(args[0])


def _absolute(builder: Any, vector: Vector, args: Sequence[Any]) -> Any:
    if vector.floating:
        return emit_intrinsic(builder, "fabs", vector, args)
    return emit_intrinsic(builder, "abs", vector, [*args, MINIMUM_IS_DEFINED])


def _shift_right(builder: Any, vector: Vector, args: Sequence[Any]) -> Any:
    return (builder.ashr if vector.signed else builder.lshr)(*args)


for _function, (_floating, _integer) in ARITHMETIC.items():
    _register_arithmetic(_function, _floating, _integer)
for _function, _sign in COMPARISONS.items():
    _register_comparison(_function, _sign)
_register(operator.rshift, lambda vector: None if vector.floating else vector, _shift_right, 2)
_register(operator.neg, lambda vector: vector, _negate, 1)
_register(operator.invert, lambda vector: None if vector.floating else vector, lambda builder, _vector, args: builder.not_(args[0]), 1)
_register(abs, lambda vector: vector, _absolute, 1)
