"""The kit by fork: one fork server for each process of the tests, and for both kits."""

import importlib
import pkgutil
import sys

from tests.support.forking.fork_server import CAN_FORK, Main, shared_forks, stand_in

KIT, POLICY_KIT = "conformance", "conformance.policy"
SIMULATOR_KIT = "conformance.simulator"
PREPARE = f"{__name__}:prepare_kits"
# The kit imports these when it first needs them.
IMPORTED_LATE = ("conformance.runner.execution", "httpcore", "stringprep")


def kit_command(program: str = KIT) -> tuple[str, ...]:
    """A command that starts a kit; its options follow."""
    if not CAN_FORK:
        return (sys.executable, "-m", program)
    return (*stand_in(shared_forks(PREPARE)), program)


def prepare_kits() -> Main:
    """In the fork server: import everything that a kit imports, its checks as well."""
    import conformance.checks
    from conformance.cli.main import main
    from conformance.policy.__main__ import main as main_of_policy_kit
    from conformance.simulator.__main__ import main as main_of_simulator_kit
    from conformance.specification.ledger import load_ledger

    load_ledger()
    for name in IMPORTED_LATE:
        importlib.import_module(name)
    checks = conformance.checks
    for module in pkgutil.walk_packages(checks.__path__, f"{checks.__name__}."):
        importlib.import_module(module.name)
    programs = {KIT: main, POLICY_KIT: main_of_policy_kit}
    programs[SIMULATOR_KIT] = main_of_simulator_kit
    return lambda arguments: programs[arguments[0]](arguments[1:])
