"""Servers with one machine-made change each, to measure how much the kit sees.

tests/mutants/ breaks one rule at a time, on purpose. Here a program changes one place
of a server in another language, whatever it means, and the kit judges the result as a
black box. What the kit does not notice is read by a person, who writes the reason into
triage.toml. `make mutation` runs it and writes build/mutation.md.
"""
