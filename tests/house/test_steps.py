"""The commands of the set-up: run and test."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace

import pytest

INSTALLER = Path(__file__).resolve().parents[2] / "installer"


@pytest.fixture
def called(installer, monkeypatch, tmp_path):
    """Return the commands a step starts; nothing is set up."""
    commands: list[list[str]] = []
    codes: dict[str, int] = {}
    variables: list[dict[str, str]] = []
    started: list[list[str]] = []

    class Started:
        def terminate(self):
            started.append(["terminated"])

        def wait(self):
            pass

    def call(command, home, more=None):
        commands.append([Path(command[0]).stem, *command[1:]])
        variables.append(more or {})
        return codes.get(Path(command[0]).stem, 0)

    monkeypatch.setattr(installer.steps, "_call", call)
    monkeypatch.setattr(installer.system_libraries, "ensure", lambda screen: None)
    monkeypatch.setattr(installer.environment, "ensure", lambda: installer.environment.Environment(tmp_path))
    monkeypatch.setattr(installer.steps.subprocess, "Popen", lambda command, **_rest: started.append(command) or Started())
    return SimpleNamespace(started=started, commands=commands, codes=codes, variables=variables)


def test_run_opens_the_window_on_a_screen_and_runs_the_demo_without(installer, called, monkeypatch) -> None:
    for screen in (True, False):
        monkeypatch.setattr(installer.steps, "has_screen", lambda screen=screen: screen)
        assert installer.steps.perform("run", ["--extra"]) == 0
    assert called.commands == [
        ["measureapp", "gui", "--demo", "--extra"],
        ["measureapp", "demo", "--resolution", "quarter", "--out", str(INSTALLER.parent / "demo-gypsum-quarter"), "--extra"],
    ]


@pytest.mark.parametrize("compiled", [False, True])
def test_the_first_demo_finds_the_kernels_compiled_by_a_process_beside_it(installer, called, monkeypatch, tmp_path, compiled) -> None:
    monkeypatch.setattr(installer.steps, "has_screen", lambda: False)
    monkeypatch.setattr(installer.environment, "ROOT", tmp_path)
    if compiled:
        cache = tmp_path / "measureapp" / "fringe" / "__pycache__"
        cache.mkdir(parents=True)
        (cache / "vote.nbi").touch()
    assert installer.steps.perform("run", []) == 0
    assert [command[-1] for command in called.started] == ([] if compiled else [installer.steps.COMPILE_KERNELS, "terminated"])


def test_a_screen_is_seen_by_its_variables(installer, monkeypatch) -> None:
    monkeypatch.setattr(installer.steps.sys, "platform", "linux")
    for name, value in (("DISPLAY", ""), ("WAYLAND_DISPLAY", "")):
        monkeypatch.setenv(name, value)
    assert not installer.steps.has_screen()
    monkeypatch.setenv("WAYLAND_DISPLAY", "wayland-0")
    assert installer.steps.has_screen()


def test_test_runs_every_check_and_returns_the_worst(installer, called, capsys) -> None:
    called.codes.update(mypy=1, python=2)
    assert installer.steps.perform("test", ["-k", "one"]) == 2
    assert [command[0] for command in called.commands] == ["ruff", "ruff", "mypy", "lint-imports", "python"]
    assert called.commands[-1] == ["python", "-m", "pytest", "-k", "one"]
    assert "failed (2)" in capsys.readouterr().out


@pytest.mark.parametrize(("workers", "shared"), [(1, []), (3, ["-n", "3", "--dist", "loadfile", "--no-loadscope-reorder"])])
def test_the_whole_suite_compiles_first_and_runs_in_as_many_processes_as_there_is_room_for(
    installer, called, monkeypatch, capsys, workers, shared
) -> None:
    monkeypatch.setattr(installer.machine, "workers", lambda: workers)
    assert installer.steps.perform("test", []) == 0
    usual = ["-m", "not slow and not timed"] if shared else []
    timed = [["python", "-m", "pytest", *installer.steps._timed_files(), "-m", "timed and not slow", *shared]] if shared else []
    assert called.commands[-1 - len(timed) :] == [["python", "-m", "pytest", *shared, *usual], *timed]
    assert ["python", "-c", installer.steps.COMPILE_KERNELS] in called.commands[:-1]
    assert "kernels       passed" in capsys.readouterr().out


def test_of_the_tests_with_a_limit_in_seconds_only_their_files_are_collected(installer, monkeypatch, tmp_path) -> None:
    files = installer.steps._timed_files()
    assert "tests/devices/test_attempt.py" in files and "tests/house/test_words.py" not in files
    monkeypatch.setattr(installer.environment, "ROOT", tmp_path)
    (tmp_path / "tests" / "room").mkdir(parents=True)
    (tmp_path / "tests" / "room" / "test_one.py").write_text(f"@{installer.steps.TIMED}", encoding="utf-8")
    (tmp_path / "tests" / "room" / "test_other.py").write_text("@pytest.mark.slow", encoding="utf-8")
    assert installer.steps._timed_files() == ["tests/room/test_one.py"]


def test_a_timed_test_that_fails_is_run_once_more_alone_and_that_run_counts(installer, called, monkeypatch, capsys) -> None:
    monkeypatch.setattr(installer.machine, "workers", lambda: 2)
    call = installer.steps._call
    for codes, counted in (([1, 0], 0), ([1, 1], 1), ([2], 2)):
        left = list(codes)

        def answer(command, home, more=None, left=left):
            if "timed and not slow" not in command:
                return call(command, home, more)
            assert ("--last-failed" in command) != ("-n" in command)
            return left.pop(0)

        monkeypatch.setattr(installer.steps, "_call", answer)
        assert installer.steps.perform("test", []) == counted
        assert left == []
    assert capsys.readouterr().out.count("== timed tests that failed, once more") == 2


@pytest.mark.parametrize(("processor", "checked"), [("x86_64", True), ("aarch64", False)])
def test_the_whole_suite_tests_kernels_for_an_older_processor_with_a_cache_of_their_own(
    installer, called, monkeypatch, processor, checked
) -> None:
    monkeypatch.setattr(installer.steps.platform, "machine", lambda: processor)
    assert installer.steps.perform("test", []) == 0
    older = [more for command, more in zip(called.commands, called.variables, strict=True) if "tests/compiled" in command]
    assert [more["NUMBA_CPU_NAME"] for more in older] == ["haswell"] * checked
    assert not any(Path(more["NUMBA_CACHE_DIR"]).exists() for more in older)
    assert called.variables[-1] == {}


def test_the_tests_for_an_older_processor_exist(installer) -> None:
    for name in installer.steps.KERNEL_TESTS:
        file, _, test = name.partition("::")
        path = INSTALLER.parent / file
        assert path.exists() and (not test or f"def {test}(" in path.read_text(encoding="utf-8"))


def test_kernels_that_do_not_compile_fail_the_whole_suite(installer, called, capsys) -> None:
    called.codes.update(python=1)
    assert installer.steps.perform("test", []) == 1
    assert "kernels       failed (1)" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("processors", "free_gb", "limit", "workers"),
    [
        (2, 20, "max", 3),
        (16, 100, "max", 4),
        (4, 7, "max", 2),
        (4, 1, "max", 1),
        (1, 20, "max", 2),
        (4, 20, "8000000000", 2),
        (4, None, "max", 4),
    ],
    ids=["two processors", "many", "little memory", "very little memory", "one processor", "a container's limit", "memory unknown"],
)
def test_there_is_a_worker_more_than_processors_where_memory_allows_it(
    installer, monkeypatch, tmp_path, processors, free_gb, limit, workers
) -> None:
    for name in ("MEMORY", "LIMIT", "USED"):
        monkeypatch.setattr(installer.machine, name, tmp_path / name)
    if free_gb is not None:
        (tmp_path / "MEMORY").write_text(f"MemTotal: 1 kB\nMemAvailable:  {free_gb * 10**9 // 1024} kB\n")
    (tmp_path / "LIMIT").write_text(f"{limit}\n")
    (tmp_path / "USED").write_text("500000000\n")
    monkeypatch.setattr(installer.machine, "processors", lambda: processors)
    assert installer.machine.workers() == workers


def test_trouble_is_reported_in_words_with_exit_code_2(installer, called, monkeypatch, capsys) -> None:
    def trouble(screen):
        raise installer.trouble.SetupTrouble("Libraries are missing.", "Run this line.")

    monkeypatch.setattr(installer.system_libraries, "ensure", trouble)
    assert installer.steps.perform("run", []) == 2
    assert capsys.readouterr().err == "Libraries are missing.\nRun this line.\n"
