"""The picture of how things stand when an attempt begins."""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Mapping
from typing import Any

from starlette.responses import Response

from reference_server.http.pages.cell_pages import media_type
from reference_server.rules.refusal import Refused
from reference_sim import benchmark_registry


def picture_response(
    benchmark_id: str, name: str, setup: Mapping[str, Any]
) -> Response:
    """The picture that the setup of a manifest names. Raises Refused.

    A benchmark that has changed since has another one, which is not shown.
    """
    if benchmark_id not in benchmark_registry.benchmark_ids():
        raise no_picture()
    world = benchmark_registry.resolve(benchmark_id).world
    described = world.settings["plan"]["benchmark"]["physical"]["setups"]
    picture = base64.b64decode(described.get(name, {}).get("picture", ""))
    if hashlib.sha256(picture).hexdigest() != setup.get("picture_sha256"):
        raise no_picture()
    return Response(picture, media_type=media_type(picture))


def no_picture() -> Refused:
    return Refused("not_found", "The setup has no picture.")
