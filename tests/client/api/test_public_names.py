"""The names that `import reference_client` offers."""

from types import ModuleType

import reference_client


def test_the_public_names_are_those_of_all() -> None:
    members = vars(reference_client).items()
    exported = {n for n, v in members if n[0] != "_" and not isinstance(v, ModuleType)}
    assert exported == set(reference_client.__all__)
