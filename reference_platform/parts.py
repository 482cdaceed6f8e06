"""The parts of the platform, put together; nothing runs before they are used."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from argon2 import PasswordHasher

from reference_platform.accounts.account_keys import Keys
from reference_platform.accounts.accounts import Accounts
from reference_platform.accounts.browser_sessions import Sessions
from reference_platform.accounts.devices import Devices
from reference_platform.accounts.openid import OpenIdLogins, OpenIdProvider
from reference_platform.accounts.organisations import Organisations
from reference_platform.accounts.page_sign_ins import PageSignIns
from reference_platform.accounts.password_resets import PasswordResets
from reference_platform.accounts.passwords import GuessLimits, Passwords
from reference_platform.mail.outbox import MailServer, Outbox
from reference_platform.storage.platform_database import Database
from reference_platform.submissions.submission_store import SubmissionStore
from reference_platform.tracks.history_entries import HistoryEntries
from reference_platform.tracks.results import Results
from reference_platform.tracks.tracks import Tracks


@dataclass(frozen=True, slots=True)
class Parts:
    """The use cases for the commands and the pages of the platform."""

    database: Database
    outbox: Outbox
    keys: Keys
    sessions: Sessions
    accounts: Accounts
    devices: Devices
    organisations: Organisations
    tracks: Tracks
    results: Results
    submissions: SubmissionStore
    clock: Callable[[], float]
    openid: OpenIdLogins
    resets: PasswordResets
    page_sign_ins: PageSignIns
    public_url: str = ""

    @classmethod
    def of(
        cls,
        path: Path,
        mail_server: MailServer | None = None,
        *,
        public_url: str = "",
        local_url: str = "",
        openid: OpenIdProvider | None = None,
        clock: Callable[[], float] = time.time,
        hasher: PasswordHasher | None = None,
    ) -> Parts:
        """public_url: of the server; empty: as requests say. local_url: its only
        address without that. clock, hasher: for tests.

        Raises BadDatabase.
        """
        database = Database(path)
        outbox = Outbox(database, mail_server, clock, public_url)
        keys, sessions = Keys(database), Sessions(database)
        accounts = Accounts(
            database, Passwords(hasher), GuessLimits(), keys, sessions, outbox, clock
        )
        devices = Devices(database, keys, clock)
        organisations = Organisations(database, outbox, clock)
        tracks = Tracks(database, outbox, organisations, clock, public_url or local_url)
        submissions = SubmissionStore(database, tracks, clock)
        return cls(
            database,
            outbox,
            keys,
            sessions,
            accounts,
            devices,
            organisations,
            tracks,
            Results(tracks, HistoryEntries(database)),
            submissions,
            clock,
            OpenIdLogins(database, openid, clock),
            PasswordResets(database, accounts, public_url, clock),
            PageSignIns(database),
            public_url,
        )
