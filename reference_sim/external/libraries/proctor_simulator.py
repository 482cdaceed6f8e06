"""Serves a simulator to an evaluation server over the simulator protocol.

One file without dependencies, for Python 3.8 and newer: copy it beside your program.

    import proctor_simulator

    class World(proctor_simulator.Simulator):
        benchmark = {...}  # spec/simulator.md, "The benchmark"; vector() helps

        def reset(self, task, seed, split):
            return {"instruction": "Reach the target.", "state": {"position": [0, 0]}}

        def step(self, action):
            return {"state": {"position": [0, 0]}, "success": False}

        def draw(self, camera, width, height):  # only with cameras
            return pixels  # uint8 (height, width, channels): an array, or bytes

    if __name__ == "__main__":
        proctor_simulator.serve(World(), *sys.argv[1:])

The server starts such a program. One that you start yourself, in a container or on a
display, is given the address of a Unix socket, `unix:/run/world.sock`, and listens
there for one server after the other.

Numbers and arrays may be NumPy's or others with `tolist`. Standard output belongs to
the protocol: while `serve` runs, what is printed goes to standard error. The SHA-256 of
each file of yours that is imported becomes part of the benchmark, so import them before
`serve`. Files in `site-packages` and in folders given as `installed` are not yours.

A robot is a simulator whose benchmark has the member `physical`; derive it from `Robot`
and write `stop`, too. This library calls `stop` when the server or its operator says
so, when the connection ends, and when no message came for `watchdog_s`.
"""

from __future__ import annotations

import hashlib
import io
import mmap
import os
import queue
import reprlib
import select
import socket
import struct
import sys
import sysconfig
import threading
import time
import traceback
from pathlib import Path
from typing import Any, Dict, List, NoReturn, Sequence, Set, Tuple, Union

PROTOCOL = 1
_LENGTH = struct.Struct(">I")
_LINES = 1  # _IOLBF of C
_LOOK_S = 0.1  # how often the guard of a robot sees that it is to end
_FOLDER = Path.cwd().resolve()  # a simulator may change it later
# A world or a driver may raise these: engines also call sys.exit.
_RAISED = (Exception, SystemExit)
Buffer = Union[bytes, bytearray, memoryview]


class Unplayable(Exception):
    """Raise it in `reset` for a task that can never be played."""


def _missing(simulator: Simulator, method: str, member: str = "") -> Exception:
    """member: of the benchmark, because of which the method is needed."""
    why = f", which `{member}` of its benchmark needs" if member else ""
    return NotImplementedError(f"{type(simulator).__name__} has no {method}{why}")


class Simulator:
    """The base class of a world; `reset` and `step` must be written."""

    benchmark: Dict[str, Any] = {}  # noqa: RUF012 - each class has its own

    def reset(self, task: str, seed: int, split: str) -> Dict[str, Any]:
        """Begin an episode: {"instruction": text, "state": {name: numbers}} and, where
        the score counts them, "stages": names of what leads to the goal, without it."""
        raise _missing(self, "reset(task, seed, split)")

    def step(self, action: Dict[str, List[float]]) -> Dict[str, Any]:
        """Execute {name: numbers}: {"state": …, "success": bool} and, if there is need,
        "terminated": bool, "reward": number, "score": 0 to 1. For a truth, 0 and 1 and
        NumPy's may stand; any other value is a fault."""
        raise _missing(self, "step(action)")

    def draw(self, camera: str, width: int, height: int) -> Any:
        """Pixels of a camera: uint8 (height, width, channels), RGB, top row first."""
        raise _missing(self, "draw(camera, width, height)", "images")

    def tensor(self, name: str) -> Any:
        """The bytes of a tensor, or an array with little-endian numbers."""
        raise _missing(self, "tensor(name)", "tensors")

    def digest(self) -> bytes:
        """Bytes that are equal when the rest of the episode is decided equally."""
        raise _missing(self, "digest()", "digest")

    def close(self) -> None:
        """Free what the end of the program does not free."""


class Robot(Simulator):
    """The base class of a robot: `reset`, `step` and `stop` must be written."""

    def stop(self) -> None:
        """End every motion, and allow none before the next `reset`.

        Another thread calls it, also while `reset` or `step` is executed, and perhaps
        several times. No later command of these two may move the robot: let the driver
        refuse it, or check an event of yours before each command.
        """
        raise _missing(self, "stop()", "physical")


def part(
    size: int,
    quantity: str = "number",
    unit: str = "1",
    frame: str = "none",
    *,
    rotation: str = "none",
    relative_to: str = "none",
    **more: Any,
) -> Dict[str, Any]:
    """Adjacent numbers of one meaning; spec/conventions.md has the words."""
    space: Dict[str, Any] = {"size": size, "quantity": quantity, "unit": unit}
    space.update(frame=frame, rotation=rotation, relative_to=relative_to)
    space.update(more)
    return space


def vector(
    parts: Any, minimum: Any = None, maximum: Any = None, **more: Any
) -> Dict[str, Any]:
    """A VectorSpace of {name: part}, one after the other, or of so many numbers.

    With bounds, numbers beyond them are executed as the nearest allowed ones.
    """
    if isinstance(parts, int):
        parts = {"all": part(parts)}
    space: Dict[str, Any] = {"size": 0, "parts": {}, "out_of_range": "unbounded"}
    for name, declared in parts.items():
        space["parts"][name] = dict(declared, start=space["size"])
        space["size"] += declared["size"]
    if minimum is not None:
        space.update(minimum=minimum, maximum=maximum, out_of_range="clip")
    space.update(more)
    return space


def serve(
    simulator: Simulator, address: str = "", *, installed: Sequence[str] = ()
) -> NoReturn:
    """Answer requests until the server closes; then end the program.

    address: `unix:PATH`, where to listen; then it goes on for the next server.
    installed: folders with packages of others, besides `site-packages`.
    """
    if isinstance(simulator, type):
        raise TypeError(f"serve needs an object: serve({simulator.__name__}())")
    sources = _Sources(installed)
    if address:
        _serve_connections(simulator, address, sources)
    requests, replies = os.fdopen(os.dup(0), "rb"), os.dup(1)
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
    _print_to_standard_error()
    _answer(simulator, sources, requests, replies)
    simulator.close()
    sys.exit(0)


def _print_to_standard_error() -> None:
    """Prints, in C as well, must not break a frame, and a crash must not lose them: C
    prints whole blocks to a pipe, and the last one holds the lines that say why."""
    os.dup2(2, 1)
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(line_buffering=True)  # Python 3.8 has blocks, too
    sys.stdout = sys.stderr
    try:
        import ctypes

        c = ctypes.CDLL(None)
        name = "__stdoutp" if sys.platform == "darwin" else "stdout"
        c.fflush(None)
        c.setvbuf(ctypes.c_void_p.in_dll(c, name), None, _LINES, ctypes.c_size_t(0))
    except (ImportError, AttributeError, OSError, ValueError):
        pass  # this C library is another one: its prints come later


def _serve_connections(simulator: Simulator, address: str, sources: Any) -> NoReturn:
    """One connection at a time, because there is one world. The socket is closed
    meanwhile, so that the server sees that the simulator is busy."""
    kind, _, path = address.partition(":")
    if kind != "unix" or not path:
        raise ValueError(f"an address is unix:PATH, not {address!r}")
    while True:
        if Path(path).is_socket():
            os.unlink(path)  # noqa: PTH108
        with socket.socket(socket.AF_UNIX) as listener:
            listener.bind(path)
            listener.listen(1)
            connection, _ = listener.accept()
        with connection, connection.makefile("rb") as requests:
            try:
                _answer(simulator, sources, requests, connection.fileno())
            except Exception as error:  # noqa: BLE001 - the next server may do better
                sys.stderr.write(f"the connection failed: {error}\n")


def _answer(simulator: Simulator, sources: Any, requests: Any, replies: int) -> None:
    """Answer requests until `close` or their end."""
    guard = _StopGuard(simulator, requests.fileno()) if _is_robot(simulator) else None
    session = _Session(simulator, sources, guard)
    try:
        while True:
            request = guard.next_request() if guard else _read(requests)
            if request is None:
                return
            reply = session.answer(request)
            _write(replies, dict(reply, number=request.get("number")))
            if request.get("call") == "close":
                return
    finally:
        if guard:
            guard.end()


def _read(requests: Any) -> Any:
    """The next request; None at the end."""
    head = requests.read(_LENGTH.size)
    if len(head) < _LENGTH.size:
        return None
    (length,) = _LENGTH.unpack(head)
    body = requests.read(length)
    return unpack(body) if len(body) == length else None


def _is_robot(simulator: Simulator) -> bool:
    return "physical" in simulator.benchmark


class _StopGuard:
    """Stops a robot in time, whatever the rest of the program does.

    A thread reads all that the server sends, and stops the robot at the message `stop`,
    at the end of the connection, and when no message came for `watchdog_s`. The other
    requests wait for the main thread. stopped_by: why the robot stands still; empty
    while it may move, which is from the request `reset` to the first stop.
    """

    def __init__(self, robot: Any, descriptor: int) -> None:
        self._robot, self._descriptor = robot, descriptor
        self._watchdog_s = float(robot.benchmark["physical"]["watchdog_s"])
        self._requests: Any = queue.Queue()
        self._is_ended = False
        self.stopped_by = "start"
        self._thread = threading.Thread(target=self._watch, daemon=True)
        self._thread.start()

    def next_request(self) -> Any:
        """The next request; None at the end."""
        return self._requests.get()

    def stop(self, reason: str) -> None:
        """Stop the robot; a stop that fails is tried again until it does not."""
        self.stopped_by = self.stopped_by or reason
        for _ in range(1000):
            try:
                self._robot.stop()
            except _RAISED:
                traceback.print_exc()
                time.sleep(0.01)
            else:
                break

    def end(self) -> None:
        """Stop the robot, and read nothing more: the descriptor may be another's."""
        self.stop("connection")
        self._is_ended = True
        self._thread.join()

    def stop_again(self) -> None:
        """After a request that a stop interrupted: its last command may be younger."""
        if self.stopped_by:
            self.stop(self.stopped_by)

    def _watch(self) -> None:
        readable = select.poll()
        readable.register(self._descriptor, select.POLLIN)
        received, heard_at = bytearray(), time.monotonic()
        while not self._is_ended:
            wait_s = _LOOK_S
            if not self.stopped_by:
                left_s = heard_at + self._watchdog_s - time.monotonic()
                wait_s = min(wait_s, max(0.0, left_s))
            if not readable.poll(wait_s * 1000):
                is_over = heard_at + self._watchdog_s <= time.monotonic()
                if is_over and not self.stopped_by:
                    self.stop("watchdog")
                continue
            try:
                data = os.read(self._descriptor, 1 << 16)
            except OSError:
                data = b""
            if not data:
                break
            heard_at = time.monotonic()
            received += data
            try:
                for message in _take_messages(received):
                    self._receive(message)
            except Exception:  # noqa: BLE001 - it was not a message
                traceback.print_exc()
                break
        self.stop("connection")
        self._requests.put(None)

    def _receive(self, message: Dict[str, Any]) -> None:
        call = message.get("call")
        if call in ("stop", "close"):
            self.stop("server")
        elif call == "reset":
            self.stopped_by = ""
        if call not in ("stop", "alive"):
            self._requests.put(message)


def _take_messages(received: bytearray) -> List[Any]:
    """The whole messages at the front, which are removed."""
    messages = []
    while len(received) >= _LENGTH.size:
        end = _LENGTH.size + _LENGTH.unpack_from(received)[0]
        if len(received) < end:
            break
        messages.append(unpack(bytes(received[_LENGTH.size : end])))
        del received[:end]
    return messages


class _Session:
    """Answers one request after the other."""

    def __init__(
        self, simulator: Simulator, sources: Any = None, guard: Any = None
    ) -> None:
        self._simulator, self._guard = simulator, guard
        self._state: Any = {}  # the last one of a robot
        self._is_reset = False
        self._sources = sources or _Sources()
        self._number, self._memory = -1, None  # type: Tuple[int, Any]

    def answer(self, request: Dict[str, Any]) -> Dict[str, Any]:
        call = request.get("call")
        calls = {
            "describe": self._describe,
            "reset": self._reset,
            "step": self._step,
            "observe": self._observe,
            "digest": self._digest,
            "close": self._close,
        }
        try:
            if call not in calls:
                return {"fault": f"unknown call {call!r}"}
            if call in ("step", "observe", "digest") and not self._is_reset:
                return {"fault": f"{call} before the first reset"}
            reply = calls[call](request)
        except Unplayable as unplayable:
            return {"fault": str(unplayable), "unplayable": True}
        except _RAISED as error:
            traceback.print_exc()
            return {"fault": f"{type(error).__name__}: {error}"}
        late = self._sources.imported_late()
        return {"fault": late} if late else reply

    def _describe(self, request: Dict[str, Any]) -> Dict[str, Any]:
        if PROTOCOL not in request["protocols"]:
            return {"fault": f"this library speaks protocol {PROTOCOL}"}
        announced = self._sources.announced()
        announced.update(self._simulator.benchmark.get("sources", {}))
        benchmark = dict(self._simulator.benchmark, sources=announced)
        return {"protocol": PROTOCOL, "benchmark": benchmark}

    def _reset(self, request: Dict[str, Any]) -> Dict[str, Any]:
        task = request["task"]
        if task not in self._simulator.benchmark["tasks"]:
            raise Unplayable(f"there is no task {task!r}")
        begun = self._simulator.reset(task, request["seed"], request["split"])
        self._is_reset = True
        if self._guard:
            self._guard.stop_again()
            self._state = begun["state"]
            if self._guard.stopped_by:
                reason = self._guard.stopped_by
                return {"fault": f"the robot was stopped during its reset ({reason})"}
        return begun

    def _step(self, request: Dict[str, Any]) -> Dict[str, Any]:
        if self._guard:
            return self._step_robot(request["action"])
        return _with_plain_verdicts(self._simulator.step(request["action"]))

    def _step_robot(self, action: Dict[str, List[float]]) -> Dict[str, Any]:
        """As `_step`; what a stop interrupts or comes before ends the attempt."""
        done: Dict[str, Any] = {"success": False}
        if not self._guard.stopped_by:
            self._check_limits(action)
            try:
                done = _with_plain_verdicts(self._simulator.step(action))
                self._state = done["state"]
            except _RAISED:
                if not self._guard.stopped_by:
                    self._guard.stop("fault")
                    raise
                traceback.print_exc()
            self._guard.stop_again()
        done["state"] = self._state
        done["stopped"] = self._guard.stopped_by
        done["terminated"] = done.get("terminated", False) or bool(done["stopped"])
        return done

    def _check_limits(self, action: Dict[str, List[float]]) -> None:
        """The server has checked them, too, and may have a defect."""
        spaces = self._simulator.benchmark["action_space"]
        for name, values in action.items():
            for i, value in enumerate(values):
                low, high = spaces[name]["minimum"][i], spaces[name]["maximum"][i]
                if not low <= value <= high:
                    self._guard.stop("limits")
                    raise ValueError(f"{name}: {value} is not from {low} to {high}")

    def _observe(self, request: Dict[str, Any]) -> Dict[str, Any]:
        images: Dict[str, Any] = {}
        tensors: Dict[str, Any] = {}
        spaces = self._simulator.benchmark["observation_space"]
        offsets = self._offsets(request.get("memory"))
        for name in request.get("images", ()):
            height, width = request["height"], request["width"]
            shape = [height, width, spaces["images"][name]["channels"]]
            drawn = self._simulator.draw(name, width, height)
            data = _checked(f"draw of {name!r}", drawn, "uint8", shape)
            images[name] = {"shape": shape}
            offset = offsets.get(name)
            if offset is None:
                images[name]["data"] = data
            else:
                self._memory[offset : offset + len(data)] = data
        for name in request.get("tensors", ()):
            space = spaces["tensors"][name]
            tensors[name] = {"dtype": space["dtype"], "shape": space["shape"]}
            values = self._simulator.tensor(name)
            what = f"tensor of {name!r}"
            tensors[name]["data"] = _checked(what, values, **tensors[name])
        return {"images": images, "tensors": tensors}

    def _offsets(self, offered: Any) -> Dict[str, int]:
        """The places of images in the server's memory; none if it cannot be mapped."""
        if offered is None:
            return {}
        if offered["number"] != self._number:
            self._number, self._memory = offered["number"], None
            try:
                with open(offered["path"], "r+b") as file:  # noqa: PTH123
                    self._memory = mmap.mmap(file.fileno(), offered["size"])
            except (OSError, ValueError):
                pass
        offsets: Dict[str, int] = offered["offsets"]
        return {} if self._memory is None else offsets

    def _digest(self, _request: Dict[str, Any]) -> Dict[str, Any]:
        return {"digest": bytes(self._simulator.digest())}

    def _close(self, _request: Dict[str, Any]) -> Dict[str, Any]:
        return {}


def _with_plain_verdicts(returned: Any) -> Dict[str, Any]:
    """The members of a step, of which those that decide a score or an end get the types
    of the protocol. Raises ValueError for a text or any other object in their place:
    Python's truth of it would decide by chance."""
    done = dict(returned)
    if done.get("score") is None:  # the protocol takes both for a score not given
        done.pop("score", None)
    optional = [name for name in ("terminated", "reward", "score") if name in done]
    for name in ["success", *optional]:
        value = done[name]
        if getattr(value, "shape", None) == () and hasattr(value, "item"):
            value = value.item()  # a scalar, or an array without an axis
        is_number = isinstance(value, (bool, int, float))
        is_truth = name in ("success", "terminated")
        if not is_number or (is_truth and value not in (0, 1)):
            needed = "true or false, or 0 or 1" if is_truth else "a number"
            kind = type(done[name]).__name__
            text = f"{name} is {reprlib.repr(done[name])} ({kind})"
            raise ValueError(f"{text}, and must be {needed}")
        done[name] = bool(value) if is_truth else float(value)
    return done


class _Sources:
    """The program's own files of Python, which no package versions."""

    def __init__(self, installed: Sequence[str] = ()) -> None:
        names = ("stdlib", "platstdlib")
        folders = [
            *map(sysconfig.get_path, names),
            os.environ.get("TMPDIR"),
            *installed,
        ]
        named = [Path(folder).absolute() for folder in folders if folder]
        self._installed = {*named, *(folder.resolve() for folder in named)}
        self._announced: Dict[str, str] = {}
        self._modules: Set[str] = set()

    def announced(self) -> Dict[str, str]:
        """Name → SHA-256 of each file that was imported before the first call."""
        if not self._modules:
            self._modules = set(sys.modules)
            for module in sorted(self._modules):
                path = self._own_file(module)
                if path:
                    digest = hashlib.sha256(path.read_bytes()).hexdigest()
                    name = _source_name(module, path)
                    is_taken = self._announced.get(name, digest) != digest
                    self._announced[module if is_taken else name] = digest
        return dict(self._announced)

    def imported_late(self) -> str:
        """Say which file was imported since; empty if none was."""
        if not self._modules or len(sys.modules) == len(self._modules):
            return ""
        for module in set(sys.modules) - self._modules:
            path = self._own_file(module)
            # multiprocessing gives the program itself a second name.
            if path and _source_name(module, path) not in self._announced:
                return (
                    f"{_source_name(module, path)} was not imported when the program "
                    "described itself, so it is not in the manifest; import it at the "
                    "top of the program"
                )
        self._modules = set(sys.modules)
        return ""

    def _own_file(self, module: str) -> Path | None:
        file = getattr(sys.modules.get(module), "__dict__", {}).get("__file__")
        if not isinstance(file, str):
            return None
        if module == "__main__":  # Python 3.8 has it relative
            file = str(_FOLDER / file)
        path = Path(file)
        if not path.is_absolute() or not path.is_file():
            return None
        # Debian links files of the standard library to files elsewhere.
        if any(map(self._is_installed, (path, path.resolve()))):
            return None
        return path.resolve()

    def _is_installed(self, path: Path) -> bool:
        folders = {"site-packages", "dist-packages"}
        is_package = not folders.isdisjoint(path.parts)
        return is_package or not self._installed.isdisjoint(path.parents)


def _source_name(module: str, path: Path) -> str:
    """Its path within the folder where the program starts, or that of imports."""
    if _FOLDER in path.parents:
        return path.relative_to(_FOLDER).as_posix()
    packages = module.split(".")
    return "/".join([*packages[: None if path.stem == "__init__" else -1], path.name])


def _checked(what: str, array: Any, dtype: str, shape: Sequence[int]) -> Buffer:
    """The bytes of an array of this type and shape. Raises ValueError for another one:
    its bytes would be read as other numbers. Bytes alone have neither."""
    has = str(getattr(array, "dtype", dtype))
    if has != dtype:
        text = f"{what} returned {has}, and {dtype} {tuple(shape)} is needed"
        if dtype == "uint8" and has.startswith("float"):
            text += ": (255 * pixels).astype(numpy.uint8), where 1 is white"
        raise ValueError(text)
    if list(getattr(array, "shape", shape)) != list(shape):
        raise ValueError(f"{what} returned {array.shape}, and {tuple(shape)} is needed")
    return _buffer(array)


def _buffer(array: Any) -> Buffer:
    """The bytes of an array, without a copy where they are in one piece."""
    view = memoryview(array)
    return view.cast("B") if view.c_contiguous and view.nbytes else view.tobytes()


def _write(descriptor: int, message: Dict[str, Any]) -> None:
    parts = pack(message)
    _write_all(descriptor, _LENGTH.pack(sum(len(part) for part in parts)))
    for part in parts:
        _write_all(descriptor, part)


def _write_all(descriptor: int, data: Buffer) -> None:
    left = memoryview(data)
    while left:
        left = left[os.write(descriptor, left) :]


# MessagePack


def pack(value: Any) -> List[Any]:
    """The value as MessagePack, in pieces: long buffers are not copied."""
    pieces: List[Any] = [bytearray()]
    _pack(value, pieces)
    return pieces


def _pack(value: Any, pieces: List[Any]) -> None:  # noqa: C901, PLR0912 - by type
    out = pieces[-1]
    if value is None or isinstance(value, bool):
        out += b"\xc0" if value is None else (b"\xc3" if value else b"\xc2")
    elif isinstance(value, float):
        out += struct.pack(">Bd", 0xCB, value)
    elif isinstance(value, int):
        out += _packed_int(value)
    elif isinstance(value, str):
        data = value.encode("utf-8")
        out += _head(len(data), 0xA0, 32, 0xD9) + data
    elif isinstance(value, (bytes, bytearray, memoryview)):
        out += _head(len(value), 0, 0, 0xC4)
        if len(value) < 4096:
            out += value
        else:
            pieces += [value, bytearray()]
    elif isinstance(value, dict):
        out += _head(len(value), 0x80, 16, 0xDD)
        for key, member in value.items():
            _pack(str(key), pieces)
            _pack(member, pieces)
    elif isinstance(value, (list, tuple)):
        out += _head(len(value), 0x90, 16, 0xDB)
        for member in value:
            _pack(member, pieces)
    elif hasattr(value, "tolist"):
        _pack(value.tolist(), pieces)
    else:
        _pack(float(value), pieces)


def _packed_int(value: int) -> bytes:
    if -32 <= value < 128:
        return struct.pack("b", value)
    return (
        struct.pack(">Bq", 0xD3, value)
        if value < 0
        else struct.pack(">BQ", 0xCF, value)
    )


def _head(length: int, short: int, short_below: int, first: int) -> bytes:
    """The type and length of text, bytes, a list or a map.

    Lists and maps have no form with one byte, so theirs begins at `first` + 1.
    """
    if length < short_below:
        return struct.pack("B", short | length)
    if length < 256 and first not in (0xDB, 0xDD):
        return struct.pack("BB", first, length)
    if length < 65536:
        return struct.pack(">BH", first + 1, length)
    return struct.pack(">BI", first + 2, length)


def unpack(data: bytes) -> Any:
    """The value of a whole MessagePack message."""
    return _unpack(memoryview(data), 0)[0]


_NUMBERS = {0xCA: ">f", 0xCB: ">d", 0xCC: ">B", 0xCD: ">H", 0xCE: ">I", 0xCF: ">Q"}
_NUMBERS.update({0xD0: ">b", 0xD1: ">h", 0xD2: ">i", 0xD3: ">q"})
_LENGTHS = {0: ">B", 1: ">H", 2: ">I"}


def _unpack(data: memoryview, at: int) -> Tuple[Any, int]:  # noqa: PLR0911 - by kind
    """The value that begins at a place, and the place behind it."""
    kind = data[at]
    at += 1
    if kind < 0x80:
        return kind, at
    if kind >= 0xE0:
        return kind - 256, at
    if kind < 0xC0:
        if kind >= 0xA0:
            return _text(data, at, kind & 31)
        return (_map if kind < 0x90 else _list)(data, at, kind & 15)
    if kind in (0xC0, 0xC2, 0xC3):
        return {0xC0: None, 0xC2: False, 0xC3: True}[kind], at
    if kind in _NUMBERS:
        number = struct.Struct(_NUMBERS[kind])
        return number.unpack_from(data, at)[0], at + number.size
    for first, read in ((0xC4, _bytes), (0xD9, _text), (0xDB, _list), (0xDD, _map)):
        size = kind - first
        if size in _LENGTHS and not (size == 0 and first in (0xDB, 0xDD)):
            length = struct.Struct(_LENGTHS[size])
            return read(data, at + length.size, length.unpack_from(data, at)[0])
    raise ValueError(f"MessagePack of an unknown kind: 0x{kind:02x}")


def _text(data: memoryview, at: int, length: int) -> Tuple[str, int]:
    return str(data[at : at + length], "utf-8"), at + length


def _bytes(data: memoryview, at: int, length: int) -> Tuple[bytes, int]:
    return bytes(data[at : at + length]), at + length


def _list(data: memoryview, at: int, length: int) -> Tuple[List[Any], int]:
    members = []
    for _ in range(length):
        member, at = _unpack(data, at)
        members.append(member)
    return members, at


def _map(data: memoryview, at: int, length: int) -> Tuple[Dict[str, Any], int]:
    pairs: Dict[str, Any] = {}
    for _ in range(length):
        key, at = _unpack(data, at)
        pairs[key], at = _unpack(data, at)
    return pairs, at
