"""The base URLs of one service, and to which of them a request goes."""

import zlib
from dataclasses import dataclass


@dataclass(frozen=True)
class BaseUrls:
    """Where a service is reached: its requests are spread, or go to one of them.

    pinned: the one that gets all requests, by its place; None spreads them.
    seed: another one spreads the same requests otherwise.
    """

    urls: tuple[str, ...]
    pinned: int | None = None
    seed: int = 0

    @property
    def first(self) -> str:
        """The one that paths are completed with."""
        return self.urls[self.pinned or 0]

    def choose(self, url: str, name: str) -> str:
        """Give the same address at the base URL that gets the request of this name.

        An address outside of the service stays as it is.
        """
        rest = self.path_of(url)
        if rest is None:
            return url
        number = self.pinned
        if number is None:
            number = zlib.crc32(f"{self.seed}/{name}".encode()) % len(self.urls)
        return self.urls[number] + rest

    def path_of(self, url: str) -> str | None:
        """Give the path behind the base URL; None for an address elsewhere."""
        for base_url in self.urls:
            rest = url.removeprefix(base_url)
            if rest != url and rest[:1] in ("", "/", "?"):
                return rest
        return None
