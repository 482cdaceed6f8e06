"""DSSE envelopes around in-toto statements: the signed bytes, and the one valid form.

The envelope has exactly one form for its content (REC-005), so that a changed byte is
found even where a lenient reader would read the same.
"""

from __future__ import annotations

import base64
import binascii
import re
from dataclasses import dataclass
from typing import Final

from reference_record.broken import BrokenRecord
from reference_record.keys import SigningKey, is_signature, keyid_of

PAYLOAD_TYPE: Final = "application/vnd.in-toto+json"
_FORM = re.compile(
    rb'\{"payload":"(?P<payload>[A-Za-z0-9+/]+={0,2})",'
    rb'"payloadType":"application/vnd\.in-toto\+json",'
    rb'"signatures":\[\{"keyid":"(?P<keyid>SHA256:[0-9a-f]{64})",'
    rb'"sig":"(?P<sig>[A-Za-z0-9+/]{86}==)"\}\]\}'
)


@dataclass(frozen=True, slots=True)
class Envelope:
    """file: its name in the record, for errors."""

    file: str
    payload: bytes
    keyid: str
    signature: bytes

    def check_signature(self, public_key: bytes) -> None:
        """REC-006: raise BrokenRecord unless the key's owner signed the payload."""
        if keyid_of(public_key) != self.keyid:
            detail = "its keyid is not that of the public key in it"
            raise BrokenRecord(self.file, "REC-006", detail)
        if not is_signature(public_key, self.signature, signed_bytes(self.payload)):
            raise BrokenRecord(self.file, "REC-006", "its signature does not fit")


def signed_bytes(payload: bytes) -> bytes:
    """DSSE's pre-authentication encoding of a payload (REC-006)."""
    head = f"DSSEv1 {len(PAYLOAD_TYPE)} {PAYLOAD_TYPE} {len(payload)} "
    return head.encode() + payload


def sign_envelope(payload: bytes, key: SigningKey) -> bytes:
    """REC-005, REC-006: the bytes of the file."""
    parts = {
        "payload": base64.b64encode(payload).decode(),
        "keyid": key.keyid,
        "sig": base64.b64encode(key.sign(signed_bytes(payload))).decode(),
    }
    return (
        f'{{"payload":"{parts["payload"]}","payloadType":"{PAYLOAD_TYPE}",'
        f'"signatures":[{{"keyid":"{parts["keyid"]}","sig":"{parts["sig"]}"}}]}}'
    ).encode()


def read_envelope(file: str, data: bytes) -> Envelope:
    """REC-005: the content of an envelope; raises BrokenRecord."""
    form = _FORM.fullmatch(data)
    if form is None:
        detail = "it is no DSSE envelope in the form that a record has"
        raise BrokenRecord(file, "REC-005", detail)
    return Envelope(
        file,
        _decode(file, form["payload"]),
        form["keyid"].decode(),
        _decode(file, form["sig"]),
    )


def _decode(file: str, text: bytes) -> bytes:
    try:
        data = base64.b64decode(text, validate=True)
    except binascii.Error as error:
        raise BrokenRecord(
            file, "REC-005", f"its base64 is invalid: {error}"
        ) from error
    if base64.b64encode(data) != text:  # bits that no byte has
        raise BrokenRecord(file, "REC-005", "its base64 has another form")
    return data
