"""A limit of threads or processes is the client's failure where its code meets it."""

import threading

import pytest

from reference_client.evaluation import rounds
from reference_client.policies.error_origin import policy_failure
from reference_client.protocol import retry_policy

NO_THREAD = 'raise RuntimeError("can\'t start new thread")'
NO_PROCESS = 'raise BlockingIOError(11, "Resource temporarily unavailable")'


@pytest.mark.parametrize("limit", [NO_THREAD, NO_PROCESS])
@pytest.mark.parametrize(
    ("place", "code", "said"),
    [
        (rounds.__file__, "client_failed", "The policy is not the cause. Raise"),
        (retry_policy.__file__, "client_failed", "the limit of this user (`ulimit -u`"),
        (threading.__file__, "client_failed", "or take fewer --workers"),
        ("/home/me/my_policy.py", "policy_failed", "(my_policy.py:1)"),
    ],
)
def test_a_limit_is_of_who_meets_it(
    limit: str, place: str, code: str, said: str
) -> None:
    with pytest.raises((RuntimeError, BlockingIOError)) as raised:
        exec(compile(limit, place, "exec"))  # noqa: S102 - a line of that file
    assert raised.tb.tb_next is not None, "the line itself"
    failure = policy_failure(raised.value.with_traceback(raised.tb.tb_next))
    assert failure.code == code
    assert said in failure.detail
