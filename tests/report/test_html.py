"""The HTML report: one file, everything escaped, with a 3-D view of the measured surface."""

from __future__ import annotations

import base64
import json
import re
import shutil
import subprocess
from dataclasses import replace

import numpy as np
import pytest

from measureapp.data.identification import Identification
from measureapp.data.mesh import Mesh
from measureapp.report.compose import compose
from measureapp.report.html import html_text
from measureapp.report.model import Details
from measureapp.report.viewer import LARGEST, MISSING, MOST_TRIANGLES, scene_document, simplify
from measureapp.resources import resource

NASTY = "</script><script>alert(1)</script> <img src=x onerror=alert(2)> 件"
LARGEST_VIEWER_BYTES = 30_000


@pytest.fixture(scope="module")
def model(measured, block):
    first, *rest = measured().inspection.dimensions
    details = Details(Identification(part_name=NASTY, remarks=NASTY))
    return compose(measured((replace(first, name=NASTY), *rest)), block, details=details, pictures=False)


def scene(html: str) -> dict:
    return json.loads(re.search(r'id="scene">(.*?)</script>', html, re.DOTALL)[1])


def numbers(text: str, kind: str) -> np.ndarray:
    return np.frombuffer(base64.b64decode(text), kind)


def test_nothing_a_user_typed_becomes_markup_or_script(model) -> None:
    html = html_text(model)
    assert html.count("<script") == 2 and "<img src=x" not in html
    assert "&lt;/script&gt;" in html


def test_the_page_loads_nothing_from_anywhere(model) -> None:
    html = html_text(model)
    assert "default-src &#39;none&#39;" in html or "default-src 'none'" in html
    assert not re.search(r"""(src|href)\s*=\s*["']?(https?:)?//""", html) and "@import" not in html
    assert "fetch(" not in html and "XMLHttpRequest" not in html and "import(" not in html


def test_the_surface_comes_back_within_a_step_of_its_numbers(model, block) -> None:
    found = scene(html_text(model))
    points = numbers(found["points"], "<i2").reshape(-1, 3).astype(float)
    triangles = numbers(found["triangles"], "<u4").reshape(-1, 3)
    mesh = model.measurement.mesh
    assert np.array_equal(triangles, mesh.triangles)
    radius = np.linalg.norm([40, 30, 20]) / 0.92
    assert np.abs(points / LARGEST * radius - mesh.vertices_mm).max() < radius / LARGEST
    values = numbers(found["values"], "<i2")
    assert np.array_equal(values == MISSING, ~mesh.measured)
    assert np.abs(values[mesh.measured] * found["unit_mm"]).max() < 1e-3  # the block is measured as it is designed


def test_dimensions_and_flags_point_to_each_other(measured, block) -> None:
    from measureapp.data.feature import Feature

    made = measured()
    feature = Feature("top", "plane", np.array([0.0, 0, 20]), np.array([0.0, 0, 1]), boundary_mm=np.array([[-40.0, -30, 20], [40, 30, 20]]))
    dimensions = tuple(replace(one, features=("top",)) for one in made.inspection.dimensions[:2])
    inspection = replace(made.inspection, features=(feature,), dimensions=dimensions)
    html = html_text(compose(replace(made, inspection=inspection), block, pictures=False))
    assert 'data-flag="0"' in html and 'data-flag="1"' in html
    flags = scene(html)["flags"]
    assert [flag["always"] for flag in flags] == [False, True]  # a failing dimension is always shown
    assert flags[0]["at"][2] > 0.3


def test_a_large_mesh_is_simplified_and_a_missing_one_leaves_the_picture(measured) -> None:
    side = 330
    grid = np.stack(np.meshgrid(np.arange(side), np.arange(side)), axis=-1).reshape(-1, 2)
    corner = np.arange(side * (side - 1)).reshape(-1, side)[:, :-1].ravel()
    triangles = np.concatenate(
        [np.stack([corner, corner + 1, corner + side], 1), np.stack([corner + 1, corner + side + 1, corner + side], 1)]
    )
    mesh = Mesh(np.column_stack([grid, np.zeros(len(grid))]).astype(float), triangles, "part", grid[:, 0] < 100)
    assert len(triangles) > MOST_TRIANGLES
    simpler = simplify(mesh)
    assert len(simpler.triangles) <= MOST_TRIANGLES and 0.2 < simpler.measured.mean() < 0.4
    model = compose(measured(mesh=False), pictures=False)
    assert scene_document(model) is None and scene(html_text(model)) is None


def test_the_viewer_is_small_and_its_script_is_valid() -> None:
    viewer = resource("report/viewer.js")
    assert viewer.stat().st_size < LARGEST_VIEWER_BYTES
    node = shutil.which("node")
    if node is None:
        pytest.skip("needs node, to check the script")
    subprocess.run([node, "--check", str(viewer)], check=True, timeout=30)
