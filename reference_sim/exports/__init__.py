"""Exports of a record: videos, tables, files that other tools read.

An export is made from a record and is none: it has no signature. Each kind is a module
that is imported when it is wanted; `__main__` is what `proctor` starts.
"""
