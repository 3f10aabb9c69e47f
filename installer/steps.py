"""The three commands: run the application, test the project, run its slow proofs."""

from __future__ import annotations

import os
import platform
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager

import environment
import machine
import proofs
import system_libraries
from trouble import SetupTrouble

DEMO_FOLDER = "demo-gypsum-quarter"
PROOFS_FOLDER = "proofs"
DEMO = ("demo", "--resolution", "quarter")  # the first report counts, and comes in half the time
CANCELLED = 130
COMPILE_KERNELS = "from measureapp.pipeline.warm_up import warm_up; warm_up()"
X86 = ("x86_64", "AMD64")
OLDER_PROCESSOR = {"NUMBA_CPU_NAME": "haswell", "NUMBA_CPU_FEATURES": "+avx2,+fma"}
TIMED = "pytest.mark.timed"
SOME_FAILED = 1  # of pytest: it ran to its end
KERNEL_TESTS = (
    "tests/compiled",
    "tests/fringe/test_reference.py",
    "tests/inspection/surface/test_closest.py",
    "tests/fringe/test_decode.py::test_highlights_and_dark_places_are_distinguished",
    "tests/reconstruct/test_kernels.py",
    "tests/reconstruct/test_reference.py",
)


def perform(step: str, arguments: Sequence[str]) -> int:
    """Set up what is missing, then do one step; trouble is told in words and gives exit code 2."""
    try:
        return STEPS[step](list(arguments))
    except SetupTrouble as trouble:
        print(f"{trouble.message}\n{trouble.remedy}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("Cancelled.", file=sys.stderr)
        return CANCELLED


def has_screen() -> bool:
    """Tell whether a window can be shown."""
    return sys.platform in ("win32", "darwin") or bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def run(arguments: Sequence[str]) -> int:
    """Open the application with the demo project, or run the demo where there is no screen."""
    screen = has_screen()
    system_libraries.ensure(screen)
    home = environment.ensure()
    if screen:
        return _call([str(home.script("measureapp")), "gui", "--demo", *arguments], home)
    print("There is no screen, so the demo runs without its window; it says at the end where its report is.", flush=True)
    with _compiling_beside(home):
        return _call([str(home.script("measureapp")), *DEMO, "--out", str(environment.ROOT / DEMO_FOLDER), *arguments], home)


def test(arguments: Sequence[str]) -> int:
    """Run every check and return the worst exit code; pytest gets the arguments, and without any several processes."""
    system_libraries.ensure(screen=False)
    system_libraries.ensure_for_tests()
    home = environment.ensure()
    checks = {
        "ruff check": [str(home.script("ruff")), "check", "."],
        "ruff format": [str(home.script("ruff")), "format", "--check", "."],
        "mypy": [str(home.script("mypy"))],
        "lint-imports": [str(home.script("lint-imports")), "--no-logo"],
    }
    pytest = [str(home.python), "-m", "pytest"]
    with ThreadPoolExecutor(max_workers=1) as beside:
        # Once and early: else every process of pytest compiles what the others compile.
        kernels = None if arguments else beside.submit(_timed, "kernels", [str(home.python), "-c", COMPILE_KERNELS], home)
        # Then types, while the selection for an older processor compiles its own: two processors are busy to the end of both.
        types = None if arguments else beside.submit(_check, "mypy", checks.pop("mypy"), home)
        results = [_check(name, command, home) for name, command in checks.items()]
        if not arguments and platform.machine() in X86:
            results.append(_older_processor(home))
        results += [task.result() for task in (types, kernels) if task is not None]
    several = _several_processes()
    if arguments or not several:
        results.append(_check("pytest", [*pytest, *arguments], home))
    else:
        results.append(_check("pytest", [*pytest, *several, "-m", "not slow and not timed"], home))
        results.append(_timed_tests([*pytest, *_timed_files(), "-m", "timed and not slow"], several, home))
    print("== summary")
    for name, code, seconds in results:
        print(f"{name:<14}{'passed' if code == 0 else f'failed ({code})':<14}{seconds:7.1f} s")
    sys.stdout.flush()
    return max(abs(code) for _, code, _ in results)


def prove(rooms: Sequence[str]) -> int:
    """Run the slow proofs of these rooms, all without any, and write a table of what they found."""
    system_libraries.ensure(screen=False)
    system_libraries.ensure_for_tests()
    home = environment.ensure()
    return proofs.prove(
        environment.ROOT, environment.ROOT / PROOFS_FOLDER, rooms, lambda arguments: _call([str(home.python), *arguments], home)
    )


@contextmanager
def _compiling_beside(home: environment.Environment) -> Iterator[None]:
    """Compile the kernels in another process where that was never done: the demo calibrates meanwhile, and finds them compiled after it."""
    if any((environment.ROOT / "measureapp").glob("**/__pycache__/*.nbi")):
        yield
        return
    command = [str(home.python), "-c", COMPILE_KERNELS]
    compiler = subprocess.Popen(command, cwd=environment.ROOT, env=home.variables(), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        yield
    finally:
        compiler.terminate()
        compiler.wait()


def _several_processes() -> list[str]:
    """Return what makes pytest run file by file in several processes, in the order of the rooms: the shortest come last."""
    count = machine.workers()
    return ["-n", str(count), "--dist", "loadfile", "--no-loadscope-reorder"] if count > 1 else []


def _older_processor(home: environment.Environment) -> tuple[str, int, float]:
    """Test a selection of kernels compiled for the instruction set of 2013; the usual cache of compiled kernels stays as it is."""
    with tempfile.TemporaryDirectory() as cache:
        variables = {**OLDER_PROCESSOR, "NUMBA_CACHE_DIR": cache}
        return _check("older CPU", [str(home.python), "-m", "pytest", "-q", *KERNEL_TESTS], home, variables)


def _timed_files() -> list[str]:
    """Return the files with tests that have a limit in seconds: to collect all others takes every process 15 seconds."""
    files = sorted((environment.ROOT / "tests").rglob("*.py"))
    return [path.relative_to(environment.ROOT).as_posix() for path in files if TIMED in path.read_text(encoding="utf-8")]


def _timed_tests(pytest: list[str], several: list[str], home: environment.Environment) -> tuple[str, int, float]:
    """Run the tests with a limit in seconds side by side, for most of it they wait; what exceeds it is run once more, and then one by one."""
    name, code, seconds = _check("timed tests", [*pytest, *several], home)
    if code != SOME_FAILED:
        return name, code, seconds
    _, again, more = _check("timed tests that failed, once more", [*pytest, "--last-failed"], home)
    return name, again, seconds + more


def _check(
    name: str, command: Sequence[str], home: environment.Environment, variables: Mapping[str, str] | None = None
) -> tuple[str, int, float]:
    print(f"== {name}", flush=True)
    return _timed(name, command, home, variables)


def _timed(
    name: str, command: Sequence[str], home: environment.Environment, variables: Mapping[str, str] | None = None
) -> tuple[str, int, float]:
    started = time.monotonic()
    code = _call(command, home, variables)
    return name, code, time.monotonic() - started


def _call(command: Sequence[str], home: environment.Environment, variables: Mapping[str, str] | None = None) -> int:
    return subprocess.run(command, cwd=environment.ROOT, env={**home.variables(), **(variables or {})}, check=False).returncode


STEPS: dict[str, Callable[[Sequence[str]], int]] = {"run": run, "test": test, "proofs": prove}
