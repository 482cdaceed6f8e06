"""Finished files in object storage: S3 and what speaks its protocol, or a folder.

The library finds credentials and the endpoint where its users expect them, as in
AWS_ACCESS_KEY_ID and AWS_ENDPOINT_URL; this module has none of its own. An object is
there whole or not at all, and durably once `put` has returned.
"""

from __future__ import annotations

import asyncio
import functools
import os
import secrets
from collections.abc import Callable, Iterable
from datetime import timedelta
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    from obstore.store import ObjectStore

Done = TypeVar("Done")

# One call, with its repeats, ends within so long: a turn waits for it.
CALL_S = 30
REPEATS = 3


class ObjectStorage:
    """Below one URL, such as s3://BUCKET/PREFIX. All methods raise OSError and block.

    `in_thread` is for who may not block.
    """

    def __init__(self, url: str) -> None:
        self.url = url

    @functools.cached_property
    def _store(self) -> ObjectStore:
        try:
            from obstore.store import from_url
        except ImportError as error:
            raise OSError(
                "records_storage needs obstore: install the extra `storage`"
            ) from error
        limit = timedelta(seconds=CALL_S)
        settings: dict[str, Any] = {
            "retry_config": {"max_retries": REPEATS, "retry_timeout": limit},
            "client_options": {"timeout": limit, "allow_http": True},
        }
        if self.url.startswith("file://"):
            settings = {"mkdir": True}
        return _call(functools.partial(from_url, self.url, **settings))

    def check(self) -> None:
        """Raises OSError if it cannot be read."""
        _call(functools.partial(self._store.list_with_delimiter, "none"))

    def put(self, name: str, path: Path) -> None:
        """Store a file."""
        _call(lambda: self._store.put(name, path))

    def fetch(self, name: str, path: Path) -> None:
        """Write an object to a file, which is whole or not there.

        Raises FileNotFoundError if there is no such object.
        """
        found = _call(lambda: self._store.get(name))
        path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        draft = path.with_name(f".{path.name}.{secrets.token_hex(4)}.draft")
        try:
            descriptor = os.open(draft, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
            with os.fdopen(descriptor, "wb") as file:
                _call(lambda: file.writelines(found))
            draft.replace(path)
        finally:
            draft.unlink(missing_ok=True)

    def folders(self) -> set[str]:
        """The first parts of all names."""
        listed = _call(self._store.list_with_delimiter)
        return {prefix.strip("/") for prefix in listed["common_prefixes"]}

    def names_in(self, folder: str) -> list[str]:
        """The last parts of the names of the objects in a folder."""
        listed = _call(lambda: self._store.list_with_delimiter(folder))
        return [item["path"].rpartition("/")[2] for item in listed["objects"]]

    def remove(self, names: Iterable[str]) -> None:
        """Objects that are not there are no error."""
        for name in names:
            try:
                _call(functools.partial(self._store.delete, name))
            except FileNotFoundError:
                continue

    def remove_folder(self, folder: str) -> None:
        self.remove(f"{folder}/{name}" for name in self.names_in(folder))


async def in_thread(work: Callable[..., Done], *given: object) -> Done:
    return await asyncio.to_thread(work, *given)


def _call(work: Callable[[], Done]) -> Done:
    """Errors of the library are errors of input and output; a missing object is one."""
    from obstore.exceptions import BaseError

    try:
        return work()
    except (BaseError, ValueError) as error:
        raise OSError(f"object storage: {str(error).partition(chr(10))[0]}") from error
