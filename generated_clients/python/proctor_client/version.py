"""The version of this client.

Generated from spec/openapi.yaml by `make generate`; never edited by hand.
"""

__version__ = "0.1.0"
