"""`proctor-host` as a process, a mail server for it, and forms of its pages."""

from __future__ import annotations

import os
import re
import signal
import socketserver
import subprocess
import sys
import threading
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from email import message_from_bytes
from email.message import Message
from pathlib import Path
from typing import Any, Self

import httpx

from tests.support.paths import ROOT
from tests.support.processes import PROGRAM_S, run_program
from tests.support.servers import TIMEOUT_S, end_process
from tests.support.waiting import wait_until


def track_file(track_id: str, *limits: str) -> str:
    """The file of a track with one phase, which is open. limits: lines of the phase."""
    lines = (
        f'track_id = "{track_id}"',
        f'title = "Calibration {track_id}"',
        "[[phases]]",
        'phase_id = "main"',
        'benchmark_id = "calibration"',
        "opens_at = 2020-01-01T00:00:00Z",
        "closes_at = 2120-01-01T00:00:00Z",
        *limits,
    )
    return "\n".join((*lines, ""))


TRACK = track_file("letters", "per_day = 2", "at_once = 2")


class _SmtpHandler(socketserver.StreamRequestHandler):
    """Takes every mail; what a client needs of SMTP, and no more."""

    server: MailReceiver

    def handle(self) -> None:
        self._answer("220 here")
        for line in self.rfile:
            command = line[:4].upper()
            if command == b"DATA":
                self._answer("354 go on")
                body = b"".join(iter(self.rfile.readline, b".\r\n"))
                self.server.mails.append(message_from_bytes(body))
            self._answer("221 end" if command == b"QUIT" else "250 yes")

    def _answer(self, text: str) -> None:
        self.wfile.write(text.encode() + b"\r\n")


class MailReceiver(socketserver.ThreadingTCPServer):
    """An SMTP server on a free port; mails: what it was sent."""

    daemon_threads = True

    def __init__(self) -> None:
        super().__init__(("127.0.0.1", 0), _SmtpHandler)
        self.mails: list[Message] = []
        self.url = f"smtp://127.0.0.1:{self.server_address[1]}"

    def wait_for(self, recipient: str, words: str) -> str:
        """The body of a mail to an address that has these words in its subject."""

        def found() -> list[Message]:
            return [
                mail
                for mail in list(self.mails)
                if mail["To"] == recipient and words in mail["Subject"]
            ]

        wait_until(found, f"a mail to {recipient} about {words}")
        return str(found()[0].get_payload())


@contextmanager
def mail_receiver() -> Iterator[MailReceiver]:
    with MailReceiver() as receiver:
        thread = threading.Thread(target=receiver.serve_forever, daemon=True)
        thread.start()
        yield receiver
        receiver.shutdown()


class HostedServer:
    """`proctor-host` on a free port, with its files in `directory`."""

    def __init__(
        self,
        directory: Path,
        smtp: str,
        submissions: Path | None = None,
        *,
        options: Sequence[str] = (),
        port: int = 0,
    ) -> None:
        """submissions: the folder of hosted submissions; None: it runs none.

        options: of the command. port: of the server; 0: another one at each start.
        """
        self.directory, self._smtp = directory, smtp
        self._options, self._port = options, port
        self.submissions = submissions
        self.database = directory / "platform.sqlite"
        self.start()

    def start(self, *server_options: str) -> None:
        environment = {k: v for k, v in os.environ.items() if k[:8] != "PROCTOR_"}
        environment["PROCTOR_DATABASE"] = str(self.directory / "proctor.sqlite")
        environment["PROCTOR_HOST_SMTP"] = self._smtp
        self._begin([*self._words(), *server_options], environment, ROOT)

    def _words(self) -> Sequence[str]:
        """The command; options of the server are its end."""
        # Users of sandboxes cannot enter a folder of pytest.
        submissions = str(self.submissions) if self.submissions else "off"
        return (
            *(sys.executable, "-m", "reference_platform", "--database"),
            *(str(self.database), "--administrator-email", "host@example.org"),
            *("--submissions", submissions, *self._options),
            *("--", "--port", str(self._port)),
        )

    def _begin(
        self, command: Sequence[str], environment: Mapping[str, str], folder: Path
    ) -> None:
        """Start the command in the folder, and read what it prints at its start."""
        with (self.directory / "log").open("ab") as log:
            self.process = subprocess.Popen(
                command, cwd=folder, env=environment, stdout=subprocess.PIPE,
                stderr=log, text=True,
            )  # fmt: skip
        assert self.process.stdout is not None
        self.password = self.url = ""
        for line in self.process.stdout:
            if "shown this once" in line:
                self.password = next(self.process.stdout).strip()
            if line.startswith("proctor-host: http"):
                self.url = line.split()[-1].removesuffix("/hosting")
                break
        assert self.url, (self.directory / "log").read_text()[-2000:]

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        assert self.end() in (0, 128 + signal.SIGTERM)

    def end(self, number: signal.Signals = signal.SIGTERM) -> int:
        return end_process(self.process, number)

    def client(self, key: str = "", **settings: Any) -> httpx.Client:
        headers = {"Authorization": f"Bearer {key}"} if key else {}
        return httpx.Client(
            base_url=self.url, headers=headers, timeout=TIMEOUT_S, trust_env=False,
            **settings,
        )  # fmt: skip

    def admin(self, *words: str) -> str:
        """The output of `proctor admin`."""
        command = [sys.executable, "-m", "reference_client.command", "admin", *words]
        command += ["--database", str(self.database)]
        done = run_program(command, cwd=ROOT, timeout=PROGRAM_S)
        assert done.returncode == 0, done.stderr
        return done.stdout.strip()

    def put_track(self, text: str = TRACK) -> None:
        file = self.directory / "track.toml"
        file.write_text(text)
        self.admin("track", "put", str(file))


def sign_in(browser: httpx.Client, account: str, password: str) -> None:
    """By the form; the account's session is in the browser's cookies then."""
    send_form(browser, "/hosting/login", account=account, password=password)


def send_form(browser: httpx.Client, page: str, to: str = "", **filled: str) -> str:
    """Fill a form of a page in; the page that follows. to: its path, if another."""
    secret = form_secret(browser.get(page).text)
    answer = browser.post(to or page, data=filled | {"csrf": secret})
    assert answer.status_code == 200, answer.text
    return answer.text


def form_secret(page: str) -> str:
    """The token that the forms of a page carry."""
    found = re.search(r'name="csrf" value="([A-Za-z0-9_-]{43})"', page)
    assert found is not None, page
    return found[1]
