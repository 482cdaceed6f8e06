"""What lists of events are compared by."""

from conformance.client.event_reader import Event


def kinds(events: list[Event]) -> list[str]:
    return [event.kind for event in events]


def indices(events: list[Event]) -> list[int]:
    return [event.body["index"] for event in events if event.kind == "episode"]
