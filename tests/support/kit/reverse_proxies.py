"""nginx and HAProxy in front of a server, with their default settings.

`make programs` provides the programs; without them the tests fail and say so.
"""

import contextlib
import os
import shutil
import socket
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.support.waiting import wait_until

PROVIDED = Path(sys.prefix, "proxies", "root")
CONFIGURATIONS = {"nginx": "nginx.conf", "haproxy": "haproxy.cfg"}
BASE_PATHS = "base_paths.conf"


def find_program(name: str) -> str:
    provided = PROVIDED / "usr" / "sbin" / name
    found = shutil.which(name) or (str(provided) if provided.exists() else None)
    if found is None:
        pytest.fail(f"{name} is missing: run `make programs`", pytrace=False)
    return found


@contextlib.contextmanager
def run_proxy(
    name: str, directory: Path, port: int, upstream: str, configuration: str = ""
) -> Iterator[None]:
    """Run a proxy on a port, in front of the server at the URL `upstream`."""
    directory.mkdir()
    file = configuration or CONFIGURATIONS[name]
    path = Path(__file__).with_name("proxies").joinpath(file)
    text = (
        path.read_text()
        .replace("DIRECTORY", str(directory))
        .replace("UPSTREAM", upstream.rpartition(":")[2])
        .replace("PORT", str(port))
    )
    with run_configuration(name, directory, port, text):
        yield


@contextlib.contextmanager
def run_configuration(
    name: str, directory: Path, port: int, text: str
) -> Iterator[None]:
    """Run a proxy with a configuration by which it listens on the port."""
    configuration = directory / "configuration"
    configuration.write_text(text)
    libraries = ":".join(map(str, PROVIDED.glob("usr/lib/*-linux-gnu")))
    options = {"nginx": ["-e", str(directory / "error.log"), "-c"], "haproxy": ["-f"]}
    with (
        (directory / "output").open("wb") as output,
        subprocess.Popen(
            [find_program(name), *options[name], str(configuration)],
            env=os.environ | {"LD_LIBRARY_PATH": libraries},
            stdout=output,
            stderr=subprocess.STDOUT,
        ) as process,
    ):
        try:
            wait_until_listening(port, process, directory / "output")
            yield
        finally:
            process.terminate()


def wait_until_listening(
    port: int, process: subprocess.Popen[bytes], output: Path
) -> None:
    def is_listening() -> bool:
        assert process.poll() is None, output.read_text()
        with socket.socket() as probe:
            return probe.connect_ex(("127.0.0.1", port)) == 0

    wait_until(is_listening, "the proxy listens")
