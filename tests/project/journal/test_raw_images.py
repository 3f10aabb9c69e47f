"""Raw images: compressed without loss and read all the same, expanded byte for byte, or removed by choice."""

from __future__ import annotations

import io
import json
from pathlib import Path

import numpy as np
import pytest
import zstandard
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from measureapp.cli import main
from measureapp.errors import Damaged, StorageError
from measureapp.project import raw_file, raw_images, upkeep
from measureapp.project.folder import ProjectFolder
from tests.project.journal.whole_project import copied, stack


@pytest.fixture
def project(template: ProjectFolder, tmp_path: Path) -> ProjectFolder:
    return copied(template, tmp_path / "project")


@settings(max_examples=25, deadline=None)
@given(arrays(np.uint8, st.tuples(*(st.integers(1, 4),) * 2, st.integers(1, 6), st.integers(1, 9))) | arrays(np.uint16, (2, 1, 5, 7)))
def test_any_images_come_back_from_compression(tmp_path_factory: pytest.TempPathFactory, images: np.ndarray) -> None:
    path = tmp_path_factory.getbasetemp() / "images.zst"
    raw_file.write_compressed(path, images, b"head")
    again = raw_file.read_compressed(path)
    assert again.dtype == images.dtype and np.array_equal(again, images)
    assert raw_file.head_of(path) == b"head"


def test_the_format_is_open_any_zstandard_tool_unpacks_the_row_differences(tmp_path: Path) -> None:
    images = stack("view01").images["left"]
    raw_file.write_compressed(tmp_path / "left.npy.zst", images, b"")
    unpacked = io.BytesIO()
    zstandard.ZstdDecompressor().copy_stream(io.BytesIO((tmp_path / "left.npy.zst").read_bytes()[_start(tmp_path) :]), unpacked)
    reader = zstandard.ZstdDecompressor().stream_reader(
        (tmp_path / "left.npy.zst").read_bytes()[_start(tmp_path) :], read_across_frames=True
    )
    differences = np.frombuffer(reader.read(), np.uint8).reshape(images.shape)
    assert np.array_equal(np.cumsum(differences, axis=-2, dtype=np.uint8), images)


def _start(folder: Path) -> int:
    return raw_file.SKIPPABLE.size + raw_file.SKIPPABLE.unpack_from((folder / "left.npy.zst").read_bytes())[1]


def test_compressed_images_are_read_as_before_and_expanded_to_the_same_bytes(project: ProjectFolder, capsys) -> None:
    raw = {path: path.read_bytes() for path in sorted((project.path / "stacks").rglob("*.npy"))}
    before = project.frames.load("view02")
    assert main(["raw", str(project.path), "--compress", "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert [view["state"] for view in document["viewpoints"]] == ["compressed", "compressed"]
    assert not list((project.path / "stacks").rglob("*.npy"))
    assert upkeep.verify(project.path).whole
    again = ProjectFolder.open(project.path)
    for camera, images in before.images.items():
        assert np.array_equal(again.frames.load("view02").images[camera], images)
    assert main(["raw", str(project.path), "--expand"]) == 0
    assert {path: path.read_bytes() for path in sorted((project.path / "stacks").rglob("*.npy"))} == raw
    assert upkeep.verify(project.path).whole


def test_smooth_images_with_noise_shrink_to_less_than_half(tmp_path: Path) -> None:
    y, x = np.mgrid[0:240, 0:320]
    rng = np.random.default_rng(2)
    frames = [100 + 60 * np.sin(0.05 * x + 0.01 * y + phase) + rng.normal(0, 1.6, x.shape) for phase in range(4)]
    images = np.clip(np.rint(frames), 0, 255).astype(np.uint8)[None]
    raw_file.write_compressed(tmp_path / "left.npy.zst", images, b"")
    assert images.nbytes / (tmp_path / "left.npy.zst").stat().st_size > 2.0


def test_damaged_raw_images_are_never_compressed(project: ProjectFolder) -> None:
    path = project.path / "stacks" / "view01" / "left.npy"
    path.write_bytes(path.read_bytes()[:-1] + b"\x01")
    with project.lock(), pytest.raises(Damaged, match=r"left\.npy is not what was stored"):
        raw_images.compress(project.journal, "view01")
    assert path.exists() and not list(path.parent.glob("*.zst"))


@pytest.mark.parametrize("place", [3, 60, -5])
def test_a_damaged_compressed_file_is_refused_with_and_without_the_journal(place: int, project: ProjectFolder) -> None:
    with project.lock():
        raw_images.compress(project.journal, "view01")
    path = project.path / "stacks" / "view01" / "left.npy.zst"
    content = bytearray(path.read_bytes())
    content[place] ^= 0x10
    path.write_bytes(content)
    with pytest.raises(Damaged, match=r"left\.npy\.zst"):
        project.frames.load("view01")
    with pytest.raises(Damaged, match=r"left\.npy\.zst is damaged"):
        raw_file.read_compressed(path)


def test_images_are_removed_only_after_a_confirmation_and_what_they_were_stays_in_the_journal(project: ProjectFolder, capsys) -> None:
    assert main(["raw", str(project.path), "--remove"]) == 2
    assert list((project.path / "stacks").rglob("*.npy"))
    assert main(["raw", str(project.path), "--remove", "--yes"]) == 0
    assert "0.0 MB of images" in capsys.readouterr().out
    assert not list((project.path / "stacks").rglob("*.npy"))
    assert upkeep.verify(project.path).whole
    with pytest.raises(StorageError, match="removed to save space"):
        ProjectFolder.open(project.path).frames.load("view01")
    assert project.measurement() is not None


def test_a_discarded_viewpoint_is_taken_again_and_stands_in_the_journal(project: ProjectFolder) -> None:
    assert main(["discard", str(project.path), "view01"]) == 0
    assert project.stored_viewpoints() == ("view02",)
    assert main(["discard", str(project.path), "view01"]) == 2
    with project.lock():
        project.frames.store(stack("view01", seed=9))
    assert upkeep.verify(project.path).whole and project.stored_viewpoints() == ("view01", "view02")
