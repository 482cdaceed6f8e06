"""Leaves about draws of seeds, which the program of the accounts adds to the history.

`POST /accounts/draws` with schema DrawLeaf and the key of that program is answered by
`{index, root_sha256}`: where the leaf is, and the root of the leaves in front of it. A
repeat changes nothing. The key of a draw follows from the secret of sealed seeds, so
that every node knows it, and only the leaf `open` shows it.
"""

from __future__ import annotations

import msgspec
from starlette.requests import Request
from starlette.responses import Response

from reference_server.files.seed_secret import SeedSecret
from reference_server.http.auth import APPEND, Tokens
from reference_server.http.problems import problem_response
from reference_server.rules.board.seed_draws import DrawLeaf
from reference_server.rules.refusal import Refused
from reference_server.runs.board_service import BoardService
from reference_sim.host_seeds import draw_key

PATH = "/accounts/draws"


class DrawLeaves:
    """Appends leaves to the history. board: None where there is no leaderboard."""

    def __init__(
        self, tokens: Tokens, secret: SeedSecret, board: BoardService | None
    ) -> None:
        self._tokens, self._secret, self._board = tokens, secret, board

    async def append(self, request: Request) -> Response:
        try:
            board = await self._board_of(request)
            asked = msgspec.json.decode(await request.body(), type=DrawLeaf)
            key = draw_key(self._secret.value, asked.draw_id)
            index, root = await board.append_of_draw(asked, key)
        except Refused as refused:
            return problem_response(refused)
        except msgspec.MsgspecError as error:
            return problem_response(Refused("invalid_request", str(error)))
        body = msgspec.json.encode({"index": index, "root_sha256": root.hex()})
        return Response(body, media_type="application/json")

    async def _board_of(self, request: Request) -> BoardService:
        """Raises Refused for every caller but the program of the accounts."""
        caller = await self._tokens.authenticate_again(
            request.headers.get("authorization"), "read"
        )
        if APPEND not in caller.scopes or self._board is None:
            raise Refused("not_found", "There is no such path.")
        return self._board
