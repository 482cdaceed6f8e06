"""One call of a policy before there is a run, with an observation that is made up.

The observation has every name, size and dtype that the benchmark declares: vectors in
the middle of their range, rotations that are the identity, grey images. The
benchmark may never be in such a state. So only mistakes that show in every state end
the evaluation here: names and shapes, and errors that a correct policy does not raise
for valid input.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from reference_client.api.action_layout import ActionLayout
from reference_client.api.observation import (
    DTYPES,
    Named,
    Observation,
    state_vector,
)
from reference_client.api.policy import Policy, check_length, chunk_of
from reference_client.errors import POLICY_FAILED, ProctorError, as_sentence
from reference_client.policies.error_origin import describe_policy_error
from reference_client.policies.servers.policy_server_client import PolicySession
from reference_record.contents.declared_parts import declared_parts
from reference_record.generated import answers

_IDENTITIES = {
    "quaternion_wxyz": [1.0, 0.0, 0.0, 0.0],
    "quaternion_xyzw": [0.0, 0.0, 0.0, 1.0],
    "rot6d_columns": [1.0, 0.0, 0.0, 0.0, 1.0, 0.0],
    "rot6d_interleaved": [1.0, 0.0, 0.0, 1.0, 0.0, 0.0],
}
_GREY = 128
_ANY_SIZE: answers.ImageSize = {"width": 64, "height": 64}
NOTE = "This was a dry turn; no run was submitted."
# Errors of a wrong signature or name. Any other error of `reset` may only mean that the
# policy does not know the instruction, which is made up: a run has real ones.
_PROGRAM_ERRORS = (TypeError, AttributeError, NameError, ImportError)


def play_dry_turn(policy: Policy, benchmark: answers.Benchmark) -> str | None:
    """Call `reset` and `act` once. benchmark: schema Benchmark as JSON.

    Returns why `act` could not be tried, if so. Raises ProctorError for actions that do
    not fit, and what the policy raises.
    """
    if isinstance(policy, PolicySession):
        return None  # it forwards real turns
    try:
        return _play(policy, benchmark)
    except ProctorError as error:
        raise error.explained(NOTE) from error
    except (Exception, SystemExit) as error:
        error.add_note(NOTE)
        raise


def settle_doubt(
    doubt: str | None, benchmark_id: str, say: Callable[[str], None], *, counts: bool
) -> None:
    """Refuse or warn, if a dry turn was not played to its end.

    counts: whether the server counts runs against a quota: none is submitted there.
    """
    if doubt is None:
        return
    if counts:
        text = f"{doubt} Runs count against a quota here, so no run was submitted. If "
        text += f"it knows the instructions of {benchmark_id}, repeat it with "
        raise ProctorError(POLICY_FAILED, f"{text}dry_turn=False.")
    say(f"{doubt} That is fine if it knows those of {benchmark_id}, which now follow.")


def _play(policy: Policy, benchmark: answers.Benchmark) -> str | None:
    title = benchmark["title"]
    try:
        policy.reset(title)
    except _PROGRAM_ERRORS:
        raise
    except Exception as error:  # noqa: BLE001 - it may know its instructions only
        what = describe_policy_error(error).removeprefix("The policy raised ")
        return (
            f"The policy was not tried before the run, as it does not take {title!r}, "
            f"a made-up instruction: {as_sentence(what)}"
        )
    layout = ActionLayout.of(benchmark["benchmark_id"], benchmark["action_space"])
    try:
        chunk = chunk_of(policy.act(_observation(benchmark)), layout)
    except (ArithmeticError, AssertionError):
        return None  # such a state may be impossible
    except ProctorError as error:
        if any("not finite" in text for _, text in error.errors):
            return None
        raise
    check_length(chunk, benchmark["max_chunk"], layout)
    return None


def _observation(benchmark: answers.Benchmark) -> Observation:
    space = benchmark["observation_space"]
    size = (benchmark["image_sizes"] or [_ANY_SIZE])[0]
    shape = (size["height"], size["width"])
    return Observation(
        state=Named(
            "state",
            {
                name: state_vector(_vector(declared))
                for name, declared in space["state"].items()
            },
        ),
        images=Named(
            "images",
            {
                name: np.full((*shape, declared["channels"]), _GREY, np.uint8)
                for name, declared in space["images"].items()
            },
        ),
        tensors=Named(
            "tensors",
            {
                name: np.zeros(declared["shape"], declared["dtype"])
                for name, declared in space["tensors"].items()
                if declared["dtype"] in DTYPES
            },
        ),
        instruction=benchmark["title"],
        episode_id="e0000",
        step=0,
    )


def _vector(space: answers.VectorSpace) -> tuple[float, ...]:
    low, high = space.get("minimum"), space.get("maximum")
    values = [0.0] * space["size"]
    if low and high:
        values = [(a + b) / 2 for a, b in zip(low, high, strict=True)]
    for part in declared_parts(space).values():
        identity = _IDENTITIES.get(part.rotation, [])
        if len(identity) == part.size:
            values[part.start : part.start + part.size] = identity
    return tuple(values)
