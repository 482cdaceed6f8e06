"""What users of `gmp` type, in this command's words.

Names that mean the same are exchanged before anything is parsed. What has no meaning
here is dropped, and said; what is neither is left for the parser to refuse.
"""

from __future__ import annotations

# As people who know `gmp` have it in their fingers → what it is called here.
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
# Flag → whether a value follows it, and why it says nothing here.
IGNORED_FLAGS = {
    "--is-public": (True, "a run is its submitter's; there is nothing to publish"),
    "--user-id": (True, "the token says whose run it is"),
    "--interval": (True, "the server is not polled but answers when there is news"),
}
PASS_THROUGH_COMMANDS = (
    "serve",
    "serve-policy",
    "conformance",
)  # their flags are their own


def translate(arguments: list[str]) -> tuple[list[str], list[str]]:
    """The arguments in this command's words, and lines about what was dropped."""
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
        if flag in IGNORED_FLAGS:
            takes_value, why = IGNORED_FLAGS[flag]
            if takes_value and not equals:
                next(rest, None)
            notes.append(f"{flag} says nothing here: {why}")
        else:
            out.append(FLAGS.get(flag, flag) + equals + value)
    return out, notes
