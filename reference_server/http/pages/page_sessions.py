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

from reference_server.http.pages.cookies import Cookie

SESSION_COOKIE = Cookie("proctor_session")
LOGIN_COOKIE = Cookie("proctor_login")
PATH = "/pages"
# Every node of a cluster answers these paths itself, wherever the reader has signed in.
_WITHOUT_SESSION = (f"{PATH}/login", f"{PATH}/static/")
# After the sign-in, and without a request.
LIFE_S = 12 * 3600.0
IDLE_S = 2 * 3600.0
LOGIN_S = 3600
SESSIONS_MAX = 10_000
SESSIONS_PER_ACCOUNT_MAX = 50
_LOGIN_SECRET = re.compile(r"[A-Za-z0-9_-]{43}")


@dataclass(slots=True)
class PageSession:
    """token: the bearer token, of the account. csrf: what its forms carry.

    reads_runs: False for an operator of robot cells, whose token sees no run.
    """

    token: str = field(repr=False)
    account: str
    csrf: str = field(repr=False)
    begun_at: float
    used_at: float
    reads_runs: bool = True


class PageSessions:
    """The sessions of this server, which end with it.

    An account that has its share loses its own oldest one. If there is no room for one
    more, the account with the most sessions does.

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
        # Account → the cookies of its sessions, in the order of their sign-ins.
        self._by_account: dict[str, dict[str, None]] = {}

    def begin(self, token: str, account: str, *, reads_runs: bool = True) -> str:
        """A session of the owner of a valid token; returns its cookie."""
        self._make_room(account)
        now = self._now()
        cookie = f"{self._node_id()}.{secrets.token_urlsafe(32)}"
        csrf = secrets.token_urlsafe(32)
        session = PageSession(token, account, csrf, now, now, reads_runs)
        self._sessions[cookie] = session
        self._by_account.setdefault(account, {})[cookie] = None
        return cookie

    def find(self, cookie: str) -> PageSession | None:
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

    def end(self, cookie: str) -> None:
        session = self._remove(cookie)
        if session is not None:
            session.begun_at = -LIFE_S * 2  # for streams that hold it
            session.token = ""

    def _make_room(self, account: str) -> None:
        """For one more session of the account."""
        while self._sessions:
            cookie, session = next(iter(self._sessions.items()))
            if self.is_alive(session):
                break
            self._remove(cookie)
        own = self._by_account.get(account, {})
        if len(own) >= SESSIONS_PER_ACCOUNT_MAX:
            self._remove(next(iter(own)))
        elif len(self._sessions) >= SESSIONS_MAX:
            most = max(self._by_account.values(), key=len)
            self._remove(next(iter(most)))

    def _remove(self, cookie: str) -> PageSession | None:
        session = self._sessions.pop(cookie, None)
        if session is not None:
            own = self._by_account[session.account]
            del own[cookie]
            if not own:
                del self._by_account[session.account]
        return session


def is_same(given: str, secret: str) -> bool:
    """Compared in a time that says nothing of where they differ."""
    return bool(secret) and hmac.compare_digest(given.encode(), secret.encode())


def login_secret(sent: str) -> str:
    """The secret that the form of the sign-in must repeat; empty without a cookie.

    sent: the value of the cookie. One of another form than `new_login_secret` makes was
    set by someone else.
    """
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
    return SESSION_COOKIE.read(request, is_secure=False).partition(".")[0]
