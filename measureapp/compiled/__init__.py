"""What compiled kernels share: SIMD vectors, cache hints, buffers, compiler options, the cache of compiled code.

Importing this package, `buffer_pool`, `kernel_cache` or `options` does not import numba.
"""
