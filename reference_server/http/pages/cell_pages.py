"""The pages of an operator beside a robot: what to set up, a stop, and the rubric.

They show what the operations of cells answer, which name neither policies nor runs.
"""

from __future__ import annotations

from collections.abc import Mapping
from http import HTTPStatus

from starlette.responses import HTMLResponse, RedirectResponse, Response

from reference_record.generated import answers
from reference_record.pages.page_templates import render_page
from reference_server.http.pages.api_documents import Problem
from reference_server.http.pages.page_calls import PageCall

# A form whose act is refused is answered with its page, which says why.
SHOWN_STATUSES = (HTTPStatus.CONFLICT, HTTPStatus.UNPROCESSABLE_ENTITY, 400)


async def show_cells(call: PageCall) -> str:
    cells = (await call.api.get("cells"))["cells"]
    judgements = (await call.api.get("second_judgements"))["judgements"]
    return render_page(
        "cells/index", call.links, csrf=call.csrf, cells=cells, judgements=judgements
    )


async def show_cell(call: PageCall) -> str:
    return _rendered(call, "cells/cell", await _cell(call))


async def show_panel(call: PageCall) -> Response:
    """The part that changes; nothing if the reader has it, so that forms stay."""
    cell = await _cell(call)
    if call.query("seen") == _version(cell):
        return Response(status_code=HTTPStatus.NO_CONTENT)
    return HTMLResponse(_rendered(call, "cells/panel", cell))


async def show_picture(call: PageCall) -> Response:
    data = await call.api.read("cells", call.path("cell_id"), "picture")
    return Response(data, media_type=media_type(data))


async def show_live(call: PageCall) -> Response:
    """The newest picture of a camera; no content while there is none."""
    camera = call.request.path_params["camera"]
    place = "cells", call.path("cell_id"), "live", camera
    try:
        data = await call.api.read(*place)
    except Problem as problem:
        if problem.status != HTTPStatus.NO_CONTENT:
            raise
        return Response(status_code=HTTPStatus.NO_CONTENT)
    return Response(data, media_type=media_type(data))


def media_type(data: bytes) -> str:
    return "image/png" if data.startswith(b"\x89PNG") else "image/jpeg"


async def act(call: PageCall, form: Mapping[str, str]) -> Response:
    """Carry out what the form says; a stop before all else (PHY-004)."""
    cell_id, problem = call.path("cell_id"), ""
    try:
        if form.get("act") == "stop":
            await call.api.send("POST", "cells", cell_id, "stop")
        else:
            await call.api.send("POST", "cells", cell_id, "acts", body=_act_of(form))
    except Problem as refused:
        if refused.status not in SHOWN_STATUSES:
            raise
        problem = refused.detail
    if "hx-request" not in call.request.headers and not problem:
        place = call.links.cell(cell_id)
        return RedirectResponse(place, HTTPStatus.SEE_OTHER)
    is_part = "hx-request" in call.request.headers
    template = "cells/panel" if is_part else "cells/cell"
    return HTMLResponse(_rendered(call, template, await _cell(call), problem))


def _act_of(form: Mapping[str, str]) -> dict[str, object]:
    """Schema CellAct."""
    wanted: dict[str, object] = {"act": form.get("act", "")}
    if form.get("trial", "").isdecimal():
        wanted["trial"] = int(form["trial"])
    if reason := form.get("reason", "").strip():
        wanted["reason"] = reason
    if wanted["act"] == "judge":
        wanted |= judgement_of(form)
    if "takes_over" in form:
        wanted["takes_over"] = True
    return wanted


def judgement_of(form: Mapping[str, str]) -> dict[str, object]:
    """Schema SecondAct: the answers to a rubric; without `success` it is refused."""
    numbers = (name.removeprefix("met_") for name in form if name[:4] == "met_")
    answers_given: dict[str, object] = {
        "met": [int(number) for number in numbers if number.isdecimal()],
        "note": form.get("note", "").strip(),
    }
    if form.get("success") in ("yes", "no"):
        answers_given["success"] = form["success"] == "yes"
    return answers_given


async def _cell(call: PageCall) -> answers.Cell:
    cell: answers.Cell = await call.api.get("cells", call.path("cell_id"))
    return cell


def _rendered(
    call: PageCall, template: str, cell: answers.Cell, problem: str = ""
) -> str:
    return render_page(
        template,
        call.links,
        csrf=call.csrf,
        cell=cell,
        seen=_version(cell),
        problem=problem,
    )


def _version(cell: answers.Cell) -> str:
    """Changes with all that the panel shows."""
    shown = cell["phase"], cell["trial"], cell["operator"]
    return "-".join(map(str, (*shown, cell["is_paused"], cell["waiting"])))
