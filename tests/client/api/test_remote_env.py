"""A run as a Gymnasium environment, checked by Gymnasium and against the server."""

import re
import warnings
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium import spaces
from gymnasium.utils.env_checker import check_env

from reference_client import ProctorError
from reference_client.gymnasium_env.remote_env import ENV_ID, RemoteEnv, RunDone
from tests.support.client.direct_client import DirectClient
from tests.support.paths import ROOT
from tests.support.servers import TOKENS, ReferenceServer
from tests.support.sim.calibration_action import calibration_action as action

pytestmark = pytest.mark.slow("starts servers or kits")

# Advice of check_env about bounds, which the benchmark alone chooses.
ADVICE = ("symmetric and normalized space", "is probably too (low|high)")


@pytest.fixture(autouse=True)
def _environment(server: ReferenceServer, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PROCTOR_URL", server.url)
    monkeypatch.setenv("PROCTOR_TOKEN", TOKENS["alice"])


def remote(*tasks: str, **settings: Any) -> RemoteEnv:
    options = {"tasks": list(tasks)}
    return RemoteEnv(benchmark="calibration", options=options, **settings)


def arrays(**values: float) -> dict[str, Any]:
    return {name: np.array(vector) for name, vector in action(**values).items()}


END = arrays(success=1.0, end=1.0)


@pytest.mark.parametrize(
    "settings",
    [
        {"benchmark": "calibration", "options": {"tasks": ["count"] * 12}},
        {"benchmark": "calibration", "options": {"tasks": ["echo"] * 12}},
        {"benchmark": "tabletop_state"},
    ],
    ids=["calibration", "echo", "tabletop_state"],
)
def test_gymnasium_finds_nothing_wrong(settings: dict[str, Any]) -> None:
    """Expect no error, and no warning but advice about bounds."""
    env = gymnasium.make(ENV_ID, **settings).unwrapped
    with warnings.catch_warnings():
        for advice in ADVICE:
            warnings.filterwarnings("ignore", f".*{advice}")
        check_env(env)
    env.close()


def test_spaces_are_those_of_the_manifest(direct: DirectClient) -> None:
    env = remote("echo", images={"codec": "png", "width": 64, "height": 48})
    benchmark = direct.control.get_benchmark("calibration")
    acts = env.action_space
    assert isinstance(acts, spaces.Dict)
    assert set(acts) == set(benchmark.action_space)
    score, vector = acts["score"], acts["vector"]
    assert isinstance(score, spaces.Box)
    assert isinstance(vector, spaces.Box)
    assert (score.low.tolist(), score.high.tolist()) == ([0.0], [1.0])
    assert vector.low.tolist() == [-np.inf] * 8
    seen, info = env.reset()
    assert seen in env.observation_space
    assert seen["images"]["pattern"].shape == (48, 64, 3)
    assert seen["images"]["pattern"][1, 2, 0] == 7 * 2 + 13
    assert seen["tensors"]["uint8"][0].tolist() == [0, 1, 2]
    assert set(seen["tensors"]) == set(benchmark.observation_space.tensors)
    assert info == {
        "episode_id": info["episode_id"],
        "instruction": "Calibration task echo.",
        "task": "echo",
    }
    env.close()


def test_missing_observations_are_zeros() -> None:
    env = remote("count")
    seen, _ = env.reset()
    assert seen in env.observation_space
    assert not seen["images"]["pattern"].any()
    env.close()


def test_episodes_are_played_one_after_another(direct: DirectClient) -> None:
    """The last observation of an episode is its own, and the next begins with reset."""
    env = remote("count", "count")
    for number in range(2):
        seen, info = env.reset()
        assert (seen["state"]["count"][0], info["episode_id"]) == (0, f"e000{number}")
        seen, reward, terminated, truncated, info = env.step(arrays(score=0.5))
        assert (seen["state"]["count"][0], reward) == (1, 0.5)
        assert (terminated, truncated) == (False, False)
        assert "episode_result" not in info
        seen, _, terminated, truncated, info = env.step(END)
        assert seen["state"]["count"][0] == 2
        assert (terminated, truncated) == (True, False)
        assert info["episode_id"] == f"e000{number}"
        assert info["episode_result"]["score"] == 1.0
    assert env.score()["score"] == 1.0
    assert env.run_id is not None
    assert direct.attempts(env.run_id) == [1, 1]
    with pytest.raises(RunDone, match="renew=True"):
        env.reset()
    with pytest.raises(gymnasium.error.ResetNeeded):
        env.step(END)
    env.close()
    env.close()


@pytest.mark.parametrize("has_subsets", [True, False])
def test_the_first_episodes_are_played_alone(
    direct: DirectClient, monkeypatch: pytest.MonkeyPatch, has_subsets: bool
) -> None:
    """Two of three. Expect the third one pending, without an attempt."""
    env = remote("count", "count", "count", episodes=2)
    if not has_subsets:  # the server begins the third one, which is given back
        monkeypatch.setattr(env._service, "profiles", ["core"])
    for number in range(2):
        _, info = env.reset()
        assert info["episode_id"] == f"e000{number}"
        env.step(END)
    with pytest.raises(RunDone, match="that is wanted"):
        env.reset()
    env.close()
    assert env.run_id is not None
    last = direct.control.list_episodes(env.run_id).episodes[-1]
    assert (last.status.value, last.attempt) == ("pending", 1)


def test_renew_starts_a_new_run() -> None:
    env = remote("count", renew=True)
    runs = []
    for _ in range(2):
        env.reset()
        runs.append(env.run_id)
        env.step(END)
    assert len(set(runs)) == 2
    env.close()


def test_the_step_limit_truncates() -> None:
    options = {"tasks": ["count"], "max_steps": 1}
    env = RemoteEnv(benchmark="calibration", options=options)
    env.reset()
    assert env.step(arrays())[2:4] == (False, True)
    env.close()


def test_a_reset_before_the_end_costs_an_attempt(direct: DirectClient) -> None:
    """Before the first step it costs none. Expect the same episode each time."""
    env = remote("count")
    env.reset()
    env.reset()
    assert direct.attempts(str(env.run_id)) == [1]
    assert direct.reasons(str(env.run_id)) == [None]
    env.step(arrays())
    seen, info = env.reset()
    assert (seen["state"]["count"][0], info["episode_id"]) == (0, "e0000")
    assert direct.attempts(str(env.run_id)) == [2]
    reset = "Its environment was reset before the end of the episode."
    assert direct.reasons(str(env.run_id)) == [reset]
    env.step(arrays())
    env.close()
    assert direct.reasons(str(env.run_id)) == ["Its environment was closed."]


def test_sessions_share_one_connection() -> None:
    env = remote("count", "count")
    sessions = set()
    for _ in range(3):
        env.reset()
        env.step(action())
        assert env._session is not None
        sessions.add(env._session.turn.session_id)
    assert len(sessions) == 3
    assert len(env._connection._planes) == 1
    env.close()


def test_a_lost_session_truncates_and_the_episode_returns(direct: DirectClient) -> None:
    """Another program takes the worker over and leaves. Expect the reason."""
    env = remote("count")
    env.reset()
    first, *_ = env.step(arrays())
    run_id = str(env.run_id)
    other = direct.attach(run_id, "env-0", takeover=True)
    direct.data.detach_worker(run_id, "env-0", other.session_id)
    seen, reward, terminated, truncated, info = env.step(END)
    assert (reward, terminated, truncated) == (0.0, False, True)
    assert seen["state"]["count"] == first["state"]["count"]
    assert "session" in info["lost"]
    seen, _ = env.reset()
    assert seen["state"]["count"][0] == 0
    assert env.step(END)[4]["episode_result"]["attempt"] == 2
    env.close()


def test_a_simulator_that_fails_truncates(direct: DirectClient) -> None:
    env = remote("fault")
    env.reset()
    _, _, terminated, truncated, info = env.step(arrays(fault=1.0))
    assert (terminated, truncated) == (False, True)
    assert "lost" in info
    env.reset()
    assert env.step(END)[2]
    assert direct.attempts(str(env.run_id)) == [1]
    env.close()


def test_an_existing_run_is_continued(direct: DirectClient) -> None:
    """With its own images. Closing leaves no worker behind."""
    run = direct.submit("count", "count")
    env = RemoteEnv(run_id=run.run_id, worker_id="mine")
    env.reset()
    assert direct.control.get_run(run.run_id).live_workers == 1
    env.close()
    assert direct.control.get_run(run.run_id).live_workers == 0


def test_an_action_that_cannot_be_sent_is_refused() -> None:
    env = remote("count")
    env.reset()
    with pytest.raises(ProctorError, match="/actions/0/values/score"):
        env.step(arrays() | {"score": np.array([np.nan])})
    with pytest.raises(ProctorError, match="invalid_request"):
        env.step({"score": np.array([0.0])})
    faults: list[Any] = [np.zeros(3), [0.0, 0.0], 3.0, None]
    for fault in faults:
        with pytest.raises(ProctorError, match=r"takes a dict of vectors: .*score 1"):
            env.step(fault)
    assert env.step(END)[2]
    env.close()


def test_invalid_settings_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(ValueError, match="benchmark=… or run_id=…"):
        RemoteEnv()
    with pytest.raises(ProctorError, match="not_found"):
        RemoteEnv(benchmark="none")
    with pytest.raises(RuntimeError, match="before the first reset"):
        remote("count").score()
    monkeypatch.delenv("PROCTOR_URL")
    with pytest.raises(ValueError, match="url=…"):
        RemoteEnv(benchmark="calibration")


def test_the_program_of_the_manual_runs(
    server: ReferenceServer, capsys: pytest.CaptureFixture[str]
) -> None:
    """As pasted, with this server's URL and token, for a shorter benchmark."""
    page = (ROOT / "docs" / "evaluate" / "policies" / "policies.md").read_text()
    (program,) = re.findall(
        r"```python\n(from reference_client import RemoteEnv\n.*?)```", page, re.DOTALL
    )
    token = f'"{TOKENS["alice"]}"'
    for old, new in (("http://127.0.0.1:8460", server.url), ('"TOKEN"', token)):
        assert old in program
        program = program.replace(old, new)
    exec(compile(program, "manual", "exec"), {})  # noqa: S102 - our own manual
    assert "'outcome': 'failure'" in capsys.readouterr().out
