"""The page of metrics of a server, read as Prometheus reads it."""

from collections.abc import Callable, Iterable

import httpx
from prometheus_client import Metric, parser

from tests.support.servers import TIMEOUT_S, ReferenceServer

METRICS = {"PROCTOR_METRICS": "on", "PROCTOR_METRICS_PORT": "0"}

# The library's reader, which has no types.
READ_TEXT: Callable[[str], Iterable[Metric]] = parser.text_string_to_metric_families
# Name and values of labels, sorted by label → value.
Page = dict[tuple[str, ...], float]


def metrics_url(server: ReferenceServer) -> str:
    """The address that the server prints."""
    assert server.process.stdout is not None
    for line in server.process.stdout:
        if line.startswith("metrics: "):
            return line.split()[1]
    raise AssertionError("the server printed no address of its metrics")


def read_page(url: str) -> Page:
    """Every sample, by its name and the values of its labels, sorted by label."""
    answer = httpx.get(url, trust_env=False, timeout=TIMEOUT_S)
    assert answer.status_code == 200, answer.text
    found: Page = {}
    for family in READ_TEXT(answer.text):
        for sample in family.samples:
            key = (sample.name, *(sample.labels[one] for one in sorted(sample.labels)))
            assert key not in found, key
            found[key] = sample.value
    return found
