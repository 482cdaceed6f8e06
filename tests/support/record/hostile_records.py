"""Records whose author changes a file and signs it again: no digest shows it."""

import base64
import hashlib
import json
from collections.abc import Mapping
from typing import Any

from reference_record.formats.envelope import sign_envelope
from reference_record.formats.names import MANIFEST, STATEMENT
from tests.support.record.broken_records import pack
from tests.support.record.sample_records import HOST_KEY


def resigned(
    contents: Mapping[str, bytes], name: str, data: bytes, **run: Any
) -> bytes:
    """The archive with another content of one file. run: changed members of `run`."""
    said = json.loads(base64.b64decode(json.loads(contents[STATEMENT])["payload"]))
    digest = hashlib.sha256(data).hexdigest()
    for subject in said["subject"]:
        if subject["name"] == name:
            subject["digest"]["sha256"] = digest
    predicate = said["predicate"]
    predicate["run"] |= run
    if name == MANIFEST:
        predicate["manifest_sha256"] = predicate["score"]["manifest_sha256"] = digest
    statement = sign_envelope(json.dumps(said).encode(), HOST_KEY)
    return pack({**contents, name: data, STATEMENT: statement})


def lengthened(manifest: bytes, filling: bytes, size: int) -> bytes:
    """A manifest with a further member of about so many bytes, which is not read."""
    copies = size // (len(filling) + 1)
    return manifest[:-1] + b',"more":[' + b",".join([filling] * copies) + b"]}"
