"""A session of a check with a policy server.

`reset` and `predict` are set-up: a refusal proves nothing against the rule under test.
The `try_` methods return the raw answer, for `expect` to judge.
"""

import itertools
from typing import Any

from conformance.client.check_context import CheckContext
from conformance.exchanges.answer import Answer
from conformance.policy import turn_builder
from conformance.policy.turn_builder import Beginning
from conformance.verdicts.expect import SetUpFailed

_numbers = itertools.count(1)


class PolicySession:
    """One session; `seq` is that of its next turn."""

    def __init__(self, context: CheckContext) -> None:
        self.context = context
        self.benchmark = context.benchmark
        self.session_id = f"kit-{context.random.randrange(10**9)}-{next(_numbers)}"
        self.seq = 0
        self.beginning = Beginning(**context.shared.settings.beginning)
        self.view = turn_builder.episode(self.benchmark, beginning=self.beginning)

    def reset_body(self, index: int = 0, attempt: int = 1) -> dict[str, Any]:
        """Give the body of a reset; the turns that follow are of that attempt."""
        self.view = turn_builder.episode(self.benchmark, index, attempt, self.beginning)
        return {
            "session_id": self.session_id,
            "run_id": "run_kit",
            "benchmark": self.benchmark,
            "episode": self.view,
        }

    def try_reset(self, index: int = 0, attempt: int = 1, **members: Any) -> Answer:
        """Send `reset`, with further members if given."""
        body = self.reset_body(index, attempt) | members
        return self.context.call("reset", json=body)

    def reset(self, index: int = 0, attempt: int = 1) -> None:
        """Begin an attempt."""
        self.context.require(lambda: self.try_reset(index, attempt), 200, "reset")

    def turn(self, **members: Any) -> dict[str, Any]:
        """Give the next turn."""
        turn_body = turn_builder.turn(
            self.benchmark, self.session_id, self.seq, self.view, self.beginning.state
        )
        return turn_body | members

    def try_predict(self, turn: dict[str, Any] | None = None, **how: Any) -> Answer:
        """Send `predict`; `seq` of the session does not change."""
        return self.context.call("predict", json=turn or self.turn(), **how)

    def predict(self) -> list[Any]:
        """Send `predict`, and advance as if the actions had been executed."""
        answer = self.context.require(self.try_predict, 200, "predict")
        actions: list[Any] = answer["actions"]
        if not actions:
            raise SetUpFailed("`predict` returned no action")
        self.seq += 1
        left = self.view["max_steps"] - 1
        step = min(self.view["step"] + len(actions), left)
        self.view = self.view | {"step": step}
        return actions
