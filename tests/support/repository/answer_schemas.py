"""Whether a body is what the specification says: its schema, and no further members."""

from typing import Any

import jsonschema_rs

from conformance.specification.document import load_spec
from reference_record.generated import answers


def check_answer(schema: str, body: Any) -> None:
    """Raise unless a body obeys a schema of openapi.yaml and has its members alone."""
    jsonschema_rs.validate(load_spec().schema(schema), body)
    unknown = body.keys() - getattr(answers, schema).__annotations__.keys()
    assert not unknown, f"schema {schema} has no {sorted(unknown)}"
