import numpy as np
import pytest

from measureapp.arrays import read_only
from measureapp.data.fringe import AxisReadback, FringeStack
from measureapp.data.pattern_sets import PAPER_PATTERNS
from measureapp.errors import StorageError
from measureapp.geometry.transform import RigidTransform
from measureapp.project.frame_store import FrameStore


@pytest.fixture
def stack():
    images = np.random.default_rng(3).integers(0, 255, (2, 8, 12, 16), np.uint8)
    readback = AxisReadback(RigidTransform.from_vector([0.1, 0.2, 0.3], [400, 0, 500], "base", "flange"), 12.5, 0.25)
    return FringeStack(
        "view01", PAPER_PATTERNS, (100_000, 50_000), {"left": read_only(images)}, 255, readback, approach="2026-05-04T10:00:00+00:00"
    )


def test_a_stack_comes_back_as_it_was_stored(tmp_path, stack):
    store = FrameStore(tmp_path)
    store.store(stack)
    loaded = store.load("view01")
    assert store.list_stored() == ("view01",)
    assert np.array_equal(loaded.images["left"], stack.images["left"])
    assert loaded.patterns == stack.patterns
    assert loaded.exposures_us == stack.exposures_us
    assert np.allclose(loaded.readback.base_from_flange.matrix, stack.readback.base_from_flange.matrix)
    assert (loaded.readback.guide_mm, loaded.readback.table_rad) == (12.5, 0.25)
    assert loaded.approach == store.approach(stack.viewpoint_id) == stack.approach


def test_one_changed_byte_is_named(tmp_path, stack):
    store = FrameStore(tmp_path)
    store.store(stack)
    assert store.find_damage("view01") == ()
    path = tmp_path / "view01" / "left.npy"
    content = bytearray(path.read_bytes())
    content[-7] ^= 1
    path.write_bytes(content)
    assert store.find_damage("view01") == (f"{path} differs from its stored checksum",)


def test_a_file_cut_in_half_is_refused_with_its_name(tmp_path, stack):
    store = FrameStore(tmp_path)
    store.store(stack)
    path = tmp_path / "view01" / "left.npy"
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])
    with pytest.raises(StorageError, match=r"left\.npy cannot be read"):
        store.load("view01")
    assert "left.npy" in store.find_damage("view01")[0]


def test_a_stack_that_was_never_finished_does_not_count_as_stored(tmp_path, stack):
    store = FrameStore(tmp_path)
    store.store(stack)
    (tmp_path / "view01" / "stack.json").unlink()
    assert store.list_stored() == ()


def test_too_little_disk_space_is_said_before_anything_is_written(tmp_path):
    with pytest.raises(StorageError, match="GB free; the images need"):
        FrameStore(tmp_path).require_space(10**18)
