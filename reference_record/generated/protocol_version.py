"""The version of the protocol: info.version of spec/openapi.yaml.

Written by `make generate`; never edited.
"""

PROTOCOL_VERSION = "1.0"
