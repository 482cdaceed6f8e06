"""A simulator without packages that an argument breaks: a rule, or a way to misbehave.

    python breakable_simulator.py [SIM-011 | NAME of a function below [unix:PATH [N]]]

Without a fault, or with "", it obeys every rule and has every part of the protocol. At
a socket each connection has a process and a world of its own; N is the one that is
broken, if not all are.
"""

import contextlib
import os
import signal
import socket
import struct
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

LIBRARIES = Path(__file__).parents[3] / "reference_sim" / "external" / "libraries"
sys.path.insert(0, str(LIBRARIES))

import proctor_simulator  # noqa: E402
from proctor_simulator import _LENGTH, _Session, _write, pack, part, unpack, vector  # noqa: E402

__all__ = ["WORLD", "part", "proctor_simulator", "vector"]

Json = dict[str, Any]
REPLIES = os.dup(1)
REQUESTS = sys.stdin.buffer
SLEEPERS: list[subprocess.Popen[bytes]] = []


class CountingWorld(proctor_simulator.Simulator):
    """The state is the seed plus the sum of actions; at 3 more, the task is done."""

    def __init__(self) -> None:
        self.benchmark = {
            "benchmark_id": "breakable",
            "simulator": {"name": "breakable", "version": "1"},
            "tasks": ["count", "hold"],
            "max_steps": 20,
            "graded": True,
            "digest": True,
            "shared_memory": True,
            "action_space": {"add": vector(1, [0.0], [0.1])},
            "observation_space": {
                "state": {"sum": vector(1), "left": vector(1) | {"tasks": ["count"]}},
                "images": {"bar": {"channels": 1, "description": "the sum"}},
                "tensors": {
                    "sums": {"dtype": "float32", "shape": [2], "description": "both"}
                },
            },
            "image_sizes": [{"width": 8, "height": 6}, {"width": 640, "height": 480}],
            "splits": [{"name": "test", "seeds": [1, 2, 3]}],
        }
        self.offset = 0.0

    def reset(self, task: str, seed: int, split: str) -> Json:
        self.task, self.seed, self.sum, self.steps = task, seed, self.offset, 0
        begun = {"instruction": f"Please {task}.", "state": self.state()}
        return begun | {"stages": ["begun", "on the way"] if task == "hold" else []}

    def step(self, action: Json) -> Json:
        self.sum += action["add"][0]
        self.steps += 1
        done = {"success": self.sum >= 3, "score": min(1.0, max(0.0, self.sum / 3))}
        if self.task == "hold" and not done["success"]:
            done["score"] = ((self.sum > 0) + (self.sum > 0.2)) / 3
        return {"state": self.state(), "reward": self.sum, **done}

    def state(self) -> Json:
        left = {"left": [3 - self.sum]} if self.task == "count" else {}
        return {"sum": [self.seed + self.sum], **left}

    def draw(self, camera: str, width: int, height: int) -> bytes:
        return bytes([int(self.sum * 50) % 256]) * (width * height)

    def tensor(self, name: str) -> bytes:
        return struct.pack("<2f", self.seed, self.sum)

    def digest(self) -> bytes:
        return struct.pack("<2d", self.seed, self.sum)


WORLD = CountingWorld()
# A change gets the request and the right reply, and gives the wrong reply.
Change = Callable[[Json, Json], Json]
CHANGES: dict[str, Change] = {}


def breaks(name: str, *calls: str) -> Callable[[Change], Change]:
    """Register a change of the replies to these calls, or of all and of faults."""

    def register(change: Change) -> Change:
        def at_calls(request: Json, reply: Json) -> Json:
            is_reply = request["call"] in calls and "fault" not in reply
            return change(request, reply) if is_reply else reply

        CHANGES[name] = at_calls if calls else change
        return change

    return register


# --- one for each rule ---


@breaks("SIM-001", "step")
def prints_where_frames_are(_request: Json, reply: Json) -> Json:
    os.write(REPLIES, b"loaded 3 assets\n")
    return reply


@breaks("SIM-002", "step")
def ends_in_an_episode(_request: Json, reply: Json) -> Json:
    if WORLD.steps == 3:
        sys.stderr.write("no more memory\n")
        os._exit(7)
    return reply


@breaks("SIM-003", "step")
def hangs(_request: Json, reply: Json) -> Json:
    while WORLD.steps == 2:
        time.sleep(60)
    return reply


@breaks("SIM-004", "reset")
def has_no_instruction(_request: Json, reply: Json) -> Json:
    return {name: value for name, value in reply.items() if name != "instruction"}


# Values that are no boolean, by the name of the simulator that sends them.
NO_BOOLEANS: dict[str, tuple[str, Any]] = {
    "success_text": ("success", "no"),
    "success_share": ("success", 0.3),
    "success_number": ("success", 1),
    "success_list": ("success", [False]),
    "success_map": ("success", {"goal": False}),
    "success_null": ("success", None),
    "terminated_text": ("terminated", "False"),
}


def sends_a_value(name: str, value: Any) -> Change:
    return lambda _request, reply: reply | {name: value}


for _fault, (_name, _value) in NO_BOOLEANS.items():
    breaks(_fault, "step")(sends_a_value(_name, _value))


@breaks("SIM-005")
def accepts_any_call(_request: Json, reply: Json) -> Json:
    return {} if "unknown call" in reply.get("fault", "") else reply


@breaks("SIM-006")
def refuses_unknown_members(request: Json, reply: Json) -> Json:
    is_strict = any("later" in name for name in request)
    return {"fault": "what is that?"} if is_strict else reply


@breaks("SIM-007", "describe")
def takes_the_last_protocol(request: Json, reply: Json) -> Json:
    return reply | {"protocol": request["protocols"][-1]}


@breaks("SIM-008", "describe")
def declares_no_unit(_request: Json, reply: Json) -> Json:
    WORLD.benchmark["action_space"]["add"]["parts"]["all"].pop("unit", None)
    return reply


@breaks("SIM-009", "describe")
def describes_its_process(_request: Json, reply: Json) -> Json:
    return reply | {"benchmark": reply["benchmark"] | {"title": str(os.getpid())}}


@breaks("SIM-013")
def faults_at_an_unknown_task(_request: Json, reply: Json) -> Json:
    return {name: value for name, value in reply.items() if name != "unplayable"}


@breaks("SIM-015", "step")
def has_one_number_more(_request: Json, reply: Json) -> Json:
    reply["state"]["sum"].append(0.0)
    return reply


@breaks("SIM-016", "step")
def scores_by_the_reward(_request: Json, reply: Json) -> Json:
    return reply | {"score": reply["reward"] + 1}


@breaks("SIM-037", "step")
def counts_the_goal_as_a_stage(_request: Json, reply: Json) -> Json:
    return reply | {"score": min(1.0, 1.5 * reply["score"])}


@breaks("stages_with_the_goal", "reset")
def names_the_goal(_request: Json, reply: Json) -> Json:
    return reply | {"stages": ["begun", "goal"]}


@breaks("SIM-017", "observe")
def draws_in_one_size(request: Json, reply: Json) -> Json:
    for name in () if "memory" in request else reply.get("images", {}):
        reply["images"][name] = {"shape": [6, 8, 1], "data": bytes(48)}
    return reply


@breaks("SIM-018", "observe")
def sends_doubles(_request: Json, reply: Json) -> Json:
    for tensor in reply.get("tensors", {}).values():
        tensor.update(dtype="float64", data=bytes(16))
    return reply


@breaks("SIM-019", "observe")
def moves_when_it_draws(_request: Json, reply: Json) -> Json:
    WORLD.sum += 0.01 * (WORLD.steps > 0)
    return reply


@breaks("SIM-020", "digest")
def has_one_digest(_request: Json, reply: Json) -> Json:
    return {"digest": b"always"} if "digest" in reply else reply


@breaks("SIM-022", "close")
def ends_with_an_error(request: Json, reply: Json) -> Json:
    _write(REPLIES, numbered(request, reply))
    os._exit(3)


@breaks("SIM-025")
def has_the_number_of_a_fault(_request: Json, reply: Json) -> Json:
    return reply | {"number": 0} if "fault" in reply else reply


@breaks("SIM-027", "close")
def keeps_the_connection(request: Json, reply: Json) -> Json:
    _write(REPLIES, numbered(request, reply))
    time.sleep(60)
    return {}


def continues_after_three_steps(right: Callable[..., Json]) -> Callable[..., Json]:
    def reset(task: str, seed: int, split: str) -> Json:
        if getattr(WORLD, "steps", 0) == 3:
            return {"instruction": "Go on.", "state": WORLD.state(), "stages": []}
        return right(task, seed, split)

    return reset


def remembers_an_episode_of_six_steps(
    right: Callable[..., Json],
) -> Callable[..., Json]:
    def reset(task: str, seed: int, split: str) -> Json:
        if getattr(WORLD, "steps", 0) == 6:
            WORLD.offset += 0.01
        return right(task, seed, split)

    return reset


def draws_without_the_seed(right: Callable[..., Json]) -> Callable[..., Json]:
    def reset(task: str, seed: int, split: str) -> Json:
        WORLD.offset += 0.01  # as from a generator that goes on
        return right(task, seed, split)

    return reset


def refuses_to_hold(right: Callable[..., Json]) -> Callable[..., Json]:
    def reset(task: str, seed: int, split: str) -> Json:
        return {"count": right}[task](task, seed, split)

    return reset


def plays_one_episode(right: Callable[..., Json]) -> Callable[..., Json]:
    return lambda task, _seed, split: right(task, 7, split)


def offsets_that_are_one_too_large(
    right: Callable[..., dict[str, int]],
) -> Callable[..., dict[str, int]]:
    def offsets(offered: Json | None) -> dict[str, int]:
        return {name: offset + 1 for name, offset in right(offered).items()}

    return offsets


# --- ways to misbehave, of which a server must lose an episode and nothing else ---


@breaks("protocol_2", "describe")
def speaks_another_protocol(_request: Json, reply: Json) -> Json:
    return reply | {"protocol": 2}


@breaks("by_chance", "describe")
def is_not_deterministic(_request: Json, reply: Json) -> Json:
    return reply | {"benchmark": WORLD.benchmark | {"deterministic": False}}


@breaks("ungraded", "describe", "step")
def names_stages_without_scores(request: Json, reply: Json) -> Json:
    if request["call"] == "describe":
        return reply | {"benchmark": WORLD.benchmark | {"graded": False}}
    return {name: value for name, value in reply.items() if name != "score"}


@breaks("has_mistyped_members", "describe")
def mistypes_members(_request: Json, reply: Json) -> Json:
    observed = WORLD.benchmark["observation_space"] | {"org_example_smell": 1}
    more = {"observation_space": observed, "control_rate": 5.0}
    return reply | {"benchmark": WORLD.benchmark | more}


@breaks("floods", "step")
def writes_errors_without_end(_request: Json, reply: Json) -> Json:
    for _ in range(20_000):
        sys.stderr.write("E" * 100 + "\n")
    return reply


@breaks("floods_forever", "step")
def never_stops_to_write(_request: Json, _reply: Json) -> Json:
    while True:
        os.write(2, b"x" * 65536)


@breaks("sends_2_gb", "observe")
def announces_and_sends_2_gb(_request: Json, _reply: Json) -> Json:
    os.write(REPLIES, _LENGTH.pack(2 << 30))
    while True:
        os.write(REPLIES, bytes(1 << 16))


@breaks("lies_about_sizes", "observe")
def says_that_pictures_are_larger(_request: Json, reply: Json) -> Json:
    for image in reply["images"].values():
        image["shape"] = [480, 640, 1]
    return reply


@breaks("garbage", "step")
def writes_what_is_not_messagepack(_request: Json, _reply: Json) -> Json:
    os.write(REPLIES, _LENGTH.pack(3) + b"\xc1\xc1\xc1")
    signal.pause()
    return {}


@breaks("replies_twice", "step")
def sends_each_reply_twice(request: Json, reply: Json) -> Json:
    body = b"".join(pack(numbered(request, reply)))
    os.write(REPLIES, 2 * (_LENGTH.pack(len(body)) + body))  # both arrive at once
    return reply


@breaks("replies_late", "step")
def repeats_its_reply_when_the_next_is_waited_for(request: Json, reply: Json) -> Json:
    return reply | {"number": request["number"] - (WORLD.steps > 1)}


@breaks("has_no_numbers")
def is_of_an_earlier_draft(request: Json, reply: Json) -> Json:
    return reply if request["call"] == "describe" else reply | {"number": None}


@breaks("faults_to_observe", "observe")
def cannot_draw(_request: Json, _reply: Json) -> Json:
    return {"fault": "the display is gone"}


@breaks("not_finite", "step")
def sends_nan(_request: Json, reply: Json) -> Json:
    reply["state"]["sum"] = [float("nan")]
    return reply


@breaks("killed", "step")
def kills_itself(_request: Json, _reply: Json) -> Json:
    os.kill(os.getpid(), signal.SIGKILL)
    return {}


@breaks("dies_once", "step")
def dies_in_the_first_process(_request: Json, reply: Json) -> Json:
    flag = Path("has_died")
    if WORLD.steps == 5 and not flag.exists():
        flag.touch()
        os._exit(9)
    return reply


@breaks("forks", "step")
def leaves_daemons_and_ends(_request: Json, _reply: Json) -> Json:
    """Two children and an orphan, each in a session of its own."""
    for _ in range(2):
        start_sleeper()
    if os.fork() == 0:
        start_sleeper()
        os._exit(0)
    os._exit(1)


@breaks("writes_files", "step")
def leaves_files(_request: Json, reply: Json) -> Json:
    Path(os.environ["TMPDIR"], "left.bin").write_bytes(bytes(1000))
    sys.stderr.write(f"TMPDIR={os.environ['TMPDIR']}\n")
    sys.stderr.write(f"PYTHONPATH={os.environ.get('PYTHONPATH', '')}\n")
    sys.stderr.write(f"SECRETS={[n for n in os.environ if 'PROCTOR' in n]}\n")
    return reply


def start_sleeper() -> None:
    SLEEPERS.append(
        subprocess.Popen(
            ["sleep", "120"],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
        )
    )


def ends_the_program(action: Json) -> Json:
    sys.exit(f"no licence to act by {', '.join(action)}")


def break_world(fault: str) -> None:
    """Break more than a single reply."""
    resets = {
        "SIM-010": continues_after_three_steps,
        "SIM-011": remembers_an_episode_of_six_steps,
        "draws_without_the_seed": draws_without_the_seed,
        "ignores_the_seed": plays_one_episode,
        "refuses_a_task": refuses_to_hold,
    }
    if fault in resets:
        WORLD.reset = resets[fault](WORLD.reset)  # type: ignore[method-assign]
    if fault == "world_reports_text":  # the library, not the reply, meets the value
        right = WORLD.step
        WORLD.step = lambda action: right(action) | {"success": "no"}  # type: ignore[method-assign]
    if fault == "exits_by_python":
        WORLD.step = ends_the_program  # type: ignore[method-assign]
    if fault == "SIM-012":
        WORLD.offset = (time.time_ns() % 1000) / 1000
    if fault == "SIM-024":
        start_sleeper()


def numbered(request: Json, reply: Json) -> Json:
    return {"number": request["number"], **reply}


def serve_connections(fault: str, path: str, broken: int = 0) -> None:
    """Each in a child of its own: what it does to itself costs no other connection."""
    global REPLIES, REQUESTS
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)
    listener = socket.socket(socket.AF_UNIX)
    listener.bind(path)
    listener.listen(8)
    count = 0
    while True:
        connection, _ = listener.accept()
        count += 1
        if os.fork() == 0:
            listener.close()
            REPLIES, REQUESTS = connection.fileno(), connection.makefile("rb")
            if fault == "SIM-026":
                WORLD.offset = 0.01 * len(list(open_connections()))
            main(fault if broken in (0, count) else "")
        connection.close()
        if fault == "SIM-028" and count == 2:
            listener.close()
            signal.pause()


def open_connections() -> Iterator[Path]:
    """The other processes of this process's parent."""
    own = f"PPid:\t{os.getppid()}\n"
    for path in Path("/proc").glob("[0-9]*/status"):
        with contextlib.suppress(OSError):
            if own in path.read_text() and path.parent.name != str(os.getpid()):
                yield path


def main(fault: str) -> None:
    session = _Session(WORLD)
    break_world(fault)
    if fault == "SIM-014":
        WORLD.reset("count", 0, "")
        session._is_reset = True

    def unchanged(_request: Json, reply: Json) -> Json:
        return reply

    if fault == "SIM-021":
        session._offsets = offsets_that_are_one_too_large(session._offsets)  # type: ignore[method-assign]
    change = CHANGES.get(fault, unchanged)
    while (request := receive()) is not None:
        _write(REPLIES, numbered(request, change(request, session.answer(request))))
        if request["call"] == "close":
            break
    if fault == "SIM-023":
        time.sleep(2.6)
    os._exit(0)  # a sleeper is not waited for


def receive() -> Json | None:
    """The next request; None when the input has ended."""
    head = REQUESTS.read(_LENGTH.size)
    if len(head) < _LENGTH.size:
        return None
    (length,) = _LENGTH.unpack(head)
    body = REQUESTS.read(length)
    request: Json = unpack(body) if len(body) == length else {}
    return request or None


if __name__ == "__main__":
    if sys.argv[2:]:
        fault, address, *numbers = sys.argv[1:]
        serve_connections(fault, address.removeprefix("unix:"), *map(int, numbers))
    main("".join(sys.argv[1:]))
