"""A page for each operation, and one of all messages, from spec/openapi.yaml."""

import re
from collections.abc import Iterator, Mapping
from typing import Any

from conformance.specification.document import (
    Operation,
    Spec,
    load_policy_spec,
    load_spec,
)
from conformance.specification.ledger import rules_of
from tools.site.kit_reports import KitReports
from tools.site.markdown import cell, link_to_rule, table
from tools.site.rule_pages import exchange_text
from tools.traceability import traces

Json = dict[str, Any]
PLANES = {False: "control", True: "data"}
LINK_IN_SPEC = re.compile(r"\]\((?=[a-z_/]+\.md)")


def pages(reports: KitReports) -> dict[str, str]:
    """Path → text of all pages about operations and messages."""
    operations = load_spec().operations
    written = {
        f"operations/{name}.md": operation_page(operation, reports)
        for name, operation in operations.items()
    }
    written["operations/index.md"] = index_page(operations)
    written["operations/messages.md"] = messages_page()
    written["operations/problems.md"] = problems_page()
    return written


def index_page(operations: Mapping[str, Operation]) -> str:
    """All operations, and what holds for each of them."""
    rows = [
        [
            f"[`{name}`]({name}.md)",
            f"`{one.method} {one.path}`",
            cell(one.description["summary"]),
            f"`{one.profile}`",
        ]
        for name, one in operations.items()
    ]
    listed = "\n".join([*operations, "messages", "problems"])
    return (
        "# Operations\n\nWhat a server serves, below its base URL. "
        "[Messages](messages.md) has the members of every body, "
        "[problems](problems.md) every code of a refusal.\n\n"
        f"{table(['operation', 'request', 'what for', 'profile'], rows)}\n"
        "How requests are read: [HTTP](/spec/http.md), [runs](/spec/runs.md) and "
        "[play](/spec/play.md).\n\n"
        f"```{{toctree}}\n:hidden:\n\n{listed}\n```\n"
    )


def operation_page(operation: Operation, reports: KitReports) -> str:
    """One operation: parameters, bodies, answers, rules, an exchange."""
    described = _raw(operation)
    needs = "a token" if operation.needs_token else "no token"
    lines = [
        f"# {operation.operation_id}\n",
        f"`{operation.method} {operation.path}`\n",
        (
            f"{described['summary']}. Profile `{operation.profile}`; "
            f"{PLANES[operation.is_data_plane]} plane; needs {needs}.\n"
        ),
        LINK_IN_SPEC.sub("](/spec/", described.get("description", "")),
        "\n## Parameters\n",
        _parameters(operation),
        "## Request\n",
        _request(described),
        "## Answers\n",
        _answers(described),
        "## Rules\n",
        _rules(operation.operation_id),
        "## A worked exchange\n",
        _exchange(operation.operation_id, reports),
    ]
    return "\n".join(lines)


def _raw(operation: Operation) -> Json:
    """The operation with its references to messages kept."""
    item: Json = load_spec().document["paths"][operation.path]
    found: Json = item[operation.method.lower()]
    return found


def _parameters(operation: Operation) -> str:
    rows = [
        [
            f"`{one['name']}`",
            one["in"],
            "yes" if one.get("required") else "no",
            _type(one["schema"]),
            cell(one.get("description", "")),
        ]
        for one in operation.description.get("parameters", [])
    ]
    return table(["name", "in", "required", "type", ""], rows) if rows else "None.\n"


def _request(described: Json) -> str:
    body = described.get("requestBody")
    if body is None:
        return "No body.\n"
    return _contents(body["content"])


def _contents(content: Json) -> str:
    parts = (f"`{kind}`: {_type(one['schema'])}" for kind, one in content.items())
    return "; ".join(parts) + ".\n"


def _answers(described: Json) -> str:
    rows = []
    for status, answer in described["responses"].items():
        if "$ref" in answer:
            rows.append([status, "A refusal: [a problem](problems.md)."])
        else:
            content = _contents(answer["content"]) if "content" in answer else ""
            rows.append([status, cell(f"{answer['description']} {content}")])
    return table(["status", ""], rows)


def _rules(operation_id: str) -> str:
    rows = [
        [link_to_rule(rule.id, traces()), cell(rule.text)]
        for rule in rules_of(operation_id)
        if rule.profile != "policy"  # its `predict` is that of policy.yaml
    ]
    if not rows:
        return "None but those that hold for every operation.\n"
    return table(["id", "rule"], rows)


def _exchange(name: str, reports: KitReports) -> str:
    accepted = [
        one
        for found in reports.exchanges.values()
        for one in found
        if one.get("operation") == name and one["status"] < 400
    ]
    with_json = [one for one in accepted if not isinstance(one.get("answer_body"), str)]
    shown = (with_json or accepted)[:1]
    return exchange_text(shown[0]) if shown else "None is recorded.\n"


def messages_page() -> str:
    """Every schema of the components, with an anchor."""
    lines = [
        (
            "# Messages\n\nThe bodies of requests and answers. A client reads past "
            "members that it does not know; a request holds only members that "
            "stand here.\n"
        )
    ]
    schemas = _schemas(load_spec()) | _schemas(load_policy_spec())
    for name, schema in schemas.items():
        lines += [f"({_anchor(name)})=\n", f"## {name}\n"]
        lines += [f"{schema['description']}\n"] if "description" in schema else []
        if "properties" in schema:
            rows = list(_members(schema))
            lines.append(table(["member", "", "type", ""], rows))
        else:
            lines.append(f"{_type(schema)}\n")
    return "\n".join(lines)


def _schemas(spec: Spec) -> Json:
    schemas: Json = spec.document["components"]["schemas"]
    return schemas


def _anchor(name: str) -> str:
    return f"message-{name.lower()}"


def _members(schema: Json) -> Iterator[list[str]]:
    required = schema.get("required", [])
    for name, member in schema["properties"].items():
        kind = "required" if name in required else "optional"
        text = cell(member.get("description", ""))
        yield [f"`{name}`", kind, _type(member), text]


BOUNDS = {
    "minimum": "≥ {}",
    "maximum": "≤ {}",
    "exclusiveMinimum": "> {}",
    "exclusiveMaximum": "< {}",
    "minLength": "≥ {} characters",
    "maxLength": "≤ {} characters",
    "minItems": "≥ {} items",
    "maxItems": "≤ {} items",
    "default": "default {}",
}


def _type(schema: Json) -> str:
    """A type in words, with links to named messages."""
    if "$ref" in schema:
        name = str(schema["$ref"]).rpartition("/")[2]
        if "schemas" in schema["$ref"]:
            return f"[{name}](/operations/messages.md#{_anchor(name)})"
        return name
    for key, joint in (("oneOf", " or "), ("anyOf", " or "), ("allOf", " and ")):
        if key in schema:
            return joint.join(_type(one) for one in schema[key])
    for key in ("enum", "x-extensible-enum"):
        if key in schema:
            return ", ".join(f"`{value}`" for value in schema[key])
    bounds = [text.format(schema[key]) for key, text in BOUNDS.items() if key in schema]
    if "pattern" in schema:
        bounds.append("`" + schema["pattern"].replace("|", "\\|") + "`")
    return ", ".join([_kind(schema), *bounds])


def _kind(schema: Json) -> str:
    if "const" in schema:
        return f"`{schema['const']}`"
    if "items" in schema:
        return f"array of {_type(schema['items'])}"
    if isinstance(schema.get("additionalProperties"), dict):
        return f"map to {_type(schema['additionalProperties'])}"
    kind = schema.get("type", "any")
    return " or ".join(kind) if isinstance(kind, list) else str(kind)


def problems_page() -> str:
    """Every code of a problem, with an anchor; `type` stays the URN."""
    lines = [
        (
            "# Problems\n\nA refusal is an RFC 9457 problem. `type` is the URN "
            "`urn:proctor:problem:CODE`; it names a problem and is not opened. A "
            "client that does not know a code decides by `status`, `retryable` and "
            "`side_effects`.\n"
        )
    ]
    known = traces()
    for code, one in load_spec().problems.items():
        naming = [t.rule for t in known.values() if f"`{code}`" in t.rule.text]
        lines += [
            f"(problem-{code.replace('_', '-')})=\n",
            f"## {code}\n",
            (
                f"{one['title']}. Status {one['status']}; a retry "
                f"{'can succeed later' if one['retryable'] else 'is refused again'}; "
                f"side effects: {one['side_effects']}.\n"
            ),
            f"What to do: {one['act']}\n",
        ]
        if naming:
            listed = ", ".join(link_to_rule(rule.id, known) for rule in naming)
            lines.append(f"Rules: {listed}.\n")
    return "\n".join(lines)
