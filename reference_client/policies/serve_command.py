"""`proctor serve-policy`: puts a policy behind HTTP, for servers that call it.

The policy is what `proctor run --policy` takes; docs/push.md has an example.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence

import uvicorn

from reference_client.policies import BadMapping, BadPolicy, Mapping, load
from reference_client.policies.policy_http_app import PolicyApp

PORT = 8470


def build_parser() -> argparse.ArgumentParser:
    """Its flags."""
    parser = argparse.ArgumentParser(
        prog="proctor serve-policy",
        description="Serve a policy for runs in which the server calls it. With "
        "PROCTOR_POLICY_KEY in the environment, callers must show that key.",
        allow_abbrev=False,
    )
    parser.add_argument(
        "--policy", required=True, metavar="WHAT", help="as of proctor run"
    )
    parser.add_argument("--mapping", metavar="FILE", help="its names for ours (TOML)")
    parser.add_argument("--name", help="of the policy, told to callers")
    parser.add_argument("--host", default="127.0.0.1", help="address to listen on")
    parser.add_argument("--port", type=int, default=PORT, help=f"port ({PORT})")
    parser.add_argument(
        "--max-sessions", type=int, default=16, metavar="N",
        help="episodes played at a time, each with an instance of the policy (16)",
    )  # fmt: skip
    return parser


def main(arguments: Sequence[str] | None = None) -> int:
    """Returns the exit code."""
    args = build_parser().parse_args(arguments)
    try:
        mapping = Mapping.read(args.mapping) if args.mapping else None
        make = load(args.policy, mapping)
        # What cannot be made is told now, and not to a caller.
        first = [make()]
    except (BadPolicy, BadMapping) as error:
        sys.stderr.write(f"proctor: {error}\n")
        return 2
    key = os.environ.get("PROCTOR_POLICY_KEY") or None
    served = PolicyApp(
        lambda: first.pop() if first else make(),
        args.name or args.policy,
        max_sessions=args.max_sessions,
        key=key,
    )
    sys.stderr.write(f"Policy serves at http://{args.host}:{args.port}\n")
    uvicorn.run(
        served.app,
        host=args.host,
        port=args.port,
        log_level="warning",
        timeout_keep_alive=75,
    )
    return 0


if __name__ == "__main__":
    sys.exit(main())
