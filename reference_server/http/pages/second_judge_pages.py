"""The page of a second judge: the pictures of a recording, and the rubric.

It shows what the operations of second judges answer, which name neither policies nor
runs nor the first judgement.
"""

from __future__ import annotations

from collections.abc import Mapping
from http import HTTPStatus

from starlette.responses import HTMLResponse, RedirectResponse, Response

from reference_record.generated import answers
from reference_record.pages.page_templates import render_page
from reference_server.http.pages.api_documents import Problem
from reference_server.http.pages.cell_pages import (
    SHOWN_STATUSES,
    judgement_of,
    media_type,
)
from reference_server.http.pages.page_calls import PageCall

PLACE = "second_judgements"


async def show(call: PageCall) -> str:
    return await _rendered(call)


async def show_setup(call: PageCall) -> Response:
    data = await call.api.read(PLACE, call.path("judgement_id"), "picture")
    return Response(data, media_type=media_type(data))


async def show_picture(call: PageCall) -> Response:
    place = PLACE, call.path("judgement_id"), "pictures", call.path("number")
    data = await call.api.read(*place)
    # The recording of an episode that has its result does not change.
    kept = {"Cache-Control": "private, max-age=3600"}
    return Response(data, media_type=media_type(data), headers=kept)


async def judge(call: PageCall, form: Mapping[str, str]) -> Response:
    judgement_id = call.path("judgement_id")
    body = judgement_of(form)
    if "success" not in body:
        problem = "A judgement needs a yes or a no."
        return HTMLResponse(await _rendered(call, problem))
    try:
        await call.api.send("POST", PLACE, judgement_id, body=body)
    except Problem as refused:
        if refused.status not in SHOWN_STATUSES:
            raise
        return HTMLResponse(await _rendered(call, refused.detail))
    return RedirectResponse(call.links.cells(), HTTPStatus.SEE_OTHER)


async def _rendered(call: PageCall, problem: str = "") -> str:
    judgement_id = call.path("judgement_id")
    shown: answers.SecondJudgement = await call.api.get(PLACE, judgement_id)
    return render_page(
        "cells/second_judge",
        call.links,
        csrf=call.csrf,
        place=call.links.second_judgement(judgement_id),
        judgement=shown,
        played=_player_data(call, shown),
        problem=problem,
    )


def _player_data(call: PageCall, shown: answers.SecondJudgement) -> dict[str, object]:
    """The data of parts/player.html.j2, with pictures alone."""
    place = call.links.second_judgement(shown["judgement_id"])
    cameras: dict[str, list[tuple[int, str]]] = {}
    for number, picture in enumerate(shown["pictures"]):
        frame = picture["step"], f"{place}/pictures/{number}"
        cameras.setdefault(picture["camera"], []).append(frame)
    data = {
        "total": shown["steps"],
        "rate": shown["rate_hz"],
        "x": {"step": [], "first": [], "last": []},
        "groups": [],
        "turns": [],
        "think_ms": [],
        "pictures": cameras,
    }
    return {"cameras": cameras, "videos": [], "data": data}
