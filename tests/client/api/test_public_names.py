"""The names that `import reference_client` offers."""

from types import ModuleType

import reference_client


def test_the_public_names_are_those_of_all() -> None:
    exported = {name for name in dir(reference_client) if name[0] != "_"}
    values = {name: getattr(reference_client, name) for name in exported}
    modules = {n for n, value in values.items() if isinstance(value, ModuleType)}
    assert exported - modules == set(reference_client.__all__)
