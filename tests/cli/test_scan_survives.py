"""`scan` when its disk is full or its folder gone, and the options that take viewpoints again or probe each of them."""

from __future__ import annotations

import io
import json
import re
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from measureapp.cli import main
from measureapp.data.fringe import FringeStack
from measureapp.data.plan import ExposureBracket
from measureapp.errors import StorageError
from measureapp.planning.viewpoints import plan_around_part
from measureapp.project.frame_store import FrameStore
from measureapp.project.rig_file import read_rig
from tests.cli.rig_files import write_binned_rig

Words = Callable[..., list[str]]


@pytest.fixture
def words(tmp_path: Path) -> Words:
    """The words of the command, for three viewpoints between which only the table turns."""
    plan = plan_around_part(read_rig("paper"), "plan", radius_mm=100, height_mm=80, count=4)
    viewpoints = tuple(plan.viewpoints[0].model_copy(update={"id": f"v{index}", "table_deg": 90.0 * index}) for index in range(3))
    changed = plan.model_copy(update={"viewpoints": viewpoints, "bracket": ExposureBracket(exposures_us=(40_000,))})
    (tmp_path / "plan.json").write_text(changed.model_dump_json(), encoding="utf-8")
    rig = write_binned_rig(tmp_path / "rig.toml", 'part = "gypsum", seed = 1', binning=8)
    base = ["scan", str(tmp_path / "plan.json"), "--rig", str(rig), "--project", str(tmp_path / "project"), "--json"]
    return lambda *more: [*base, *more]


@pytest.fixture
def at_store(monkeypatch: pytest.MonkeyPatch) -> list[tuple[str, Callable[[FringeStack], None]]]:
    """What happens instead, or after, when a viewpoint is stored: "before" or "after" with a function, used up one by one."""
    plans: list[tuple[str, Callable[[FringeStack], None]]] = []
    genuine = FrameStore.store

    def store(self: FrameStore, stack: FringeStack) -> Any:
        when, function = plans.pop(0) if plans else ("after", lambda _: None)
        if when == "before":
            function(stack)
        result = genuine(self, stack)
        if when == "after":
            function(stack)
        return result

    monkeypatch.setattr(FrameStore, "store", store)
    return plans


class Keyboard(io.StringIO):
    """A terminal at which a person types these lines."""

    def isatty(self) -> bool:
        return True


def answer(words: list[str], capsys: pytest.CaptureFixture[str]) -> tuple[int, dict[str, Any], str]:
    code = main(words)
    captured = capsys.readouterr()
    return code, json.loads(captured.out), captured.err


def nothing(stack: FringeStack) -> None:
    """Nothing happens."""


def full(stack: FringeStack) -> None:
    raise StorageError("The disk is full.", "Free some space.")


ALSO = [pytest.param(False, gone, marks=pytest.mark.slow) for gone in ("", "stacks")]  # noticed as the view that was removed


@pytest.mark.parametrize(("last", "gone"), [(True, ""), (True, "stacks"), (True, "stacks/v0"), (False, "stacks/v0"), *ALSO])
def test_a_project_or_a_folder_in_it_that_is_removed_during_a_scan_is_no_success(
    last, gone, words: Words, at_store, tmp_path: Path, capsys
) -> None:
    at_store += [("after", nothing)] * (2 if last else 1) + [("after", lambda _: shutil.rmtree(tmp_path / "project" / gone))]
    code, document, said = answer(words(), capsys)
    assert code == 2
    assert document["error"]["type"] == "StorageError"
    assert "gone" in document["error"]["message"]
    assert "The images are stored" not in said


def test_without_a_person_a_full_disk_ends_the_scan_and_says_how_to_go_on(words: Words, at_store, capsys) -> None:
    at_store += [("after", nothing), ("before", full)]
    code, document, said = answer(words(), capsys)
    assert (code, document["error"]["message"]) == (2, "The disk is full.")
    assert (
        "1 of 3 viewpoints are stored and kept; not v1, v2. Continue the run to take the missing ones. Run the same command with --resume."
        in said
    )
    code, document, _ = answer(words("--resume"), capsys)
    assert (code, [view["state"] for view in document["views"]]) == (0, ["stored"] * 3)


def test_at_a_terminal_a_full_disk_pauses_the_scan_and_enter_stores_the_very_images(
    words: Words, at_store, tmp_path: Path, capsys, monkeypatch
) -> None:
    refused: list[FringeStack] = []
    monkeypatch.setattr("sys.stdin", Keyboard("\n"))
    at_store += [("after", nothing), ("before", lambda stack: (refused.append(stack), full(stack)))]  # type: ignore[list-item]
    code, document, said = answer(words(), capsys)
    assert (code, document["ended"], [view["state"] for view in document["views"]]) == (0, "done", ["stored"] * 3)
    assert "Paused: The disk is full. Free some space. The images of v1 are in memory" in said
    assert "Press Enter to go on, or Ctrl-C to stop." in said
    assert re.search(r"v0: stored; \d+ s left, \d+ s at most\n", said)
    assert said.rstrip().endswith("v2: stored")
    for camera, images in refused[0].images.items():
        assert np.array_equal(np.load(tmp_path / "project" / "stacks" / "v1" / f"{camera}.npy"), images)


def test_a_viewpoint_is_taken_again_on_request_and_no_other_one(words: Words, tmp_path: Path, capsys) -> None:
    assert answer(words(), capsys)[0] == 0
    image = {name: tmp_path / "project" / "stacks" / name / "left.npy" for name in ("v0", "v1", "v2")}
    before = {name: path.stat().st_mtime_ns for name, path in image.items()}
    code, document, _ = answer(words("--retake", "v1"), capsys)
    assert (code, [view["state"] for view in document["views"]]) == (0, ["stored"] * 3)
    assert {name for name, path in image.items() if path.stat().st_mtime_ns != before[name]} == {"v1"}
    code, document, _ = answer(words("--retake", "v9"), capsys)
    assert (code, document["error"]["message"]) == (2, "The plan has no viewpoint 'v9'.")


def test_exposures_are_chosen_at_every_viewpoint_and_kept_with_its_images(words: Words, tmp_path: Path, capsys) -> None:
    code, document, said = answer(words("--auto-bracket", "4", "--per-viewpoint"), capsys)
    assert code == 0, document
    chosen = [line for line in said.splitlines() if "Exposures chosen" in line]
    assert [line.split(":")[0] for line in chosen] == ["v0", "v1", "v2"]
    store = FrameStore(tmp_path / "project" / "stacks")
    for name, line in zip(("v0", "v1", "v2"), chosen, strict=True):
        exposures = ", ".join(f"{exposure / 1000:g}" for exposure in store.load(name).exposures_us)
        assert f"Exposures chosen: {exposures} ms" in line
    code, document, _ = answer(words("--per-viewpoint"), capsys)
    assert (code, document["error"]["hint"]) == (2, "Add --auto-bracket SECONDS.")


def test_a_scan_with_exposures_of_its_own_is_continued(words: Words, tmp_path: Path, capsys) -> None:
    assert answer(words("--auto-bracket", "4"), capsys)[0] == 0
    assert main(["discard", str(tmp_path / "project"), "v2"]) == 0
    capsys.readouterr()
    code, document, _ = answer(words("--auto-bracket", "4", "--resume"), capsys)
    assert (code, [view["state"] for view in document["views"]]) == (0, ["stored"] * 3)
    store = FrameStore(tmp_path / "project" / "stacks")
    assert store.load("v2").exposures_us == store.load("v0").exposures_us
