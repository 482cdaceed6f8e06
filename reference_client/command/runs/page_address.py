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
from reference_client.protocol.connection import Connection
from reference_client.protocol.control_client import HAS_PAGES, ControlClient
from reference_record.command_line.click_commands import Options


def open_page(args: Options, printer: Printer) -> int:
    """`proctor open [RUN]`: the address is printed whether a browser starts or not.

    People have it first, as a browser in the terminal stays until it is left.
    """
    run_id = run_id_of(args)
    with connect(args, printer) as (connection, retry_policy):
        control_client = ControlClient(connection.control, retry_policy)
        if run_id is not None:
            control_client.read(run_id)
        status = control_client.status_of_pages()
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
