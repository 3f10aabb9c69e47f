"""Open3D comes without its viewers, and does what the program asks of it."""

from __future__ import annotations

import subprocess
import sys

CODE = """
import sys
import numpy as np
from measureapp.open3d_library import open3d

tensor = open3d().core.Tensor.from_numpy
scene = open3d().t.geometry.RaycastingScene()
scene.add_triangles(tensor(np.eye(3, dtype=np.float32)), tensor(np.array([[0, 1, 2]], np.uint32)))
hit = scene.cast_rays(tensor(np.array([[0, 0, 0, 1, 1, 1]], np.float32)))["t_hit"].numpy()
import open3d as again
assert again is open3d()
print(round(float(hit[0]), 6), sorted({"dash", "plotly", "IPython"} & set(sys.modules)))
"""


def test_the_library_is_imported_without_its_viewers() -> None:
    done = subprocess.run([sys.executable, "-c", CODE], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "0.333333 []"


def test_another_thread_that_imports_meanwhile_does_not_fail_the_import(tmp_path) -> None:
    (tmp_path / "open3d").mkdir()
    text = 'import sys\nsys.trials = getattr(sys, "trials", 0) + 1\nif sys.trials < 3:\n    raise RuntimeError("dictionary changed size during iteration")\n'
    (tmp_path / "open3d" / "__init__.py").write_text(text, encoding="utf-8")
    code = f"import sys; sys.path.insert(0, {str(tmp_path)!r}); from measureapp.open3d_library import open3d; print(open3d().__name__, sys.trials)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "open3d 3"
