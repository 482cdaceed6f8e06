"""Heartbeats are sent while a policy computes, and only then."""

import threading

from reference_client.protocol.heartbeat import HeartbeatThread
from tests.support.servers import TIMEOUT_S


def test_heartbeats_are_sent_only_while_the_policy_thinks() -> None:
    beats = threading.Semaphore(0)

    def send_heartbeat() -> bool:
        beats.release()
        return True

    with HeartbeatThread(0.12, send_heartbeat) as heartbeat:
        assert not beats.acquire(timeout=0.2)
        with heartbeat.keep_alive():
            assert beats.acquire(timeout=TIMEOUT_S)
            assert beats.acquire(timeout=TIMEOUT_S)


def test_heartbeats_stop_when_the_session_has_ended() -> None:
    beaten = threading.Event()

    def send_heartbeat() -> bool:
        assert not beaten.is_set()
        beaten.set()
        return False

    with HeartbeatThread(0.06, send_heartbeat) as heartbeat, heartbeat.keep_alive():
        assert beaten.wait(TIMEOUT_S)
        heartbeat._thread.join(TIMEOUT_S)
        assert not heartbeat._thread.is_alive()
