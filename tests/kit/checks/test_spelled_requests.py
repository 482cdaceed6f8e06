"""Other spellings of a request are legal, and have the same content."""

import json

import pytest

from conformance.checks.support.generated.spelled_requests import spell_request

BODY = {
    "policy": {"name": 'a/b \u00e9 \U0001f600 "\\\n'},
    "values": [0.1, 1.0, -0.0, 1e300, 0.375, 5e-324, 123456.789],
    "seq": 3,
    "flags": [True, None, {}],
}


@pytest.mark.parametrize("seed", range(1, 60))
def test_spelled_body_has_the_same_content(seed: int) -> None:
    content, headers = spell_request(seed, BODY, {"If-None-Match": "x"})
    assert content is not None
    assert json.loads(content) == BODY
    assert headers["Content-Type"].lower().startswith("application/json")
    assert headers["If-None-Match"] == "x"
    assert spell_request(seed, BODY, {"If-None-Match": "x"}) == (content, headers)


def test_spellings_differ() -> None:
    spelled = [spell_request(seed, BODY, None) for seed in range(1, 60)]
    assert len({content for content, _ in spelled}) == 59
    for name in ("Accept", "Content-Type"):
        assert len({headers[name] for _, headers in spelled}) > 4
    assert spell_request(1, None, None)[0] is None
