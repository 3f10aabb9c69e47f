"""The slow proofs by one command: each file once, kept while its sources are the same, and stated in one table."""

from __future__ import annotations

import importlib
import json
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import pytest

INSTALLER = Path(__file__).resolve().parents[2] / "installer"
FILES = ("tests/benchmarks/test_views.py", "tests/pipeline/test_seeds.py")
COVERAGE = {"group": "gypsum-usual", "measurements": 3, "dimensions": 12, "inside": 11, "largest_error_mm": 0.0361, "median_u_mm": 0.0702}
PROVEN = '<testcase name="test_one" time="2.5"><properties><property name="rms, mm" value="0.0123"/></properties></testcase>'
WRONG = '<testcase name="test_two" time="1"><failure message="too far"/></testcase>'


class Checkout:
    """A checkout with two files of proofs, and a Python that answers for pytest and the campaign."""

    def __init__(self, proofs: ModuleType, root: Path) -> None:
        self.proofs, self.root, self.folder = proofs, root, root / "proofs"
        self.started: list[str] = []
        self.cases, self.interrupted, self.unmeasured = {FILES[0]: PROVEN, FILES[1]: PROVEN}, "", {}
        for file in FILES:
            (root / file).parent.mkdir(parents=True)
            (root / file).write_text("def test_one(): ...\n")

    def run(self, arguments: list[str]) -> int:
        """Do what the environment's Python would."""
        if "--collect-only" in arguments:
            Path(arguments[2]).write_text("".join(f"{file}::test_one\n{file}::test_two\n" for file in FILES) + "\n2 tests collected\n")
            return 0
        if "campaign" in arguments:
            Path(arguments[2]).write_text(json.dumps({"coverage": [COVERAGE], "failed": self.unmeasured}))
            return 1
        file = arguments[-1]
        if file == self.interrupted:
            raise KeyboardInterrupt
        self.started.append(file)
        options = dict(argument.split("=", 1) for argument in arguments if "=" in argument)
        Path(options["--junit-xml"]).write_text(f"<testsuites><testsuite>{self.cases[file]}</testsuite></testsuites>")
        if "--benchmark-json" in options:
            speed = {"name": "test_one", "stats": {"median": 0.0112}, "extra_info": {"ratio": 1.25}}
            Path(options["--benchmark-json"]).write_text(json.dumps({"benchmarks": [speed]}))
        return int("failure" in self.cases[file])

    def proven(self, *rooms: str) -> tuple[int, list[str]]:
        """Run the proofs; return the exit code and the files that were run."""
        self.started = []
        return self.proofs.prove(self.root, self.folder, rooms, self.run), self.started

    @property
    def table(self) -> str:
        return (self.folder / "proofs.md").read_text(encoding="utf-8")


@pytest.fixture
def checkout(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[Checkout]:
    monkeypatch.syspath_prepend(str(INSTALLER))
    yield Checkout(importlib.import_module("proofs"), tmp_path)
    for name in ("proofs", "machine", "trouble"):
        sys.modules.pop(name, None)


def test_accuracy_coverage_and_speed_stand_in_one_table(checkout) -> None:
    assert checkout.proven() == (0, list(FILES))
    assert "| gypsum-usual, 3 seeds | 12 | 11 | 0.0361 mm | 0.0702 mm |" in checkout.table
    assert "| pipeline.test_seeds: test_one | rms, mm | 0.0123 |" in checkout.table
    assert "| benchmarks.test_views: test_one | median, ms | 11.2 |" in checkout.table
    assert "| benchmarks.test_views: test_one | ratio | 1.25 |" in checkout.table
    document = json.loads((checkout.folder / "proofs.json").read_text())
    assert [one["proofs"][0]["outcome"] for one in document["proofs"]] == ["passed", "passed"]
    assert document["coverage"] == [COVERAGE]


def test_an_interrupted_run_goes_on_where_it_was(checkout) -> None:
    checkout.interrupted = FILES[1]
    with pytest.raises(KeyboardInterrupt):
        checkout.proven()
    assert "1 of 2 files have run" in checkout.table
    checkout.interrupted = ""
    assert checkout.proven() == (0, [FILES[1]])
    assert checkout.proven() == (0, [])
    assert "2 of 2 files have run" in checkout.table


def test_a_changed_source_makes_every_proof_run_again_and_says_how_long(checkout, capsys) -> None:
    checkout.proven()
    (checkout.root / FILES[0]).write_text("def test_one(): assert True\n")
    capsys.readouterr()
    assert checkout.proven() == (0, list(FILES))
    assert "min left" in capsys.readouterr().out


def test_what_failed_is_named_and_runs_again(checkout) -> None:
    checkout.cases[FILES[1]] = PROVEN + WRONG
    assert checkout.proven()[0] == 1
    assert f"- `{FILES[1]}`: test_two" in checkout.table
    assert "| pipeline | 1 | 1 | 0 |" in checkout.table
    checkout.cases[FILES[1]] = PROVEN
    assert checkout.proven() == (0, [FILES[1]])
    assert "## Failed" not in checkout.table


def test_a_measurement_without_a_result_fails_the_proofs(checkout) -> None:
    checkout.unmeasured = {"gypsum-bad-1": "no board was found"}
    assert checkout.proven()[0] == 1
    assert checkout.proven("pipeline")[0] == 0  # rooms alone need no campaign


def test_an_unknown_room_is_refused_by_the_names_of_those_that_exist(checkout) -> None:
    with pytest.raises(checkout.proofs.SetupTrouble) as caught:
        checkout.proven("pipelin")
    assert "tests/pipelin" in caught.value.message
    assert caught.value.remedy == "Name one of: benchmarks, pipeline."
    assert not checkout.folder.exists()
