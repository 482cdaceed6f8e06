"""The names that `import reference_client` offers."""

from types import ModuleType

import reference_client


def test_the_public_names_are_those_of_all() -> None:
    exported = {name for name in dir(reference_client) if name[0] != "_"}
    modules = {
        n for n in exported if isinstance(getattr(reference_client, n), ModuleType)
    }
    assert exported - modules == set(reference_client.__all__)
