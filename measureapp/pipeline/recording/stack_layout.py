"""What a manifest of recorded fringe images says about them, and whether it fits the rig."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from measureapp.data.fringe import PatternSet
from measureapp.data.rig import RigDescription
from measureapp.pipeline.recording.images import check_image
from measureapp.pipeline.recording.problems import Problems
from measureapp.project.fringes.manifest import manifest_files, parse_manifest, read_layout
from measureapp.project.images import read_image


@dataclass(frozen=True, slots=True, eq=False)
class StackLayout:
    """Fringe images of one viewpoint, not yet read."""

    manifest: Path
    patterns: PatternSet
    exposures_us: tuple[int, ...]  # from long to short
    cameras: tuple[str, ...]
    first_images: tuple[tuple[str, Path], ...]  # camera -> its first image
    files: tuple[Path, ...]
    projector_px: int | None  # as the manifest states it
    projector_rows: int | None
    saturation: int | None

    @property
    def images(self) -> int:
        """Number of images of one camera."""
        return self.patterns.count * len(self.exposures_us)


def read_stack_layout(path: Path) -> StackLayout:
    """Read a manifest without its images, which must exist. Raises InputError, DecodeError as `read_manifest`."""
    patterns, cameras = read_layout(path)
    manifest = parse_manifest(path)
    first = manifest.exposure[0].group[0].images
    return StackLayout(
        manifest=path,
        patterns=patterns,
        exposures_us=tuple(sorted((entry.exposure_us for entry in manifest.exposure), reverse=True)),
        cameras=cameras,
        first_images=tuple((camera, path.parent / files[0]) for camera, files in first.items()),
        files=manifest_files(path),
        projector_px=manifest.projector_px,
        projector_rows=manifest.projector_rows,
        saturation=manifest.saturation,
    )


def check_layout(viewpoint_id: str, layout: StackLayout, rig: RigDescription, problems: Problems) -> None:
    """Note where a manifest contradicts the rig: cameras, size of the projector, bit depth, and the first image of every camera."""
    place, cameras = f"viewpoint {viewpoint_id!r}", {camera.name: camera for camera in rig.cameras}
    if set(layout.cameras) != set(cameras):
        problems.note(
            f"{place}: {layout.manifest} has the cameras {', '.join(sorted(layout.cameras))}, the rig has {', '.join(sorted(cameras))}.",
            "Give the images of all cameras of the rig, under their names.",
        )
        return
    for word, stated, size in (
        ("projector_px", layout.projector_px, rig.projector.width_px),
        ("projector_rows", layout.projector_rows, rig.projector.height_px),
    ):
        if stated is not None and stated > size:
            problems.note(
                f"{place}: {layout.manifest} has {word} = {stated}, the rig's projector has {rig.projector.width_px} × "
                f"{rig.projector.height_px} px.",
                "Correct the manifest, or the projector in the rig description.",
            )
    brightest = min(camera.saturation for camera in rig.cameras)
    if layout.saturation is not None and layout.saturation > brightest + 1:
        problems.note(
            f"{place}: {layout.manifest} has saturation = {layout.saturation}, the rig's cameras reach {brightest}.",
            "Correct saturation in the manifest, or bit_depth in the rig description.",
        )
    for camera, file in layout.first_images:
        with problems.gathered():
            check_image(place, file, read_image(file), cameras[camera])
