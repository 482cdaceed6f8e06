"""Mail is stored in the transaction that it reports, and sent by SMTP afterwards.

A mail that cannot be sent is tried again, with growing pauses; the review page shows
how many wait, and why.
"""

from __future__ import annotations

import asyncio
import logging
import smtplib
import sqlite3
import ssl
import time
from collections.abc import Callable
from email.message import EmailMessage
from typing import Final
from urllib.parse import unquote, urlsplit

import msgspec

from reference_platform.storage.platform_database import Database

log = logging.getLogger("proctor.mail")

LOOK_S: Final = 0.25
PAUSE_S_MAX: Final = 600.0
TIMEOUT_S: Final = 20.0
TRIES_MAX: Final = 20


class Mail(msgspec.Struct, frozen=True):
    number: int
    recipient: str
    subject: str
    body: str
    made_at: float
    sent_at: float | None
    tries: int
    error: str


class BadMailServer(ValueError):
    """The setting names no mail server; the text says why."""


class MailServer:
    """`smtp://USER:PASSWORD@HOST:PORT`, or `smtps://`; smtp uses TLS if it is offered.

    sender: the address that mail comes from.
    """

    def __init__(self, url: str, sender: str) -> None:
        parts = urlsplit(url)
        if parts.scheme not in ("smtp", "smtps") or not parts.hostname:
            raise BadMailServer("the mail server is not smtp://HOST:PORT or smtps://…")
        self._host, self._is_tls = parts.hostname, parts.scheme == "smtps"
        self._port = parts.port or (465 if self._is_tls else 25)
        self._user, self._password = parts.username, parts.password or ""
        self.sender = sender

    def send(self, mail: Mail) -> None:
        """Blocks. Raises OSError and smtplib.SMTPException."""
        message = EmailMessage()
        message["From"], message["To"] = self.sender, mail.recipient
        message["Subject"] = f"Proctor: {mail.subject}"
        message.set_content(mail.body + "\n")
        context = ssl.create_default_context()
        with self._connect(context) as connection:
            if not self._is_tls and connection.has_extn("starttls"):
                connection.starttls(context=context)
                connection.ehlo()
            if self._user:
                connection.login(unquote(self._user), unquote(self._password))
            connection.send_message(message)

    def _connect(self, context: ssl.SSLContext) -> smtplib.SMTP:
        if self._is_tls:
            return smtplib.SMTP_SSL(
                self._host, self._port, timeout=TIMEOUT_S, context=context
            )
        connection = smtplib.SMTP(self._host, self._port, timeout=TIMEOUT_S)
        connection.ehlo()
        return connection


class Outbox:
    """The stored mail. server: None if none is sent; then it waits in the database."""

    def __init__(
        self,
        database: Database,
        server: MailServer | None = None,
        clock: Callable[[], float] = time.time,
        public_url: str = "",
    ) -> None:
        self._database, self._server, self._clock = database, server, clock
        self._footer = f"\n\n{public_url.rstrip('/')}/hosting" if public_url else ""

    @property
    def is_sent(self) -> bool:
        """Whether mail leaves this host; pages promise none where it does not."""
        return self._server is not None

    def add(self, recipient: str, subject: str, body: str) -> None:
        if not recipient:
            return
        self._database.execute(
            "INSERT INTO mail (recipient, subject, body, made_at, tries, error) "
            "VALUES (?, ?, ?, ?, 0, '')",
            *(recipient, subject, body + self._footer, self._clock()),
        )

    def waiting(self) -> tuple[int, str]:
        """How many were not sent, and the newest error."""
        count = self._database.number("SELECT count(*) FROM mail WHERE sent_at IS NULL")
        newest = self._database.row(
            Mail,
            "SELECT * FROM mail WHERE sent_at IS NULL AND error != '' "
            "ORDER BY number DESC LIMIT 1",
        )
        return int(count or 0), "" if newest is None else newest.error

    async def send_all(self) -> None:
        """Send what waits, as it comes, until cancelled."""
        while self._server is not None:
            try:
                for mail in self._due():
                    await self._send(self._server, mail)
            except sqlite3.OperationalError as error:
                log.warning("mail waits: %s", error)
            await asyncio.sleep(LOOK_S)

    def _due(self) -> list[Mail]:
        waiting = self._database.rows(
            Mail,
            "SELECT * FROM mail WHERE sent_at IS NULL AND tries < ? "
            "ORDER BY number LIMIT 100",
            TRIES_MAX,
        )
        now = self._clock()
        return [
            mail
            for mail in waiting
            if not mail.tries or now > mail.made_at + min(2.0**mail.tries, PAUSE_S_MAX)
        ]

    async def _send(self, server: MailServer, mail: Mail) -> None:
        sent_at, error = None, ""
        try:
            await asyncio.to_thread(server.send, mail)
            sent_at = self._clock()
        except (OSError, smtplib.SMTPException, ValueError) as failure:
            error = str(failure)[:500]
            log.warning("mail %s to %s: %s", mail.number, mail.recipient, error)
        self._database.execute(
            "UPDATE mail SET sent_at = ?, tries = tries + 1, error = ? "
            "WHERE number = ?",
            *(sent_at, error, mail.number),
        )
