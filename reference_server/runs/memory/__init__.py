"""The runs in memory, and facts that are kept there beside them."""
