"""All attacks, by name. A module for each subject; each lists its own in ATTACKS."""

from __future__ import annotations

from tests.campaigns.attack.attack import Attack
from tests.campaigns.attack.attacks import (
    capacity_hoarding,
    connection_floods,
    fuzzed_requests,
    process_kills,
    recorded_kills,
    storage_faults,
)

MODULES = (
    connection_floods,
    capacity_hoarding,
    process_kills,
    recorded_kills,
    storage_faults,
    fuzzed_requests,
)
ATTACKS: dict[str, Attack] = {
    attack.name: attack for module in MODULES for attack in module.ATTACKS
}
