"""Settings that differ between nodes are named, once and without secrets."""

from __future__ import annotations

import pytest

from reference_server.assembly.node_parts import _comparison_of
from reference_server.assembly.run_parts import Secrets
from reference_server.cluster.settings_comparison import (
    SETTLED_S,
    TOKENS,
    SettingsComparison,
)
from reference_server.files.seed_secret import SeedSecret
from reference_server.http.auth import Tokens
from reference_server.push.key_encryption import KeyEncryption
from reference_server.settings import Settings
from reference_server.settings.cluster_settings import OF_EACH_NODE
from reference_server.storage.node_store import ListedNode, Node

SECRETS = Secrets(SeedSecret(), KeyEncryption())
TOKEN = "alice:run:of-alice"


def comparison_of(token: str = TOKEN, **settings: str | int) -> SettingsComparison:
    made = Settings.model_validate({"tokens": token, **settings})
    return _comparison_of(made, SECRETS, Tokens.parse(token))


class TwoNodes:
    """One that looks at another one; now: the time of its clock."""

    def __init__(self, first: SettingsComparison, second: SettingsComparison) -> None:
        self.first, self.second, self.now = first, second, 0.0
        first._clock = lambda: self.now

    def look(self, *, after_s: float) -> None:
        self.now += after_s
        node = Node("second", "http://second", "secret")
        self.first.compare([ListedNode(node, 0.0, self.second.text())])


@pytest.mark.parametrize(
    ("theirs", "named"),
    [
        ({}, ""),
        ({"port": 9, "metrics": "on", "tokens_file": "other", "max_simulators": 3}, ""),
        ({"max_body_bytes": 70000}, "max_body_bytes is '8388608' here, '70000' there;"),
        ({"profiles": "ebench"}, "profiles is '' here, 'ebench' there;"),
        ({"failover": "replay"}, "failover is 'end' here, 'replay' there;"),
        ({"record_imports": "on"}, "record_imports is 'off' here, 'on' there;"),
        ({"token": "alice:run:of-alice,bob:run:of-bob"}, f"either: {TOKENS}; set"),
    ],
)
def test_a_setting_that_differs_is_named_once(
    theirs: dict[str, str | int], named: str, caplog: pytest.LogCaptureFixture
) -> None:
    """Expect nothing for those of a machine, and no token."""
    nodes = TwoNodes(comparison_of(), comparison_of(**theirs))  # type: ignore[arg-type]
    for _ in range(4):
        nodes.look(after_s=SETTLED_S)
    assert len(caplog.messages) == bool(named)
    assert named in caplog.text
    assert "the node at http://second" in caplog.text or not named
    assert "of-" not in nodes.second.text()


def test_a_file_that_one_node_has_not_yet_read_is_no_difference(
    caplog: pytest.LogCaptureFixture,
) -> None:
    nodes = TwoNodes(comparison_of(), comparison_of(max_chunk=5))
    nodes.look(after_s=0.0)
    nodes.look(after_s=SETTLED_S)
    nodes.first = comparison_of(max_chunk=5)
    nodes.look(after_s=SETTLED_S)
    assert caplog.messages == []


@pytest.mark.parametrize(
    ("asked_at", "read_at", "answered_at", "named"),
    [
        (100.0, 100.5, 101.0, ""),
        (100.0, 96.0, 101.0, ""),
        (100.0, 130.0, 160.0, ""),  # a slow answer
        (7300.5, 100.5, 7301.0, "is 7200 s ahead of that of the database"),
        (100.0, 7301.0, 101.0, "is 7200 s behind that of the database"),
    ],
)
def test_a_clock_that_is_wrong_is_named_once(
    asked_at: float,
    read_at: float,
    answered_at: float,
    named: str,
    caplog: pytest.LogCaptureFixture,
) -> None:
    compared = comparison_of()
    for times in (1, 2):
        compared.compare_clock(asked_at, read_at, answered_at)
        compared.compare_clock(asked_at, read_at, answered_at)
        assert len(caplog.messages) == times * bool(named)
        compared.compare_clock(5.0, 5.0, 5.0)  # it is right again
    assert named in caplog.text


def test_every_setting_of_a_machine_exists() -> None:
    assert OF_EACH_NODE - Settings.model_fields.keys() == set()
