"""Sessions, forms, refusals and headers, which all pages of the platform share.

The cookie of a session is a new secret at each sign-in. Every form carries a second
secret, which other sites cannot know; a form without a session repeats that of a cookie
made with it. A form that was refused is shown again with the reason.
"""

from __future__ import annotations

import logging
import re
import sqlite3
from collections.abc import Awaitable, Callable, Sequence
from dataclasses import dataclass, replace
from functools import cache, partial
from http import HTTPStatus
from typing import Any, Final
from urllib.parse import quote

from jinja2 import Environment, PackageLoader
from starlette.requests import Request
from starlette.responses import HTMLResponse, RedirectResponse, Response

from reference_platform.accounts.account_rules import Account
from reference_platform.accounts.browser_sessions import LIFE_S, Session
from reference_platform.http.api_calls import (
    LastingEndpoint,
    database_refusal,
    maybe_time,
    public_url,
)
from reference_platform.parts import Parts
from reference_record.pages.page_templates import make_environment
from reference_server.generated.problem_codes import PROBLEMS
from reference_server.http.pages.cookies import Cookie
from reference_server.http.pages.page_links import ServerLinks
from reference_server.http.pages.page_routes import HEADERS, read_form
from reference_server.http.pages.page_sessions import (
    LOGIN_S,
    is_from_other_site,
    is_same,
    login_secret,
    new_login_secret,
)
from reference_server.http.tokens.open_requests import OpenRequests
from reference_server.rules.refusal import Refused

log = logging.getLogger("proctor.hosting")

BASE: Final = "/hosting"
COOKIE: Final = Cookie("proctor_hosting")
FORM_COOKIE: Final = Cookie("proctor_hosting_form")
_FORMS: Final = tuple(
    f"{BASE}/{name}" for name in ("register", "login", "forgotten", "reset")
)
_FORM_MEMBERS_MAX: Final = 64
_NEXT: Final = re.compile(r"/hosting(/[a-z0-9_-]+)*(\?[A-Za-z0-9_.=&%+-]*)?")
_DEFECT: Final = "The platform has a defect. Try it again."
_STALE: Final = "This form is too old, or it came from another site. Send it again."


@dataclass(frozen=True, slots=True)
class PageCall:
    """One request of a browser. session, reader: None for one who has not signed in.

    form: what was sent with POST. address: of the client.
    """

    request: Request
    parts: Parts
    session: Session | None
    reader: Account | None
    form: dict[str, str]
    secret: str

    @property
    def account(self) -> Account:
        assert self.reader is not None, "the page needs a sign-in"
        return self.reader

    @property
    def owners(self) -> Sequence[str]:
        """The names that the reader acts for: its own, and its organisations."""
        return self.parts.organisations.names_of(self.account.account)

    @property
    def links(self) -> ServerLinks:
        url = public_url(self.parts, self.request)
        links = ServerLinks.of(self.request.url.path)
        return replace(links, server_url=url, has_tracks=True)

    @property
    def is_secure(self) -> bool:
        """Whether the browser is connected over TLS."""
        return public_url(self.parts, self.request).startswith("https:")

    def read(self, cookie: Cookie) -> str:
        return cookie.read(self.request, is_secure=self.is_secure)

    @property
    def address(self) -> str:
        return (self.request.client or ("",))[0]

    @property
    def csrf(self) -> str:
        """The secret that the forms of this answer carry."""
        return self.secret if self.session is None else self.session.csrf

    def path(self, name: str) -> str:
        return str(self.request.path_params[name])

    def page(self, template: str, *, problem: str = "", **values: Any) -> Response:
        """problem: why what was sent is refused; it stands above the page.

        template: of the folder `hosting`, or with the name of its folder.
        """
        name = template if "/" in template else f"hosting/{template}"
        text = _environment().get_template(f"{name}.html.j2").render(
            links=self.links, form_csrf=self.csrf, reader=self.reader, problem=problem,
            runs_submissions=self.request.app.state.runs_submissions,
            sends_mail=self.parts.outbox.is_sent, form=self.form,
            openid=self.parts.openid.provider, **values,
        )  # fmt: skip
        return HTMLResponse(text, HTTPStatus.BAD_REQUEST if problem else HTTPStatus.OK)

    def redirect(self, path: str) -> Response:
        """To another page of the platform."""
        return RedirectResponse(self.links.to(BASE + path), HTTPStatus.SEE_OTHER)

    def to_login(self) -> Response:
        target = self.request.url.path
        if self.request.method == "GET" and self.request.url.query:
            target += f"?{self.request.url.query}"
        return self.redirect(f"/login?next={quote(safe_next(target), safe='')}")

    def begin_session(self, cookie: str, target: str) -> Response:
        response: Response = RedirectResponse(
            self.links.to(safe_next(target)), HTTPStatus.SEE_OTHER
        )
        FORM_COOKIE.forget(response, is_secure=self.is_secure)
        return self.with_session(response, cookie)

    def with_session(self, response: Response, cookie: str) -> Response:
        """For all pages, wherever the sign-in was."""
        COOKIE.set(
            response,
            cookie,
            seconds=int(LIFE_S),
            is_secure=self.is_secure,
            path=self._path(),
        )
        return response

    def _path(self) -> str | None:
        """None is the folder of the request, which a proxy may serve elsewhere."""
        is_below = self.request.url.path.count("/") > BASE.count("/") + 1
        return BASE if is_below else None


Show = Callable[[PageCall], Awaitable[Response]]


def page_endpoint(
    parts: Parts, open_requests: OpenRequests, show: Show, needs: str = ""
) -> LastingEndpoint:
    """The endpoint of a page. needs: `account`, `approved` (account), `administrator`,
    or nothing.

    A page of administrators is not found by others.
    """

    async def answer(request: Request) -> Response:
        call = PageCall(request, parts, None, None, {}, new_login_secret())
        try:
            call = await _read(call)
            if needs and call.reader is None:
                response = call.to_login()
            else:
                _check_reader(call, needs)
                response = await show(call)
        except Refused as refused:
            response = call.page("notice", heading="Refused", problem=refused.detail)
            response.status_code = PROBLEMS[refused.code]["status"]
        except sqlite3.OperationalError as error:
            log.warning("a page was not made: %s", error)
            why = database_refusal()
            response = call.page("notice", heading="Refused", problem=why.detail)
            response.status_code = PROBLEMS[why.code]["status"]
        except Exception:
            log.exception("a page could not be made")
            response = call.page("notice", heading="Refused", problem=_DEFECT)
            response.status_code = HTTPStatus.INTERNAL_SERVER_ERROR
        if call.session is None:
            _set_form_cookie(call, response)
        for name, value in HEADERS.items():
            response.headers.setdefault(name, value)
        return response

    return LastingEndpoint(answer, _session_check(parts, needs), open_requests)


def _session_check(parts: Parts, needs: str) -> Callable[[Request], None]:
    """A page that is read ends with its session; a form may end its own session."""

    def check(request: Request) -> None:
        if request.method == "POST" or not needs:
            return
        cookie = PageCall(request, parts, None, None, {}, "").read(COOKIE)
        if cookie and not parts.sessions.find(cookie, parts.clock()):
            raise Refused("unauthenticated", "The session has ended.")

    return check


def _check_reader(call: PageCall, needs: str) -> None:
    if needs == "administrator" and not call.account.is_administrator:
        raise Refused("not_found", "There is no such page.")
    if needs == "approved" and call.account.state != "approved":
        text = f"Only an approved account may do this; this one is {call.account.state}"
        why = f": {call.account.reason}" if call.account.reason else "."
        raise Refused("forbidden", text + why)


async def _read(call: PageCall) -> PageCall:
    """The call, with a form that is this platform's own. Raises Refused."""
    request, parts, now = call.request, call.parts, call.parts.clock()
    cookie = call.read(COOKIE)
    session = parts.sessions.find(cookie, now) if cookie else None
    reader = None if session is None else parts.accounts.get(session.account)
    form: dict[str, str] = {}
    if request.method == "POST":
        form = await read_form(request, _FORM_MEMBERS_MAX)
        await parts.database.until_free()
        expected = login_secret(call.read(FORM_COOKIE))
        expected = expected if session is None else session.csrf
        is_ours = is_same(form.pop("csrf", ""), expected)
        if not is_ours or is_from_other_site(request):
            raise Refused("forbidden", _STALE)
    return replace(call, session=session, reader=reader, form=form)


def _set_form_cookie(call: PageCall, response: Response) -> None:
    """For a form that needs no session; a new one with each page that has it.

    From all of them it is a cookie of one folder, so that there are never two.
    """
    is_form = call.request.url.path in _FORMS
    if is_form and not 300 <= response.status_code < 400:
        FORM_COOKIE.set(
            response, call.secret, seconds=LOGIN_S, is_secure=call.is_secure
        )


def safe_next(path: str) -> str:
    """The path after the sign-in: only a page of the platform."""
    is_page = _NEXT.fullmatch(path) and not path.startswith(f"{BASE}/log")
    return path if is_page else BASE


@cache
def _environment() -> Environment:
    environment = make_environment(PackageLoader(__package__, "templates"))
    environment.filters["at"] = _at
    environment.filters["at_second"] = partial(_at, chars=19)
    return environment


def _at(at: float | None, chars: int = 16) -> str:
    text = maybe_time(at)
    return "–" if text is None else f"{text[:10]} {text[11:chars]} UTC"
