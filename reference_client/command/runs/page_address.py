"""The command open: the page of a run on its server, in a browser.

The protocol does not require pages, so a server may have none. The token is not sent to
them: they ask for it.
"""

from __future__ import annotations

import os
import sys
import webbrowser
from urllib.parse import quote

from reference_client.command.exit_codes import DONE, with_flag_names
from reference_client.command.output.printer import Printer
from reference_client.command.runs.control import run_id_of
from reference_client.command.server_connection import connect
from reference_client.command.usage_error import UsageError
from reference_client.protocol.connection import TIMEOUTS_S, Connection
from reference_client.protocol.control_client import ControlClient
from reference_client.protocol.retry_policy import RetryPolicy
from reference_record.command_line.click_commands import Options

HAS_PAGES = (200, 303)  # a page, or the way to the sign-in


def open_page(args: Options, printer: Printer) -> int:
    """`proctor open [RUN]`: the address is printed whether a browser starts or not.

    People have it first, as a browser in the terminal stays until it is left.
    """
    run_id = run_id_of(args)
    with connect(args, printer) as (connection, retry_policy):
        if run_id is not None:
            ControlClient(connection.control, retry_policy).read(run_id)
        status = retry_policy.call(lambda: _status_of_pages(connection))
        if status not in HAS_PAGES:
            raise UsageError(
                f"{connection.url} has no pages (it answers {status}); "
                "`proctor report RUN -o DIR` writes them as files"
            )
        address = f"{connection.url}/pages"
        sign_in = "" if args.print else _how_to_sign_in(connection)
    if run_id is not None:
        address += f"/runs/{quote(run_id, safe='')}"
    if not printer.as_json:
        printer.answer(None, address)
    if sign_in:
        printer.say(f"The pages ask for a token once: {sign_in}.")
    opened = not args.print and _open_browser(address)
    if printer.as_json:
        printer.answer({"url": address, "opened": opened})
    if not (opened or args.print):
        printer.say("proctor: no browser can be started here; open the address in one")
    return DONE


def page_of(connection: Connection, retry_policy: RetryPolicy, path: str) -> str | None:
    """The address of a page, such as `runs/ID`; None if the server has no pages."""
    if retry_policy.call(lambda: _status_of_pages(connection)) not in HAS_PAGES:
        return None
    return f"{connection.url}/pages/{quote(path)}"


def _status_of_pages(connection: Connection) -> int:
    pool = connection.control.api_client.pool_manager
    response = pool.request(
        "GET",
        f"{connection.url}/pages",
        redirect=False,
        retries=False,
        timeout=TIMEOUTS_S[1],
    )
    return int(response.status)


def _open_browser(address: str) -> bool:
    """Open the address, and say whether a browser was started."""
    names = ("DISPLAY", "WAYLAND_DISPLAY", "BROWSER")
    if sys.platform == "linux" and not any(os.environ.get(name) for name in names):
        return False
    sys.stdout.flush()
    # A browser prints to stdout, which scripts read for the answer: it gets stderr.
    kept = os.dup(1)
    try:
        os.dup2(2, 1)
        return webbrowser.open(address)
    finally:
        os.dup2(kept, 1)
        os.close(kept)


def _how_to_sign_in(connection: Connection) -> str:
    if source := connection.credential.source:
        return with_flag_names(f"paste {source}")
    none = "this command has none"
    if not connection.has_accounts():
        return none
    return f"{none}; `proctor login --url {connection.url}` makes a key"
