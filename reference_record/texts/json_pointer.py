"""Steps of JSON pointers, by which messages name a member."""


def pointer_step(name: str) -> str:
    """A name as one step of a JSON pointer (RFC 6901)."""
    return name.replace("~", "~0").replace("/", "~1")
