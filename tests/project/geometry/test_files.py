from __future__ import annotations

import struct
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from measureapp.data.cloud import PointCloud, StitchedCloud
from measureapp.data.mesh import Mesh
from measureapp.data.view_errors import POWERS, CloudDistortion, FormErrors, SystematicErrors, ViewErrors
from measureapp.errors import InputError, StorageError
from measureapp.geometry.transform import RigidTransform
from measureapp.project.geometry.files import (
    PlainPoints,
    read_cloud_or_mesh,
    read_mesh,
    read_point_cloud,
    read_points,
    read_stitched,
    write_cloud,
    write_mesh,
)
from measureapp.project.geometry.ply import Ply
from measureapp.project.geometry.view_errors import error_elements, errors_from

CORNERS = np.array([[0, 0, 0], [10, 0, 0], [0, 10, 0], [0, 0, 10.0]])
FACES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])


@pytest.fixture
def view() -> PointCloud:
    rng = np.random.default_rng(1)
    normals = rng.normal(size=(50, 3))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    pixel = rng.integers(0, 2000, (50, 2))
    return PointCloud(
        rng.uniform(-900, 900, (50, 3)), normals, rng.uniform(0.01, 0.1, 50), rng.random(50), pixel, np.full(50, 5), "camera", "v 01"
    )


@pytest.fixture
def tetrahedron() -> Mesh:
    return Mesh(CORNERS, FACES, "part", np.array([True, True, False, True]))


def ply(body: bytes, *lines: str, form: str = "ascii") -> bytes:
    return "\n".join(["ply", f"format {form} 1.0", *lines, "end_header\n"]).encode() + body


XYZ = ("property float x", "property float y", "property float z")


def test_a_views_cloud_comes_back_as_it_was_written(tmp_path: Path, view: PointCloud):
    write_cloud(tmp_path / "v.ply", view)
    back = read_point_cloud(tmp_path / "v.ply")
    np.testing.assert_allclose(back.points_mm, view.points_mm, atol=1e-4)
    np.testing.assert_allclose(back.normals, view.normals, atol=1e-6)
    np.testing.assert_array_equal(back.sigma_mm, view.sigma_mm)
    np.testing.assert_array_equal(back.pixel, view.pixel)
    np.testing.assert_array_equal(back.cameras, view.cameras)
    assert (back.frame, back.viewpoint_id) == ("camera", "v 01")


def test_a_stitched_cloud_comes_back_as_it_was_written(tmp_path: Path, view: PointCloud):
    cloud = StitchedCloud(view.points_mm, view.normals, view.sigma_mm, view.grey, np.arange(50), ())
    write_cloud(tmp_path / "s.ply", cloud)
    back = read_stitched(tmp_path / "s.ply")
    np.testing.assert_allclose(back.points_mm, cloud.points_mm, atol=1e-4)
    np.testing.assert_array_equal(back.view, cloud.view)
    with pytest.raises(InputError, match="not a view's cloud"):
        read_point_cloud(tmp_path / "s.ply")


def errors_of(count: int, frame: str = "part") -> ViewErrors:
    rng = np.random.default_rng(5)
    poses = tuple(RigidTransform.from_vector(rng.normal(size=3), rng.normal(size=3), frame, "camera") for _ in range(count))
    bends = CloudDistortion(np.array([1.0, 2.0, 500.0]), np.array([90.0, 80.0, 70.0]), rng.normal(size=(len(POWERS), 3, 4)))
    stitching_motions, calibration_motions = rng.normal(size=(6 * count, 9)), rng.normal(size=(6 * count, 4))
    nodes, sizes = 20 * rng.normal(size=(3 * count, 3)), rng.uniform(0.001, 0.002, count)
    form = FormErrors(nodes, np.repeat(np.arange(count), 3), sizes, 20 + 1000 * sizes, 1e-3 * rng.normal(size=(6 * count, 3 * count)))
    common = SystematicErrors(rng.normal(size=(5, 3)), 0.002, 1e-3 * rng.normal(size=(6 * count, 5)))
    return ViewErrors(poses, rng.normal(size=(count, 3)), stitching_motions, calibration_motions, bends, form, common)


@pytest.mark.parametrize("calibrated", [True, False])
@pytest.mark.parametrize("formed", [True, False])
def test_what_the_views_err_by_comes_back_with_the_stitched_cloud(tmp_path: Path, view: PointCloud, calibrated: bool, formed: bool):
    errors = errors_of(3)
    if not calibrated:
        errors = replace(errors, distortion=None, calibration_motions=np.zeros((18, 0)))
    if not formed:
        errors = replace(errors, form=None, systematic=None)
    errors = replace(errors, unexplained_mm=0.003)
    number = np.arange(50) % 3
    cloud = StitchedCloud(view.points_mm, view.normals, view.sigma_mm, view.grey, number, (), sampled_view=(number + 1) % 3, errors=errors)
    write_cloud(tmp_path / "s.ply", cloud)
    back = read_stitched(tmp_path / "s.ply")
    assert back.errors is not None and back.sampled_view is not None
    np.testing.assert_array_equal(back.sampled_view, cloud.sampled_view)
    one, other = (each.along(cloud.points_mm, np.asarray(cloud.normals, float), number) for each in (errors, back.errors))
    assert one.keys() == other.keys() and [name in one for name in ("calibration", "form", "common", "unexplained")] == [
        calibrated,
        formed,
        formed,
        formed,
    ]
    for share, columns in one.items():
        np.testing.assert_allclose(other[share], columns, atol=1e-9)


@pytest.mark.parametrize("element", ["view_pose", "cloud_form", "cloud_form_node", "common_error"])
def test_elements_of_errors_that_lost_their_rows_are_refused(element: str):
    elements = error_elements(errors_of(3))
    elements[element] = {name: np.zeros(0) for name in elements[element]}
    with pytest.raises(InputError, match=r"s\.ply is damaged: what it says of its views' errors"):
        errors_from(Path("s.ply"), Ply((), elements), "part")


def test_points_of_views_that_a_file_does_not_describe_are_refused(tmp_path: Path, view: PointCloud):
    cloud = StitchedCloud(view.points_mm, view.normals, view.sigma_mm, view.grey, np.arange(50) % 3, (), errors=errors_of(2))
    write_cloud(tmp_path / "s.ply", cloud)
    with pytest.raises(InputError, match="points of views that it does not describe"):
        read_points(tmp_path / "s.ply")


def test_points_written_as_text_can_be_read(tmp_path: Path, view: PointCloud):
    write_cloud(tmp_path / "v.xyz", view)
    back = read_points(tmp_path / "v.xyz")
    np.testing.assert_allclose(back.points_mm, view.points_mm, atol=1e-2)
    assert back.normals is not None


@pytest.mark.parametrize("ending", ["ply", "stl"])
def test_a_mesh_comes_back_as_it_was_written(tmp_path: Path, tetrahedron: Mesh, ending: str):
    path = tmp_path / f"m.{ending}"
    write_mesh(path, tetrahedron)
    back = read_mesh(path)
    wanted = np.sort(tetrahedron.vertices_mm[tetrahedron.triangles].reshape(4, 9), axis=0)
    np.testing.assert_allclose(np.sort(back.vertices_mm[back.triangles].reshape(4, 9), axis=0), wanted, atol=1e-5)
    assert len(back.vertices_mm) == 4
    if ending == "ply":
        np.testing.assert_array_equal(back.measured, tetrahedron.measured)


def test_ascii_ply_with_polygons_lists_and_strange_elements_is_read(tmp_path: Path):
    lines = ("comment made elsewhere", "obj_info x", "element strange 2", "property list uchar int what", "element vertex 4", *XYZ)
    lines += ("property uchar quality", "element face 2", "property list uchar int vertex_indices", "property float area")
    body = b"2 7 8\n0\n0 0 0 9\n1 0 0 9\n1 1 0 9\n0 1 0 9\n4 0 1 2 3 1.0\n3 0 1 2 0.5\n"
    (tmp_path / "a.ply").write_bytes(ply(body, *lines))
    mesh = read_cloud_or_mesh(tmp_path / "a.ply")
    assert isinstance(mesh, Mesh)
    np.testing.assert_array_equal(mesh.triangles, [[0, 1, 2], [0, 2, 3], [0, 1, 2]])


@pytest.mark.parametrize(("form", "order"), [("binary_little_endian", "<"), ("binary_big_endian", ">")])
def test_binary_ply_of_both_byte_orders_is_read(tmp_path: Path, form: str, order: str):
    lines = ("element vertex 3", "property double x", "property double y", "property double z", "property list uchar short tags")
    lines += ("element face 1", "property list uchar uint vertex_index")
    body = b"".join(struct.pack(f"{order}3dB{k}h", k, 2, 3, k, *range(k)) for k in range(3)) + struct.pack(f"{order}B3I", 3, 0, 1, 2)
    (tmp_path / "b.ply").write_bytes(ply(body, *lines, form=form))
    mesh = read_mesh(tmp_path / "b.ply")
    np.testing.assert_array_equal(mesh.vertices_mm[:, 0], [0, 1, 2])
    np.testing.assert_array_equal(mesh.triangles, [[0, 1, 2]])


@pytest.mark.parametrize(
    ("body", "lines"),
    [
        (b"\n", ("comment caf\xe9", "element vertex 1", *XYZ)),
        (b"", ("", "element vertex 1", *XYZ)),
        (b"\1\2\3\4", ("element vertex 1", *XYZ, "property float x")),
        (b"\1\2\3\4\5\6\7\7", ("element vertex 1", *XYZ, "element view_pose 1", "property double m00")),
        (b"\4" + bytes(16) + b"\3" + bytes(12), ("element vertex 1", *XYZ, "element face 2", "property list uchar int corners")),
    ],
    ids=[
        "a byte too many, a comment in Latin-1",
        "a blank line",
        "two properties of one name",
        "an unknown element",
        "lists of two lengths",
    ],
)
def test_binary_ply_as_programs_write_it_is_read(tmp_path: Path, body: bytes, lines: tuple[str, ...]):
    header = ply(b"", *lines, form="binary_little_endian").decode().encode("latin-1")
    (tmp_path / "p.ply").write_bytes(header + struct.pack("<3f", 1, 2, 3) + body)
    np.testing.assert_array_equal(read_points(tmp_path / "p.ply").points_mm, [[1, 2, 3]])


def test_ascii_stl_and_obj_are_read(tmp_path: Path):
    facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1e0 0\nendloop\nendfacet\n"
    (tmp_path / "a.stl").write_text(f"solid s\n{facet}endsolid s\n")
    assert read_mesh(tmp_path / "a.stl").triangles.shape == (1, 3)
    (tmp_path / "a.obj").write_text("# c\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1 4//1\nf -4 -3 -2\n")
    np.testing.assert_array_equal(read_mesh(tmp_path / "a.obj").triangles, [[0, 1, 2], [0, 2, 3], [0, 1, 2]])


@pytest.mark.parametrize("layout", ["ascii", "binary"])
def test_pcd_is_read(tmp_path: Path, layout: str):
    header = f"# .PCD v0.7\nVERSION 0.7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA {layout}\n"
    body = b"1 2 3 0\n4 5 nan 0\n" if layout == "ascii" else struct.pack("<3fI3fI", 1, 2, 3, 0, 4, 5, float("nan"), 0)
    (tmp_path / "p.pcd").write_bytes(header.encode() + body)
    points = read_points(tmp_path / "p.pcd")
    np.testing.assert_allclose(points.points_mm, [[1, 2, 3]])
    assert points.dropped == 1


def test_text_points_with_commas_names_and_comments_are_read(tmp_path: Path):
    (tmp_path / "p.csv").write_text("x,y,z\n# a comment\n1,2,3\n4;5;6\n7 8 9\n")
    np.testing.assert_allclose(read_points(tmp_path / "p.csv").points_mm, [[1, 2, 3], [4, 5, 6], [7, 8, 9]])


def test_points_that_are_not_numbers_are_dropped_and_counted(tmp_path: Path):
    (tmp_path / "n.ply").write_bytes(ply(b"1 2 3\nnan 0 0\n0 inf 0\n1e30 0 0\n", "element vertex 4", *XYZ))
    points = read_cloud_or_mesh(tmp_path / "n.ply")
    assert isinstance(points, PlainPoints)
    assert len(points) == 1 and points.dropped == 3


def damaged() -> list[tuple[str, bytes]]:
    huge = "element vertex 1000000000000"
    cut_stl = b"x".ljust(80) + struct.pack("<I", 1000) + bytes(50 * 3)
    pcd = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nPOINTS 99999999999\nDATA {}\n"
    return [
        ("empty.ply", b""),
        ("garbage.ply", bytes(range(256)) * 4),
        ("noend.ply", b"ply\nformat ascii 1.0\nelement vertex 1\n"),
        ("huge_ascii.ply", ply(b"0 0 0\n", huge, *XYZ)),
        ("huge_binary.ply", ply(bytes(120), huge, *XYZ, form="binary_little_endian")),
        ("huge_list.ply", ply(b"\xff\xff\xff\x7f", "element vertex 1", "property list uint double x", form="binary_little_endian")),
        ("negative_list.ply", ply(b"\xff\xff\xff\xff", "element vertex 1", "property list int double x", form="binary_little_endian")),
        ("digits.ply", ply(b"0 0 0\n", "element vertex " + "9" * 5000, *XYZ)),
        ("nothing.ply", ply(b"", "element vertex 1000000000000")),
        ("words.ply", ply(b"0 0 zero\n", "element vertex 1", *XYZ)),
        ("kind.ply", ply(b"", "element vertex 1", "property quaternion x")),
        ("no_xyz.ply", ply(b"1\n", "element vertex 1", "property float x")),
        ("no_points.ply", ply(b"", "element vertex 0", *XYZ)),
        ("all_nan.ply", ply(b"nan nan nan\n", "element vertex 1", *XYZ)),
        ("corners.ply", ply(b"0 0 0\n3 0 1 99\n", "element vertex 1", *XYZ, "element face 1", "property list uchar int vertex_indices")),
        ("cut.stl", cut_stl),
        ("garbage.stl", b"\x00\x01\x02"),
        ("cut_ascii.stl", b"solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"),
        ("nan.stl", b"x".ljust(80) + struct.pack("<I", 1) + struct.pack("<12f", *[float("nan")] * 12) + b"\0\0"),
        ("garbage.obj", b"\x00\xff\n"),
        ("corners.obj", b"v 0 0 0\nf 1 2 3\n"),
        ("words.obj", b"v 0 zero 0\n"),
        ("huge_ascii.pcd", pcd.format("ascii").encode() + b"1 2 3\n"),
        ("huge_binary.pcd", pcd.format("binary").encode() + bytes(12)),
        ("compressed.pcd", pcd.format("binary_compressed").encode() + bytes(12)),
        ("header.pcd", b"FIELDS x y z\nDATA ascii\n1 2 3\n"),
        ("garbage.pcd", bytes(range(256))),
        ("words.xyz", b"1 2 3\n1 two 3\n"),
        ("columns.xyz", b"1 2 3\n1 2\n"),
        ("two.txt", b"1 2\n3 4\n"),
        ("garbage.xyz", bytes(range(256))),
        ("unknown.foo", b"1 2 3"),
    ]


@pytest.mark.parametrize(("name", "content"), damaged(), ids=[name for name, _ in damaged()])
def test_damaged_files_are_refused_with_their_name_and_a_remedy(tmp_path: Path, name: str, content: bytes):
    (tmp_path / name).write_bytes(content)
    with pytest.raises(InputError, match=name) as refusal:
        read_cloud_or_mesh(tmp_path / name)
    assert refusal.value.hint


@pytest.mark.parametrize("ending", ["ply", "stl"])
def test_a_mesh_file_cut_anywhere_is_refused(tmp_path: Path, tetrahedron: Mesh, ending: str):
    whole = tmp_path / f"m.{ending}"
    write_mesh(whole, tetrahedron)
    data = whole.read_bytes()
    for length in range(0, len(data) - 1, 7):
        cut = tmp_path / f"cut.{ending}"
        cut.write_bytes(data[:length])
        with pytest.raises(InputError, match="cut"):
            read_mesh(cut)


def test_a_file_that_does_not_exist_is_refused(tmp_path: Path):
    with pytest.raises(InputError, match="does not exist"):
        read_points(tmp_path / "none.ply")
    with pytest.raises(InputError, match="does not exist"):
        read_points(tmp_path)


def test_a_cloud_asked_for_as_a_mesh_is_refused(tmp_path: Path, view: PointCloud):
    write_cloud(tmp_path / "v.ply", view)
    with pytest.raises(InputError, match="no triangles"):
        read_mesh(tmp_path / "v.ply")


def test_nothing_half_written_is_left_where_writing_fails(tmp_path: Path, view: PointCloud, tetrahedron: Mesh):
    (tmp_path / "folder.ply").mkdir()
    with pytest.raises(StorageError):
        write_cloud(tmp_path / "folder.ply", view)
    with pytest.raises(InputError, match="not a format for meshes"):
        write_mesh(tmp_path / "m.obj", tetrahedron)
    assert [path.name for path in tmp_path.iterdir()] == ["folder.ply"]
