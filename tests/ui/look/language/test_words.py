"""Translation of single texts: with values, of constants, of messages of the core, and back."""

from __future__ import annotations

import pytest

from measureapp.errors import InputError
from measureapp.language.catalogue import Catalogue, Entry, read_catalogue, write_catalogue
from measureapp.language.translator import Translator
from ui.look.language.sources import catalogue_file, window_texts

WORDS = {
    "{count} views left out": "省略 {count} 个视图",
    "Surface": "表面",
    "Camera {v1} does not answer: {v2}.": "相机 {v1} 没有应答：{v2}。",
    "the cable is loose": "电缆松动",
    "Check the cable.": "检查电缆。",
}


@pytest.fixture
def translator() -> Translator:
    made = Translator()
    made.use(Catalogue("zh_CN", {source: Entry(source, words) for source, words in WORDS.items()}))
    return made


def test_a_message_of_one_word_is_a_text_of_the_window():
    assert {"Ready.", "Cancelled.", "Paused."} <= window_texts().keys()


def test_values_are_put_into_the_translation(translator):
    assert translator.translate("{count} views left out", {"count": 3}) == "省略 3 个视图"


def test_a_text_without_translation_stays_english(translator):
    assert translator.translate("{count} points", {"count": 3}) == "3 points"
    assert translator.renewed("gypsum-4711") == "gypsum-4711"


def test_a_message_of_the_core_is_recognised_with_its_values(translator):
    assert translator.renewed("Camera left does not answer: the cable is loose.") == "相机 left 没有应答：电缆松动。"


def test_a_number_that_was_formatted_in_a_message_stays_as_it_is(translator):
    translator.use(Catalogue("zh_CN", {"Guide over {stroke:.0f} mm": Entry("Guide over {stroke:.0f} mm", "{stroke:.0f} mm 上的导轨")}))
    assert translator.renewed("Guide over 650 mm") == "650 mm 上的导轨"
    assert translator.translate("Guide over {stroke:.0f} mm", {"stroke": 650.2}) == "650 mm 上的导轨"


def test_sentences_put_together_are_translated_one_by_one(translator):
    assert translator.renewed("Check the cable. Camera left does not answer: the cable is loose.").startswith("检查电缆。相机 left")
    assert translator.renewed("Surface…") == "表面…"


def test_a_text_that_became_part_of_a_sentence_is_known_by_its_other_first_letter(translator):
    english, catalogue = Translator(), translator.catalogue
    source = "Residual up to {limit}"
    catalogue.entries |= {
        source: Entry(source, "残差不超过 {limit}"),
        "Criterion: {criterion}.": Entry("Criterion: {criterion}.", "判据：{criterion}。"),
    }
    limit = english.translate(source, {"limit": "0.5 px"})
    shown = english.translate("Criterion: {criterion}.", {"criterion": limit[:1].lower() + limit[1:]})
    english.use(catalogue)
    chinese = english.renewed(shown)
    assert chinese == "判据：残差不超过 0.5 px。"
    assert english.renewed("The cable is loose") == "电缆松动"
    assert english.renewed("surface") == "surface"  # one word may be the name of a part
    english.use(None)
    assert english.renewed(chinese) == shown == "Criterion: residual up to 0.5 px."


@pytest.mark.parametrize(
    ("text", "chinese"),
    [
        ("datum system A|B", "基准体系 A|B"),
        ("means of 2 mm cells, minimum zone, the worst of 5 sections", "2 mm 单元的均值，最小区域，5 个截面中最差者"),
        ("0.0123 mm less 0.0045 mm by noise", "0.0123 mm，扣除噪声引起的 0.0045 mm"),
        ("datums: minimum zone; associated centre", "基准：最小区域；拟合中心"),
        ("7 constructed features: mid-line.1 … mid-line.7", "7 个构造特征：mid-line.1 … mid-line.7"),
        ("angle", "角度"),
        (
            "The table's radial error motion is ± 0.208 mm, 42 times what is stated or usual (± 0.005 mm): its bearing has play, the robot "
            "warmed up during the calibration, or the board moved on the table.",
            "转台的径向误差运动为 ± 0.208 mm，是所述或通常值（± 0.005 mm）的 42 倍：其轴承有间隙、机器人在标定过程中升温，或标定板在转台上移动了。",
        ),
    ],
)
def test_results_read_in_chinese_how_they_were_obtained(text, chinese):
    own = Translator()
    own.use(read_catalogue(catalogue_file("zh_CN")))
    assert own.renewed(text) == chinese


def test_a_name_in_latin_letters_stands_apart_from_the_word_before_it():
    own = Translator()
    own.use(
        Catalogue(
            "zh_CN",
            {
                text: Entry(text, chinese)
                for text, chinese in (("the roll", "滚转"), ("upper less than {v}", "upper 小于 {v}"), (" or ", "或"))
            },
        )
    )
    assert own.renewed("the roll or upper less than 0.1°") == "滚转或 upper 小于 0.1°"


def test_what_is_translated_already_stays(translator):
    once = translator.renewed("Surface")
    assert translator.renewed(once) == once


def test_texts_on_display_follow_the_language_there_and_back(translator):
    english, catalogue = Translator(), translator.catalogue
    shown = [english.translate("{count} views left out", {"count": 3}), "Surface", "Camera a does not answer: the cable is loose."]
    english.use(catalogue)
    chinese = [english.renewed(text) for text in shown]
    assert chinese == ["省略 3 个视图", "表面", "相机 a 没有应答：电缆松动。"]
    english.use(None)
    assert [english.renewed(text) for text in chinese] == shown


def test_a_catalogue_is_written_and_read(tmp_path):
    path = tmp_path / "zh_CN.ts"
    write_catalogue(path, "zh_CN", [("plan", Entry("A <b> & {x:.1f}", "甲 <b> & {x:.1f}")), ("rig", Entry("Open"))])
    found = read_catalogue(path)
    assert found.language == "zh_CN" and found.translation("A <b> & {x:.1f}") == "甲 <b> & {x:.1f}" and found.translation("Open") is None
    assert 'type="unfinished"' in path.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("<TS><message>", "not a file of Qt Linguist"),
        ("<TS><message><source>{a}</source><translation>{b}</translation></message></TS>", "placeholders"),
    ],
)
def test_a_damaged_catalogue_is_refused(tmp_path, text, words):
    path = tmp_path / "zh_CN.ts"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=words):
        read_catalogue(path)


def test_a_text_that_equals_its_value_follows_its_value(translator):
    translator.translate("{name}{remark}", {"name": "Surface", "remark": ""})
    translator.use(None)
    assert translator.renewed("Surface") == "Surface"
    translator.translate("{name}{remark}", {"name": "gypsum-4711", "remark": ""})
    translator.use(None)
    assert translator.renewed("gypsum-4711") == "gypsum-4711"


def test_texts_that_are_each_others_values_are_renewed_once(translator):
    translator.translate("{first:.1}", {"first": "ab"})  # "a" is made of "ab"
    translator.translate("{first}b", {"first": "a"})  # and "ab" of "a"
    translator.use(None)
    assert (translator.renewed("a"), translator.renewed("ab")) == ("a", "ab")
