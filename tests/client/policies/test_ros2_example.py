"""The bridge to ROS 2 and its example node, on stand-ins for rclpy and the messages.

A topic delivers at once, a queue is read by `spin_once`: enough to see that
observations and actions find each other, and nothing of ROS itself.
"""

import importlib.util
import sys
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
import pytest

from reference_client import Observation, evaluate
from tests.support.paths import ROOT
from tests.support.servers import TOKENS, ReferenceServer


@dataclass
class Header:
    stamp: Any = field(default_factory=lambda: SimpleNamespace(sec=0, nanosec=0))


@dataclass
class JointState:
    header: Header = field(default_factory=Header)
    name: list[str] = field(default_factory=list)
    position: list[float] = field(default_factory=list)


@dataclass
class Image:
    header: Header = field(default_factory=Header)
    height: int = 0
    width: int = 0
    encoding: str = ""
    step: int = 0
    data: bytes = b""


@dataclass
class String:
    data: str = ""


class Topics:
    """All nodes of the test, and what was published."""

    def __init__(self) -> None:
        self.subscribers: dict[str, list[Callable[[Any], None]]] = {}
        self.published: list[tuple[str, Any]] = []
        self.queue: deque[tuple[Callable[[Any], None], Any]] = deque()

    def create_node(self, _name: str) -> Any:
        made = SimpleNamespace(create_publisher=self._publisher)
        made.create_subscription = self._subscribe
        return made

    def _subscribe(
        self, _kind: Any, topic: str, then: Callable[[Any], None], _depth: int
    ) -> None:
        self.subscribers.setdefault(topic, []).append(then)

    def _publisher(self, kind: type, topic: str, _depth: int) -> Any:
        def publish(message: Any) -> None:
            assert isinstance(message, kind)
            self.published.append((topic, message))
            self.queue += [(then, message) for then in self.subscribers.get(topic, [])]

        def count() -> int:
            return len(self.subscribers.get(topic, []))

        return SimpleNamespace(publish=publish, get_subscription_count=count)

    def spin_once(self, _node: Any, timeout_sec: float) -> None:
        if self.queue:
            then, message = self.queue.popleft()
            then(message)


@pytest.fixture
def topics(monkeypatch: pytest.MonkeyPatch) -> Topics:
    made = Topics()
    rclpy = ModuleType("rclpy")
    rclpy.__dict__.update(
        ok=lambda: True, create_node=made.create_node, spin_once=made.spin_once
    )
    sensor, standard = ModuleType("sensor_msgs.msg"), ModuleType("std_msgs.msg")
    sensor.__dict__.update(Image=Image, JointState=JointState)
    standard.__dict__.update(String=String)
    modules = {"rclpy": rclpy, "sensor_msgs": ModuleType("sensor_msgs")}
    modules |= {"sensor_msgs.msg": sensor, "std_msgs": ModuleType("std_msgs")}
    for name, module in (modules | {"std_msgs.msg": standard}).items():
        monkeypatch.setitem(sys.modules, name, module)
    return made


def example(name: str) -> Any:
    path = ROOT / "examples" / "ros2" / f"{name}.py"
    spec = importlib.util.spec_from_file_location(name, path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def observation(step: int = 0) -> Observation:
    return Observation(
        instruction="hold",
        episode_id="e0",
        step=step,
        state={"joint_position": np.arange(3.0), "gripper": np.zeros(1)},
        images={"front": np.zeros((4, 6, 3), np.uint8)},
        tensors={},
    )


def test_an_observation_is_published_and_answered(topics: Topics) -> None:
    """Expect the image before the state, one stamp, and the node's vectors."""
    example("hold_node").HoldNode()
    policy = example("policy_bridge").RosPolicy()
    policy.reset("hold")
    action = {"joint_position": [0.0, 1.0, 2.0], "gripper": [1.0]}
    assert policy.act(observation(7)) == action
    names = [topic.removeprefix("/proctor/") for topic, _ in topics.published]
    assert names == ["instruction", "images/front", "state", "action"]
    image = topics.published[1][1]
    assert (image.height, image.width, image.step) == (4, 6, 18)
    assert (image.encoding, len(image.data)) == ("rgb8", 72)
    stamps = [message.header.stamp for _, message in topics.published[1:]]
    assert {(stamp.sec, stamp.nanosec) for stamp in stamps} == {(1, 7)}


def test_a_late_action_is_left_out(topics: Topics) -> None:
    """An action for the step before. Expect it not taken, and the wait to end."""
    policy = example("policy_bridge").RosPolicy(timeout_s=0.0)
    topics.subscribers["/proctor/state"] = [lambda _state: None]
    policy.reset("hold")
    late = JointState(name=["gripper.0"], position=[1.0])
    late.header.stamp = SimpleNamespace(sec=1, nanosec=6)
    topics.queue.append((policy._receive, late))
    with pytest.raises(TimeoutError, match="no action on /proctor/action"):
        policy.act(observation(7))
    policy._receive(late)
    assert policy.answer == {}
    late.header.stamp.nanosec = 7
    policy._receive(late)
    assert policy.answer == {"gripper": [1.0]}


@pytest.mark.usefixtures("topics")
def test_a_missing_node_is_named() -> None:
    policy = example("policy_bridge").RosPolicy(timeout_s=0.0)
    with pytest.raises(TimeoutError, match="no node subscribes to /proctor/state"):
        policy.reset("hold")


@pytest.mark.slow("starts a server")
@pytest.mark.usefixtures("topics")
def test_a_run_is_played_by_a_node(server: ReferenceServer) -> None:
    """The example node on tabletop_state. Expect the episode scored."""
    example("hold_node").HoldNode()
    score = evaluate(
        example("policy_bridge").RosPolicy,
        url=server.url,
        token=TOKENS["alice"],
        benchmark="tabletop_state",
        episodes=1,
    )
    assert score.counts.success + score.counts.failure == 1
