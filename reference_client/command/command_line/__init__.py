"""The command line of `proctor`: its flags, other names for them, completion."""
