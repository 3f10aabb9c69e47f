"""Meshes of every kind, cut in half."""

from __future__ import annotations

from pathlib import Path

import pytest
import trimesh

from measureapp.data.mesh import Mesh
from measureapp.project.geometry.files import read_mesh, write_mesh
from tests.cli.refusal import NOMINAL, cut_in_half, filled, refused


@pytest.fixture(scope="module")
def halves(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """A mesh of every kind that says how long it is, cut in half."""
    folder = tmp_path_factory.mktemp("halves")
    mesh: Mesh = read_mesh(Path(NOMINAL))
    files = {kind: folder / f"{kind}.{kind.split('_')[-1]}" for kind in ("binary_ply", "binary_stl", "ascii_ply", "ascii_stl")}
    write_mesh(files["binary_ply"], mesh)
    write_mesh(files["binary_stl"], mesh)
    plain = trimesh.Trimesh(mesh.vertices_mm, mesh.triangles, process=False)
    plain.export(files["ascii_ply"], encoding="ascii")
    plain.export(files["ascii_stl"], file_type="stl_ascii")
    for path in files.values():
        assert len(read_mesh(path).triangles) == len(mesh.triangles)
        cut_in_half(path)
    return files


@pytest.mark.parametrize("kind", ["binary_ply", "binary_stl", "ascii_ply", "ascii_stl"])
@pytest.mark.parametrize(
    "line",
    [
        "fit plane IN",
        "measure IN PROGRAM",
        "compare IN NOMINAL",
        "compare NOMINAL IN",
        "demo --part IN --out OUT",
    ],
)
def test_a_mesh_cut_in_half_is_refused(line: str, kind: str, halves: dict[str, Path], shelf: Path, tmp_path: Path, capsys) -> None:
    assert halves[kind].name in refused(capsys, filled(line, shelf, tmp_path / "out", str(halves[kind])))
    assert list(tmp_path.iterdir()) == []
