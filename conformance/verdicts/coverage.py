"""How many histories a run of the kit tried, and which operations followed which."""

from typing import Any

from conformance.run_settings import Settings
from conformance.specification.document import load_spec


class Coverage:
    """Counts generated histories, and the pairs of operations on one run in a row."""

    def __init__(self) -> None:
        self.histories = 0
        self.pairs: set[tuple[str, str]] = set()
        self._last: dict[str, str] = {}

    def note(self, operation_id: str, run_id: str | None) -> None:
        """Note that an operation was requested for a run."""
        if run_id is None:
            return
        before = self._last.get(run_id)
        if before is not None:
            self.pairs.add((before, operation_id))
        self._last[run_id] = operation_id

    def as_plain(self) -> dict[str, Any]:
        """Give it as JSON-ready data."""
        return {"histories": self.histories, "pairs": [*map(list, sorted(self.pairs))]}

    def add_plain(self, plain: dict[str, Any]) -> None:
        """Add what another check has tried."""
        self.histories += plain["histories"]
        self.pairs |= {(before, after) for before, after in plain["pairs"]}

    def sentence(self, settings: Settings) -> str:
        """Say it to a reader."""
        about_runs = {
            operation.operation_id
            for operation in load_spec().operations.values()
            if "{run_id}" in operation.path and settings.is_offered(operation.profile)
        }
        tried = sum({*pair} <= about_runs for pair in self.pairs)
        return (
            f"{self.histories} generated histories; {tried} of {len(about_runs) ** 2} "
            "pairs of operations on one run, one right after the other"
        )
