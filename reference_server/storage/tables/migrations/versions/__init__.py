"""One upgrade each, in the order of `schema_version.VERSIONS`."""
