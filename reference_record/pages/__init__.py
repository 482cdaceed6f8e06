"""Pages about runs: one set of templates, for a server and for files on a disk.

They are filled with documents of the public API (schemas of spec/openapi.yaml) and with
recordings, as plain data. Who fetches those, and where the pages lie, is known to the
caller alone: this package opens no connection.
"""
