from __future__ import annotations

import csv
import io
from math import sqrt
from pathlib import Path

import numpy as np
import pytest

from measureapp.cli.main import main
from measureapp.data.dimension import Verdict
from measureapp.data.identification import Identification
from measureapp.data.series import SeriesRun, SeriesValue
from measureapp.errors import InputError
from measureapp.project.series.store import SeriesStore
from measureapp.report.series.capability import count_once, index, trends
from measureapp.report.series.documents import series_csv_text, series_document, series_typeset, write_series
from measureapp.report.typeset import typeset

SIGMA = 0.01


def runs(count: int, *, lower: float | None = -0.05, nominal: float = 80.0, seed: int = 1) -> tuple[SeriesRun, ...]:
    values = nominal + 0.01 + SIGMA * np.random.default_rng(seed).standard_normal(count)
    return tuple(
        SeriesRun(
            run_id=f"{n:032x}",
            program="lid 盖 #1",
            identification=Identification(serial_number=f"={n}"),
            verdict=Verdict.PASS,
            values=(
                SeriesValue(
                    name="width", nominal=nominal, lower_tolerance=lower, upper_tolerance=0.05, measured=float(value), uncertainty=0.004,
                    verdict=Verdict.PASS,
                ),
            ),
            project="p",
            measured_at=f"2026-05-{1 + n // 24:02d}T{n % 24:02d}:00:00+00:00",
        )
        for n, value in enumerate(values)
    )  # fmt: skip


def test_an_index_is_that_of_the_definition_with_bissells_interval() -> None:
    values = np.array([9.99, 10.0, 10.01, 10.02] * 10)
    found = index(values, 9.9, 10.1, 0.02, ("C", "given"))
    expected = (10.1 - values.mean()) / 0.06
    half = 1.959964 * sqrt(1 / (9 * 40) + expected**2 / (2 * 39))
    assert (found.name, found.value) == ("Cpk", pytest.approx(expected))
    assert found.interval == (pytest.approx(expected - half), pytest.approx(expected + half))
    assert found.spread_only == pytest.approx(0.2 / 0.12)


def test_the_published_width_of_the_interval_is_found() -> None:
    for n, half in ((25, 0.40), (50, 0.28), (125, 0.18)):
        spread = np.tile([-1.0, 1.0], n)[:n]
        values = spread - spread.mean()
        found = index(values, -4.0, 4.0, 4 / (3 * 1.33), ("C", ""))
        assert (found.interval[1] - found.interval[0]) / 2 == pytest.approx(half, abs=0.01)


def test_below_25_parts_there_is_no_index_and_below_50_it_is_preliminary() -> None:
    (few,), (some,), (many,) = trends(runs(24)), trends(runs(25)), trends(runs(50))
    assert few.indices == () and "24 parts: no index below 25" in few.remark
    assert some.remark.startswith("Preliminary: 25 parts") and len(some.indices) == 2
    assert many.remark.startswith("50 parts")
    assert "measurement" in many.remark and many.uncertainty == pytest.approx(0.004)


def test_the_standard_deviations_are_found_again() -> None:
    (trend,) = trends(runs(400))
    overall, within = trend.indices
    assert overall.sigma == pytest.approx(SIGMA, rel=4 / sqrt(2 * 400))
    assert within.sigma == pytest.approx(SIGMA, rel=6 / sqrt(2 * 400))


def test_the_interval_contains_the_true_index_as_often_as_it_says() -> None:
    random = np.random.default_rng(5)
    samples = 0.01 + SIGMA * random.standard_normal((600, 60))
    found = [index(values, -0.05, 0.05, float(values.std(ddof=1)), ("P", "")) for values in samples]
    share = np.mean([one.interval[0] < 0.04 / (3 * SIGMA) < one.interval[1] for one in found])
    assert abs(share - 0.95) < 3.5 * sqrt(0.95 * 0.05 / 600)


def test_a_zone_has_one_limit_and_no_cp() -> None:
    (trend,) = trends(runs(60, lower=0.0, nominal=0.0))
    assert trend.limits == (None, 0.05)
    assert [one.name for one in trend.indices] == ["Pk", "Ck"] and trend.indices[0].spread_only is None


def test_a_part_counts_once_with_its_last_measurement() -> None:
    first, *rest = runs(3)
    again = rest[1].model_copy(update={"identification": first.identification, "repeat_reason": "dust"})
    assert count_once((first, rest[0], again)) == (rest[0], again)


def test_values_of_other_limits_are_left_out() -> None:
    old = runs(2, lower=-0.2)
    (trend,) = trends((*old, *(run.model_copy(update={"identification": Identification()}) for run in runs(3))))
    assert trend.n == 3 and len(trend.values) == 5


def test_a_series_becomes_pages_tables_and_a_document(tmp_path: Path) -> None:
    some = runs(30)
    files = write_series("lid 盖 #1", some, tmp_path)
    assert files["pdf"].read_bytes().startswith(b"%PDF-") and files["csv"].read_bytes().startswith(b"\xef\xbb\xbf")
    rows = list(csv.DictReader(io.StringIO(series_csv_text(some))))
    document = series_document("lid", some)
    assert [float(row["width"]) for row in rows] == document["dimensions"][0]["values"]
    assert rows[0]["serial_number"] == "'=0"
    assert typeset(series_typeset("lid", some), "png", 30)
    with pytest.raises(InputError, match="no runs"):
        write_series("lid", (), tmp_path)


def test_the_command_line_lists_shows_and_reports_a_series(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for run in runs(3):
        SeriesStore(run.program, tmp_path).add(run)
    place = ["--results", str(tmp_path)]
    assert main(["series", "list", *place]) == 0 and "lid 盖 #1" in capsys.readouterr().out
    assert main(["series", "show", "lid 盖 #1", "--serial", "=1", *place]) == 0
    assert capsys.readouterr().out.count("2026-05-01") == 1
    assert main(["series", "report", "lid 盖 #1", "--out", str(tmp_path / "out"), *place]) == 0
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == ["series.csv", "series.json", "series.pdf"]
    assert main(["series", "report", "lid 盖 #1", "--out", str(tmp_path / "zh"), "--language", "zh_CN", *place]) == 0
    english, chinese = ({path.name: path.read_bytes() for path in (tmp_path / folder).iterdir()} for folder in ("out", "zh"))
    assert english["series.csv"] == chinese["series.csv"] and english["series.pdf"] != chinese["series.pdf"]
    assert main(["series", "report", "lid 盖 #1", "--out", str(tmp_path / "fr"), "--language", "fr", *place]) == 2
    capsys.readouterr()
    assert main(["series", "rebuild", "lid 盖 #1", str(tmp_path), *place]) == 0 and "3 runs" in capsys.readouterr().out


def test_a_program_without_a_series_is_refused_by_name(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["series", "show", "lid", "--results", str(tmp_path)]) == 2
    assert "There is no series of lid." in capsys.readouterr().err
