"""The compiler's type of a vector, and what writes machine code for it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from llvmlite import ir  # type: ignore[import-untyped]
from numba import types
from numba.core.cgutils import get_or_insert_function
from numba.extending import models, register_model

FAST = ("fast",)  # of arithmetic: reciprocals are estimated and refined, products go into sums unrounded
PLACE = ir.IntType(32)
BIT = 1


class Vector(types.Type):
    """The type of ``count`` numbers of one type."""

    def __init__(self, element: Any, count: int) -> None:
        self.element, self.count = element, count
        super().__init__(f"Vector({element}, {count})")

    @property
    def real(self) -> bool:
        """Whether the numbers have a fraction."""
        return isinstance(self.element, types.Float)

    @property
    def signed(self) -> bool:
        """Whether they may be below zero."""
        return self.real or bool(getattr(self.element, "signed", False))

    @property
    def bits(self) -> int:
        """Of one of the numbers."""
        return BIT if self.element is types.boolean else int(self.element.bitwidth)

    @property
    def machine(self) -> Any:
        """The type in LLVM's words."""
        real = ir.FloatType() if self.element is types.float32 else ir.DoubleType()
        return ir.VectorType(real if self.real else ir.IntType(self.bits), self.count)

    @property
    def suffix(self) -> str:
        """What the names of LLVM's functions for it end with."""
        return f"v{self.count}{'f' if self.real else 'i'}{self.bits}"


@register_model(Vector)
class _VectorModel(models.PrimitiveModel):
    """A vector goes from function to function in registers."""

    def __init__(self, manager: Any, kind: Vector) -> None:
        super().__init__(manager, kind, kind.machine)


def kind_of(operands: Sequence[Any]) -> Vector | None:
    """Return the one kind of vector among types that else are of numbers; None where they do not fit."""
    kinds = [operand for operand in operands if isinstance(operand, Vector)]
    numbers = [operand for operand in operands if isinstance(operand, types.Number | types.Boolean)]
    fit = len(kinds) + len(numbers) == len(operands) and all(kind == kinds[0] for kind in kinds)
    return kinds[0] if kinds and fit else None


def spread(context: Any, builder: Any, kind: Vector, given: Any, value: Any) -> Any:
    """Write a vector of equal numbers from one of type ``given``; a vector stays as it is."""
    if isinstance(given, Vector):
        return value
    nothing = ir.Constant(kind.machine, ir.Undefined)
    first = builder.insert_element(nothing, context.cast(builder, value, given, kind.element), PLACE(0))
    return builder.shuffle_vector(first, nothing, ir.Constant(ir.VectorType(PLACE, kind.count), [0] * kind.count))


def spread_all(context: Any, builder: Any, kind: Vector, made: Any, args: Any) -> list[Any]:
    """Write vectors of all operands of a call."""
    return [spread(context, builder, kind, given, value) for given, value in zip(made, args, strict=True)]


def call(builder: Any, name: str, kind: Vector, args: Sequence[Any], result: Any = None) -> Any:
    """Write the call of a function of LLVM's for vectors of a kind."""
    made = ir.FunctionType(result or kind.machine, [arg.type for arg in args])
    function = get_or_insert_function(builder.module, made, f"llvm.{name}.{kind.suffix}")
    return builder.call(function, args, fastmath=FAST if kind.real else ())


def compare(builder: Any, sign: str, kind: Vector, args: Sequence[Any]) -> Any:
    """Write a comparison, which gives a mask."""
    if kind.real:
        return builder.fcmp_ordered(sign, *args, flags=FAST)
    return (builder.icmp_signed if kind.signed else builder.icmp_unsigned)(sign, *args)


def select(builder: Any, kind: Vector, mask: Any, args: Sequence[Any]) -> Any:
    """Write the choice between two vectors by a mask."""
    return builder.select(mask, *args, flags=FAST if kind.real else ())
