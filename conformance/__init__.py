"""The conformance kit: checks any Proctor server against the specification over HTTP.

It imports no server and no client of this repository, because it must be able to send
what a client refuses to send. Layers, each importing only those before it:
specification (rules with ids), exchanges (requests and responses as data), verdicts,
client (requests of a check), oracle (expected results), policy and profiles (servers
and clients that checks need), checks (one per rule), runner (pytest), reports, cli.
"""
