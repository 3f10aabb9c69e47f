"""Poisson reconstruction as a stand-alone program: `python poisson_worker.py in.npz out.npz`, started by `measureapp.register.surface.poisson`.

It imports nothing of the application.
"""

from __future__ import annotations

import sys
from types import ModuleType

import numpy as np

EXIT_OUT_OF_MEMORY = 3
VIEWERS = "open3d.visualization"


def main(arguments: list[str]) -> int:
    """Read points, normals, depth and scale from the first file, write vertices and triangles to the second; returns the exit code."""
    sys.modules[VIEWERS] = ModuleType(VIEWERS)  # as `measureapp.open3d_library`: without them it starts in half the time
    import open3d as o3d

    source, target = arguments
    with np.load(source) as given:
        cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(given["points"]))
        cloud.normals = o3d.utility.Vector3dVector(given["normals"])
        depth, scale = int(given["depth"]), float(given["scale"])
    try:
        made, _ = o3d.geometry.TriangleMesh.create_from_point_cloud_poisson(cloud, depth=depth, scale=scale)
        np.savez(target, vertices=np.asarray(made.vertices), triangles=np.asarray(made.triangles))
    except MemoryError:
        return EXIT_OUT_OF_MEMORY
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
