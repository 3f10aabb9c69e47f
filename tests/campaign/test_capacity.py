"""The simulated queue agrees with queueing theory, and what becomes scarce first is the least of what each resource could serve."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.campaign.capacity import Cluster, ProjectWork, Task, arrivals, most_per_day, simulate, work_of
from measureapp.errors import InputError

GIB = 2.0**30


def cluster(**changes):
    usual = {"machines": 1, "cores": 1, "memory_bytes": 8 * GIB, "storage_bytes_s": 1e9, "connection_bytes_s": 1e9, "scheduler_s": 0.0}
    return Cluster(**{**usual, **changes})


def test_one_project_alone_takes_the_time_of_its_longest_chain():
    work = ProjectWork(((Task(3.0, 2e9, 0.0), 1), (Task(5.0, 1e9, 1e9), 4), (Task(7.0, 0.0, 1e9), 1)), GIB)
    alone = simulate(work, cluster(cores=4, storage_bytes_s=1e12, scheduler_s=0.25), np.zeros(1))
    # the views pass the scheduler one after the other; the last of them is the one that the last task waits for
    assert alone.latency_s[0] == pytest.approx((0.25 + 2 + 3) + (4 * 0.25 + 1 + 5 + 1) + (0.25 + 7 + 1))
    single = simulate(work, cluster(), np.zeros(1))
    assert single.latency_s[0] == pytest.approx(5 + 4 * 7 + 8)
    assert single.busy["processors"] == pytest.approx(1.0)


@pytest.mark.parametrize("load", [0.5, 0.8])
def test_waiting_for_a_place_follows_pollaczek_and_khinchine(load):
    """One place, equal tasks, independent arrivals: M/D/1, whose mean wait is ρ s / (2 (1 − ρ))."""
    service, count = 10.0, 20_000
    work = ProjectWork(((Task(service, 0.0, 0.0), 1),), GIB)
    waits = [
        simulate(work, cluster(), arrivals(count, count * service / load / 3600, seed)).latency_s.mean() - service for seed in range(6)
    ]
    expected = load * service / (2 * (1 - load))
    assert abs(np.mean(waits) - expected) < 4 * np.std(waits, ddof=1) / np.sqrt(len(waits)) + 0.005 * expected


def test_a_shared_storage_follows_the_formula_of_processor_sharing():
    """M/G/1 with processor sharing: the mean time is s / (1 − ρ), whatever the sizes."""
    seconds, load, count = 2.0, 0.6, 20_000
    work = ProjectWork(((Task(0.0, seconds * 1e9, 0.0), 1),), GIB)
    many = cluster(cores=10_000, memory_bytes=1e6 * GIB)
    means = [simulate(work, many, arrivals(count, count * seconds / load / 3600, seed)).latency_s.mean() for seed in range(6)]
    expected = seconds / (1 - load)
    assert abs(np.mean(means) - expected) < 4 * np.std(means, ddof=1) / np.sqrt(len(means)) + 0.005 * expected


def test_what_each_resource_could_serve_is_what_a_long_day_uses():
    work = ProjectWork(((Task(2.0, 1e9, 0.0), 1), (Task(4.0, 5e8, 1e8), 6), (Task(6.0, 1e8, 1e9), 1)), 2 * GIB)
    machines = cluster(machines=3, cores=8, storage_bytes_s=1e11, scheduler_s=1e-3)
    assert machines.places(work) == 12  # memory for four on each
    most = most_per_day(work, machines)
    assert min(most, key=most.get) == "processors"
    half = round(most["processors"] / 2)
    day = simulate(work, machines, arrivals(half, 24, 1))
    for name, share in day.busy.items():
        assert share == pytest.approx(half / most[name], rel=0.1), name
    slow = cluster(machines=3, cores=8, storage_bytes_s=2e7)
    scarce = most_per_day(work, slow)
    assert min(scarce, key=scarce.get) == "storage"
    assert simulate(work, slow, arrivals(round(1.5 * scarce["storage"]), 24, 1)).ended_s > 1.3 * 86_400


def test_the_work_of_a_project_is_what_its_profile_says():
    use = {"wall_s": 1.0, "peak_memory_mb": 900.0}
    stages = {
        "calibration": {**use, "processor_s": 30.0, "read_mb": 100.0, "written_mb": 1.0},
        "clouds": {**use, "processor_s": 16.0, "read_mb": 800.0, "written_mb": 80.0, "peak_memory_mb": 1500.0},
        "stitching": {**use, "processor_s": 8.0, "read_mb": 0.0, "written_mb": 0.0},
        "report": {**use, "processor_s": 4.0, "read_mb": 2.0, "written_mb": 3.0},
        "whole": {**use, "processor_s": 58.0, "read_mb": 902.0, "written_mb": 84.0},  # of all stages, so that nothing is counted twice
    }
    work = work_of({"views": [{}] * 8, "profile": stages}, "a.json")
    assert work.phases == ((Task(30.0, 1e8, 1e6), 1), (Task(2.0, 1e8, 1e7), 8), (Task(12.0, 2e6, 3e6), 1))
    assert (work.tasks, work.memory_bytes) == (10, 1.5e9)


@pytest.mark.parametrize(
    "answer", [{}, [], {"profile": {}, "views": []}, {"profile": {"clouds": {}}, "views": [1]}, {"profile": 3, "views": 2}]
)
def test_another_document_is_refused(answer):
    with pytest.raises(InputError, match=r"^a\.json is not the profile"):
        work_of(answer, "a.json")


def test_too_little_memory_is_refused_with_its_numbers():
    with pytest.raises(InputError, match=r"needs 16\.0 GiB, a machine has 8\.0 GiB"):
        cluster().places(ProjectWork(((Task(1.0, 0.0, 0.0), 1),), 16 * GIB))
