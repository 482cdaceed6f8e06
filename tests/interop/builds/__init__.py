"""Steps that build a client: the generator, compilers, checks of downloaded files."""
