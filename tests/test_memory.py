"""What a program may use is the least of what the computer has and what its groups of processes leave."""

from __future__ import annotations

from pathlib import Path

import psutil
import pytest

from measureapp.memory import available_bytes

MIB = 2**20


def group(folder: Path, **files: str) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in files.items():
        (folder / name.replace("__", ".")).write_text(text)


def of_version_2(folder: Path, most: str, used: int, cache: int) -> None:
    group(folder, memory__max=f"{most}\n", memory__current=f"{used}\n", memory__stat=f"anon 5\ninactive_file {cache}\n")


def test_a_container_of_version_2_limits_what_is_available_and_its_file_cache_counts_as_free(tmp_path: Path) -> None:
    (tmp_path / "own").write_text("0::/\n")
    of_version_2(tmp_path, str(100 * MIB), 70 * MIB, 20 * MIB)
    assert available_bytes(tmp_path, tmp_path / "own") == 50 * MIB


def test_the_tightest_of_the_groups_above_counts(tmp_path: Path) -> None:
    (tmp_path / "own").write_text("0::/users/one/program\n")
    of_version_2(tmp_path / "users" / "one" / "program", "max", 70 * MIB, 0)
    of_version_2(tmp_path / "users" / "one", str(90 * MIB), 80 * MIB, 0)
    of_version_2(tmp_path / "users", str(100 * MIB), 20 * MIB, 0)
    assert available_bytes(tmp_path, tmp_path / "own") == 10 * MIB


def test_a_container_of_version_1_limits_it_too_and_more_than_its_limit_leaves_nothing(tmp_path: Path) -> None:
    (tmp_path / "own").write_text("3:cpu,cpuacct:/docker/1\n9:memory:/docker/1\n")
    files = {"memory__limit_in_bytes": str(50 * MIB), "memory__usage_in_bytes": str(60 * MIB), "memory__stat": "total_inactive_file 1000\n"}
    group(tmp_path / "memory", **files)
    assert available_bytes(tmp_path, tmp_path / "own") == 0


@pytest.mark.parametrize("own", ["0::/somewhere\n", ""])
def test_without_a_limit_it_is_what_the_computer_has(tmp_path: Path, own: str) -> None:
    (tmp_path / "own").write_text(own)
    there = psutil.virtual_memory()
    assert 0 < available_bytes(tmp_path, tmp_path / "own") <= there.total
    assert 0 < available_bytes(tmp_path, tmp_path / "absent") <= there.total
