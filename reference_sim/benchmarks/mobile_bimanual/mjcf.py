"""The MJCF text of the scene: both arms are made from one text, with different names.

A test compares the dimensions of the XML with those of layout.py.
"""

from __future__ import annotations

from importlib.resources import files
from string import Template

from reference_sim.benchmarks.mobile_bimanual.layout import ARM_JOINTS, FINGERS, SIDES

# Side → y of the shoulder in the base's frame, m, and collision bits (see scene.xml).
_ARMS = {
    "left": {"mount_y": "0.22", "contype": "2", "conaffinity": "1"},
    "right": {"mount_y": "-0.22", "contype": "4", "conaffinity": "3"},
}
_SMALL_JOINTS = ("wrist_pitch", "wrist_yaw", "hand_roll")


def scene_mjcf() -> str:
    """The MJCF text of robot, room and objects."""
    arm, defaults = _text("arm.xml"), _text("arm_defaults.xml")
    parts = {
        f"{side}_arm": Template(arm).substitute(_ARMS[side], side=side)
        for side in SIDES
    }
    return Template(_text("scene.xml")).substitute(
        parts,
        arm_defaults="".join(
            Template(defaults).substitute(_ARMS[side], side=side) for side in SIDES
        ),
        motors="".join(_motors(side) for side in SIDES),
    )


def _motors(side: str) -> str:
    """The actuators of one arm, in the order of its joints, fingers last."""
    classes = {f"{side}_{joint}": f"{side}_small_joint" for joint in _SMALL_JOINTS}
    classes |= dict.fromkeys(FINGERS[side], f"{side}_finger")
    joints = (*ARM_JOINTS[side], *FINGERS[side])
    return "".join(
        f'<position name="{name}" joint="{name}" class="{classes.get(name, "arm")}"/>'
        for name in joints
    )


def _text(name: str) -> str:
    """A file's XML; its first comment, which may name placeholders, is left out."""
    whole = (files("reference_sim.benchmarks.mobile_bimanual") / name).read_text()
    return whole.partition("-->")[2] if whole.startswith("<!--") else whole
