"""A policy that is a ROS 2 node, evaluated on a Proctor server.

    proctor run --policy examples/ros2/policy_bridge.py:RosPolicy --benchmark tabletop

Publishes each observation below /proctor and waits for the action of the node. The
stamp of a message is not a time; it names an observation: `sec` counts episodes,
`nanosec` steps. An action carries the stamp of the observation that it answers, so that
a late one is never executed. README.md lists the topics.
"""

from __future__ import annotations

import time
from typing import Any

import rclpy
from sensor_msgs.msg import Image, JointState
from std_msgs.msg import String

from reference_client import Observation

QUEUE = 10
ENCODINGS = {1: "mono8", 3: "rgb8"}


class RosPolicy:
    """One evaluation in one process: `--workers 1`.

    timeout_s: how long the node may think, and how long it may take to appear.
    """

    def __init__(self, timeout_s: float = 30.0) -> None:
        if not rclpy.ok():
            rclpy.init()
        self.timeout_s = timeout_s
        self.node = rclpy.create_node("proctor_client")
        self.instructions = self._publisher(String, "instruction")
        self.states = self._publisher(JointState, "state")
        self.cameras: dict[str, Any] = {}
        self.node.create_subscription(
            JointState, "/proctor/action", self._receive, QUEUE
        )
        self.episode = 0
        self.wanted = (0, 0)
        self.answer: dict[str, list[float]] = {}

    def reset(self, instruction: str) -> None:
        self.episode += 1
        self._wait(
            lambda: self.states.get_subscription_count() > 0,
            "no node subscribes to /proctor/state",
        )
        self.instructions.publish(String(data=instruction))

    def act(self, observation: Observation) -> dict[str, list[float]]:
        self.answer, self.wanted = {}, (self.episode, observation.step)
        for name, pixels in observation.images.items():
            self._show(name, pixels)
        # The state comes last: a node that has it has the images, too.
        state = JointState()
        self._stamp(state)
        for name, vector in observation.state.items():
            state.name += [f"{name}.{index}" for index in range(len(vector))]
            state.position += [float(number) for number in vector]
        self.states.publish(state)
        self._wait(lambda: bool(self.answer), "no action on /proctor/action")
        return self.answer

    def _show(self, name: str, pixels: Any) -> None:
        if name not in self.cameras:
            self.cameras[name] = self._publisher(Image, f"images/{name}")
        height, width, channels = pixels.shape
        image = Image(height=height, width=width, encoding=ENCODINGS[channels])
        image.step = width * channels
        image.data = pixels.tobytes()
        self._stamp(image)
        self.cameras[name].publish(image)

    def _receive(self, message: Any) -> None:
        stamp = message.header.stamp
        if (stamp.sec, stamp.nanosec) != self.wanted:
            return
        vectors: dict[str, list[float]] = {}
        for name, number in zip(message.name, message.position, strict=True):
            vectors.setdefault(name.rpartition(".")[0], []).append(float(number))
        self.answer = vectors

    def _stamp(self, message: Any) -> None:
        message.header.stamp.sec, message.header.stamp.nanosec = self.wanted

    def _publisher(self, kind: Any, topic: str) -> Any:
        return self.node.create_publisher(kind, f"/proctor/{topic}", QUEUE)

    def _wait(self, is_done: Any, what: str) -> None:
        deadline = time.monotonic() + self.timeout_s
        while not is_done():
            if time.monotonic() > deadline:
                raise TimeoutError(f"{what} within {self.timeout_s:g} s")
            rclpy.spin_once(self.node, timeout_sec=0.1)
