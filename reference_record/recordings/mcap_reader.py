"""Messages of an MCAP file of unknown origin, within bounds (https://mcap.dev/spec).

Reads from front to back and trusts no index. A chunk is decompressed after its size was
checked twice: as the file says it, and as the compressed frame says it.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator
from typing import BinaryIO, Final

import zstandard

from reference_record.broken import BrokenRecord
from reference_record.formats.bundle import Bundle

MAGIC: Final = b"\x89MCAP0\r\n"
_FOOTER, _SCHEMA, _CHANNEL, _MESSAGE, _CHUNK = 0x02, 0x03, 0x04, 0x05, 0x06
_KNOWN = range(0x01, 0x10)
_HEAD = struct.Struct("<BQ")
_MESSAGE_HEAD = struct.Struct("<HIQQ")
_CHUNK_HEAD = struct.Struct("<QQQII")

RECORD_BYTES_MAX: Final = 2**26
CHANNELS_MAX: Final = 256
EXPANSION_MAX: Final = 1000
EXPANSION_FREE_BYTES: Final = 2**26
# Added to the size of each record in a chunk: a small one takes time to read, too.
CHUNKED_RECORD_BYTES: Final = 64


class _Malformed(Exception):
    pass


class McapReader:
    """Gives the messages of one file; errors call it `name`."""

    def __init__(self, name: str, file: BinaryIO, size: int) -> None:
        self._name = name
        self._file = file
        self._left = size
        self._expanded_left = EXPANSION_MAX * size + EXPANSION_FREE_BYTES
        self._topics: dict[int, str] = {}
        self._decompressor = zstandard.ZstdDecompressor()

    def messages(self) -> Iterator[tuple[str, memoryview]]:
        """Topic and data of each message, in the order of the file.

        Raises BrokenRecord: REC-012 if the file is not MCAP, REC-030 beyond the bounds.
        """
        try:
            self._take_magic("begin")
            while True:
                code, length = _HEAD.unpack(self._take(_HEAD.size))
                content = memoryview(self._take(length))
                if code == _CHUNK:
                    yield from self._records_in(self._expand(content))
                elif code == _FOOTER:
                    break
                else:
                    yield from self._read(code, content)
            self._take_magic("end")
        except (_Malformed, struct.error, UnicodeDecodeError) as error:
            raise BrokenRecord(self._name, "REC-012", str(error)) from error

    def _take_magic(self, verb: str) -> None:
        if self._take(len(MAGIC)) != MAGIC or (verb == "end" and self._left):
            raise _Malformed(f"it does not {verb} as an MCAP file")

    def _take(self, count: int) -> bytes:
        if count > self._left:
            raise _Malformed("it is cut")
        self._bound(count, "a record")
        self._left -= count
        data = self._file.read(count)
        if len(data) < count:
            raise _Malformed("it is cut")
        return data

    def _bound(self, count: int, what: str) -> None:
        if count > RECORD_BYTES_MAX:
            most = f"at most {RECORD_BYTES_MAX} are read"
            detail = f"{what} of it has {count} bytes; {most}"
            raise BrokenRecord(self._name, "REC-030", detail)

    def _charge(self, count: int) -> None:
        self._expanded_left -= count
        if self._expanded_left < 0:
            detail = "its chunks have too many bytes or records for its size"
            raise BrokenRecord(self._name, "REC-030", detail)

    def _expand(self, chunk: memoryview) -> memoryview:
        _, _, expanded, _, word = _CHUNK_HEAD.unpack_from(chunk)
        start = _CHUNK_HEAD.size + word
        compression = bytes(chunk[_CHUNK_HEAD.size : start]).decode()
        (length,) = struct.unpack_from("<Q", chunk, start)
        data = chunk[start + 8 :]
        if len(data) != length:
            raise _Malformed("a chunk is cut")
        self._bound(expanded, "a chunk")
        self._charge(expanded)
        if compression == "zstd":
            data = self._decompress(data, expanded)
        elif compression:
            raise _Malformed("a chunk is compressed by something else than zstd")
        if len(data) != expanded:
            raise _Malformed("a chunk has another size than it says")
        return data

    def _decompress(self, data: memoryview, expanded: int) -> memoryview:
        try:
            inside = zstandard.get_frame_parameters(data).content_size
            # The library allocates what the frame says, not what it is allowed.
            if inside != expanded:
                raise _Malformed("a chunk has another size than it says")
            return memoryview(
                self._decompressor.decompress(data, expanded, allow_extra_data=False)
                if expanded
                else b""
            )
        except zstandard.ZstdError as error:
            raise _Malformed(f"a chunk cannot be decompressed: {error}") from error

    def _records_in(self, data: memoryview) -> Iterator[tuple[str, memoryview]]:
        position, end = 0, len(data)
        while position < end:
            code, length = _HEAD.unpack_from(data, position)
            position += _HEAD.size
            self._charge(CHUNKED_RECORD_BYTES)
            if length > end - position:
                raise _Malformed("a record in a chunk is cut")
            if code not in (_SCHEMA, _CHANNEL, _MESSAGE):
                raise _Malformed("a chunk holds what cannot stand in one")
            yield from self._read(code, data[position : position + length])
            position += length

    def _read(self, code: int, content: memoryview) -> Iterator[tuple[str, memoryview]]:
        if code == _MESSAGE:
            channel, *_ = _MESSAGE_HEAD.unpack_from(content)
            topic = self._topics.get(channel)
            if topic is None:
                raise _Malformed("a message has no channel")
            yield topic, content[_MESSAGE_HEAD.size :]
        elif code == _CHANNEL:
            self._add_channel(content)
        elif code not in _KNOWN:
            raise _Malformed(f"it has a record of the unknown kind {code}")

    def _add_channel(self, content: memoryview) -> None:
        id_, _, length = struct.unpack_from("<HHI", content)
        topic = bytes(content[8 : 8 + length]).decode()
        if self._topics.setdefault(id_, topic) != topic:
            raise _Malformed("a channel stands twice with different topics")
        if len(self._topics) > CHANNELS_MAX:
            detail = f"at most {CHANNELS_MAX} channels are read"
            raise BrokenRecord(self._name, "REC-030", detail)


def read_messages(bundle: Bundle, name: str) -> Iterator[tuple[str, memoryview]]:
    """Topic and data of each message of a file in a record; raises as McapReader."""
    with bundle.open(name) as file:
        yield from McapReader(name, file, bundle.sizes[name]).messages()
