"""Campaign files: which jobs they name, and what is refused."""

from __future__ import annotations

import pytest

from measureapp.campaign.campaign_file import process_jobs, read_campaign
from measureapp.campaign.jobs import DemoJob, ProcessJob
from measureapp.errors import InputError


def written(tmp_path, text):
    path = tmp_path / "campaign.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_every_part_on_every_rig_with_every_seed_is_a_job(tmp_path):
    text = 'folder = "out"\n[demo]\nparts = ["gypsum", "gear"]\nrigs = ["good", "bad"]\nseeds = "3-5"\nresolution = "quarter"\nviewpoints = 6\n'
    folder, jobs = read_campaign(written(tmp_path, text))
    assert folder == tmp_path / "out"
    assert [job.name for job in jobs][:4] == ["gypsum-good-3", "gypsum-good-4", "gypsum-good-5", "gypsum-bad-3"]
    assert len({job.folder for job in jobs}) == len(jobs) == 12
    last = jobs[-1]
    assert isinstance(last, DemoJob)
    assert (last.request.part, last.request.conditions, last.request.seed, last.request.viewpoints) == ("gear", "bad", 5, 6)


def test_projects_are_found_by_pattern_relative_to_the_file(tmp_path):
    for name in ("monday", "tuesday"):
        (tmp_path / "week" / name).mkdir(parents=True)
        (tmp_path / "week" / name / "project.json").touch()
    (tmp_path / "week" / "notes").mkdir()
    _, jobs = read_campaign(written(tmp_path, 'projects = ["week/*"]'))
    assert jobs == [ProcessJob(name, tmp_path / "week" / name) for name in ("monday", "tuesday")]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "names no job"),
        ("[demo]\nseeds = []", "demo.seeds"),
        ('[demo]\nrigs = ["perfect"]', "demo.rigs"),
        ("[demo]\nspeed = 3", "demo.speed: is not a known field"),
        ('projects = ["nowhere/*"]', "no project lies at nowhere"),
        ("folder = ", "is not valid TOML"),
    ],
)
def test_what_cannot_be_used_is_named(tmp_path, text, words):
    with pytest.raises(InputError, match=words):
        read_campaign(written(tmp_path, text))


def test_a_missing_file_and_a_project_named_twice_are_refused(tmp_path):
    with pytest.raises(InputError, match="cannot be read"):
        read_campaign(tmp_path / "none.toml")
    with pytest.raises(InputError, match="named twice"):
        process_jobs([tmp_path, tmp_path])
