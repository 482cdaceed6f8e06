"""JSON pointers (RFC 6901), which name the place of an error in a request."""


def pointer_step(name: str) -> str:
    """A name as one step of a pointer."""
    return name.replace("~", "~0").replace("/", "~1")
