"""Texts become sentences of their own script."""

from __future__ import annotations

import pytest

from ui.look.wording import sentence


@pytest.mark.parametrize(
    ("text", "made"),
    [
        ("not determined: rotation about z", "Not determined: rotation about z."),
        ("Ready…", "Ready…"),
        (" 未确定：绕 z 轴旋转 ", "未确定：绕 z 轴旋转。"),
        ("已完成。", "已完成。"),
        ("", ""),
    ],
)
def test_a_text_ends_with_the_full_stop_of_its_script(text: str, made: str) -> None:
    assert sentence(text) == made
