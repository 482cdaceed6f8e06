"""How times are shown."""

from __future__ import annotations

from datetime import UTC, datetime

import pytest

from reference_server.views.run_views import timestamp


@pytest.mark.parametrize("at_wall", [0.0, 951_827_696.789, 1.7e9, 1_798_761_599.999])
def test_times_are_rfc_3339_to_the_millisecond(at_wall: float) -> None:
    """A leap day, and the last second of a year, among others."""
    expected = datetime.fromtimestamp(int(at_wall * 1000) / 1000, UTC)
    text = timestamp(at_wall)
    assert datetime.fromisoformat(text) == expected
    assert len(text) == len("2026-11-23T09:00:00.000Z")
