"""To which base URL of a service a request goes."""

from conformance.client.base_urls import BaseUrls

A, B = "http://a.example:84", "http://a.example:8460/proctor"


def test_requests_are_spread_alike_with_the_same_seed_only() -> None:
    names = [f"CLU-001/{number}" for number in range(40)]
    spread, again, other = (
        [BaseUrls((A, B), seed=seed).choose(f"{A}/v1", name) for name in names]
        for seed in (1, 1, 2)
    )
    assert set(spread) == {f"{A}/v1", f"{B}/v1"}
    assert spread == again != other


def test_a_pinned_one_gets_all_requests() -> None:
    urls = BaseUrls((A, B), pinned=1)
    assert urls.first == B
    for address in (f"{A}/v1/runs?limit=1", f"{B}/v1/runs?limit=1"):
        assert urls.choose(address, "any/1") == f"{B}/v1/runs?limit=1"


def test_addresses_elsewhere_stay_as_they_are() -> None:
    """A port that begins alike is another server; the base URL alone is not."""
    urls = BaseUrls((A, B))
    for address in ("http://other.example/v1", f"{A}99/v1", "http://a.example/v1"):
        assert urls.path_of(address) is None
        assert urls.choose(address, "any/1") == address
    assert (urls.path_of(A), urls.path_of(f"{B}/v1")) == ("", "/v1")
    assert BaseUrls((A,)).choose(f"{A}/v1", "any/1") == f"{A}/v1"
