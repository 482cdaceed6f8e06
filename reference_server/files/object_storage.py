"""Finished files in object storage: S3 and what speaks its protocol, or a folder.

The library finds credentials and the endpoint where its users expect them, as in
AWS_ACCESS_KEY_ID and AWS_ENDPOINT_URL; this module has none of its own. An object is
there whole or not at all, and durably once `put` has returned.
"""

from __future__ import annotations

import functools
import os
import re
import secrets
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from datetime import timedelta
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar
from urllib.parse import urlsplit

if TYPE_CHECKING:
    from obstore.store import ObjectStore

Done = TypeVar("Done")

# The folder of records that were handed in; the others are those of runs.
IMPORTED = "imported"
# One call, with its repeats, ends within so long: a turn waits for it.
CALL_S = 30
REPEATS = 3
# A look whether the storage is there is not repeated, and ends within so long.
LOOK_S = 1.5

# Part of a text of the library → the reason in our words; the first that fits counts.
_REASONS = (
    (
        r"//169\.254\.|/latest/api/token|Missing \w*AccessKey|Account must be",
        "no credentials were found: set {credentials}",
    ),
    (r"NoSuchBucket|ContainerNotFound", "there is no bucket {bucket} at {address}"),
    (r"status code: 40[13]", "{address} refuses the credentials: {status}"),
    (r"status code: ", "{address} answers {status}"),
    (r"dns error", "no address is known of {address}"),
    (r"certificate", "the certificate of {address} is not trusted"),
    (r"TimedOut|timed out", "{address} does not answer in time"),
    (r"kind: Connect", "{address} takes no connection"),
)
_CREDENTIALS = {
    "s3": "AWS_ACCESS_KEY_ID and AWS_SECRET_ACCESS_KEY",
    "gs": "GOOGLE_APPLICATION_CREDENTIALS",
    "az": "AZURE_STORAGE_ACCOUNT_NAME and AZURE_STORAGE_ACCOUNT_KEY",
}
_ADDRESS = re.compile(r"performing [A-Z]+ https?://([^/\s]+)")
_STATUS = re.compile(r"status code: (\d+[\w ]*)")
_CODE = re.compile(r"<Code>(\w+)</Code>")


class StorageFailed(OSError):
    """The storage cannot be used now; the text says why."""


class ObjectStorage:
    """Below one URL, such as s3://BUCKET/PREFIX.

    All methods raise StorageFailed, and block.
    """

    def __init__(self, url: str) -> None:
        self.url = url
        self._was_reached = False  # at the last look

    @functools.cached_property
    def _store(self) -> ObjectStore:
        return self._open(CALL_S, REPEATS)

    @functools.cached_property
    def _looked_at(self) -> ObjectStore:
        return self._open(LOOK_S, 0)

    def _open(self, limit_s: float, repeats: int) -> ObjectStore:
        try:
            from obstore.store import from_url
        except ImportError as error:
            raise StorageFailed(
                "records_storage needs obstore: install the extra `storage`"
            ) from error
        limit = timedelta(seconds=limit_s)
        settings: dict[str, Any] = {
            "retry_config": {"max_retries": repeats, "retry_timeout": limit},
            "client_options": {"timeout": limit, "allow_http": True},
        }
        if self.url.startswith("file://"):
            settings = {"mkdir": True}
        return self._call(functools.partial(from_url, self.url, **settings))

    def check(self) -> None:
        """Raises StorageFailed if it cannot be read."""
        self._call(functools.partial(self._store.list_with_delimiter, "none"))

    def look(self) -> None:
        """As `check`, soon; one failure after a success is not raised."""
        was_reached, self._was_reached = self._was_reached, False
        try:
            self._call(functools.partial(self._looked_at.list_with_delimiter, "none"))
            self._was_reached = True
        except StorageFailed:
            if not was_reached:
                raise

    def put(self, name: str, path: Path) -> None:
        """Store a file."""
        self._call(lambda: self._store.put(name, path))

    def fetch(self, name: str, path: Path) -> None:
        """Write an object to a file, which is whole or not there.

        Raises FileNotFoundError if there is no such object.
        """
        found = self._call(lambda: self._store.get(name))
        path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        draft = path.with_name(f".{path.name}.{secrets.token_hex(4)}.draft")
        try:
            descriptor = os.open(draft, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
            with os.fdopen(descriptor, "wb") as file:
                self._call(lambda: file.writelines(found))
            draft.replace(path)
        finally:
            draft.unlink(missing_ok=True)

    def sizes(self) -> Mapping[str, int]:
        """The bytes of all objects, by the first part of their names."""
        sizes: Counter[str] = Counter()

        def add_all() -> None:
            for objects in self._store.list():
                for item in objects:
                    sizes[item["path"].partition("/")[0]] += item["size"]

        self._call(add_all)
        return sizes

    def folders(self) -> set[str]:
        """The first parts of all names."""
        listed = self._call(self._store.list_with_delimiter)
        return {prefix.strip("/") for prefix in listed["common_prefixes"]}

    def names_in(self, folder: str) -> list[str]:
        """The last parts of the names of the objects in a folder."""
        listed = self._call(lambda: self._store.list_with_delimiter(folder))
        return [item["path"].rpartition("/")[2] for item in listed["objects"]]

    def remove(self, names: Iterable[str]) -> None:
        """Objects that are not there are no error."""
        for name in names:
            try:
                self._call(functools.partial(self._store.delete, name))
            except FileNotFoundError:
                continue

    def remove_folder(self, folder: str) -> None:
        self.remove(f"{folder}/{name}" for name in self.names_in(folder))

    def _call(self, work: Callable[[], Done]) -> Done:
        """Errors of the library are StorageFailed; a missing object is none of them."""
        from obstore.exceptions import BaseError

        try:
            return work()
        except (BaseError, ValueError, OSError) as error:
            text, is_missing = str(error), isinstance(error, FileNotFoundError)
            is_of_disk = isinstance(error, OSError) and error.errno is not None
            if is_of_disk or (is_missing and "NoSuchBucket" not in text):
                raise
            raise StorageFailed(f"object storage: {self._reason(text)}") from error

    def _reason(self, text: str) -> str:
        """text: of the library, with its details."""
        url = urlsplit(self.url)
        address, status, code = (
            pattern.search(text) for pattern in (_ADDRESS, _STATUS, _CODE)
        )
        values = {
            "address": address[1] if address else url.netloc,
            "bucket": url.netloc,
            "credentials": _CREDENTIALS.get(url.scheme, ""),
            "status": " ".join(found[1] for found in (status, code) if found),
        }
        for pattern, reason in _REASONS:
            if re.search(pattern, text):
                return reason.format_map(values)
        return text.partition("\n")[0]


def storage_at(url: str) -> ObjectStorage | None:
    """Where finished files are kept; None for the folder that they are written to."""
    return ObjectStorage(url) if url else None
