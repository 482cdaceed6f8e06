"""The paths of a server: operations, those of other nodes, health, and pages."""

from __future__ import annotations

import typing
from collections.abc import Mapping

from starlette.routing import BaseRoute, Route, Router
from starlette.types import ASGIApp, Scope

from reference_server.accounts.account_forwarding import PATHS, AccountForwarding
from reference_server.accounts.account_service import AccountService
from reference_server.accounts.draw_leaves import PATH as DRAWS_PATH
from reference_server.accounts.draw_leaves import DrawLeaves
from reference_server.assembly.nearest_path import UnknownPath
from reference_server.cluster.node_routes import NodeRoutes
from reference_server.cluster.server_node import ServerNode
from reference_server.http.application import Endpoint
from reference_server.http.auth import Tokens
from reference_server.http.handlers import Handlers
from reference_server.http.pages.films import FilmSettings
from reference_server.http.pages.page_routes import Pages
from reference_server.http.tokens.open_requests import OpenRequests
from reference_server.monitoring.health import HEALTH_PATHS, health_routes
from reference_server.monitoring.readiness import Readiness
from reference_server.monitoring.request_spans import RequestSpans
from reference_server.profiles.operation_tables import profile_tables
from reference_server.profiles.physical.cell_handlers import CellHandlers
from reference_server.settings import Settings

if typing.TYPE_CHECKING:
    from reference_server.monitoring.traces import Traces


def make_endpoints(
    handlers: Handlers, cells: CellHandlers, tokens: Tokens
) -> dict[str, Endpoint]:
    """path → the operations of the standard and of the profiles with another API."""
    table = handlers.table() | profile_tables(handlers) | cells.table()
    settings = handlers.settings
    hosts, most = settings.hosts, settings.max_body_bytes
    open_requests = OpenRequests()
    return {
        path: Endpoint(operations, tokens, most, hosts, open_requests)
        for path, operations in table.items()
    }


def make_router(
    handlers: Handlers,
    operations_by_path: Mapping[str, Endpoint],
    readiness: Readiness,
    node: ServerNode | None,
    node_routes: NodeRoutes | None,
    *,
    tokens: Tokens,
    accounts: AccountService | None = None,
    draws: DrawLeaves | None = None,
) -> ASGIApp:
    """Everything that the server answers. node, node_routes: both, or none of them.

    accounts: the program that keeps them; None if there is none. draws: for it.
    """
    settings = handlers.settings
    endpoints: dict[str, ASGIApp] = dict(operations_by_path)
    not_found = UnknownPath([*endpoints, *HEALTH_PATHS])
    if node_routes is not None:
        endpoints = node_routes.routed(endpoints)
    routes: list[BaseRoute] = [Route(*endpoint) for endpoint in endpoints.items()]
    routes += health_routes(readiness)
    if accounts is not None:
        forwarding = AccountForwarding(accounts, settings.hosts)
        routes += [Route(path, forwarding) for path in PATHS]
    if draws is not None:
        routes.append(Route(DRAWS_PATH, draws.append, methods=["POST"]))
    operations = Router(routes, False, not_found)
    if settings.pages == "off":
        return operations
    node_id = str if node is None else node.node_id
    find_entry_id = None if handlers.board is None else handlers.board.entry_id_of_run
    films = None
    if settings.films == "on" and settings.recordings != "off":
        seeds = settings.opened_seeds
        films = FilmSettings(
            settings.benchmark_references,
            "" if "," in seeds else seeds,
            lambda: str(settings.seed_secret_path) * settings.is_for_one_person,
        )
    pages = Pages(
        operations,
        settings.hosts,
        tokens.account_of,
        node_id,
        find_entry_id,
        url_of=handlers.url_of,
        find_options=handlers.service.options_of_run,
        films=films,
        take_token=None if accounts is None else accounts.take_page_token,
    )
    shown: ASGIApp = Router(pages.routes(), False, pages.lead_from_root(not_found))
    if node_routes is not None:
        shown = node_routes.routed_pages(shown, pages.show_away)
    # Behind the operations: no turn looks at the routes of pages.
    return Router(routes, False, shown)


def traced(
    app: ASGIApp, traces: Traces | None, settings: Settings, node: ServerNode | None
) -> ASGIApp:
    """The same, with a span for each request; unchanged without traces."""
    if traces is None:
        return app

    def trusts(scope: Scope) -> bool:
        is_of_node = node is not None and node.is_passed_on(scope)
        return is_of_node or settings.traces_parent == "all"

    return RequestSpans(app, traces, trusts)
