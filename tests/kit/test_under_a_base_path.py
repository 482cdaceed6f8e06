"""A server that nginx serves under a path of its own, as its documentation begins."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from reference_client import ProctorError, evaluate
from tests.support.client.policies import GradedPolicy
from tests.support.kit.reverse_proxies import BASE_PATHS, run_proxy
from tests.support.kit.run_kit import KitRun, run_kit
from tests.support.ports import free_port
from tests.support.servers import TOKENS, ReferenceServer

pytestmark = pytest.mark.slow("a server, a proxy and a kit")


@pytest.fixture(scope="module")
def proxy_url(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The URL of nginx, which drops headers with an underscore, too."""
    folder, port = tmp_path_factory.mktemp("base_path"), free_port()
    with (
        ReferenceServer(folder, PROCTOR_PROFILES="ebench") as server,
        run_proxy("nginx", folder / "nginx", port, server.url, BASE_PATHS),
    ):
        yield f"http://127.0.0.1:{port}"


def evaluate_at(url: str) -> int:
    played = evaluate(
        GradedPolicy,
        url=url,
        token=TOKENS["alice"],
        benchmark="calibration",
        episodes=1,
        retry_timeout_s=1,
    )
    return played.counts.success


def judge(url: str, folder: Path, only: str) -> KitRun:
    return run_kit(
        folder, *("--url", url), *("--only", only), PROCTOR_TOKEN=TOKENS["alice"]
    )


def test_a_prefix_that_the_proxy_sends_is_in_the_endpoint(
    proxy_url: str, tmp_path: Path
) -> None:
    assert evaluate_at(f"{proxy_url}/proctor") == 1
    kit = judge(f"{proxy_url}/proctor", tmp_path, "RUN-016,EBE-005,EBE-024")
    assert kit.outcomes == {
        "RUN-016": "passed",
        "EBE-005": "passed",
        "EBE-024": "not_verified",
    }
    assert "nginx, in front" in kit.rows["EBE-024"]["reason"]
    assert "underscores_in_headers on" in kit.rows["EBE-024"]["reason"]
    assert kit.code == 0


def test_without_it_client_and_kit_name_the_endpoint(
    proxy_url: str, tmp_path: Path
) -> None:
    with pytest.raises(ProctorError) as caught:
        evaluate_at(f"{proxy_url}/without")
    assert f"{proxy_url} answered 405" in caught.value.detail
    assert f"which {proxy_url}/without has named" in caught.value.detail
    assert "--public-url" in caught.value.detail
    kit = judge(f"{proxy_url}/without", tmp_path, "RUN-016")
    assert kit.code == 2
    assert f"runs have the endpoint {proxy_url}, which does not lead" in kit.output
    assert "--public-url" in kit.output
