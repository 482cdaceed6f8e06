"""The operations, by plane.

Written by hand, beside what is generated from the specification.
"""
