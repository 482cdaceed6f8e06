"""Object storage that cannot be used: the reasons, in our words."""

from __future__ import annotations

import asyncio
import contextlib
import threading
from collections.abc import Awaitable, Callable, Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path

import pytest

from reference_server.files import object_storage
from reference_server.files.object_storage import ObjectStorage, StorageFailed
from reference_server.records.import_files import Draft, ImportFiles
from reference_server.records.recordings import Recordings
from reference_server.rules.refusal import Refused

URL = "s3://bucket/prefix"
NO_CREDENTIALS = "no credentials were found: set AWS_ACCESS_KEY_ID and AWS_SECRET"


class Answers(BaseHTTPRequestHandler):
    """To each GET the same."""

    status, body = 200, b""

    def do_GET(self) -> None:
        self.send_response(self.status)
        self.send_header("Content-Length", str(len(self.body)))
        self.end_headers()
        self.wfile.write(self.body)

    def log_message(self, *_: object) -> None:
        """The output is that of pytest."""


@contextmanager
def storage_that_answers(status: int, code: str) -> Iterator[str]:
    """The address of a storage with this error of S3."""
    body = f'<?xml version="1.0"?>\n<Error><Code>{code}</Code></Error>'.encode()
    answers = type("Given", (Answers,), {"status": status, "body": body})
    with HTTPServer(("127.0.0.1", 0), answers) as server:
        thread = threading.Thread(target=server.serve_forever, args=(0.02,))
        thread.start()
        try:
            yield f"127.0.0.1:{server.server_port}"
        finally:
            server.shutdown()
            thread.join()


@pytest.fixture
def endpoint(monkeypatch: pytest.MonkeyPatch) -> pytest.MonkeyPatch:
    monkeypatch.setenv("AWS_ACCESS_KEY_ID", "a")
    monkeypatch.setenv("AWS_SECRET_ACCESS_KEY", "b")
    return monkeypatch


@pytest.mark.parametrize(
    ("status", "code", "said"),
    [
        (404, "NoSuchBucket", "there is no bucket bucket at {}"),
        (404, "None", "{} answers 404 Not Found None"),
        (403, "InvalidAccessKeyId", "{} refuses the credentials: 403 Forbidden Inval"),
        (401, "Unauthorized", "{} refuses the credentials: 401 Unauthorized"),
        (503, "SlowDown", "{} answers 503 Service Unavailable SlowDown"),
    ],
)
def test_an_error_of_the_storage_is_a_reason(
    endpoint: pytest.MonkeyPatch, tmp_path: Path, status: int, code: str, said: str
) -> None:
    """In a look and in a fetch, where a missing bucket is no missing object."""
    with storage_that_answers(status, code) as address:
        endpoint.setenv("AWS_ENDPOINT_URL", f"http://{address}")
        with pytest.raises(StorageFailed) as failed:
            ObjectStorage(URL).look()
        assert f"object storage: {said.format(address)}" in str(failed.value)
        if code == "NoSuchBucket":
            with pytest.raises(StorageFailed, match="no bucket"):
                ObjectStorage(URL).fetch("object", tmp_path / "file")
        if code == "None":
            with pytest.raises(FileNotFoundError):
                ObjectStorage(URL).fetch("object", tmp_path / "file")


@pytest.mark.parametrize(
    ("names", "said"),
    [
        ({"AWS_ENDPOINT_URL": "http://127.0.0.1:9"}, "127.0.0.1:9 takes no connection"),
        ({"AWS_ENDPOINT_URL": "http://x.invalid"}, "no address is known of x.invalid"),
        (
            {
                "AWS_ACCESS_KEY_ID": "",
                "AWS_SECRET_ACCESS_KEY": "",
                "AWS_METADATA_ENDPOINT": "http://127.0.0.1:9",
            },
            NO_CREDENTIALS,
        ),
        ({"AWS_ACCESS_KEY_ID": ""}, NO_CREDENTIALS),
        ({"AWS_SECRET_ACCESS_KEY": ""}, NO_CREDENTIALS),
    ],
)
def test_a_storage_that_is_not_reached_is_a_reason(
    endpoint: pytest.MonkeyPatch, tmp_path: Path, names: dict[str, str], said: str
) -> None:
    """Also where the server looks whether it can record."""
    for name, value in names.items():
        endpoint.setenv(name, value)
        if not value:
            endpoint.delenv(name)
    recordings = Recordings(tmp_path, storage=ObjectStorage(URL))
    with pytest.raises(StorageFailed, match=said):
        asyncio.run(recordings.check_writable())
    asyncio.run(recordings.close())


def test_one_slow_answer_of_the_storage_is_not_its_end(tmp_path: Path) -> None:
    """All nodes have the same storage, and would not be ready at once."""

    class Slow:
        def list_with_delimiter(self, _prefix: str) -> None:
            if not next(reached):
                raise OSError("503 SlowDown")

    reached = iter([False, True, False, True, False, False])
    storage = ObjectStorage(f"file://{tmp_path}")
    vars(storage)["_looked_at"] = Slow()
    for is_raised in [True, False, False, False, False, True]:
        with pytest.raises(StorageFailed) if is_raised else contextlib.nullcontext():
            storage.look()


@pytest.mark.parametrize("operation", ["recording", "archive", "deletion", "upload"])
async def test_who_needs_the_storage_may_try_again(
    endpoint: pytest.MonkeyPatch, tmp_path: Path, operation: str
) -> None:
    """It is away: what is stored there is neither missing nor the database's fault."""
    endpoint.setenv("AWS_ENDPOINT_URL", "http://127.0.0.1:9")
    endpoint.setattr(object_storage, "REPEATS", 0)
    storage = ObjectStorage(URL)
    recordings = Recordings(tmp_path / "records", storage=storage)
    imports = ImportFiles(tmp_path / "imports", storage=storage)
    imports.open(set())
    draft = Draft(tmp_path / "draft", 0, "")
    draft.path.touch()
    used: dict[str, Callable[[], Awaitable[object]]] = {
        "recording": lambda: recordings.make_here("run_1", [(0, 0)]),
        "archive": lambda: imports.make_here("imp_1"),
        "deletion": lambda: imports.remove_stored("imp_1"),
        "upload": lambda: imports.keep("imp_1", draft),
    }
    with pytest.raises(Refused, match="storage of recordings") as refused:
        await used[operation]()
    assert refused.value.code == "unavailable"
    await recordings.close()
