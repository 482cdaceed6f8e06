"""What the server needs of uvicorn's connection is looked for at the start."""

import re
from pathlib import Path

import pytest
import uvicorn
from uvicorn.protocols.http.flow_control import FlowControl
from uvicorn.protocols.http.httptools_impl import HttpToolsProtocol

from reference_server.http.connections import uvicorn_protocol
from reference_server.http.connections.uvicorn_protocol import (
    WrongUvicorn,
    check_uvicorn,
)


def test_the_installed_release_is_a_tested_one() -> None:
    check_uvicorn()
    check_uvicorn(uvicorn.__version__ + ".post1")


@pytest.mark.parametrize("version", ["0.5", "0.55.0", "1.54.0", ""])
def test_another_release_is_refused_with_what_to_install(version: str) -> None:
    with pytest.raises(WrongUvicorn, match=r"install uvicorn==0\.54\.\*"):
        check_uvicorn(version)


@pytest.mark.parametrize(
    ("owner", "name"),
    [(HttpToolsProtocol, "on_message_begin"), (FlowControl, "pause_reading")],
)
def test_a_missing_name_is_named(
    monkeypatch: pytest.MonkeyPatch, owner: type, name: str
) -> None:
    monkeypatch.delattr(owner, name)
    with pytest.raises(WrongUvicorn, match=rf"has no {owner.__name__}\.{name}:"):
        check_uvicorn()


def test_another_constructor_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    def constructor(self: object, config: object) -> None:
        """Another one."""

    monkeypatch.setattr(HttpToolsProtocol, "__init__", constructor)
    with pytest.raises(WrongUvicorn, match=r"HttpToolsProtocol\(self, config, "):
        check_uvicorn()


def test_every_name_that_is_used_is_in_the_list() -> None:
    """The names of the cycle and of the flow can be read in the source."""
    folder = Path(uvicorn_protocol.__file__).parent
    source = (folder / "bounded_connection.py").read_text()
    for part, of in (("cycle", "RequestResponseCycle"), ("flow", "FlowControl")):
        used = set(re.findall(rf"\b{part}\.(\w+)", source))
        assert used
        assert used <= set(uvicorn_protocol._MEMBERS[of][1]), part
