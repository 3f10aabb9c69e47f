from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest

from measureapp.data.fringe import PatternSet
from measureapp.data.pattern_sets import PATTERN_SETS
from measureapp.errors import DecodeError, InputError
from measureapp.fringe.decode import decode
from measureapp.fringe.patterns.draw import pattern_images
from measureapp.project.fringes.manifest import read_manifest
from measureapp.project.fringes.pattern_files import manifest_skeleton

EXPOSURES_US = (2000, 1000)


def recorded(folder: Path, patterns: PatternSet, cameras: tuple[str, ...] = ("left", "right")) -> Path:
    """Store what cameras in the projector's place see of the patterns, and the manifest of an export."""
    drawn = pattern_images(patterns, 1024, 768)[:, ::48, ::2]
    for camera in cameras:
        for share, exposure_us in enumerate(EXPOSURES_US, 1):
            place = folder / camera / str(exposure_us)
            place.mkdir(parents=True)
            for number, image in enumerate(drawn):
                cv2.imwrite(str(place / f"{number:03d}.png"), np.rint(image * (0.8 / share) + 20).astype(np.uint8))
    manifest = folder / "MANIFEST.toml"
    manifest.write_text(manifest_skeleton(patterns, cameras, EXPOSURES_US), encoding="utf-8")
    return manifest


@pytest.mark.parametrize("name", ["three-close", "complementary-gray", "complementary-gray-both"])
def test_recordings_of_exported_patterns_are_read_as_what_was_exported(name: str, tmp_path: Path) -> None:
    patterns = PATTERN_SETS[name]
    stack = read_manifest(recorded(tmp_path, patterns))
    assert stack.patterns.model_copy(update={"name": ""}) == patterns.model_copy(update={"name": ""})
    assert stack.exposures_us == EXPOSURES_US
    assert set(stack.images) == {"left", "right"}
    assert stack.images["left"].shape == (2, patterns.count, 16, 512)
    assert np.array_equal(stack.images["left"][0, :, :, 5] > 127, pattern_images(patterns, 1024, 768)[:, ::48, 10] * 0.8 + 20 > 127)


def test_recordings_of_exported_patterns_decode_to_the_columns(tmp_path: Path) -> None:
    maps = decode(read_manifest(recorded(tmp_path, PATTERN_SETS["three-close"])))
    for phase_map in maps.values():
        assert phase_map.valid.mean() > 0.99
        assert np.abs(phase_map.column_px - np.arange(0, 1024, 2))[phase_map.valid].max() < 0.06


def test_horizontal_groups_may_be_named_first(tmp_path: Path) -> None:
    patterns = PATTERN_SETS["paper-both"]
    manifest = recorded(tmp_path, patterns, ("left",))
    wanted = read_manifest(manifest)
    head, *exposures = manifest.read_text().split("[[exposure]]")
    turned = []
    for exposure in exposures:
        time, *groups = exposure.split("  [[exposure.group]]")
        turned.append("  [[exposure.group]]".join([time, *(group.rstrip("\n") + "\n" for group in reversed(groups))]))
    manifest.write_text("[[exposure]]".join([head, *turned]))
    # the groups of one direction keep the order they have in the file
    found = read_manifest(manifest)
    assert [group.direction for group in found.patterns.groups] == ["vertical", "vertical", "horizontal", "horizontal"]
    assert found.patterns.pitches_px == tuple(wanted.patterns.pitches_px[i] for i in (1, 0, 3, 2))
    assert np.array_equal(found.images["left"][:, 0:4], wanted.images["left"][:, 4:8])


def test_periods_of_horizontal_fringes_fill_the_rows(tmp_path: Path) -> None:
    manifest = recorded(tmp_path, PATTERN_SETS["paper-both"], ("left",))
    text = manifest.read_text().replace("pitch_px = 28.0", "periods = 24").replace("pitch_px = 29.0", "periods = 23.5")
    manifest.write_text(text)
    assert read_manifest(manifest).patterns.subset("horizontal")[0].pitches_px == (768 / 24, 768 / 23.5)
    manifest.write_text(text.replace("projector_rows = 768\n", ""))
    with pytest.raises(InputError, match="needs `projector_rows`"):
        read_manifest(manifest)


def test_where_no_rows_are_given_the_beat_of_horizontal_pitches_is_taken(tmp_path: Path) -> None:
    manifest = recorded(tmp_path, PATTERN_SETS["paper-both"], ("left",))
    manifest.write_text(manifest.read_text().replace("projector_rows = 768\n", ""))
    assert read_manifest(manifest).patterns.projector_rows == 28 * 29


@pytest.mark.parametrize(
    ("old", "new", "error", "reason"),
    [
        ("steps = 4", "steps = 5", InputError, "has 4 images but steps = 5"),
        ("planes = 7", "planes = 8", InputError, "has 7 images but planes = 8"),
        ('"left/2000/003.png"', '"./left/../left/2000/002.png"', InputError, "more than once"),
        ("left/2000/00", "left/2000/99", InputError, "99[0-9].png cannot be read: it does not exist, and 9 more of the 88"),
        ("left/1000/001.png", r"left/\\u0000.png", InputError, "does not exist"),
        ('direction = "horizontal"', 'direction = "oblique"', InputError, "direction"),
        ("projector_rows = 768", "projector_rows = 0", InputError, "projector_rows"),
        ("projector_rows = 768", "projector_rows = 7680", DecodeError, "7680 rows"),
        ("projector_rows = 768", "projector_lines = 768", InputError, "projector_lines: is not a known field"),
        ('  direction = "vertical"\n', '  direction = "vertical"\n  projector_px = 1000\n', InputError, "different projector_px"),
        ("pitch_px = 16.0", "pitch_px = 16.0\n  step = 4", InputError, "step: is not a known field"),
        (
            '  direction = "horizontal"\n',
            '  direction = "horizontal"\n  projector_px = 768\n',
            InputError,
            "horizontal fringes has projector_px",
        ),
    ],
)
def test_a_manifest_that_cannot_be_right_is_refused(old: str, new: str, error: type[Exception], reason: str, tmp_path: Path) -> None:
    manifest = recorded(tmp_path, PATTERN_SETS["complementary-gray-both"])
    text = manifest.read_text()
    assert old in text
    manifest.write_text(text.replace(old, new.replace("\\\\", "\\")))
    with pytest.raises(error, match=reason) as raised:
        read_manifest(manifest)
    assert raised.value.hint


def test_an_image_of_another_depth_is_refused_by_its_name(tmp_path: Path) -> None:
    manifest = recorded(tmp_path, PATTERN_SETS["paper"])
    odd = tmp_path / "right" / "1000" / "005.png"
    cv2.imwrite(str(odd), cv2.imread(str(odd), cv2.IMREAD_UNCHANGED).astype(np.uint16) * 16)
    with pytest.raises(InputError, match=r"right/1000/005\.png has 16 bit"):
        read_manifest(manifest)


def test_of_several_bad_images_the_first_is_named(tmp_path: Path) -> None:
    manifest = recorded(tmp_path, PATTERN_SETS["paper"], ("left",))
    for number in range(7, 2, -1):
        (tmp_path / "left" / "2000" / f"{number:03d}.png").write_bytes(b"nothing")
    for _ in range(5):
        with pytest.raises(InputError, match=r"2000/003\.png"):
            read_manifest(manifest)
