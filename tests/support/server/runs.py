"""A run and a session as the rules of the server see them."""

from typing import Any

from reference_server.rules.runs.run import Episode, Run, Session
from reference_sim.vector_spaces import VectorPart

NOW = 1000.0
ACTION: dict[str, list[float]] = {"arm": [0.0, 0.5], "grip": [1.0], "head": [2.0]}


def make_run(length: int = 3, *, run_type: type[Run] = Run, **changes: Any) -> Run:
    """A run as the rules see it; its episodes hold nothing but their number."""
    joints = {"joints": VectorPart("joints", 2, "joint_position", "rad").declare(0)}
    vector = {"size": 2, "out_of_range": "unbounded", "parts": joints}
    number = {"all": VectorPart("all", 1, "number", "1").declare(0)}
    bounds = {"size": 1, "minimum": [0.0], "maximum": [1.0], "parts": number}
    manifest = {
        "benchmark_id": "calibration",
        "control_rate_hz": 10.0,
        "max_steps": 10,
        "max_chunk": 4,
        "max_attempts": 2,
        "max_faults": 2,
        "action_space": {
            "arm": vector,
            "grip": bounds | {"out_of_range": "refuse"},
            "head": bounds | {"out_of_range": "clip"},
        },
        "observation_space": {"state": {"joints": vector}},
        "episodes": [
            {"task": "score", "split": "even", "seed": i} for i in range(length)
        ],
    }
    fields: dict[str, Any] = {
        "run_id": "run_1",
        "number": 1,
        "account": "alice",
        "state": "ready",
        "reason": None,
        "retryable": None,
        "manifest": manifest,
        "manifest_sha256": "0" * 64,
        "submission": {"benchmark_id": "calibration", "policy": {"name": "p"}},
        "max_workers": 2,
        "idle_timeout_s": 10.0,
        "images": {"codec": "raw", "width": 16, "height": 12},
        "created_at_wall": 1000.0,
        "updated_at_wall": 1000.0,
        "queue_until_wall": 0.0,
        "episodes": [Episode(i, "score", "even", i) for i in range(length)],
    }
    return run_type(**fields | changes)


def add_session(run: Run, worker_id: str = "w", **changes: Any) -> Session:
    """A live session in a running run: seq 3 was answered, the lease has begun."""
    fields: dict[str, Any] = {
        "session_id": f"session-of-{worker_id}",
        "worker_id": worker_id,
        "attach_key": "key",
        "idle_timeout_s": 10.0,
        "max_steps": 10,
        "expires_at": NOW + 10.0,
        "episode": Episode(0, "score", "even", 0),
        "seq": 3,
        "request": ([ACTION], "last"),
        "turn": {"seq": 3},
    }
    session = Session(**fields | changes)
    run.workers[worker_id] = session
    run.state = "running"
    return session
