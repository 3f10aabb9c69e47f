"""SIMD vectors in numba kernels: a fixed number of lanes of one type, with Python's operators.

LLVM vectorises a plain loop by itself only with few arrays, checks them for overlap at every start, and passes values from one loop to
the next through memory. With vectors a kernel states the lanes itself and values stay in registers. A vector wider than a register is
split over several, on any processor.

Vectors of one type support ``+ - * /``, ``abs``, comparisons and, for integers, ``& | >> ~``; the other operand may be a scalar, which is
broadcast. Comparisons return masks (vectors of booleans) for ``& | ~`` and `elements.select`. Floating-point arithmetic uses LLVM's fast-math flags:
products are fused into sums, and results are undefined where an operand is NaN or infinite.
"""

from measureapp.compiled.simd import operators as operators  # registers the operators with numba
