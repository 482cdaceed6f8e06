"""Accepts the command lines of `gmp` (EBench): maps its names to those of `proctor`.

Equivalent names are replaced before parsing. Flags without an equivalent are ignored,
with a note; unknown flags are left for the parser to reject.
"""

from __future__ import annotations

from reference_client.command.usage_error import UsageError

# gmp's command → proctor's.
COMMANDS = {
    ("online", "submit"): ["submit", "--wait"],
    ("online", "create"): ["submit"],
    ("online", "ready"): ["status"],
    ("online", "stop"): ["stop"],
    ("eval",): ["run"],
}
FLAGS = {
    "--base-url": "--url",
    "--task-id": "--run-id",
    "--benchmark-set": "--benchmark",
    "--model-name": "--name",
    "--model-type": "--type",
    "--submitter-name": "--submitter",
    "--submitter-homepage": "--homepage",
    "--web-view": "--view",
    "--web-view-port": "--view-port",
}
# Flag → whether a value follows it, and why it is ignored.
IGNORED_FLAGS = {
    "--is-public": (True, "runs are private to the account"),
    "--user-id": (True, "the token identifies the account"),
    "--interval": (True, "the client uses long polling"),
}
SHOWN, HIDDEN = {"1", "true", "yes"}, {"0", "false", "no"}  # --is-public of publish
# Programs with a command line of their own.
PASS_THROUGH_COMMANDS = ("serve", "admin", "serve-policy", "replay", "conformance")


def translate(arguments: list[str]) -> tuple[list[str], list[str]]:
    """The arguments with proctor's names, and a note for each ignored flag.

    Raises UsageError.
    """
    for words, here in COMMANDS.items():
        if tuple(arguments[: len(words)]) == words:
            arguments = here + arguments[len(words) :]
            break
    if arguments[:1] and arguments[0] in PASS_THROUGH_COMMANDS:
        return arguments, []
    out: list[str] = []
    notes: list[str] = []
    rest = iter(arguments)
    for argument in rest:
        if argument == "--":
            return [*out, argument, *rest], notes
        flag, equals, value = argument.partition("=")
        if not flag.startswith("--"):
            out.append(argument)
            continue
        flag = flag.replace("_", "-")
        if flag == "--is-public" and arguments[0] == "publish":
            out += _visibility(value if equals else next(rest, ""))
        elif flag in IGNORED_FLAGS:
            takes_value, why = IGNORED_FLAGS[flag]
            if takes_value and not equals:
                next(rest, None)
            notes.append(f"{flag} is ignored: {why}")
        else:
            out.append(FLAGS.get(flag, flag) + equals + value)
    return out, notes


def _visibility(value: str) -> list[str]:
    """Ignored, `--is-public 0` would show an entry that is to be private."""
    if value.lower() not in SHOWN | HIDDEN:
        raise UsageError(f"--is-public {value}: expected 1 or 0")
    return ["--private"] if value.lower() in HIDDEN else []
