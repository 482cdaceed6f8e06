"""A ROS 2 node that holds the arm where it is: the shortest policy for the bridge.

python3 hold_node.py
"""

from __future__ import annotations

from typing import Any

import rclpy
from sensor_msgs.msg import JointState


class HoldNode:
    """Answers each state with its own joint positions and an open gripper."""

    def __init__(self) -> None:
        self.node = rclpy.create_node("hold")
        self.actions = self.node.create_publisher(JointState, "/proctor/action", 10)
        self.node.create_subscription(JointState, "/proctor/state", self.answer, 10)

    def answer(self, state: Any) -> None:
        action = JointState()
        action.header.stamp = state.header.stamp
        for name, position in zip(state.name, state.position, strict=True):
            if name.startswith("joint_position."):
                action.name.append(name)
                action.position.append(position)
        action.name.append("gripper.0")
        action.position.append(1.0)
        self.actions.publish(action)


if __name__ == "__main__":
    rclpy.init()
    rclpy.spin(HoldNode().node)
