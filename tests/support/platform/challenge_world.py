"""A challenge with people who own one of everything, and requests to all of it.

A person's private texts begin with `private-of-NAME.`, and those of its organisation
with `shared-of-NAME.`: so a text that others must not read is found wherever it is.
Requests come from spec/profiles/hosting.yaml and from the routes of the pages, so a new
operation or page is among them.
"""

from __future__ import annotations

import re
from collections.abc import AsyncIterator, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from types import SimpleNamespace
from typing import Any, NamedTuple, cast

import httpx
import yaml
from starlette.applications import Starlette
from starlette.routing import Route

from conformance.specification.rule_documents import read_rules
from reference_platform.accounts.organisations import Member, Owner
from reference_platform.http.server_calls import ServerRuns
from reference_platform.images.image_reviews import ImageReviews
from reference_platform.images.presets import Presets
from reference_platform.images.unpacked_roots import UnpackedRoots
from reference_platform.images.upload_folder import UploadFolder
from reference_platform.pages.form_calls import COOKIE
from reference_platform.parts import Parts
from reference_platform.platform_app import make_application
from reference_platform.sandbox.sandbox_interface import Limits
from reference_platform.submissions.hosted_parts import HostedParts
from reference_platform.submissions.lifecycle import Event
from reference_platform.submissions.submission_logs import FileLogs
from reference_platform.tracks.track_rules import Phase, Track
from tests.support.paths import ROOT
from tests.support.platform.approved_accounts import approved, key_of
from tests.support.platform.archives import digest_of, write_image

# Administrators alone use the operations of this rule, and these pages.
(HST_014,) = (rule for rule in read_rules(ROOT / "spec") if rule.id == "HST-014")
ADMINISTRATION = re.compile(r"/hosting/(review|operation|images)\b")
SCOPES = ("read", "run", "account")
_PHASE = {"score": "never", "log": "never", "record": "never"}
_TO_VERIFIED: tuple[Event, ...] = ("upload", "begin_verification", "pass_verification")


class Call(NamedTuple):
    """name: the id of the operation, or method and path of the page."""

    name: str
    method: str
    path: str
    is_open: bool = False  # to those who have not signed in


def operations() -> list[Call]:
    """All of the specification."""
    text = (ROOT / "spec/profiles/hosting.yaml").read_text()
    paths = yaml.load(text, yaml.CSafeLoader)["paths"]
    return [
        Call(row["operationId"], method.upper(), path, row.get("security") == [])
        for path, methods in paths.items()
        for method, row in methods.items()
    ]


def pages(app: Starlette) -> list[Call]:
    """All below /hosting but the one that is shown for unknown paths."""
    routes = [route for route in app.routes if isinstance(route, Route)]
    return [
        Call(f"{method} {route.path}", method, route.path)
        for route in routes
        if route.path.startswith("/hosting") and "{rest" not in route.path
        for method in sorted(route.methods or ())
        if method != "HEAD"
    ]


class ServerWithRecords(ServerRuns):
    """Every run has ended, and has a record."""

    def __init__(self) -> None:
        super().__init__("http://127.0.0.1:9")

    async def read_run(self, run_id: str) -> Mapping[str, Any]:
        return {"run_id": run_id, "state": "completed"}

    async def open_record(
        self, run_id: str
    ) -> tuple[Mapping[str, str], AsyncIterator[bytes]]:
        async def blocks() -> AsyncIterator[bytes]:
            yield f"{run_id.replace('run_', 'private-of-')}. record".encode()

        return {"content-type": "application/zip"}, blocks()


@dataclass
class Person:
    """ids: the names of path parameters, and the person's object for each."""

    name: str
    ids: dict[str, str]
    submissions: dict[str, str] = field(default_factory=dict)


@dataclass
class World:
    """The platform, in this process. app: as `proctor-host` has it.

    code: of the mail or the program that a request with a code is about.
    """

    parts: Parts
    folder: Path
    hosted: HostedParts
    app: Starlette
    code: str = "unknown"

    @classmethod
    def of(cls, parts: Parts, folder: Path) -> World:
        hosted = HostedParts(
            folder, UploadFolder(folder / "uploads"),
            ImageReviews(parts.database, parts.clock), Presets(folder / "presets"),
            UnpackedRoots(folder / "roots"),
            FileLogs(folder / "logs", lambda _name: True), limits=Limits(),
            supervisor=cast(Any, SimpleNamespace(problem="")),
            maker=cast(Any, SimpleNamespace(enforcement=lambda _limits: "")),
        )  # fmt: skip
        (folder / "presets").mkdir()
        (folder / "presets" / "python.toml").write_text('command = ["/python"]')
        now = parts.clock()
        phase = Phase("main", "calibration", now - 1, now + 1e6, **_PHASE)  # type: ignore[arg-type]
        for name, entry in (("letters", "open"), ("digits", "review")):
            track = Track(name, name, (phase,), entry=entry)  # type: ignore[arg-type]
            parts.tracks.put(track, "a test")
        app = make_application(parts, ServerWithRecords(), hosted)
        return cls(parts, folder, hosted, app)

    def client(self) -> httpx.AsyncClient:
        transport = httpx.ASGITransport(self.app)
        return httpx.AsyncClient(transport=transport, base_url="http://host.example")

    async def person(self, name: str) -> Person:
        """An approved account with one of everything that an account may own."""
        parts, mark = self.parts, f"private-of-{name}.x"
        await approved(parts, name)
        for column in ("full_name", "organisation", "email"):
            statement = f"UPDATE accounts SET {column} = ? WHERE account = ?"  # noqa: S608
            parts.database.execute(statement, f"{mark}@example.org", name)
        now, lab = parts.clock(), f"{name}lab"
        key, _ = parts.keys.make(name, mark, ["read"], 1e6, now)
        title = f"shared-of-{name}. title"
        parts.organisations.create(lab, title, parts.accounts.get(name))
        parts.organisations.invite(lab, name, f"{mark}@example.org", "member")
        parts.tracks.enter("digits", Owner(name))
        for owner in (Owner(name), Owner(lab, is_organisation=True)):
            parts.tracks.enter("letters", owner)
        image = self.folder / f"{name}.tar"
        write_image(image, environment=[f"MARK={mark}"])
        content = image.read_bytes()
        digest = await self.upload(name, content)
        person = Person(name, {
            "account": name, "organisation": lab, "key_id": key.key_id,
            "digest": digest, "track_id": "letters",
        })  # fmt: skip
        for state in ("created", "verified", "completed"):
            person.submissions[state] = self._submission(name, state, mark, digest)
        person.ids["result_id"] = person.submissions["completed"]
        self.hosted.reviews.add(digest, name, len(content), mark)
        return person

    def join(self, person: Person, account: str) -> None:
        """An account becomes a member of the person's organisation."""
        member = Member(person.ids["organisation"], account, "member")
        self.parts.database.insert("members", member)

    async def upload(self, owner: str, content: bytes) -> str:
        async def parts() -> AsyncIterator[bytes]:
            yield content

        digest = digest_of(content)
        await self.hosted.uploads.append(owner, digest, len(content), 0, parts())
        return digest

    def _submission(self, owner: str, state: str, mark: str, digest: str) -> str:
        store = self.parts.submissions
        made = store.create(owner, "letters", policy_name=mark)
        name = made.submission_id
        events = () if state == "created" else _TO_VERIFIED
        for event in events:
            store.move(name, event, digest=digest)
        if state == "completed":
            store.move(name, "start")
            store.move(name, "begin_run", run_id=f"run_{owner}")
            completed = store.move(name, "complete")
            store.note_score(completed, {"score": 0.5})
        self.hosted.logs.write(name, "policy", f"line of {mark}")
        return name

    # --- requests ---

    def path(self, call: Call, person: Person) -> str:
        """With the objects of a person. Each act gets a submission that allows it."""
        state = "verified" if call.path.endswith("/start") else "created"
        ids = person.ids | {"submission_id": person.submissions[state]}
        if "/review/entries/" in call.path:
            ids["track_id"] = "digits"
        return call.path.format(**ids)

    async def send(
        self, client: httpx.AsyncClient, call: Call, person: Person, key: str = ""
    ) -> httpx.Response:
        """An operation on what a person owns, with a body that is right for it."""
        headers = {"Authorization": f"Bearer {key}"} if key else {}
        path = self.path(call, person)
        body = BODIES.get(call.name)
        if call.name == "append_upload":
            query = {"offset": 0, "size": 3}
            return await client.patch(
                path.replace(person.ids["digest"], digest_of(b"new")), params=query,
                content=b"new", headers=headers,
            )  # fmt: skip
        if body is None:
            return await client.request(call.method, path, headers=headers)
        if call.name in FORMS:
            form = self._filled(body, person)
            return await client.post(path, data=form, headers=headers)
        return await client.request(
            call.method, path, json=self._filled(body, person), headers=headers
        )

    def _filled(self, body: dict[str, Any], person: Person) -> dict[str, Any]:
        values = {"DIGEST": person.ids["digest"], "CODE": self.code}
        return {
            name: values.get(value, value) if isinstance(value, str) else value
            for name, value in body.items()
        }

    async def open_page(
        self, client: httpx.AsyncClient, call: Call, person: Person, csrf: str
    ) -> httpx.Response:
        """A page about a person's objects, or its form, filled in rightly."""
        path = self.path(call, person)
        if call.method == "GET":
            return await client.get(path)
        form = self._filled(PAGE_FORMS.get(call.path, {}), person) | {"csrf": csrf}
        return await client.post(path, data=form)

    def sign_in(self, client: httpx.AsyncClient, account: str) -> str:
        """The secret of the forms of a new session."""
        now = self.parts.clock()
        cookie = self.parts.sessions.begin(account, now)
        client.cookies.set(COOKIE.name, cookie)
        session = self.parts.sessions.find(cookie, now)
        assert session is not None
        return session.csrf

    def key(self, account: str, *scopes: str, organisation: str = "") -> str:
        if not organisation:
            return key_of(self.parts, account, *(scopes or SCOPES))
        return self.parts.keys.make(
            account, "", scopes or SCOPES, 3600, self.parts.clock(),
            organisation=organisation,
        )[1]  # fmt: skip

    # --- what is compared ---

    def owned_by(self, person: Person, *, with_organisation: bool = True) -> list[Any]:
        """All that is stored of a person, in the database and on the disk."""
        names = {person.name, *person.ids.values(), *person.submissions.values()}
        names -= {"letters"} if with_organisation else {"letters", f"{person.name}lab"}
        names.add(f"private-of-{person.name}.x@example.org")
        rows = [row for row in self._rows() if names & {str(value) for value in row}]
        owners = [person.name, person.ids["organisation"]]
        files = [
            (str(path.relative_to(self.folder)), path.read_bytes())
            for owner in owners[: 2 if with_organisation else 1]
            for path in sorted((self.folder / "uploads" / owner).glob("*"))
        ]  # fmt: skip
        return [*rows, *files]

    def _rows(self) -> Iterator[tuple[Any, ...]]:
        connection = self.parts.database._connection
        tables = connection.execute("SELECT name FROM sqlite_master WHERE type='table'")
        for (table,) in tables.fetchall():
            for row in connection.execute(f"SELECT * FROM {table}"):  # noqa: S608
                yield table, *row


# A right body for each operation that has one.
BODIES: dict[str, dict[str, Any]] = {
    "register": {
        "account": "newcomer", "full_name": "N", "organisation": "O",
        "email": "n@example.org", "password": "correct horse", "agrees": True,
    },
    "decide_account": {"decision": "suspend", "reason": "for a test"},
    "make_key": {"label": "new", "scopes": ["read"]},
    "begin_device": {"label": "a test"},
    "poll_device": {
        "grant_type": "urn:ietf:params:oauth:grant-type:device_code",
        "device_code": "CODE",
    },
    "create_organisation": {"organisation": "newlab", "title": "New"},
    "invite_member": {"email": "guest@example.org", "role": "member"},
    "set_role": {"role": "owner"},
    "accept_invitation": {"code": "CODE"},
    "create_submission": {"track_id": "letters"},
    "attach_upload": {"digest": "DIGEST"},
    "decide_image": {"decision": "approve"},
}  # fmt: skip
FORMS = ("begin_device", "poll_device")
PAGE_FORMS: dict[str, dict[str, str]] = {
    "/hosting/register": {
        "account": "newcomer", "full_name": "N", "organisation": "O",
        "email": "n@example.org", "password": "correct horse", "agrees": "on",
    },
    "/hosting/login": {"account": "newcomer", "password": "correct horse"},
    "/hosting/forgotten": {"account": "newcomer"},
    "/hosting/reset": {"code": "unknown", "password": "another horse"},
    "/hosting/account/email": {"email": "x@example.org", "current": "correct horse"},
    "/hosting/account/password": {
        "current": "correct horse", "password": "another horse",
    },
    "/hosting/keys": {"label": "new", "scope_read": "on", "days": "9"},
    "/hosting/device": {"code": "CODE", "decision": "approve"},
    "/hosting/organisations": {"organisation": "newlab", "title": "New"},
    "/hosting/organisations/join": {"code": "CODE"},
    "/hosting/organisations/{organisation}/invite": {
        "email": "guest@example.org", "role": "member",
    },
    "/hosting/organisations/{organisation}/members/{account}": {"role": "none"},
    "/hosting/review/accounts/{account}": {
        "decision": "suspend", "reason": "for a test",
    },
    "/hosting/review/entries/{track_id}/{account}": {"decision": "accept"},
    "/hosting/images/{digest}": {"decision": "approve"},
}  # fmt: skip
