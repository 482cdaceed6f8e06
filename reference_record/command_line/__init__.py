"""How command lines look, how a mistyped name is answered, how text files are read."""
