"""Where commands look for a server that nothing names."""

DEFAULT_URL = "http://127.0.0.1:8460"  # where `proctor serve` serves
