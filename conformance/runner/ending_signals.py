"""The signals that end the kit, taken where an exception harms nothing.

An exception of a handler may land in a function that a library in C has called: the
library prints it and goes on. So the interruption is raised in the code of the kit, or
where a call waits; elsewhere the handler is called again a moment later.
"""

import atexit
import signal
from types import FrameType

from conformance.client.connections.transport.closed_output import take_ending_signals

_AGAIN_S = 0.01
_OWN_CODE = ("conformance.",)
# The next alarm may come before a handler has returned to the library.
_HANDLERS = (__name__, take_ending_signals.__module__)
_WAITS = (
    *("httpcore.", "multiprocessing.", "selectors", "socket", "ssl"),
    *("subprocess", "threading"),
)


class EndingSignals:
    """Raises KeyboardInterrupt at a signal, and with `once` at the first alone.

    With it, a second signal does not end what tidies up after the first.
    """

    def __init__(self, *, once: bool) -> None:
        self._once = once
        self._is_over = False

    def install(self) -> None:
        """Take the signals from now on; one that `nohup` has switched off stays so."""
        take_ending_signals(self._handle)
        if hasattr(signal, "setitimer"):  # no alarm outlives the handler
            atexit.register(signal.setitimer, signal.ITIMER_REAL, 0)

    def _handle(self, _number: int, frame: FrameType | None) -> None:
        if self._is_over:
            return
        module = frame.f_globals.get("__name__", "") if frame else ""
        is_elsewhere = not module.startswith(_OWN_CODE + _WAITS) or module in _HANDLERS
        if is_elsewhere and hasattr(signal, "setitimer"):
            signal.signal(signal.SIGALRM, self._handle)
            signal.setitimer(signal.ITIMER_REAL, _AGAIN_S)
            return
        self._is_over = self._once
        raise KeyboardInterrupt
