"""Settings of what the operator sees of the server, and of how it ends."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, Field


class OperationSettings(BaseModel):
    """Settings of what the operator sees of the server, and of how it ends."""

    pages: Literal["off", "on"] = Field(
        "on",
        description="Whether the server has pages for people, under /pages.",
    )
    films: Literal["off", "on"] = Field(
        "on",
        description="Whether readers of the pages may have an episode drawn from its "
        "record: by one process at a time, beside max_simulators.",
    )
    metrics: Literal["off", "on"] = Field(
        "off",
        description="Whether metrics for Prometheus are served, at /metrics of a port "
        "of their own, with /livez and /readyz.",
    )
    metrics_host: str = Field(
        "127.0.0.1",
        min_length=1,
        description="Address of that port. There is no token: name one that only the "
        "operator reaches.",
    )
    metrics_port: int = Field(
        9464, ge=0, le=65535, description="That port; 0 chooses a free port."
    )
    traces: str = Field(
        "",
        description="URL of a collector of OpenTelemetry (OTLP over HTTP), such as "
        "http://127.0.0.1:4318, to which traces of requests are sent. If empty, none. "
        "Needs the extra traces.",
    )
    traces_ratio: float = Field(
        0.01,
        ge=0,
        le=1,
        allow_inf_nan=False,
        description="Traces: of those that begin at this server, how many are "
        "recorded, at random; 1 is all.",
    )
    traces_parent: Literal["nodes", "all"] = Field(
        "nodes",
        description="Traces: whose header traceparent a request goes on with, recorded "
        "or not as it says. nodes: that of the other nodes. all: that of every client, "
        "too, for servers that only a balancer of yours reaches: with it any client "
        "may have all of its requests recorded.",
    )
    drain_s: float = Field(
        10.0,
        ge=0,
        le=3600,
        description="After SIGTERM or Ctrl-C, how long the server waits for turns in "
        "progress and sends their answers. What is new is refused meanwhile. A second "
        "signal ends it at once.",
    )
    drain_notice_s: float = Field(
        0.0,
        ge=0,
        le=3600,
        description="After SIGTERM or Ctrl-C, how long the server listens in any case "
        "and answers /readyz with 503, so that a load balancer learns that it ends. "
        "drain_s begins after it.",
    )
    log_level: Literal["critical", "error", "warning", "info", "debug", "trace"] = (
        Field(
            "warning",
            description="What is logged, on the standard error. info: also what "
            "happens to every run.",
        )
    )
    log_format: Literal["text", "json"] = Field(
        "text", description="Log lines: text for people, or one JSON object each."
    )
    access_log: Literal["off", "on"] = Field(
        "off", description="Whether every answered request is logged."
    )
