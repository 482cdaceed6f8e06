"""The simulator under test, as checks use it: calls, episodes and their comparison.

A reply that breaks another rule than the one under test is a set-up that failed, and
names the rule that it breaks.
"""

import contextlib
import math
import random
import time
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Never

import msgspec

from conformance.client.check_context import CheckContext
from conformance.simulator.process_under_test import (
    LENGTH,
    ConnectionUnderTest,
    Ended,
    NoFrame,
    ProcessUnderTest,
    TooSlow,
)
from conformance.specification.tensor_formats import tensor_bytes
from conformance.verdicts.expect import (
    NotApplicable,
    SetUpFailed,
    TooLate,
    Violation,
    format_value,
)

NO_ROBOT = "the simulator does not declare `physical`"
PROTOCOL = 1
REPLY_BYTES_MAX = 16 << 20
EXTRA_BYTES = 1 << 20
STEPS = 12
_AWAY_PAUSE_S = 0.02
TASKS_MAX = 3
_NUMBER = (int, float)
_REQUIRED: Mapping[str, Mapping[str, Any]] = {
    "describe": {"protocol": int, "benchmark": dict},
    "reset": {"instruction": str, "state": dict},
    "step": {"state": dict, "success": bool},
    "observe": {},
    "digest": {"digest": bytes},
    "close": {},
}
_OPTIONAL: Mapping[str, Any] = {
    "terminated": bool,
    "reward": _NUMBER,
} | {"score": (*_NUMBER, type(None)), "images": dict, "tensors": dict}

Json = dict[str, Any]
# The replies of an episode: of reset, of each step, and of what was asked in between.
Episode = list[Json]


class SimulatorClient:
    """One process of the simulator, or one connection to it at a socket.

    context: names the rule under test. away_s: how long it is tried again when it does
    not listen at its socket; by default, the time to start.
    """

    def __init__(self, context: CheckContext, away_s: float | None = None) -> None:
        self._context = context
        self._limits = context.shared.settings.simulator
        self._number = self._answered = 0
        command = self._limits["command"]
        try:
            self.process: ConnectionUnderTest | ProcessUnderTest
            if (path := socket_path(context)) is None:
                self.process = ProcessUnderTest(command)
            else:
                wait_s = self._limits["start_timeout_s"] if away_s is None else away_s
                self.process = _connect(path, wait_s)
        except OSError as error:
            if path is not None:
                text = f"{command[0]} cannot be reached: {error.strerror}"
                self.broken("SIM-028", "that a new connection is accepted", text)
            text = f"{command[0]} cannot be started: {error.strerror}"
            raise SetUpFailed(text) from error
        self._has_described = self._has_signalled = False

    @property
    def started(self) -> ProcessUnderTest:
        """The process. Raises NotApplicable for a simulator at a socket."""
        if isinstance(self.process, ConnectionUnderTest):
            raise NotApplicable("the simulator is at a socket")
        return self.process

    def send(self, call: str, **members: Any) -> None:
        """Send a request, with the next number."""
        self._number += 1
        with contextlib.suppress(Ended):  # what it wrote before says more
            self._write(call, self._number, **members)

    def signal(self, call: str) -> None:
        """Send a message that gets no reply: its number is 0."""
        self._write(call, 0)
        self._has_signalled = True

    def _write(self, call: str, number: int, **members: Any) -> None:
        body = msgspec.msgpack.encode({"call": call, "number": number, **members})
        self.process.send(LENGTH.pack(len(body)) + body)

    def receive(self, call: str, bytes_max: int = REPLY_BYTES_MAX) -> Json:
        """The next reply: a map, whatever its members are."""
        name = "timeout_s" if self._has_described else "start_timeout_s"
        timeout_s = float(self._limits[name])
        try:
            body = self.process.read_frame(timeout_s, bytes_max)
            reply = msgspec.msgpack.decode(body)
        except TooSlow as late:
            option = f"--{name.removesuffix('_s').replace('_', '-')}"
            observed = f"{self._describe(late)}; {option} allows more"
            self._too_late(f"a reply to {call}", timeout_s, observed)
        except Ended as ended:
            self.broken("SIM-002", f"a reply to {call}", self._describe(ended))
        except (NoFrame, msgspec.DecodeError) as wrong:
            self.broken("SIM-001", f"a frame with a reply to {call}", str(wrong))
        if not isinstance(reply, dict):
            self.broken("SIM-001", "a map", format_value(reply))
        self._answered += 1
        number = reply.pop("number", None)
        if number == 0 and self._has_signalled:
            self.broken("SIM-036", f"number {self._answered} in {call}", str(body[:80]))
        if number != self._answered:
            self.broken("SIM-025", f"number {self._answered} in {call}", str(body[:80]))
        self._has_described = True
        return reply

    def ask(self, call: str, **members: Any) -> Json:
        """Send a request, and give its reply, which may be a fault."""
        self.send(call, **members)
        return self.receive(call, self._bytes_max(call, members))

    def call(self, call: str, **members: Any) -> Json:
        """Give a reply that is not a fault and has its members."""
        reply = self.ask(call, **members)
        if "fault" in reply:
            fault = f"the fault {format_value(reply['fault'])}"
            if call == "reset":
                episode = "an episode of task {task} with seed {seed}".format(**members)
                self.broken("SIM-010", episode, fault)
            raise SetUpFailed(f"{call} is answered by {fault}")
        for fault in reply_faults(call, reply, has_memory="memory" in members):
            self.broken("SIM-004", f"the members of a reply to {call}", fault)
        return reply

    def _bytes_max(self, call: str, members: Mapping[str, Any]) -> int:
        if call != "observe" or not self._has_described:
            return REPLY_BYTES_MAX
        space = self._limits["benchmark"]["observation_space"]
        pixels = sum(
            members["height"] * members["width"] * space["images"][name]["channels"]
            for name in members.get("images", ())
        )
        sizes = [tensor_bytes(space["tensors"][name]) for name in members["tensors"]]
        return int(pixels + sum(sizes) + EXTRA_BYTES)

    def broken(self, rule: str, expected: str, observed: str) -> Never:
        """Raise: the simulator breaks this rule, whichever one is under test."""
        if rule == self._context.name:
            raise Violation(expected, observed)
        text = f"expected {expected}; observed {observed}"
        raise SetUpFailed(text, breaks=rule)

    def _too_late(self, what: str, limit_s: float, observed: str) -> Never:
        text = f"{what} within {limit_s:g} s"
        if self._context.name == "SIM-003":
            raise TooLate(text, math.inf, limit_s, observed)
        raise SetUpFailed(f"expected {text}; observed {observed}", breaks="SIM-003")

    def _describe(self, what: NoFrame) -> str:
        line = self.process.last_error_line
        code = self.process.wait(0.2) if isinstance(what, Ended) else None
        ended = "" if code is None else f"; exit code {code}"
        return f"{what}{ended}" + (f"; its last error line: {line}" if line else "")

    # --- episodes ---

    def describe(self) -> Json:
        """The benchmark, which later calls need."""
        reply = self.call("describe", protocols=[PROTOCOL])
        benchmark: Json = reply["benchmark"]
        return benchmark

    def reset(self, task: str, seed: int) -> Json:
        """Begin an episode of the first split."""
        splits = self._limits["benchmark"].get("splits") or [{"name": "test"}]
        return self.call("reset", task=task, seed=seed, split=splits[0]["name"])

    def observe(self, task: str, **more: Any) -> Json:
        """All images and tensors of a task. more: members of the request."""
        benchmark = self._limits["benchmark"]
        sizes = benchmark.get("image_sizes") or [{"width": 64, "height": 64}]
        size = sizes[0]
        return self.call(
            "observe",
            images=names_of(benchmark, "images", task),
            tensors=names_of(benchmark, "tensors", task),
            width=size["width"],
            height=size["height"],
            **more,
        )

    def play(
        self,
        task: str,
        seed: int,
        *,
        steps: int = STEPS,
        observed: bool = False,
        digested: bool = False,
    ) -> Episode:
        """The replies of the first steps of an episode; the actions are the same."""
        replies = [self.reset(task, seed)]
        for index in range(steps + 1):
            if digested:
                replies[-1]["digest"] = self.call("digest")["digest"]
            if observed:
                replies[-1]["observation"] = self.observe(task)
            if index == steps or replies[-1].get("terminated"):
                break
            replies.append(self.step(task, index))
        return replies

    def step(self, task: str, index: int) -> Json:
        """Execute the action of this number."""
        return self.call(
            "step", action=action_of(self._limits["benchmark"], task, index)
        )


def socket_path(context: CheckContext) -> str | None:
    """Where the simulator listens; None if it is a command that the kit starts."""
    kind, _, path = context.shared.settings.simulator["command"][0].partition(":")
    return path if kind == "unix" else None


def _connect(path: str, wait_s: float) -> ConnectionUnderTest:
    """Raises OSError if the simulator does not listen in this time."""
    until = time.monotonic() + wait_s
    while True:
        try:
            return ConnectionUnderTest(path)
        except OSError:
            if time.monotonic() > until:
                raise
            time.sleep(_AWAY_PAUSE_S)


@contextlib.contextmanager
def simulator(
    context: CheckContext, away_s: float | None = None
) -> Iterator[SimulatorClient]:
    """A simulator that has described itself; it is ended after the check."""
    client = SimulatorClient(context, away_s)
    try:
        for fault in context.shared.settings.simulator["faults"]:
            client.broken("SIM-008", "a description with all that is required", fault)
        described = client.describe()
        if described != context.shared.settings.simulator["benchmark"]:
            text = "the description of the first process"
            client.broken("SIM-009", text, "another one")
        yield client
    finally:
        client.process.end()


def tasks_of(context: CheckContext) -> Sequence[str]:
    """The tasks that checks play: some of those that can be reset, if there are any."""
    limits = context.shared.settings.simulator
    tasks: Sequence[str] = limits.get("tasks") or limits["benchmark"]["tasks"]
    return tasks[:TASKS_MAX]


def playable_tasks(context: CheckContext) -> Sequence[str]:
    """The tasks of a whole description without those that `reset` refuses (SIM-010)."""
    playable = []
    with simulator(context) as client:
        for task in tasks_of(context):
            with contextlib.suppress(SetUpFailed):
                client.reset(task, context.shared.settings.seed)
                playable.append(task)
    return playable


def names_of(benchmark: Mapping[str, Any], group: str, task: str) -> list[str]:
    """The names of images, tensors or state that a task has."""
    spaces = benchmark["observation_space"].get(group, {})
    return [n for n, space in spaces.items() if task in space.get("tasks", (task,))]


def action_of(benchmark: Mapping[str, Any], task: str, index: int) -> Json:
    """A random action within its bounds, or within 1 of 0; the same for each index."""
    rng = random.Random(index)
    action = {}
    for name, space in benchmark["action_space"].items():
        if task in space.get("tasks", (task,)):
            low = space.get("minimum", [-1.0] * space["size"])
            high = space.get("maximum", [1.0] * space["size"])
            pairs = zip(low, high, strict=True)
            action[name] = [float(rng.uniform(*pair)) for pair in pairs]
    return action


def known_members(call: str) -> Sequence[str]:
    """The members of a reply without a fault, of all that the document has."""
    optional = {"reset": ["stages"], "step": ["terminated", "reward", "score"]}
    of_robots = ["stopped"] if call == "step" else []
    return [*_REQUIRED[call], *optional.get(call, ()), *of_robots]


def reply_faults(
    call: str, reply: Mapping[str, Any], *, has_memory: bool = False
) -> Iterator[str]:
    """How a reply lacks members, or has others of a wrong type.

    has_memory: whether memory was offered, so that images may come without data.
    """
    required = _REQUIRED[call]
    for name, kind in {**_OPTIONAL, **required}.items():
        if name not in reply:
            if name in required:
                yield f"no member {name}"
        elif not _is_a(reply[name], kind):
            yield f"{name} is {format_value(reply[name])}"
    yield from _stage_faults(reply.get("stages", []))
    state = reply.get("state", {})
    for name, numbers in state.items() if isinstance(state, dict) else ():
        if not isinstance(numbers, list) or not all(_is_a(n, _NUMBER) for n in numbers):
            yield f"state {name} is {format_value(numbers)}"
    for group, member, kind in (("images", "shape", list), ("tensors", "dtype", str)):
        for name, value in (reply.get(group) or {}).items():
            if not isinstance(value, dict) or not (
                _is_a(value.get(member), kind)
                and isinstance(value.get("data", b"" if has_memory else None), bytes)
            ):
                yield f"{group} {name} lacks its {member} or its data as `bin`"


def _stage_faults(stages: Any) -> Iterator[str]:
    """How stages are not a list of different names without the goal."""
    is_list = isinstance(stages, list) and all(isinstance(name, str) for name in stages)
    if not is_list or len({"", "goal", *stages}) < len(stages) + 2:
        yield f"stages is {format_value(stages)}"


def _is_a(value: Any, kind: Any) -> bool:
    is_other_truth = isinstance(value, bool) and kind is not bool
    return isinstance(value, kind) and not is_other_truth
