"""How command lines of all programs look, and how a mistyped name is answered."""
