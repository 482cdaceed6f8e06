"""Bugs that people wrote without a look at the kit, put into a server one at a time.

The kit did not notice them when it met them first; those that it noticed at once are
gone. `make mutation WRITTEN=1` judges the kit by those that are left.
"""
