"""openpi's way, with the real client. It sends what others receive: see openpi_server.

So what is judged is what was sent, and that the answer belongs to it.
"""

from __future__ import annotations

from openpi_client.websocket_client_policy import WebsocketClientPolicy

from benchmarks.round_trips.contenders import turn_client
from benchmarks.round_trips.observations import ScenarioPlayer


def connect(address: str, scenario: str) -> turn_client.Turn:
    host, _, port = address.partition(":")
    policy = WebsocketClientPolicy(host, int(port))
    world = ScenarioPlayer(scenario)

    def turn(action: list[float]) -> turn_client.ObservationParts:
        state, images = world.turn(action)
        answer = policy.infer({"state": state, "images": images})
        assert answer["step"] == state["base"][0]
        assert answer["actions"].shape == (len(action),)
        return state, images

    return turn


if __name__ == "__main__":
    turn_client.main(connect)
