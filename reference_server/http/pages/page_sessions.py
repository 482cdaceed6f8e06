"""Who reads the pages: sessions of browsers, in memory.

A browser has an unguessable cookie, the server has the token that belongs to it. With
every form comes a second secret of the session, which other sites cannot know.
"""

from __future__ import annotations

import hmac
import re
import secrets
import time
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass, field

from starlette.requests import Request
from starlette.responses import Response

from reference_server.http.pages.cookies import read_cookie

SESSION_COOKIE = "proctor_session"
LOGIN_COOKIE = "proctor_login"
PATH = "/pages"
# Every node of a cluster answers these paths itself, wherever the reader has signed in.
_WITHOUT_SESSION = (f"{PATH}/login", f"{PATH}/static/")
# After the sign-in, and without a request.
LIFE_S = 12 * 3600.0
IDLE_S = 2 * 3600.0
LOGIN_S = 3600
SESSIONS_MAX = 10_000
# The most sessions of one token: without it its owner could end the sessions of others.
SESSIONS_PER_TOKEN_MAX = 50
_LOGIN_SECRET = re.compile(r"[A-Za-z0-9_-]{43}")


@dataclass(slots=True)
class PageSession:
    """token: the bearer token. csrf: what the forms of this session carry.

    reads_runs: False for an operator of robot cells, whose token sees no run.
    """

    token: str = field(repr=False)
    csrf: str = field(repr=False)
    begun_at: float
    used_at: float
    reads_runs: bool = True


class PageSessions:
    """The sessions of this server; they end with it, and it forgets old ones first.

    node_id: of this server among several; each cookie begins with it, so that the
    others find the one that has the session.
    """

    def __init__(
        self,
        now: Callable[[], float] = time.monotonic,
        node_id: Callable[[], str] = str,
    ) -> None:
        self._now, self._node_id = now, node_id
        # Sessions by cookie; the one that was used longest ago is the first.
        self._sessions: OrderedDict[str, PageSession] = OrderedDict()
        # Token → the cookies of its sessions, in the order of their sign-ins.
        self._of_token: dict[str, dict[str, None]] = {}

    def begin(self, token: str, *, reads_runs: bool = True) -> str:
        """A session of the owner of a valid token; returns its cookie."""
        self._forget(token)
        now = self._now()
        cookie = f"{self._node_id()}.{secrets.token_urlsafe(32)}"
        session = PageSession(token, secrets.token_urlsafe(32), now, now, reads_runs)
        self._sessions[cookie] = session
        self._of_token.setdefault(token, {})[cookie] = None
        return cookie

    def find(self, request: Request) -> PageSession | None:
        cookie = read_cookie(request, SESSION_COOKIE)
        session = self._sessions.get(cookie)
        if session is None:
            return None
        if not self.is_alive(session):
            self._remove(cookie)
            return None
        session.used_at = self._now()
        self._sessions.move_to_end(cookie)
        return session

    def is_alive(self, session: PageSession) -> bool:
        """Whether its time is not over. A session that was ended has no begin."""
        now = self._now()
        return now - session.begun_at < LIFE_S and now - session.used_at < IDLE_S

    def end(self, request: Request) -> None:
        session = self._remove(read_cookie(request, SESSION_COOKIE))
        if session is not None:
            session.begun_at = -LIFE_S * 2  # for streams that hold it
            session.token = ""

    def _forget(self, token: str) -> None:
        """Make room for a session of the token. Looks only at what may have to go."""
        own = self._of_token.get(token, {})
        if len(own) >= SESSIONS_PER_TOKEN_MAX:
            self._remove(next(iter(own)))
        while self._sessions:
            cookie, session = next(iter(self._sessions.items()))
            if self.is_alive(session) and len(self._sessions) < SESSIONS_MAX:
                return
            self._remove(cookie)

    def _remove(self, cookie: str) -> PageSession | None:
        session = self._sessions.pop(cookie, None)
        if session is not None:
            own = self._of_token[session.token]
            del own[cookie]
            if not own:
                del self._of_token[session.token]
        return session


def is_same(given: str, secret: str) -> bool:
    """Compared in a time that says nothing of where they differ."""
    return bool(secret) and hmac.compare_digest(given.encode(), secret.encode())


def set_cookie(
    response: Response, name: str, value: str, *, seconds: int, is_secure: bool
) -> None:
    """Sent to these pages alone, never with a request that another site began.

    Without a path it is for the folder of the sign-in, as the browser knows it: also
    where a proxy serves the pages under a path of its own.
    """
    response.set_cookie(
        name,
        value,
        max_age=seconds,
        path=None,
        httponly=True,
        samesite="strict",
        secure=is_secure,
    )


def forget_cookie(response: Response, name: str) -> None:
    """Forget what `set_cookie` set: both are sent from one folder."""
    response.set_cookie(name, max_age=0, expires=0, path=None)


def login_secret(request: Request) -> str:
    """The secret that the form of the sign-in must repeat; empty without a cookie.

    A cookie of another form than `new_login_secret` makes was set by someone else.
    """
    sent = read_cookie(request, LOGIN_COOKIE)
    return sent if _LOGIN_SECRET.fullmatch(sent) else ""


def new_login_secret() -> str:
    return secrets.token_urlsafe(32)


def is_from_other_site(request: Request) -> bool:
    """Whether a browser says that another site sent this form."""
    site = request.headers.get("sec-fetch-site", "none")
    origin = request.headers.get("origin")
    host = request.headers.get("host", "")
    is_foreign = origin is not None and origin.partition("://")[2] != host
    return site not in ("same-origin", "none") or is_foreign


def needs_session(path: str) -> bool:
    """Whether only the node that has the session can answer it."""
    is_page = path == PATH or path.startswith(f"{PATH}/")
    return is_page and not path.startswith(_WITHOUT_SESSION)


def node_of_session(request: Request) -> str:
    """The node that has the session of the reader; empty without one."""
    return read_cookie(request, SESSION_COOKIE).partition(".")[0]
