"""A request that is passed on to another node is one trace, with the spans of both."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.support.server.cluster_nodes import Cluster, attach, predict
from tests.support.server.http_runs import submit
from tests.support.server.otlp_collector import Collector, ReceivedSpan, collecting

PREDICT = "POST /v1/runs/{run_id}/workers/{worker_id}/predict"
PASSED_ON = "pass on to owner"
OF_CLIENT = "4bf92f3577b34da6a3ce929d0e0e4736"


def play_through_the_other(cluster: Cluster) -> None:
    """One turn, of a run of the first node, that the second one is asked for.

    Its client says that it is recorded already, and that it is a node.
    """
    owner, other = cluster.clients
    run_id = submit(owner, "score")
    other.headers["traceparent"] = f"00-{OF_CLIENT}-00f067aa0ba902b7-01"
    other.headers["tracestate"] = "secret=of-a-client"
    other.headers["Proctor-Node-Secret"] = "no-node-has-this-one"
    answer = predict(other, run_id, attach(other, run_id), score=0.5)
    assert answer.status_code == 200, answer.text


def part_of(collector: Collector, span: ReceivedSpan, name: str) -> ReceivedSpan:
    (part,) = [one for one in collector.parts_of(span) if one.name == name]
    return part


@pytest.mark.slow("starts two servers")
def test_two_nodes_record_one_trace(tmp_path: Path) -> None:
    with (
        collecting() as collector,
        Cluster.of(
            tmp_path, str(tmp_path / "db"), 2, **collector.settings()
        ) as cluster,
    ):
        play_through_the_other(cluster)
        turns = collector.wait_for(PREDICT, 2)
        owner, other = (node.url for node in cluster.nodes)
        (asked,) = [one for one in turns if one.instance == other]
        passed_on = part_of(collector, asked, PASSED_ON)
        answered = part_of(collector, passed_on, PREDICT)
        playing = part_of(collector, answered, "simulator plays")
        assert [one.instance for one in (passed_on, answered, playing)] == [
            *(other, owner, owner)
        ]
        assert {one.trace_id for one in (asked, passed_on, answered, playing)} == {
            asked.trace_id
        }
        assert asked.parent == ""
        assert asked.trace_id != OF_CLIENT
        request_ids = {one.values["proctor.request_id"] for one in (asked, answered)}
        assert len(request_ids) == 1
        secrets = (b"of-a-client", b"no-node-has-this-one")
        assert not any(one in b"".join(collector.bodies) for one in secrets)


@pytest.mark.slow("starts two servers")
def test_nodes_that_draw_nothing_record_nothing_for_a_client(tmp_path: Path) -> None:
    """Nor does the owner believe a client whose request another node has passed on."""
    with collecting() as collector:
        settings = collector.settings(PROCTOR_TRACES_RATIO="0")
        with Cluster.of(tmp_path, str(tmp_path / "db"), 2, **settings) as cluster:
            play_through_the_other(cluster)
            for node in cluster.nodes:
                node.end()  # sends all that is recorded
        assert collector.spans() == []
