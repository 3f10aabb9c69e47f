"""Arms from TOML and URDF."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from measureapp.errors import InputError
from measureapp.geometry.kinematics.inverse import inverse
from measureapp.geometry.kinematics.ortho_parallel import ortho_parallel
from measureapp.project.geometry.robot_file import read_robot
from measureapp.project.geometry.urdf import read_urdf
from measureapp.resources import resource

# name, type, parent, child, xyz in m, rpy, axis, lower, upper in °, speed in °/s
IRB = [
    ("joint_1", "revolute", "base_link", "link_1", "0 0 0.3991", "0 0 0", "0 0 1", -170, 170, 288),
    ("joint_2", "revolute", "link_1", "link_2", "0 0 0", "0 0 0", "0 1 0", -100, 135, 240),
    ("joint_3", "revolute", "link_2", "link_3", "0 0 0.350", "0 0 0", "0 1 0", -200, 70, 300),
    ("joint_4", "revolute", "link_3", "link_4", "0 0 0.042", "0 0 0", "1 0 0", -270, 270, 400),
    ("joint_5", "revolute", "link_4", "link_5", "0.351 0 0", "0 0 0", "0 1 0", -130, 130, 405),
    ("joint_6", "revolute", "link_5", "link_6", "0.082 0 0", "0 0 0", "1 0 0", -360, 360, 600),
    ("flange", "fixed", "link_6", "tool0", "0 0 0", f"0 {np.pi / 2!r} 0", "1 0 0", 0, 0, 0),
    ("base", "fixed", "base_link", "base", "0 0 0", "0 0 0", "1 0 0", 0, 0, 0),
]


def joint(name: str, kind: str, parent: str, child: str, xyz: str, rpy: str, axis: str, *limits_deg: float) -> str:
    lower, upper, speed = (repr(float(np.deg2rad(value))) for value in limits_deg)
    limit = f'<limit lower="{lower}" upper="{upper}" velocity="{speed}" effort="0"/>' if kind == "revolute" else ""
    return (
        f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
        f'<origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="{axis}"/>{limit}</joint>'
    )


def urdf(joints: list[tuple] = IRB, before: str = "") -> str:
    return f'<?xml version="1.0"?>{before}<robot name="irb1200">{"".join(joint(*one) for one in joints)}</robot>'


def written(folder: Path, text: str | bytes, name: str = "arm.urdf") -> Path:
    path = folder / name
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


def test_the_irb_1200_of_its_urdf_and_of_its_rows_agree(tmp_path):
    rows, chain = read_robot("irb1200_7_07"), read_robot(written(tmp_path, urdf()))
    joints_rad = np.random.default_rng(0).uniform(rows.limits_rad[:, 0], rows.limits_rad[:, 1], (1000, 6))
    assert np.abs(rows.forward_matrices(joints_rad) - chain.forward_matrices(joints_rad)).max() < 1e-9
    assert np.abs(rows.limits_rad - chain.limits_rad).max() < 1e-12
    assert np.abs(rows.speeds_rad_s - chain.speeds_rad_s).max() < 1e-12
    for one in joints_rad[:20]:
        found = [np.array([s.joints_rad for s in inverse(model, model.forward(one))]) for model in (rows, chain)]
        assert found[0].shape == found[1].shape
        assert np.abs(np.sort(found[0], axis=0) - np.sort(found[1], axis=0)).max() < 1e-7


def test_links_move_the_same_in_both_models(tmp_path):
    rows, chain = read_robot("irb1200_7_07"), read_robot(written(tmp_path, urdf()))
    joints_rad = np.deg2rad([30, 20, -10, 40, 50, 60])
    motions = [model.link_frames(joints_rad) @ np.linalg.inv(model.link_frames(np.zeros(6))) for model in (rows, chain)]
    assert np.abs(motions[0] - motions[1]).max() < 1e-9


def test_link_frames_of_a_urdf_are_its_own(tmp_path):
    frames = read_robot(written(tmp_path, urdf())).link_frames(np.zeros(6))
    assert np.allclose(frames[:, :3, :3], np.eye(3))
    assert np.allclose(frames[5, :3, 3], [433.0, 0.0, 791.1])


def test_a_urdf_with_rounded_angles_and_axes_of_any_length_is_solved_exactly(tmp_path):
    rounded = [(*one[:5], "0 1.5708 0", *one[6:]) if one[3] == "tool0" else one for one in IRB]
    rounded[3] = (*IRB[3][:5], "0 1.5708 0", "0 0 2", *IRB[3][7:])
    rounded[4] = (*IRB[4][:4], "0 0 0.351", "0 -1.5708 0", *IRB[4][6:])
    model = read_robot(written(tmp_path, urdf(rounded)))
    assert ortho_parallel(model) is not None
    joints_rad = np.deg2rad([30, 20, -10, 40, 50, 60])
    found = np.array([one.joints_rad for one in inverse(model, model.forward(joints_rad))])
    assert np.abs(found - joints_rad).max(axis=1).min() < 1e-9


def test_base_and_flange_of_a_urdf_can_be_chosen(tmp_path):
    world = ("world", "fixed", "world", "base_link", "1 0 0", "0 0 0", "1 0 0", 0, 0, 0)
    path = written(tmp_path, urdf([*IRB, world]))
    assert np.allclose(read_urdf(path).forward(np.zeros(6)).translation_mm, [1433.0, 0, 791.1])
    model = read_urdf(path, base="base_link", flange="link_6")
    assert np.allclose(model.forward(np.zeros(6)).matrix[:3], [[1, 0, 0, 433.0], [0, 1, 0, 0], [0, 0, 1, 791.1]])
    with pytest.raises(InputError, match="Link 'link_9' is not between 'world' and 'tool0'"):
        read_urdf(path, base="link_9")


def without(text: str, part: str) -> str:
    assert part in text
    return text.replace(part, "", 1)


LIMIT_6 = f'upper="{float(np.deg2rad(360))!r}" '
CASES = {
    "five joints": (
        urdf([*IRB[:5], ("flange", "fixed", "link_5", "tool0", *IRB[6][4:])]),
        "5 revolute joints between 'base_link' and 'tool0'",
    ),
    "no limit": (without(urdf(), LIMIT_6), "Joint 'joint_6' has no 'upper' in <limit>"),
    "limits exchanged": (urdf([(*IRB[0][:7], 170, -170, 288), *IRB[1:]]), "Joint 1 of irb1200 has no lower limit below its upper limit"),
    "gripper": (urdf([*IRB, ("finger", "prismatic", "tool0", "tip", *IRB[6][4:])]), "Joint 'finger' moves, but is not between .* branches"),
    "continuous": (urdf([*IRB[:5], ("joint_6", "continuous", *IRB[5][2:]), *IRB[6:]]), "Joint 'joint_6' is of type 'continuous'"),
    "NaN": (urdf().replace("0.351 0 0", "nan 0 0"), "Joint 'joint_5': xyz='nan 0 0' should be 3 finite numbers"),
    "infinite": (urdf().replace("0.351 0 0", "1e999 0 0"), "should be 3 finite numbers"),
    "two numbers": (urdf().replace("0.351 0 0", "0.351 0"), "should be 3 finite numbers"),
    "xacro": (urdf().replace("0.351 0 0", "${length} 0 0"), "is not numeric. .*xacro"),
    "no axis": (urdf([(*IRB[0][:6], "0 0 0", *IRB[0][7:]), *IRB[1:]]), "Joint 'joint_1' has an axis of length 0"),
    "no tool0": (urdf(IRB[:6]), "No joint ends at a link 'tool0'. .*link_6"),
    "loop": (urdf([("back", "fixed", "link_6", "base_link", *IRB[6][4:]), *IRB]), "closed loop"),
    "two parents": (urdf([*IRB, ("again", "fixed", "base_link", "link_3", *IRB[6][4:])]), "Link 'link_3' is the child of several joints"),
    "no parent": (without(urdf(), '<parent link="link_2"/>'), "Joint 'joint_3' has no parent or no child link"),
    "empty robot": ("<robot/>", "No joint ends at a link 'tool0'. .*none"),
    "other XML": ("<sdf/>", "root element is <sdf>"),
    "broken XML": (urdf()[:-20], "is not valid XML: .* line 1"),
    "empty file": ("", "is not valid XML"),
    "binary": (bytes(range(256)), "is not valid XML"),
    "other encoding": ('<?xml version="1.0" encoding="utf-7"?><robot/>', "is not valid XML"),
    "entity bomb": (
        urdf(before='<!DOCTYPE x [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;"><!ENTITY c "&b;&b;&b;&b;&b;&b;&b;">]>'),
        "declares a document type",
    ),
    "external entity": (urdf(before='<!DOCTYPE x SYSTEM "file.dtd">'), "declares a document type"),
    "deeply nested": ("<robot>" * 100_000, "nests more than 100 elements"),
    "huge": (b"<robot>" + b" " * (17 * 2**20), "is larger than 16 MB"),
}


@pytest.mark.parametrize("case", CASES)
def test_a_urdf_that_is_no_six_axis_arm_is_refused_with_its_file_and_a_remedy(tmp_path, case):
    text, message = CASES[case]
    with pytest.raises(InputError, match=message) as refused:
        read_robot(written(tmp_path, text))
    assert "arm.urdf" in refused.value.message
    assert refused.value.hint


TOML = resource("robots/irb1200_7_07.toml").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("d_mm = 351.0", "d_mm = nan", "joints.3.d_mm"),
        ("d_mm = 351.0", "d_mm = 1e300", "joints.3.d_mm"),
        ("limits_deg = [-130.0, 130.0]\n", "", "joints.4.limits_deg: Field required"),
        ("limits_deg = [-130.0, 130.0]", "limits_deg = [130.0, -130.0]", "Joint 5 .* no lower limit below its upper limit"),
        ("speed_deg_s = 288.0", "speed_deg_s = 0.0", "joints.0.speed_deg_s"),
        ("a_mm = 42.0", "a_inch = 42.0", "joints.2.a_mm: Field required"),
        ("[[joints]]", "[[joints]", "not valid TOML"),
    ],
)
def test_a_toml_file_with_a_wrong_field_is_refused_by_its_name(tmp_path, old, new, message):
    assert old in TOML
    with pytest.raises(InputError, match=message) as refused:
        read_robot(written(tmp_path, TOML.replace(old, new, 1), "arm.toml"))
    assert "arm.toml" in refused.value.message and refused.value.hint


def test_a_toml_file_with_five_joints_is_refused(tmp_path):
    with pytest.raises(InputError, match="joints"):
        read_robot(written(tmp_path, TOML.rsplit("[[joints]]", 1)[0], "arm.toml"))


def test_a_robot_that_is_not_there_is_refused_with_the_names_of_those_that_are(tmp_path):
    with pytest.raises(InputError, match=r"There is no robot 'nosuch'. .*irb1200_7_07"):
        read_robot("nosuch")
    with pytest.raises(InputError, match=r"arm\.urdf cannot be read"):
        read_robot(tmp_path / "arm.urdf")
