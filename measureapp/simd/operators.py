"""Python's operators for vectors."""

from __future__ import annotations

import operator
from collections.abc import Callable, Sequence
from typing import Any

from llvmlite import ir  # type: ignore[import-untyped]
from numba import types
from numba.core.typing.templates import AbstractTemplate, infer_global, signature
from numba.extending import lower_builtin

from measureapp.simd.vectors import FAST, Vector, call, compare, kind_of, spread_all

Write = Callable[[Any, Vector, Sequence[Any]], Any]  # write(builder, kind, operands)
UNCHECKED = ir.IntType(1)(0)  # of abs: the lowest whole number is its own opposite

ARITHMETIC = {  # in LLVM's words for numbers with a fraction and whole ones
    operator.add: ("fadd", "add"),
    operator.sub: ("fsub", "sub"),
    operator.mul: ("fmul", "mul"),
    operator.truediv: ("fdiv", None),
    operator.and_: (None, "and_"),
    operator.or_: (None, "or_"),
}
COMPARISONS = {operator.lt: "<", operator.le: "<=", operator.gt: ">", operator.ge: ">=", operator.eq: "==", operator.ne: "!="}


def _define(function: Any, result: Callable[[Vector], Vector | None], write: Write, operands: int) -> None:
    """Let the compiler take a function for vectors: the ``result`` for a kind, None where there is none, and its code."""

    class Operator(AbstractTemplate):
        def generic(self, args: Any, _kws: Any) -> Any:
            kind = kind_of(args) if len(args) == operands else None
            made = kind and result(kind)
            return signature(made, *args) if made else None

    def lower(context: Any, builder: Any, made: Any, args: Any) -> Any:
        kind = kind_of(made.args)
        assert kind is not None
        return write(builder, kind, spread_all(context, builder, kind, made.args, args))

    infer_global(function)(Operator)
    for shape in ((Vector, Vector), (Vector, types.Any), (types.Any, Vector)) if operands == 2 else ((Vector,),):
        lower_builtin(function, *shape)(lower)


def _define_arithmetic(function: Any, real: str | None, whole: str | None) -> None:
    def result(kind: Vector) -> Vector | None:
        return kind if (real if kind.real else whole) else None

    def write(builder: Any, kind: Vector, args: Sequence[Any]) -> Any:
        return getattr(builder, str(real))(*args, flags=FAST) if kind.real else getattr(builder, str(whole))(*args)

    _define(function, result, write, 2)


def _define_comparison(function: Any, sign: str) -> None:
    def mask(kind: Vector) -> Vector:
        return Vector(types.boolean, kind.count)

    _define(function, mask, lambda builder, kind, args: compare(builder, sign, kind, args), 2)


def _negated(builder: Any, kind: Vector, args: Sequence[Any]) -> Any:
    return builder.fneg(args[0], flags=FAST) if kind.real else builder.neg(args[0])


def _magnitude(builder: Any, kind: Vector, args: Sequence[Any]) -> Any:
    return call(builder, "fabs", kind, args) if kind.real else call(builder, "abs", kind, [*args, UNCHECKED])


def _shifted(builder: Any, kind: Vector, args: Sequence[Any]) -> Any:
    return (builder.ashr if kind.signed else builder.lshr)(*args)


for _function, (_real, _whole) in ARITHMETIC.items():
    _define_arithmetic(_function, _real, _whole)
for _function, _sign in COMPARISONS.items():
    _define_comparison(_function, _sign)
_define(operator.rshift, lambda kind: None if kind.real else kind, _shifted, 2)
_define(operator.neg, lambda kind: kind, _negated, 1)
_define(operator.invert, lambda kind: None if kind.real else kind, lambda builder, _kind, args: builder.not_(args[0]), 1)
_define(abs, lambda kind: kind, _magnitude, 1)
