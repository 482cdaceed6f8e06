"""Clients of other systems' APIs, as the checks of their profiles need them."""
