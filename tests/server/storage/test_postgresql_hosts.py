"""A database on several hosts: how they are named, and which one is used."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from typing import Any

import asyncpg
import pytest
import sqlalchemy as sa

from reference_server.storage.connection import postgresql, postgresql_hosts
from reference_server.storage.connection.database import url_of


@pytest.mark.parametrize(
    ("url", "shown", "of_programs"),
    [
        ("postgresql://u:p@a:5/x", "a:5", "postgresql://u@a:5/x"),
        ("postgresql://u:p,q@a/x", "a:5432", "postgresql://u@a/x"),
        (
            "postgres://u:p@a:5,b/x?sslmode=require",
            "a:5 and b:5432",
            "postgresql://u@/x?host=a%2Cb&port=5%2C5432&sslmode=require",
        ),
        (
            "postgresql://u@/x?host=a:5&host=b:6",
            "a:5 and b:6",
            "postgresql://u@/x?host=a%2Cb&port=5%2C6",
        ),
        ("postgresql://u:p/q@a,b/x", "a:5432 and b:5432", "host=a%2Cb"),
        ("postgresql://u@server:p@a/x", "a:5432", "postgresql://u%40server@a/x"),
        ("postgresql://u:p@a/x@y", "a:5432", "postgresql://u@a/x%40y"),
        (
            "postgresql://u:p@a,b/x@y",
            "a:5432 and b:5432",
            "postgresql://u@/x%40y?host=",
        ),
        ("postgresql://u:p@a", "a:5432", "postgresql://u@a"),
        ("postgresql://u:p@a,b/", "a:5432 and b:5432", "host=a%2Cb"),
        ("postgresql://a,b/x", "a:5432 and b:5432", "host=a%2Cb&port=5432%2C5432"),
        ("postgresql:///x?host=/run/pg", "/run/pg:5432", "host=%2Frun%2Fpg"),
    ],
)
def test_each_host_of_a_url_is_used_and_shown(
    url: str, shown: str, of_programs: str
) -> None:
    used = url_of(url)
    text = postgresql.describe(used, TimeoutError())
    assert text == f"PostgreSQL at {shown} does not answer in time"
    assert of_programs in postgresql.url_of_programs(used)
    given = sa.engine.make_url(used).translate_connect_args()
    assert "," not in given.get("host", "")


def test_hosts_that_cannot_be_written_to_are_named() -> None:
    """The text of the library does not name them. Expect what to do."""
    raised = asyncpg.TargetServerAttributeNotMatched(
        "None of the hosts match the target attribute requirement "
        "<SessionAttribute.read_write: 'read-write'>"
    )
    text = postgresql.describe(url_of("postgresql://u:p@a:5,b/x"), raised)
    assert text.startswith("none of a:5 and b:5432 can be written to: promote a stand")


class _Connected:
    """A connection, by the host that it was made to."""

    def __init__(self, host: str) -> None:
        self.host, self.is_terminated = host, False

    def terminate(self) -> None:
        self.is_terminated = True


Behaviour = Callable[[str], Awaitable[_Connected]]


async def _answer(host: str) -> _Connected:
    return _Connected(host)


async def _answer_late(host: str) -> _Connected:
    await asyncio.sleep(0.01)
    return _Connected(host)


async def _vanish(_host: str) -> _Connected:
    await asyncio.Event().wait()
    raise AssertionError


async def _refuse(host: str) -> _Connected:
    raise ConnectionRefusedError(host)


async def _be_a_standby(host: str) -> _Connected:
    await asyncio.sleep(0)
    raise asyncpg.TargetServerAttributeNotMatched(host)


@pytest.mark.parametrize(
    ("behaviours", "used"),
    [
        ([_answer, _be_a_standby], 0),
        ([_be_a_standby, _answer_late], 1),
        ([_vanish, _answer_late], 1),  # a host without power
        ([_answer_late, _vanish], 0),
        ([_refuse, _vanish, _answer_late], 2),
        ([_refuse, _be_a_standby], None),
        ([_be_a_standby, _refuse], None),
        ([_answer], 0),
        ([_refuse], None),
    ],
)
async def test_the_host_that_can_be_written_to_is_used(
    behaviours: list[Behaviour], used: int | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[dict[str, Any]] = []

    async def connect(**options: Any) -> _Connected:
        asked.append(options)
        host = options["host"]
        return await behaviours[int(host)](host)

    monkeypatch.setattr(asyncpg, "connect", connect)
    hosts: Any = [str(number) for number in range(len(behaviours))]
    if len(hosts) == 1:
        hosts = hosts[0]
    if used is None:
        has_standby = _be_a_standby in behaviours
        failure = asyncpg.TargetServerAttributeNotMatched if has_standby else OSError
        with pytest.raises(failure):
            await postgresql_hosts.connect(host=hosts)
    else:
        connected: Any = await postgresql_hosts.connect(host=hosts)
        assert connected.host == str(used)
        assert not connected.is_terminated
    writes = [options.get("target_session_attrs") for options in asked]
    assert set(writes) == ({None} if len(behaviours) == 1 else {"read-write"})


async def test_a_second_connection_is_closed(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two hosts answer at once: one connection is used, and none stays open."""
    made: list[_Connected] = []

    async def connect(*, host: str, **_: Any) -> _Connected:
        made.append(_Connected(host))
        return made[-1]

    monkeypatch.setattr(asyncpg, "connect", connect)
    used: Any = await postgresql_hosts.connect(host=["0", "1"], port=[1, 2])
    assert [one.is_terminated for one in made if one is not used] == [True]
    assert not used.is_terminated


@pytest.mark.parametrize(
    "connect_args",
    [
        postgresql.engine_options()["connect_args"],
        postgresql.engine_options(is_shared=True)["connect_args"],
        postgresql.node_engine_options()["connect_args"],
    ],
)
def test_each_connection_is_lost_on_both_sides(connect_args: dict[str, Any]) -> None:
    """Else those of a machine without power would use up PostgreSQL's places."""
    assert connect_args["async_creator_fn"] is postgresql_hosts.connect
    settings = connect_args["server_settings"]
    idle, every, count = (
        int(settings[f"tcp_keepalives_{name}"])
        for name in ("idle", "interval", "count")
    )
    assert idle + every * count == 25
