"""Where a value comes from, as reports say it."""

from __future__ import annotations

import pytest

from measureapp.report.language import Words
from measureapp.report.origin import origin_words

SOURCE = (
    "bore: 300 points, 5 rejected, small segment: Monte Carlo, 200 draws, hub.1: not found, 7 constructed features: rib.1 … rib.7; "
    "datums A|B; mean of 6"
)


@pytest.mark.parametrize(
    ("source", "chinese"),
    [
        ("bore: 300 points, 5 rejected, hub: 200 points, 2 rejected", "bore：300 个点，5 个被剔除；hub：200 个点，2 个被剔除"),
        ("bore: not found, hub: constructed; datums A|B; max of 6", "bore：未找到；hub：构造的；基准 A|B；6 个的最大值"),
        (
            SOURCE,
            "bore：300 个点，5 个被剔除，弧段小：蒙特卡洛，200 次抽样；hub.1：未找到；7 个构造特征：rib.1 … rib.7；基准 A|B；6 个的平均值",
        ),
        (
            "rim: 9 points, 1 rejected (grown from seed to 9 points within 0.100 mm (noise 0.010 mm); border: 62% surface tilted, 38% deviation from the shape), hub: constructed",
            "rim：9 个点，1 个被剔除（由种子生长为 0.100 mm 以内的 9 个点（噪声 0.010 mm）；边界：62% 表面倾斜，38% 形状偏差）；hub：构造的",
        ),
    ],
)
def test_every_feature_is_translated_by_itself_and_named_as_people_named_it(source: str, chinese: str) -> None:
    assert origin_words(source, Words("zh_CN", ["bore", "hub", "hub.1", "rim"])) == chinese


def test_english_stays_as_it_was_stated_with_features_set_apart() -> None:
    assert (
        origin_words("bore: 300 points, 5 rejected, hub: constructed; datums A", Words())
        == "bore: 300 points, 5 rejected; hub: constructed; datums A"
    )
