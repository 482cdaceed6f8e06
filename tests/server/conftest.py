"""The fixture `parts`: a server without HTTP."""

from tests.support.server.server_parts import parts

__all__ = ["parts"]
