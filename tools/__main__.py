"""The tools of this repository: `python -m tools COMMAND`, in the repository's root.

This module has the list of commands and their options. A command calls the function
`main` of its module, which is imported only then: environments differ in what they
have, and `make` knows which command needs which. It must not know what a tool does.
"""

import argparse
import importlib
import os
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

AddCommand = Callable[[str, str, str], argparse.ArgumentParser]


def make_parser() -> argparse.ArgumentParser:
    """Give the parser; `module` of what it reads is the module of the command."""
    parser = argparse.ArgumentParser(prog="python -m tools")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

    def add(name: str, module: str, text: str) -> argparse.ArgumentParser:
        command = commands.add_parser(name, help=text, description=text)
        command.set_defaults(module=f"tools.{module}")
        return command

    _add_writers(add)
    _add_releases(add)
    _add_measurements(add)
    return parser


def _add_writers(add: AddCommand) -> None:
    command = add("generate", "generate", "write messages and clients from spec/")
    command.add_argument("--check", action="store_true", help="only compare them")
    command.add_argument("--client", metavar="LANGUAGE", help="write this one alone")
    command.add_argument("--to", metavar="FOLDER", type=Path, help="write it there")
    command = add("traceability", "traceability", "write the table of all rules")
    command.add_argument("ids", nargs="*", metavar="ID", help="print its places")
    command.add_argument(
        "--release-ids",
        dest="is_release",
        action="store_true",
        help="add new rules to spec/ids.txt",
    )
    add("diagrams", "diagrams", "rewrite the pictures in docs/")
    add("vectors", "record_vectors", "rewrite records and manifests of spec/vectors/")
    add("examples", "api_examples.play_story", "rewrite the examples of spec/*.yaml")
    add("site", "site.build_site", "build the site of the standard")


def _add_releases(add: AddCommand) -> None:
    command = add("lock", "locks.resolve", "resolve requirements/*.in into locks")
    command.add_argument("--upgrade", action="store_true", help="take the newest")
    command.add_argument(
        "--upgrade-package", metavar="NAME", action="append", default=[], dest="names"
    )
    command = add("dist", "distributions.release_files", "build wheels and archives")
    command.add_argument("folder", nargs="?", type=Path, default=Path("dist").resolve())
    command.add_argument("--clients", action="store_true", help="archive clients too")


def _add_measurements(add: AddCommand) -> None:
    text = "play every scenario through each language's client"
    command = add("interop", "interop", text)
    for flag, meaning in (
        ("url", "of another server; PROCTOR_TOKEN is its token"),
        ("languages", "comma-separated; all when absent"),
        ("only", "comma-separated scenarios; all when absent"),
    ):  # `make interop URL=... LANGUAGES=... ONLY=...`
        default = os.environ.get(flag.upper(), "")
        command.add_argument(f"--{flag}", default=default, help=meaning)
    text = "run the kit on right servers again and again"
    command = add("false-alarms", "measurements.false_alarms", text)
    command.add_argument("--runs", type=int, default=12)
    command.add_argument(
        "--load", choices=["quiet", "busy", "halted"], help="of all runs"
    )
    command.add_argument("-j", type=int, default=1, dest="jobs", help="runs at once")
    command.add_argument("kit", nargs="*", help="further options of the kit")
    module = "measurements.both_ways.compare_both"
    command = add("both-ways", module, "play a benchmark directly and by the protocol")
    command.add_argument("compared", help="push_t, aloha, panda_lift or metaworld")
    command.add_argument("--episodes", type=int, help="only the first ones")
    command = add("experts", "experts", "measure the scripted experts, and chance")
    command.add_argument("benchmarks", nargs="*", help="all with an expert if none")
    command.add_argument("--seeds", type=int, default=100, help="per task and split")
    command.add_argument("--task", help="measure this task alone")
    command.add_argument(
        "--draw", dest="only_pictures", action="store_true", help="only the pictures"
    )
    command.add_argument("--processes", type=int, default=2)
    command.add_argument("--write", action="store_true", help="page and pictures")
    _add_cluster(add)


def _add_cluster(add: AddCommand) -> None:
    text = "run a cluster of this machine, behind one address"
    command = add("cluster", "local_cluster.run_cluster", text)
    command.epilog = (
        "PROCTOR_DATABASE and PROCTOR_SIMULATORS, where they are set, are used "
        "instead. All settings of the server are passed on to the nodes."
    )
    command.add_argument(
        "--nodes", type=int, default=2, metavar="N", help="how many servers (2)"
    )
    command.add_argument(
        "--database",
        choices=["sqlite", "postgresql"],
        default="sqlite",
        help="a file, or a PostgreSQL of its own (sqlite)",
    )
    command.add_argument(
        "--simulators",
        choices=["local", "ray"],
        default="local",
        help="processes, or a Ray cluster of its own (local)",
    )
    command.add_argument(
        "--folder",
        type=Path,
        default=Path("var/cluster"),
        help="of PostgreSQL's data, keys and recordings (var/cluster)",
    )


def main(arguments: Sequence[str] | None = None) -> int:
    """Call the command; gives its exit code."""
    chosen = vars(make_parser().parse_args(arguments))
    command = importlib.import_module(chosen.pop("module"))
    code: int = command.main(**chosen)
    return code


if __name__ == "__main__":
    sys.exit(main())
