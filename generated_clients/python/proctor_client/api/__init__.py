"""The operations, by plane.

Generated from spec/openapi.yaml by `make generate`; never edited by hand.
"""
