"""Leaves about draws of seeds, which the program of the accounts adds to the history.

`POST /accounts/draws` with schema DrawLeaf and the key of that program is answered by
`{index, root_sha256}`: where the leaf is, and the root of the leaves in front of it. A
repeat changes nothing. The key of a draw follows from the secret of sealed seeds, so
that every node knows it, and only the leaf `open` shows it.
"""

from __future__ import annotations

from collections.abc import Awaitable, Callable

import msgspec
from starlette.requests import Request
from starlette.responses import Response

from reference_server.http.auth import APPEND, Tokens
from reference_server.http.problems import problem_response
from reference_server.rules.board.seed_draws import DrawLeaf
from reference_server.rules.refusal import Refused

PATH = "/accounts/draws"


# The index of a leaf that is appended, and the root of those in front of it.
Append = Callable[[DrawLeaf], Awaitable[tuple[int, bytes]]]


class DrawLeaves:
    """Appends leaves to the history. append: None where there is no leaderboard."""

    def __init__(self, tokens: Tokens, append: Append | None) -> None:
        self._tokens, self._append = tokens, append

    async def append(self, request: Request) -> Response:
        try:
            append = await self._append_for(request)
            asked = msgspec.json.decode(await request.body(), type=DrawLeaf)
            index, root = await append(asked)
        except Refused as refused:
            return problem_response(refused)
        except msgspec.MsgspecError as error:
            return problem_response(Refused("invalid_request", str(error)))
        body = msgspec.json.encode({"index": index, "root_sha256": root.hex()})
        return Response(body, media_type="application/json")

    async def _append_for(self, request: Request) -> Append:
        """Raises Refused for every caller but the program of the accounts."""
        caller = await self._tokens.authenticate_again(
            request.headers.get("authorization"), "read"
        )
        if APPEND not in caller.scopes or self._append is None:
            raise Refused("not_found", "There is no such path.")
        return self._append
