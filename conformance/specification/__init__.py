"""Reads the specification: operations, schemas, requirements."""
