"""The settings of the server, by subject.

The description of a field is its documentation: `--help` prints it, and the page of
settings in docs/ is generated from it. Only validation here: what a setting does is
decided where it is used.
"""

from reference_server.settings.server_settings import Settings, describe_faults

__all__ = ["Settings", "describe_faults"]
