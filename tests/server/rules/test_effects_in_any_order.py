"""Commands and events in any order: what holds for a run whatever came before."""

from typing import Any

import pytest
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import (
    RuleBasedStateMachine,
    initialize,
    invariant,
    rule,
)

from reference_server.generated.problem_codes import PROBLEMS
from reference_server.rules import effects
from reference_server.rules.lifecycle import (
    TRANSITIONS,
    Accept,
    Attach,
    Command,
    Detach,
    Heartbeat,
    NoChange,
    Predict,
    Refuse,
    Replay,
    Resume,
    Stop,
    Verdict,
    Wait,
    decide,
)
from reference_server.rules.run import Result, Run, Session, State
from tests.support.server.play_turns import WALL, Draw, chunk_result, play_turn
from tests.support.server.runs import ACTION, NOW, make_run

pytestmark = pytest.mark.slow("many random examples")


class TransitionCheckedRun(Run):
    """A run that lets its state change only along the table."""

    def __setattr__(self, name: str, value: Any) -> None:
        if name == "state" and hasattr(self, "state"):
            steps = {(s, t) for (s, _), t in TRANSITIONS.items()}
            assert (self.state, value) in steps
        super().__setattr__(name, value)


# What happens next, and how often; one rule, because most steps need a session.
STEPS = {
    "continue_session": 20,
    "attach": 5,
    "detach": 3,
    "repeat": 2,
    "resume": 2,
    "fault": 1,
    "give_up": 1,
    "heartbeat": 1,
    "stop": 1,
    "wait": 1,
}


class AnyOrder(RuleBasedStateMachine):
    """The pure core as the executor uses it: sweep, decide, and do what is accepted.

    Between the parts of a turn anything else may happen, as it does when a simulator
    executes while other requests arrive.
    """

    @initialize(
        episodes=st.integers(1, 4),
        max_workers=st.integers(1, 3),
        state=st.sampled_from(["ready", "ready", "queued"]),
    )
    def submit(self, episodes: int, max_workers: int, state: State) -> None:
        self.run = make_run(
            episodes,
            run_type=TransitionCheckedRun,
            state=state,
            max_workers=max_workers,
        )
        self.now = NOW
        self.sessions: list[Session] = []
        self.results: dict[int, Result] = {}

    @rule(
        data=st.data(),
        step=st.sampled_from([name for name, n in STEPS.items() for _ in range(n)]),
    )
    def next(self, data: st.DataObject, step: str) -> None:
        getattr(self, step)(data.draw)

    def decide_checked(self, command: Command) -> Verdict:
        effects.expire(self.run, self.now, WALL)
        before = self.snapshot()
        verdict = decide(self.run, command, self.now)
        assert self.snapshot() == before, "deciding changes nothing"
        if isinstance(verdict, Refuse):
            assert verdict.code in PROBLEMS
        return verdict

    def snapshot(self) -> str:
        run = self.run
        return repr((run.state, run.pending, run.episodes, run.workers, run.ended))

    def open(self, command: Attach) -> Session:
        old = self.run.workers.get(command.worker_id)
        first = min(self.run.pending, default=None)
        inherited = None if old is None or old.done else old.episode
        name = f"s{len(self.sessions)}"
        session = effects.open_session(self.run, command, name, self.now)
        self.sessions.append(session)
        if inherited is not None:
            assert session.episode is inherited
        else:  # EPI-001
            assert (session.episode and session.episode.index) == first
        return session

    def attach(self, draw: Draw) -> None:
        worker = draw(st.sampled_from("abcd"))
        command = Attach(worker, draw(st.sampled_from("xyz")), draw(st.booleans()))
        match self.decide_checked(command):
            case Accept():
                self.open(command)
            case Replay(session) | Wait(session):
                assert session is self.run.workers[worker]

    def continue_session(self, draw: Draw) -> None:
        """A session does what comes next for it."""
        sessions = list(self.run.workers.values())
        if not sessions:
            return self.attach(draw)
        session = draw(st.sampled_from(sessions))
        if session.busy is None:
            return self.predict(session, session.seq + 1)
        if session.busy == "playing":
            executed, ended = draw(st.integers(1, 3)), draw(st.booleans())
            effects.end_turn(
                self.run, session, chunk_result(executed, ended=ended), WALL
            )
            return None
        return effects.store_answer(session, {"seq": session.seq}, self.now)

    def predict(self, session: Session, seq: int) -> None:
        command = Predict(session.worker_id, session.session_id, seq, [ACTION])
        match self.decide_checked(command):
            case Accept():
                assert seq == session.seq + 1
                assert session.episode is not None
                effects.begin_turn(session, command, self.now)
            case Replay(other):
                assert (other, seq) == (session, session.seq)
                assert session.turn is not None

    def any_session(self, draw: Draw) -> Session | None:
        return draw(st.sampled_from(self.sessions)) if self.sessions else None

    def repeat(self, draw: Draw) -> None:
        """Any session, also one that has ended, and any seq."""
        session = self.any_session(draw)
        if session is not None:
            self.predict(session, max(1, session.seq + draw(st.integers(-1, 2))))

    def any_busy_session(self, draw: Draw) -> Session | None:
        busy = [s for s in self.run.workers.values() if s.busy and s.episode]
        return draw(st.sampled_from(busy)) if busy else None

    def fault(self, draw: Draw) -> None:
        session, unplayable = self.any_busy_session(draw), draw(st.booleans())
        if session is not None:
            session.busy = "turning"
            effects.record_fault(
                self.run, session, "died", unplayable=unplayable, now_wall=WALL
            )

    def give_up(self, draw: Draw) -> None:
        """No simulator was free: the session ends by no fault of its policy."""
        session = self.any_busy_session(draw)
        if session is not None:
            session.busy, session.steps = "turning", 0
            effects.close_session(self.run, session, "unknown", WALL)

    def heartbeat(self, draw: Draw) -> None:
        session = self.any_session(draw)
        if session is not None:
            command = Heartbeat(session.worker_id, session.session_id)
            if self.decide_checked(command) == Accept():
                effects.extend_lease(session, self.now)

    def detach(self, draw: Draw) -> None:
        session = self.any_session(draw)
        if session is None:
            return
        verdict = self.decide_checked(Detach(session.worker_id, session.session_id))
        if verdict == Accept():
            effects.close_session(self.run, session, "detached", WALL)
        assert (verdict == NoChange()) <= (session not in self.run.workers.values())

    def stop(self, draw: Draw) -> None:
        mode: Any = draw(st.sampled_from(["abort", "drain"]))
        if self.decide_checked(Stop(mode)) == Accept():
            effects.stop(self.run, mode, WALL)
            assert self.run.state in ("stopped", "stopping", "completed")

    def resume(self, _draw: Draw | None) -> None:
        if self.decide_checked(Resume()) == Accept():
            effects.resume(self.run, WALL)
        is_queued = self.run.state == "queued"
        assert effects.admit(self.run, WALL) == is_queued

    def wait(self, draw: Draw) -> None:
        self.now += draw(st.sampled_from([1.0, 9.0, 11.0]))

    @invariant()
    def every_episode_is_in_one_place(self) -> None:
        run = self.run
        held = [s.episode.index for s in run.workers.values() if s.episode]
        scored = [e.index for e in run.episodes if e.result is not None]
        everywhere = sorted([*run.pending, *held, *scored])
        assert everywhere == list(range(len(run.episodes)))
        assert [e.index for e in run.episodes if e.in_progress] == sorted(held)
        assert run.scored == len(scored)

    @invariant()
    def results_are_written_once(self) -> None:
        for episode in self.run.episodes:
            assert 1 <= episode.attempt <= self.run.manifest["max_attempts"]
            assert episode.faults_forgiven <= episode.faults
            if episode.result is not None:
                first = self.results.setdefault(episode.index, episode.result)
                assert episode.result is first
        assert len(self.results) == self.run.scored

    @invariant()
    def the_state_follows_from_the_rest(self) -> None:
        run = self.run
        assert (run.state == "completed") == (run.scored == len(run.episodes))
        assert (run.state in ("running", "stopping")) == bool(run.live_sessions)
        assert len(run.live_sessions) <= run.max_workers
        assert all((s.episode is None) == s.done for s in run.workers.values())
        assert (run.retryable is None) == (run.state != "failed")
        assert run.reason or run.state != "failed"

    def teardown(self) -> None:
        """From wherever it got to, the run can be brought to its end."""
        run = self.run
        if run.retryable is False:
            return
        if run.state not in ("failed", "completed"):
            effects.stop(run, "abort", WALL)
        self.resume(None)
        while run.scored < len(run.episodes):
            session = self.open(Attach("a", "last", takeover=True))
            effects.store_answer(session, {}, self.now)
            play_turn(run, session, chunk_result(1, ended=True), self.now)
        self.every_episode_is_in_one_place()
        self.results_are_written_once()
        self.the_state_follows_from_the_rest()


AnyOrder.TestCase.settings = settings(max_examples=200, stateful_step_count=50)
TestAnyOrder = AnyOrder.TestCase
