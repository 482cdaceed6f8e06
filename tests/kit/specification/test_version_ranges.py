"""Which servers a kit judges: those whose range includes the version of its rules.

A server of an earlier minor version is not judged by later rules: it would be called
wrong for what its version did not say.
"""

from __future__ import annotations

import copy
import json

import pytest

from conformance.run_settings import Settings
from conformance.runner import preflight
from conformance.specification.document import Spec, load_spec
from tests.support.kit.null_servers import SERVICE, Reply, Request, run_server


def kit_of(version: str, patch: pytest.MonkeyPatch) -> None:
    document = copy.deepcopy(dict(load_spec().document))
    document["info"]["version"] = f"{version}.0"
    patch.setattr(preflight, "load_spec", lambda: Spec(document))


@pytest.mark.parametrize(
    ("low", "high", "kit"),
    [("1.0", "1.0", "1.0"), ("1.0", "1.3", "1.1"), ("1.2", "1.10", "1.9")],
)
def test_a_server_whose_range_includes_the_kit_is_judged(
    low: str, high: str, kit: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    kit_of(kit, monkeypatch)
    preflight._require_version_overlap({"protocol": {"min": low, "max": high}})


@pytest.mark.parametrize(
    ("low", "high", "kit", "needed"),
    [
        ("1.0", "1.0", "1.1", "1.0"),  # an older server
        ("1.0", "1.9", "1.10", "1.9"),  # numbers, not texts
        ("1.2", "1.4", "1.1", "1.2"),  # a newer one that serves no older client
        ("2.0", "2.1", "1.3", "2.0"),
    ],
)
def test_any_other_server_is_named_its_kit(
    low: str, high: str, kit: str, needed: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    kit_of(kit, monkeypatch)
    with pytest.raises(preflight.CannotJudge) as refusal:
        preflight._require_version_overlap({"protocol": {"min": low, "max": high}})
    assert f"use the kit of Proctor {needed} " in str(refusal.value)


def test_an_older_server_gets_no_request_but_the_description(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A server of 1.0, a kit of 1.1. Expect nothing submitted, and no verdict."""
    kit_of("1.1", monkeypatch)
    requests: set[str] = set()
    head = {"Content-Type": "application/json", "Proctor-Version": "1.0"}

    def serve(request: Request) -> Reply:
        requests.add(f"{request.method} {request.path}")
        protocol = {"protocol": {"min": "1.0", "max": "1.0"}}
        return 200, head, json.dumps(SERVICE | protocol).encode()

    with run_server(serve) as url:
        settings = Settings(url=url, token="t")
        with pytest.raises(preflight.CannotJudge, match=r"the kit of Proctor 1\.0 "):
            preflight.inspect(settings)
    assert requests == {"GET /v1"}
