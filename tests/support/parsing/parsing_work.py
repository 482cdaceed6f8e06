"""Whether the work of a parser grows with the length of its input alone.

Work is the processor time of this process, of which other programs take nothing. For an
input that is sixteen times as long a linear parser needs sixteen times the work, and a
quadratic one 256 times: the limit is between them, and never a number of seconds. What
disturbs a measurement makes it longer, so the least of several is compared.
"""

import gc
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

# The sizes that are compared, and how much more work the larger one may be.
SIZE_FACTOR, WORK_FACTOR = 16, 64
# Less than this delays no other request, however it grows.
FREE_S = 0.005
# Shorter measurements say nothing: the first bytes of a long text cost memory, too.
LEAST_S = 0.000_25
ATTEMPTS = 5
# A quadratic parser is found at this size, before it takes minutes for larger ones.
FIRST_SIZE = 2**15


class NotLinear(AssertionError):
    """The work of a parser grows faster than its input."""


def assert_linear(parse: Callable[[int], object], most: int, what: str) -> None:
    """Raise NotLinear unless `parse`, called with sizes up to `most`, is linear. parse:
    makes an input of that size and parses it; making it must be the smaller part of the
    work. what: names the input in the error."""
    sizes = [most]
    while sizes[0] > FIRST_SIZE:
        sizes.insert(0, sizes[0] // 4)
    for size in sizes:
        _assert_linear_up_to(size, parse, what)


def _assert_linear_up_to(size: int, parse: Callable[[int], object], what: str) -> None:
    smaller = size // SIZE_FACTOR
    work_s = smaller_s = float("inf")
    for _ in range(ATTEMPTS):
        work_s = min(work_s, work_of(lambda: parse(size)))
        if work_s <= FREE_S:
            return
        smaller_s = min(smaller_s, work_of(lambda: parse(smaller)))
        if work_s <= WORK_FACTOR * max(smaller_s, LEAST_S):
            return
    raise NotLinear(
        f"{what}: {smaller} bytes take {smaller_s * 1e3:.2f} ms of a processor, "
        f"{size} bytes take {work_s * 1e3:.1f} ms"
    )


def work_of(call: Callable[[], object]) -> float:
    """Seconds of a processor that a call takes in all threads of this process."""
    with _without_collections():
        begun_at = time.process_time()
        call()
        return time.process_time() - begun_at


@contextmanager
def _without_collections() -> Iterator[None]:
    gc.disable()
    try:
        yield
    finally:
        gc.enable()
