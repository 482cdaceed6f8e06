"""All attacks, by name. A module for each subject; each lists its own in ATTACKS."""

from __future__ import annotations

from tests.attack.attack import Attack
from tests.attack.attacks import connection_floods

MODULES = (connection_floods,)
ATTACKS: dict[str, Attack] = {
    attack.name: attack for module in MODULES for attack in module.ATTACKS
}
