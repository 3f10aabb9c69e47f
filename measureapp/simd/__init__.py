"""Vectors for compiled loops: so many numbers in registers, which one instruction of the processor takes together (SIMD).

The compiler makes SIMD code of a plain loop over one index by itself, but only of one with few arrays, after asking at every start
whether these overlap, and it keeps in memory what one loop leaves to the next. With vectors a loop says itself which numbers go together,
and step follows step in registers. A vector may be longer than a register: it is then spread over several, on any processor.

Vectors of one kind are added, subtracted, multiplied and divided, compared with each other and with single numbers, which are taken for
all their elements. Comparisons give masks, vectors of truth values, to be joined by ``&`` and ``|``, turned round by ``~`` and used by
`where`. A product is not rounded before the sum that it goes into, and numbers that are not finite give anything.
"""

from measureapp.simd import operators as operators  # the compiler knows them from here on
