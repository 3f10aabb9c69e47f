"""After the warm-up nothing is left to compile."""

from __future__ import annotations

from types import ModuleType

import pytest

from measureapp.fringe.kernels import solve, vote
from measureapp.pipeline.warm_up import warm_up
from measureapp.progress import CallbackProgress, Cancelled
from measureapp.reconstruct.kernels import blur, clean, components, cross_check, fuse, gather, gradients, match, reproject, table
from measureapp.reconstruct.reconstruct import reconstruct
from measureapp.register.grid import kernels as register_kernels
from measureapp.register.pairs.prepare import prepare
from tests.reconstruct.conftest import make_head, plane

MEASURING = (
    solve,
    vote,
    blur,
    clean,
    components,
    cross_check,
    fuse,
    gather,
    gradients,
    match,
    reproject,
    table,
    register_kernels,
)


def compiled(module: ModuleType) -> dict[str, int]:
    """How many versions every kernel of a module has in this process; those that are forced inline into others have none."""
    kernels = {name: found for name, found in vars(module).items() if hasattr(found, "signatures")}
    return {name: len(found.signatures) for name, found in kernels.items() if not found.targetoptions.get("forceinline")}


def test_every_kernel_that_measures_is_compiled_by_the_warm_up() -> None:
    reports: list[tuple[float, str]] = []
    warm_up(CallbackProgress(lambda done, total, note: reports.append((done / total, note))))
    counts = {f"{module.__name__}.{name}": count for module in MEASURING for name, count in compiled(module).items()}
    assert len(counts) > 20
    called_from_kernels = {"root_of", "match", "fuse_pairs"}
    rare = {"check_orthogonal"}  # for sets with fringes of both directions
    assert {name for name, count in counts.items() if count == 0 and name.split(".")[-1] not in called_from_kernels | rare} == set()
    shares = [share for share, _ in reports]
    assert shares == sorted(shares) and shares[0] == 0 and shares[-1] == 1


@pytest.mark.parametrize("names", [("left", "right"), ("left", "right", "upper")])
def test_a_measurement_after_it_compiles_nothing(names: tuple[str, ...]) -> None:
    warm_up()
    before = [compiled(module) for module in MEASURING]
    head = make_head(16, names)
    made = reconstruct(head.phase_maps(plane(550, 0.2, 0.1), 0.01, 1), head.cameras)
    prepare(made.cloud, 5.0)
    assert [compiled(module) for module in MEASURING] == before


def test_it_stops_between_two_stages_when_asked() -> None:
    notes = []

    def stop_at_the_third(_done: float, _total: float, note: str) -> None:
        notes.append(note)
        if len(notes) == 3:
            raise Cancelled

    with pytest.raises(Cancelled):
        warm_up(CallbackProgress(stop_at_the_third))
    assert len(notes) == 3
