"""Parts from files: any mesh in millimetres is stood on the table; a damaged one is refused in words."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import trimesh

from measureapp.data.length_unit import LengthUnit
from measureapp.errors import InputError
from measureapp.simulate.part_file import mesh_span
from measureapp.simulate.parts import make_part


@pytest.fixture
def block() -> trimesh.Trimesh:
    mesh = trimesh.creation.box((60.0, 40.0, 30.0))
    mesh.apply_translation([500.0, -200.0, 70.0])
    return mesh


@pytest.mark.parametrize("kind", ["stl", "ply", "obj"])
def test_a_mesh_is_stood_on_the_table_with_its_centre_on_the_axis(kind: str, block: trimesh.Trimesh, tmp_path: Path) -> None:
    path = tmp_path / f"block.{kind}"
    block.export(path)
    part = make_part(str(path))
    assert part.name == "block"
    assert part.watertight
    np.testing.assert_allclose(part.mesh.vertices_mm.min(axis=0), [-30.0, -20.0, 0.0], atol=1e-4)
    np.testing.assert_allclose(part.mesh.vertices_mm.max(axis=0), [30.0, 20.0, 30.0], atol=1e-4)


def test_a_mesh_turned_inside_out_is_turned_back(block: trimesh.Trimesh, tmp_path: Path) -> None:
    block.invert()
    block.export(tmp_path / "inverted.stl")
    part = make_part(str(tmp_path / "inverted.stl"))
    assert trimesh.Trimesh(part.mesh.vertices_mm, part.mesh.triangles).volume > 0


@pytest.mark.parametrize("kind", ["stl", "ply"])
def test_a_file_cut_in_half_is_refused(kind: str, block: trimesh.Trimesh, tmp_path: Path) -> None:
    path = tmp_path / f"half.{kind}"
    block.export(path)
    content = path.read_bytes()
    path.write_bytes(content[: len(content) // 2 + 100])
    with pytest.raises(InputError, match=f"half.{kind}.*truncated") as refusal:
        make_part(str(path))
    assert "again" in refusal.value.hint


def test_a_text_file_cut_in_half_is_refused(block: trimesh.Trimesh, tmp_path: Path) -> None:
    text = trimesh.exchange.stl.export_stl_ascii(block)
    path = tmp_path / "half.stl"
    path.write_text(text[: len(text) // 2])
    with pytest.raises(InputError, match="truncated"):
        make_part(str(path))


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("empty.stl", b""),
        ("noise.stl", bytes(range(256)) * 3),
        ("noise.ply", b"ply\nformat ascii 1.0\nend_header\n"),
        ("noise.obj", b"v 1 2\nf 1 2 9\n"),
        ("noise2.ply", b"\x00\x01nothing"),
    ],
)
def test_a_file_that_holds_no_mesh_is_refused(name: str, content: bytes, tmp_path: Path) -> None:
    path = tmp_path / name
    path.write_bytes(content)
    with pytest.raises(InputError, match=name):
        make_part(str(path))


def test_a_mesh_in_metres_is_refused(block: trimesh.Trimesh, tmp_path: Path) -> None:
    block.apply_scale(0.001)
    block.export(tmp_path / "metres.stl")
    with pytest.raises(InputError, match=r"0\.06 mm long"):
        make_part(str(tmp_path / "metres.stl"))


def test_a_missing_file_and_a_foreign_kind_are_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="does not exist"):
        make_part(str(tmp_path / "missing.stl"))
    with pytest.raises(InputError, match="not a supported mesh"):
        make_part(str(tmp_path / "part.docx"))


def test_a_mesh_in_a_stated_unit_has_the_size_it_has_in_millimetres(block: trimesh.Trimesh, tmp_path: Path) -> None:
    whole, path = np.ptp(block.vertices, axis=0), tmp_path / "block.stl"
    block.copy().apply_scale(1 / 25.4).export(path)
    assert mesh_span(path) == pytest.approx(whole.max() / 25.4, rel=1e-5)
    part = make_part(str(path), LengthUnit.INCH)
    assert np.ptp(part.mesh.vertices_mm, axis=0) == pytest.approx(whole, rel=1e-5)
