"""Internals of numba that the kernels depend on. They are not covered by its deprecation policy and may change with any minor version."""

from __future__ import annotations

import importlib

import numba

MINOR_VERSION = "0.68"
INTERNALS = {
    "numba.extending": ("intrinsic", "models", "register_model", "lower_builtin"),
    "numba.core.typing.templates": ("AbstractTemplate", "infer_global", "signature"),
    "numba.core.cgutils": ("get_or_insert_function", "pack_array"),
    "numba.core.errors": ("RequireLiteralValue",),
    "numba.np.arrayobj": ("make_array", "populate_array"),
    "numba.core.cpu:CPUContext": ("make_array", "make_tuple", "cast", "get_dummy_value", "get_data_type", "get_constant"),
    "numba.core.cpu:CPUTargetOptions": ("_nrt", "forceinline", "nogil", "error_model", "fastmath"),  # options of njit
    "numba.core.config": ("CPU_NAME", "CPU_FEATURES", "CACHE_DIR"),  # variables that the check for an older processor sets
}


def test_numba_has_the_minor_version_and_the_internals_that_the_kernels_use() -> None:
    missing = []
    for place, names in INTERNALS.items():
        module, _, holder = place.partition(":")
        owner = importlib.import_module(module)
        owner = getattr(owner, holder) if holder else owner
        missing += [f"{place}.{name}" for name in names if not hasattr(owner, name)]
    used = "; ".join(f"{place}: {', '.join(names)}" for place, names in INTERNALS.items())
    assert numba.__version__.startswith(f"{MINOR_VERSION}."), (
        f"numba is {numba.__version__}, the kernels were tested with {MINOR_VERSION}. Run the tests of the kernels, compare the benchmarks, "
        f"then change MINOR_VERSION here and the dependency in pyproject.toml. Missing of the internals in use: {missing or 'none'}. Used are {used}."
    )
    assert not missing
