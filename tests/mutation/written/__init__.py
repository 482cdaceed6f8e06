"""Bugs that people wrote without a look at the kit, put into a server one at a time.

How many of them the kit notices says more than machine-made changes and broken servers
that were written with the checks. `make mutation WRITTEN=1` judges the kit by them and
writes build/unseen-bugs.md.
"""
