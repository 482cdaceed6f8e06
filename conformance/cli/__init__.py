"""The command line and the console output of the kit."""
