"""Routes of the pages, the sign-in, and the headers that each answer has.

Answers are made for browsers: a refusal is a page, and one that needs a sign-in leads
to it. Scripts and styles come from this server alone, and no other site may frame a
page.
"""

from __future__ import annotations

import logging
import re
from collections.abc import Awaitable, Callable, Mapping, Sequence
from dataclasses import replace
from http import HTTPStatus
from typing import Final
from urllib.parse import parse_qsl

from starlette.background import BackgroundTask
from starlette.datastructures import Headers
from starlette.requests import Request
from starlette.responses import HTMLResponse, RedirectResponse, Response
from starlette.routing import BaseRoute, Route
from starlette.types import ASGIApp, Receive, Scope, Send

from reference_record.pages.page_templates import (
    ASSETS,
    CONTENT_SECURITY_POLICY,
    asset_version,
    compile_templates,
    read_asset,
    render_page,
)
from reference_server.generated.problem_codes import PROBLEMS
from reference_server.http.auth import hash_of
from reference_server.http.bodies.request_bodies import read_body
from reference_server.http.pages import (
    board_pages,
    cell_pages,
    entry_pages,
    second_judge_pages,
)
from reference_server.http.pages.api_documents import ApiDocuments, Problem
from reference_server.http.pages.cookies import Cookie
from reference_server.http.pages.films import FilmSettings
from reference_server.http.pages.page_calls import PageCall, links_of
from reference_server.http.pages.page_handlers import FindOptions, PageHandlers
from reference_server.http.pages.page_links import ServerLinks, safe_next
from reference_server.http.pages.page_sessions import (
    LIFE_S,
    LOGIN_COOKIE,
    LOGIN_S,
    PATH,
    SESSION_COOKIE,
    PageSession,
    PageSessions,
    is_from_other_site,
    is_same,
    login_secret,
    new_login_secret,
)
from reference_server.rules.refusal import Refused
from reference_server.settings.allowed_hosts import AllowedHosts

log = logging.getLogger("proctor.pages")

FORM_BYTES_MAX: Final = 2**14
FORM_MEMBERS_MAX: Final = 32
FORM: Final = "application/x-www-form-urlencoded"
HEADERS: Final = {
    "Content-Security-Policy": CONTENT_SECURITY_POLICY,
    "X-Frame-Options": "DENY",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "same-origin",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cache-Control": "no-store",
}
_DEFECT = "The server has a defect. What it evaluates is not affected; try it again."
_NOT_ACCEPTED = "This server does not accept the token."
_STALE_FORM = "This form is too old, or it came from another site. Send it again."
_LACKED_SCOPE: Final = re.compile(r"The token has no scope `(\w+)`")
_NEEDS_SCOPE: Final = (
    "The token with which you signed in does not open this page. Sign in with one "
    "that has the scope `{}`; who runs the server makes them."
)
_STALE_CODE = "This sign-in is too old, or it began in another window. Begin it again."
_AWAY = (
    "The server that has your sign-in does not answer now. Try it again, or sign in at "
    "this one."
)
# The token of the account that a program of accounts has signed in: by a code that it
# gave to the browser, and by the state with which the browser was sent there.
TakeToken = Callable[[str, str], Awaitable[str | None]]
Show = Callable[[PageCall], Awaitable[str | Response]]
Change = Callable[[PageCall, Mapping[str, str]], Awaitable[Response]]
Endpoint = Callable[[Request], Awaitable[Response]]


class Pages:
    """The pages of a server, over its API.

    api: the application with the operations.
    url_of: where the client of a request reaches the server, for printed commands; over
    https, cookies are secure. account_of: whose a valid token is.
    node_id: see PageSessions. find_entry_id: None if there is no leaderboard.
    find_options: gives those of a run; None: they are not known. films: None if none
    are drawn. take_token: None if no program keeps accounts.
    """

    def __init__(
        self,
        api: ASGIApp,
        hosts: AllowedHosts,
        account_of: Callable[[str], str],
        node_id: Callable[[], str] = str,
        find_entry_id: board_pages.FindEntryId | None = None,
        *,
        url_of: Callable[[Request], str] = lambda _request: "",
        find_options: FindOptions | None = None,
        films: FilmSettings | None = None,
        take_token: TakeToken | None = None,
    ) -> None:
        self._take_token = take_token
        self._hosts = hosts
        self._url_of = url_of
        self._account_of = account_of
        self._sessions = PageSessions(node_id=node_id)
        self._handlers = PageHandlers(find_entry_id, films, find_options)
        self._api = api

    def routes(self) -> list[BaseRoute]:
        handlers = self._handlers
        run, cell = "/runs/{run_id}", "/cells/{cell_id}"
        second = "/second_judgements/{judgement_id}"
        shown: dict[str, Show] = {
            "": handlers.show_index,
            "/runs": handlers.show_runs,
            "/benchmarks/{benchmark_id}": handlers.show_benchmark,
            "/compare": handlers.show_comparison,
            "/compare/episode": handlers.show_pair,
            "/compare/several": handlers.show_several,
            "/cells": cell_pages.show_cells,
            cell: cell_pages.show_cell,
            f"{cell}/panel": cell_pages.show_panel,
            f"{cell}/picture": cell_pages.show_picture,
            f"{cell}/live/{{camera}}": cell_pages.show_live,
            second: second_judge_pages.show,
            f"{second}/picture": second_judge_pages.show_setup,
            f"{second}/pictures/{{number}}": second_judge_pages.show_picture,
            "/imports": entry_pages.show_imports,
            "/imports/{import_id}": entry_pages.show_import,
            run: handlers.show_run,
            f"{run}/live": self._stream_run,
            f"{run}/record": handlers.fetch_record,
            f"{run}/episodes/{{episode_id}}": handlers.show_episode,
            f"{run}/episodes/{{episode_id}}/pictures/{{number}}": (
                handlers.fetch_picture
            ),
            f"{run}/episodes/{{episode_id}}/film/{{number}}": handlers.fetch_film,
        }
        board = "/benchmarks/{benchmark_id}/leaderboard"
        open_to_all: dict[str, Show] = {
            board: board_pages.show_leaderboard,
            f"{board}/{{form}}": board_pages.send_leaderboard,
            "/entries/{entry_id}": entry_pages.show_entry,
            "/history": entry_pages.show_history,
        }
        changes: dict[str, Change] = {
            f"{run}/publish": board_pages.publish,
            f"{run}/withdraw": board_pages.withdraw,
            f"{run}/films": handlers.draw_failures,
            f"{cell}/act": cell_pages.act,
            f"{second}/judge": second_judge_pages.judge,
            f"{run}/episodes/{{episode_id}}/film": handlers.draw_film,
            "/compare/episode/films": handlers.draw_pair,
        }
        return [
            self._route("/static/{name:path}", self._answered(self._send_asset)),
            self._route("/login", self._answered(self._login), "GET", "POST"),
            self._route("/logout", self._answered(self._sign_out), "POST"),
            *(self._route(path, self._signed_in(show)) for path, show in shown.items()),
            *(
                self._route(path, self._signed_in(show, is_open=True))
                for path, show in open_to_all.items()
            ),
            *(
                self._route(path, self._changed(change), "POST")
                for path, change in changes.items()
            ),
            self._route("/{rest:path}", self._answered(self._show_nothing)),
        ]

    def lead_from_root(self, not_found: ASGIApp) -> ASGIApp:
        """For paths that nothing has: a browser at / is led here, all else refused."""

        async def answer(scope: Scope, receive: Receive, send: Send) -> None:
            is_root = scope["type"] == "http" and scope["path"] == "/"
            accepted = Headers(scope=scope).get("accept", "") if is_root else ""
            app = not_found
            if "text/html" in accepted and scope["method"] == "GET":
                app = RedirectResponse(
                    ServerLinks.of("/").index(), HTTPStatus.SEE_OTHER
                )
            await app(scope, receive, send)

        return answer

    async def show_away(self, scope: Scope, receive: Receive, send: Send) -> None:
        """The page for a reader whose sign-in is at a node that does not answer."""

        async def answer(request: Request) -> Response:
            sign_in = _login_path(request) if request.method == "GET" else ""
            response = _problem_page(
                request, HTTPStatus.SERVICE_UNAVAILABLE, _AWAY, sign_in
            )
            # Over a new connection a balancer may choose the node that is meant.
            response.headers["Connection"] = "close"
            return response

        request = Request(scope, receive)
        await (await self._answered(answer)(request))(scope, receive, send)

    # --- what holds for every page ---

    def _route(self, path: str, endpoint: Endpoint, *methods: str) -> Route:
        """The route of a path below the pages. methods: GET, if none is named."""

        async def refuse(request: Request) -> Response:
            detail = f"{request.method[:16]} is not a method of this page."
            response = _problem_page(request, HTTPStatus.METHOD_NOT_ALLOWED, detail)
            response.headers["Allow"] = ", ".join(sorted(route.methods or ()))
            return response

        refused = self._answered(refuse)
        route = _PageRoute(PATH + path, endpoint, refused, methods or ("GET",))
        return route

    def _answered(self, endpoint: Endpoint) -> Endpoint:
        """The endpoint, with refusals as pages and the headers of all pages."""

        async def answer(request: Request) -> Response:
            try:
                self._hosts.check(request.headers.get("host", ""))
                response = await endpoint(request)
            except Problem as problem:
                response = self._refusal(request, problem)
            except Refused as refused:
                status = PROBLEMS[refused.code]["status"]
                response = _problem_page(request, status, str(refused))
            except Exception:
                log.exception("a page could not be made")
                response = _problem_page(request, 500, _DEFECT)
            for name, value in HEADERS.items():
                response.headers.setdefault(name, value)
            return response

        return answer

    def _refusal(self, request: Request, problem: Problem) -> Response:
        """A refusal as a page, whose links are those of its reader."""
        session, detail, sign_in = self._session_of(request), problem.detail, ""
        if session is not None and (scope := _LACKED_SCOPE.match(detail)):
            detail = _NEEDS_SCOPE.format(scope[1])
            sign_in = _login_path(request)
        return _problem_page(
            request,
            problem.status,
            detail,
            sign_in,
            reads_runs=session is None or session.reads_runs,
        )

    def _signed_in(self, show: Show, *, is_open: bool = False) -> Endpoint:
        """is_open: the API is asked without a token where there is no session."""

        async def answer(request: Request) -> Response:
            session = self._session_of(request)
            if session is None and is_open:
                session = PageSession("", "", "", 0, 0)
            if session is None:
                return _to_login(request)
            try:
                shown = await show(self._call(request, session))
            except Problem as problem:
                if problem.status != HTTPStatus.UNAUTHORIZED:
                    raise
                self._end_session(request)  # the token was revoked
                return _to_login(request)
            return HTMLResponse(shown) if isinstance(shown, str) else shown

        return self._answered(answer)

    def _changed(self, change: Change) -> Endpoint:
        """A form of a page, sent by its reader."""

        async def show(call: PageCall) -> Response:
            form = await read_form(call.request)
            is_ours = is_same(form.get("csrf", ""), call.csrf)
            if not is_ours or is_from_other_site(call.request):
                raise Problem(403, "forbidden", _STALE_FORM)
            return await change(call, form)

        return self._signed_in(show)

    def _call(self, request: Request, session: PageSession) -> PageCall:
        documents = self._documents(request, session.token)
        links = replace(
            links_of(request),
            reads_runs=session.reads_runs,
            server_url=self._url_of(request),
            has_tracks=self._take_token is not None,
        )
        return PageCall(request, session, documents, links)

    def _documents(self, request: Request, token: str) -> ApiDocuments:
        return ApiDocuments.of(self._api, request, token)

    def _is_secure(self, request: Request) -> bool:
        return self._url_of(request).startswith("https:")

    def _read(self, cookie: Cookie, request: Request) -> str:
        return cookie.read(request, is_secure=self._is_secure(request))

    def _session_of(self, request: Request) -> PageSession | None:
        return self._sessions.find(self._read(SESSION_COOKIE, request))

    def _end_session(self, request: Request) -> None:
        self._sessions.end(self._read(SESSION_COOKIE, request))

    # --- pages without a session ---

    async def _login(self, request: Request) -> Response:
        if request.method == "POST":
            return await self._sign_in(request)
        if self._take_token is not None and "with" not in request.query_params:
            return await self._sign_in_at_host(request, self._take_token)
        return await self._show_login(request)

    async def _sign_in_at_host(self, request: Request, take: TakeToken) -> Response:
        """To the sign-in of the accounts, and back from there with a code."""
        asked = request.query_params
        target, code = asked.get("next", ""), asked.get("code", "")
        if code:
            # A link of someone else comes without the cookie: no code is for that.
            secret = login_secret(self._read(LOGIN_COOKIE, request))
            token = await take(code, hash_of(secret)) if secret else None
            if token is None:
                return self._login_page(request, target, _STALE_CODE)
            return await self._begin_session(request, token, target)
        secret = new_login_secret()
        place = links_of(request).host_sign_in(
            target, state=hash_of(secret), owner=asked.get("owner", "")
        )
        return self._with_login_cookie(
            request, RedirectResponse(place, HTTPStatus.SEE_OTHER), secret
        )

    async def _show_nothing(self, request: Request) -> Response:
        if request.url.path == f"{PATH}/":  # as many people type it
            return RedirectResponse(links_of(request).index(), HTTPStatus.SEE_OTHER)
        raise Problem(404, "not_found", "There is no such page.")

    async def _send_asset(self, request: Request) -> Response:
        name = request.path_params["name"]
        if name not in ASSETS:
            raise Problem(404, "not_found", "There is no such file.")
        is_current = request.query_params.get("v") == asset_version(name)
        kept = "max-age=31536000, immutable" if is_current else "max-age=60"
        headers = {"Content-Type": ASSETS[name], "Cache-Control": f"public, {kept}"}
        return Response(read_asset(name), headers=headers)

    async def _show_login(self, request: Request) -> Response:
        response = self._login_page(request, request.query_params.get("next", ""))
        # While a person types: the first page after it has its template.
        response.background = BackgroundTask(compile_templates)
        return response

    def _login_page(self, request: Request, target: str, problem: str = "") -> Response:
        # A cookie that came with the request may be one that another site has set.
        secret = new_login_secret()
        text = render_page(
            "login",
            links_of(request),
            form_csrf=secret,
            next=safe_next(target),
            problem=problem,
            is_host=self._take_token is not None,
        )
        status = HTTPStatus.FORBIDDEN if problem else HTTPStatus.OK
        return self._with_login_cookie(request, HTMLResponse(text, status), secret)

    def _with_login_cookie(
        self, request: Request, response: Response, secret: str
    ) -> Response:
        is_secure = self._is_secure(request)
        LOGIN_COOKIE.set(response, secret, seconds=LOGIN_S, is_secure=is_secure)
        return response

    async def _sign_in(self, request: Request) -> Response:
        form = await read_form(request)
        target = form.get("next", "")
        secret = login_secret(self._read(LOGIN_COOKIE, request))
        is_ours = is_same(form.get("csrf", ""), secret)
        if not is_ours or is_from_other_site(request):
            return self._login_page(request, target, _STALE_FORM)
        token = form.get("token", "").strip()
        if not token.isascii() or not token.isprintable():
            return self._login_page(request, target, _NOT_ACCEPTED)
        return await self._begin_session(request, token, target)

    async def _begin_session(
        self, request: Request, token: str, target: str
    ) -> Response:
        """The page at the target for the owner of a token, or the sign-in again."""
        try:
            is_operator = await _may_only_operate(self._documents(request, token))
        except Problem as problem:
            if problem.status not in (HTTPStatus.UNAUTHORIZED, HTTPStatus.FORBIDDEN):
                raise
            detail = f"{_NOT_ACCEPTED} {problem.detail}"
            return self._login_page(request, target, detail)
        self._end_session(request)
        cookie = self._sessions.begin(
            token, self._account_of(token), reads_runs=not is_operator
        )
        is_secure = self._is_secure(request)
        target = safe_next(target)
        if is_operator and target == PATH:
            target = f"{PATH}/cells"
        place = links_of(request).to(target)
        response = RedirectResponse(place, HTTPStatus.SEE_OTHER)
        SESSION_COOKIE.set(response, cookie, seconds=int(LIFE_S), is_secure=is_secure)
        LOGIN_COOKIE.forget(response, is_secure=is_secure)
        return response

    async def _sign_out(self, request: Request) -> Response:
        session = self._session_of(request)
        form = await read_form(request)
        if session is not None:
            is_ours = is_same(form.get("csrf", ""), session.csrf)
            if not is_ours or is_from_other_site(request):
                raise Problem(403, "forbidden", _STALE_FORM)
            self._end_session(request)
        # Not to the accounts, whose sign-in would lead back to where the reader was.
        query = "" if self._take_token is None else "?with=key"
        place = links_of(request).to(f"{PATH}/login{query}")
        response = RedirectResponse(place, HTTPStatus.SEE_OTHER)
        SESSION_COOKIE.forget(response, is_secure=self._is_secure(request))
        return response

    async def _stream_run(self, call: PageCall) -> Response:
        session = call.session
        return await self._handlers.stream_run(
            call, lambda: self._sessions.is_alive(session)
        )


async def _may_only_operate(documents: ApiDocuments) -> bool:
    """Whether the token operates cells and reads no run. Raises Problem."""
    try:
        await documents.get("runs", limit=1)
    except Problem as problem:
        if problem.status != HTTPStatus.FORBIDDEN:
            raise
        await documents.get("cells")
        return True
    return False


class _PageRoute(Route):
    """A route whose refusal of a method has the headers of all pages, too."""

    def __init__(
        self, path: str, endpoint: Endpoint, refuse: Endpoint, methods: Sequence[str]
    ) -> None:
        super().__init__(path, endpoint, methods=methods)
        self._refuse = refuse

    async def handle(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["method"] in (self.methods or ()):
            await super().handle(scope, receive, send)
        else:
            response = await self._refuse(Request(scope, receive))
            await response(scope, receive, send)


def _to_login(request: Request) -> Response:
    """The sign-in, and back from there; a stream and a form do not come back."""
    if request.url.path.endswith("/live"):
        raise Problem(401, "unauthenticated", "Sign in again.")
    return RedirectResponse(_login_path(request), HTTPStatus.SEE_OTHER)


def _login_path(request: Request) -> str:
    """The sign-in, which leads back to the requested page."""
    here = request.url.path
    if request.method == "POST":
        here = here.rpartition("/")[0]  # the page that has the form
    if request.url.query:
        here += f"?{request.url.query}"
    return links_of(request).login(here)


def _problem_page(
    request: Request,
    status: int,
    detail: str,
    sign_in: str = "",
    *,
    reads_runs: bool = True,
) -> Response:
    """sign_in: where the reader may sign in again; none: that would not help."""
    heading = {404: "Not found", 403: "Refused", 503: "Not available now"}.get(
        status, "This cannot be shown"
    )
    text = render_page(
        "problem",
        replace(links_of(request), reads_runs=reads_runs),
        heading=heading,
        detail=detail,
        sign_in=sign_in,
    )
    return HTMLResponse(text, status)


async def read_form(
    request: Request, members_max: int = FORM_MEMBERS_MAX
) -> dict[str, str]:
    """The members of a form. Raises Refused."""
    kind = request.headers.get("content-type", "").partition(";")[0].strip().lower()
    if kind != FORM:
        raise Refused("unsupported_media_type", "This is not a form of this page.")
    body = await read_body(request, FORM_BYTES_MAX)
    try:
        pairs = parse_qsl(
            body.decode(),
            keep_blank_values=True,
            max_num_fields=members_max,
            errors="strict",
        )
    except ValueError as error:
        raise Refused("malformed_body", "The form cannot be read.") from error
    return dict(pairs)
