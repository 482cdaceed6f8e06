"""The attempts of a hostile policy, as a program that a sandbox runs.

`python escape_attempts.py FACTS`: FACTS is JSON that names what the host has. Each
attempt is a process of its own. One line of JSON per attempt: its name, and how it was
refused; `refused` is null where it succeeded.
"""
# mypy: disable-error-code="no-untyped-def, no-untyped-call, misc"

import contextlib
import ctypes
import json
import os
import resource
import signal
import socket
import sys
import time
from pathlib import Path

FACTS = json.loads(sys.argv[1])
# Standard input and output, and the folder that is read here, are its own.
INHERITED = [
    link.name
    for link in list(Path("/proc/self/fd").iterdir())
    if int(link.name) > 2 and link.exists()
]
LIBC = ctypes.CDLL(None, use_errno=True)


def connect(family, address, kind=socket.SOCK_STREAM):
    with socket.socket(family, kind) as attempt:
        attempt.settimeout(2)
        attempt.connect(address)


def send(family, address):
    with socket.socket(family, socket.SOCK_DGRAM) as attempt:
        attempt.sendto(b"x", address)


def call(number, *arguments):
    if LIBC.syscall(number, *arguments) < 0:
        error = ctypes.get_errno()
        raise OSError(error, os.strerror(error))


def write(path):
    Path(path).write_text("changed")


def fill(folder):
    with Path(folder, "large").open("wb") as file:
        while True:
            file.write(bytes(2**20))


def fork_without_end():
    while True:
        if os.fork() == 0:
            time.sleep(60)


def take_memory():
    taken = []
    while True:
        taken.append(bytearray(b"x" * 2**24))


def open_without_end():
    taken = []
    while True:
        taken.append(os.open("/", os.O_RDONLY))


def become_root_by_file():
    """A file of its own with the bit set, and a program of the system that has it."""
    copy = Path("/tmp/own")  # noqa: S108 - the sandbox's own
    copy.write_bytes(Path(os.path.realpath(sys.executable)).read_bytes())
    copy.chmod(0o6755)
    os.chown(copy, 0, 0)


def become_root():
    os.setuid(0)


def read_processes():
    """Only processes of this sandbox are seen."""
    others = []
    for folder in Path("/proc").iterdir():
        if folder.name.isdecimal():
            command = (folder / "cmdline").read_bytes()
            if b"escape_attempts" not in command and b"bwrap" not in command:
                others.append(command)
    if not others:
        raise ProcessLookupError("no process of the host is seen")


def find_environment():
    allowed = {"PATH", "HOME", "LANG", "PWD", "PROCTOR_POLICY_SOCKET"}
    first = Path("/proc/1/environ").read_text().split("\0")
    names = {line.partition("=")[0] for line in first if line} | os.environ.keys()
    if names <= allowed:
        raise KeyError("only the sandbox's own variables")


def find_descriptors():
    """No descriptor of the platform or of the set-up is inherited."""
    if not INHERITED:
        raise FileNotFoundError("only standard input, output and error")


def signal_host():
    os.kill(FACTS["host_pid"], signal.SIGTERM)


def find_interfaces():
    others = [name for _, name in socket.if_nameindex() if name != "lo"]
    if not others:
        raise FileNotFoundError("only lo")


def raise_limit():
    for name in (resource.RLIMIT_NOFILE, resource.RLIMIT_NPROC, resource.RLIMIT_CORE):
        resource.setrlimit(name, (2**20, 2**20))


def alg():
    connect(socket.AF_ALG, ("hash", "sha256"))


ATTEMPTS = {
    "loopback of the host": lambda: connect(
        socket.AF_INET, ("127.0.0.1", FACTS["port"])
    ),
    "network, IPv4": lambda: connect(socket.AF_INET, ("192.0.2.1", 80)),
    "network, IPv6": lambda: connect(socket.AF_INET6, ("2001:db8::1", 80)),
    "network, datagrams": lambda: send(socket.AF_INET, ("192.0.2.1", 53)),
    "network, raw": lambda: socket.socket(
        socket.AF_INET, socket.SOCK_RAW, socket.IPPROTO_ICMP
    ),
    "network, netlink": lambda: socket.socket(socket.AF_NETLINK, socket.SOCK_RAW),
    "network, packets": lambda: socket.socket(socket.AF_PACKET, socket.SOCK_RAW),
    "network, virtual machine": lambda: socket.socket(40, socket.SOCK_STREAM),
    "network, Bluetooth": lambda: socket.socket(31, socket.SOCK_RAW, 1),
    "network, kernel crypto": alg,
    "network, interfaces": find_interfaces,
    "abstract socket of the host": lambda: connect(
        socket.AF_UNIX, "\0" + FACTS["abstract"]
    ),
    "socket file of the host": lambda: connect(socket.AF_UNIX, FACTS["socket"]),
    "secret of the host": lambda: Path(FACTS["secret"]).read_text(),
    "other submissions": lambda: list(Path(FACTS["folder"]).iterdir()),
    "passwords of the host": lambda: Path("/etc/shadow").read_text(),
    "root of the first process": lambda: list(Path("/proc/1/root/oldroot").iterdir()),
    "memory of the server": lambda: Path(f"/proc/{FACTS['host_pid']}/mem").read_bytes(),
    "kernel settings": lambda: write("/proc/sys/kernel/core_pattern"),
    "kernel keys": lambda: write("/proc/sysrq-trigger"),
    "control groups": lambda: list(Path("/sys/fs/cgroup").iterdir()),
    "files of the image": lambda: write("/usr/changed"),
    "root folder": lambda: write("/changed"),
    "devices": lambda: os.mknod("/tmp/disk", 0o60666, os.makedev(8, 0)),  # noqa: S108
    "device folder": lambda: write("/dev/changed"),
    "kernel memory": lambda: os.open("/dev/mem", os.O_RDWR),
    "processes of the host": read_processes,
    "environment of the platform": find_environment,
    "descriptors of the platform": find_descriptors,
    "signal to the host": signal_host,
    "limits": raise_limit,
    "priority": lambda: os.nice(-5),
    "setuid file": become_root_by_file,
    "setuid": become_root,
    "fork bomb": fork_without_end,
    "memory": take_memory,
    "disk": lambda: fill("/tmp"),  # noqa: S108
    "shared memory": lambda: fill("/dev/shm"),  # noqa: S108
    "disk, socket folder": lambda: fill("/run"),
    "descriptors": open_without_end,
    **{
        f"system call {name}": lambda number=number: call(number, 0, 0, 0, 0, 0, 0)
        for name, number in FACTS["calls"].items()
    },
    "new user namespace by clone": lambda: call(
        FACTS["clone"], 0x10000000 | signal.SIGCHLD, 0, 0, 0, 0
    ),
    "system call of another convention": lambda: call(
        FACTS["getpid"] | 0x40000000, 0, 0, 0
    ),
}


def attempt_in_child(name):
    """How it was refused; None if it was not."""
    read_fd, write_fd = os.pipe()
    child = os.fork()
    if child == 0:
        os.setpgid(0, 0)
        os.close(read_fd)
        text = ""
        try:
            ATTEMPTS[name]()
        except BaseException as error:  # noqa: BLE001
            text = f"{type(error).__name__}: {error}"[:200]
        os.write(write_fd, text.encode())
        os._exit(0)
    os.close(write_fd)
    status = os.waitpid(child, 0)[1]
    with contextlib.suppress(ProcessLookupError):
        os.killpg(child, signal.SIGKILL)
    for path in ("/tmp", "/dev/shm", "/run"):  # noqa: S108
        for file in list(Path(path).iterdir()):
            file.unlink()
    if os.WIFSIGNALED(status):
        return signal.Signals(os.WTERMSIG(status)).name
    with os.fdopen(read_fd) as answer:
        return answer.read() or None


for name in ATTEMPTS:
    outcome = {"attempt": name, "refused": attempt_in_child(name)}
    sys.stdout.write(f"{json.dumps(outcome)}\n")
    sys.stdout.flush()
