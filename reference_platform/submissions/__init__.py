"""Hosted submissions: their lifecycle as a table, what is stored, who runs them."""
