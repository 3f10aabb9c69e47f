"""Tessellation of a STEP file as a separate program: `python step_worker.py in.step out.npz CHORD_MM ANGLE_RAD BYTES`.

Started by `measureapp.project.geometry.step_files`. It imports nothing from the application, so that it starts from its file alone.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

EXIT_OUT_OF_MEMORY, EXIT_NO_SURFACE = 3, 4
MM_PER_GLTF_UNIT = 1000.0  # glTF 2.0 is in metres; OpenCASCADE converts from the unit of the file


def main(arguments: list[str]) -> int:
    """Write vertices in mm (V, 3) and triangles (T, 3) of the STEP file to the npz file; return the exit code."""
    source, target, chord_mm, angle_rad, limit = arguments
    _limit_memory(int(limit))
    import cascadio
    import trimesh

    try:
        made = cascadio.to_glb_bytes(
            Path(source).read_bytes(), cascadio.FileType.STEP, float(chord_mm), float(angle_rad), False, use_parallel=False
        )
        if not made:
            return EXIT_NO_SURFACE
        scene = trimesh.load_scene(trimesh.util.wrap_as_stream(made), file_type="glb")
        mesh = scene.to_mesh() if len(scene.geometry) else trimesh.Trimesh()
        if len(mesh.faces) == 0:
            return EXIT_NO_SURFACE
        np.savez(target, vertices=np.asarray(mesh.vertices) * MM_PER_GLTF_UNIT, triangles=np.asarray(mesh.faces))
    except MemoryError:
        return EXIT_OUT_OF_MEMORY
    return 0


def _limit_memory(limit_bytes: int) -> None:
    """Limit the address space to ``limit_bytes``; not available on Windows."""
    try:
        import resource
    except ImportError:
        return
    resource.setrlimit(resource.RLIMIT_AS, (limit_bytes, limit_bytes))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
