"""What compiled kernels share: SIMD vectors, cache hints, buffers, compiler options, the cache of compiled code.

Importing this package, `buffer_pool`, `kernel_cache`, `options` or `selection` does not import numba.
"""
