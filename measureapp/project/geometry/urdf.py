"""Arms from URDF files: six revolute joints in a chain, with fixed joints between them."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np
from scipy.spatial.transform import Rotation

from measureapp.arrays import FloatArray
from measureapp.errors import InputError
from measureapp.geometry.kinematics.arm import JOINTS, ArmModel, homogeneous
from measureapp.project.geometry.guarded_xml import read_xml

MM_PER_M = 1000.0
LARGEST_NUMBER = 1e4  # metres or radians; beyond it a number is garbage
EXPORT_AGAIN = "Export the URDF of the arm again; a xacro file has to be expanded first."


@dataclass(frozen=True, slots=True)
class _Joint:
    """One joint of the file."""

    element: Element
    name: str  # as messages begin
    kind: str
    parent: str
    child: str

    def part(self, tag: str) -> Element:
        """Return the child element ``tag``; an empty one if there is none."""
        found = self.element.find(tag)
        return Element(tag) if found is None else found

    def numbers(self, tag: str, attribute: str, default: str | None, count: int) -> FloatArray:
        """Return the numbers of an attribute, (count,); raises InputError."""
        text = self.part(tag).get(attribute, default)
        if text is None:
            raise InputError(
                f"{self.name} has no {attribute!r} in <{tag}>.", "Add limits (lower, upper, velocity) to every revolute joint."
            )
        try:
            numbers = np.array([float(word) for word in text.split()])
        except ValueError as error:
            raise InputError(f"{self.name}: {attribute}={text[:60]!r} is not numeric.", EXPORT_AGAIN) from error
        if len(numbers) != count or not (np.abs(numbers) < LARGEST_NUMBER).all():  # NaN is refused, too
            expected = "one finite number" if count == 1 else f"{count} finite numbers"
            raise InputError(f"{self.name}: {attribute}={text[:60]!r} should be {expected}.", "Correct this attribute.")
        return numbers

    def origin(self) -> FloatArray:
        """Return the frame of the joint in the one of its parent link, (4, 4), mm."""
        rotation = Rotation.from_euler("xyz", self.numbers("origin", "rpy", "0 0 0", 3)).as_matrix()
        return homogeneous(rotation, self.numbers("origin", "xyz", "0 0 0", 3) * MM_PER_M)

    def axis(self) -> FloatArray:
        """Return the unit vector of the axis, (3,)."""
        axis = self.numbers("axis", "xyz", "1 0 0", 3)
        length = float(np.linalg.norm(axis))
        if length < 1e-6:
            raise InputError(f"{self.name} has an axis of length 0.", "Correct the axis of this joint.")
        return axis / length

    def limit(self, name: str) -> float:
        """Return a number of its limits."""
        return float(self.numbers("limit", name, None, 1)[0])


def read_urdf(path: Path, base: str | None = None, flange: str = "tool0") -> ArmModel:
    """Read an arm whose chain from link ``base`` to link ``flange`` has six revolute joints.

    Link frames are those of the file. Meshes, inertia and fixed branches are ignored.

    Parameters
    ----------
    base : link of the controller's base frame; None: the link without a parent
    flange : link of the flange, z out of the flange

    Raises
    ------
    InputError
        The file is no URDF, the chain is not one of six revolute joints, other joints move, or a number is missing or impossible.
    """
    root = read_xml(path, EXPORT_AGAIN)
    try:
        return _arm(root, base, flange)
    except InputError as error:
        raise InputError(f"{path}: {error.message}", error.hint) from error


def _arm(root: Element, base: str | None, flange: str) -> ArmModel:
    if root.tag != "robot":
        raise InputError(f"The root element is <{root.tag}>, not <robot>, as in a URDF.", EXPORT_AGAIN)
    joints = tuple(_joint(element) for element in root.findall("joint"))
    chain = _chain(joints, base, flange)
    _require_six(joints, chain)
    frames, pending = [], np.eye(4)
    for joint in chain:
        pending = pending @ joint.origin()
        if joint.kind == "revolute":
            frames.append(pending)
            pending = np.eye(4)
    moving = [joint for joint in chain if joint.kind == "revolute"]
    return ArmModel(
        name=root.get("name", "The arm"),
        parent_from_joint=np.array(frames),
        axes=np.array([joint.axis() for joint in moving]),
        last_from_flange=pending,
        limits_rad=np.array([[joint.limit("lower"), joint.limit("upper")] for joint in moving]),
        speeds_rad_s=np.array([joint.limit("velocity") for joint in moving]),
    )


def _joint(element: Element) -> _Joint:
    name = f"Joint {element.get('name', '?')!r}"
    links = [part.get("link") if (part := element.find(tag)) is not None else None for tag in ("parent", "child")]
    if not links[0] or not links[1]:
        raise InputError(f"{name} has no parent or no child link.", EXPORT_AGAIN)
    return _Joint(element, name, element.get("type", ""), links[0], links[1])


def _chain(joints: tuple[_Joint, ...], base: str | None, flange: str) -> tuple[_Joint, ...]:
    """Return the joints from base to flange, walking up from the flange, since a link has one parent only."""
    twice = [link for link, count in Counter(joint.child for joint in joints).items() if count > 1]
    if twice:
        raise InputError(f"Link {twice[0]!r} is the child of several joints.", EXPORT_AGAIN)
    parents = {joint.child: joint for joint in joints}
    if flange not in parents:
        raise InputError(f"No joint ends at a link {flange!r}.", f"Name the link of the flange, one of: {', '.join(parents) or 'none'}.")
    chain: list[_Joint] = []
    link = flange
    while link != base and link in parents:
        chain.insert(0, parents[link])
        link = parents[link].parent
        if len(chain) > len(joints):
            raise InputError("The joints form a closed loop.", "Only open chains are supported.")
    if not chain or (base is not None and link != base):
        raise InputError(f"Link {base!r} is not between {link!r} and {flange!r}.", "Name a link of the chain as base.")
    return tuple(chain)


def _require_six(joints: tuple[_Joint, ...], chain: tuple[_Joint, ...]) -> None:
    """Refuse other than revolute joints, other than six of them, and moving branches."""
    ends = f"between {chain[0].parent!r} and {chain[-1].child!r}"
    for joint in joints:
        if joint.kind != "fixed" and joint not in chain:
            raise InputError(
                f"{joint.name} moves, but is not {ends}: the chain branches.", "Export the arm alone, without gripper, guide or second arm."
            )
        if joint.kind not in ("fixed", "revolute"):
            raise InputError(f"{joint.name} is of type {joint.kind!r}.", "Only revolute joints with limits, and fixed ones, are supported.")
    count = sum(joint.kind == "revolute" for joint in chain)
    if count != JOINTS:
        raise InputError(f"There are {count} revolute joints {ends}.", "A six-axis arm is needed.")
